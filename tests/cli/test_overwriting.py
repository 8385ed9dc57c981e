"""No command writes over a file that it reads, or over one that it has not written, by any name or link."""

import os
import shutil

import numpy as np
import pytest

from asperity.cli.runs.design import front_columns, front_table
from asperity.errors import InputError
from asperity.joint_file.contact_table import INPUT_COLUMNS, MODEL_COLUMN, convert_contact_table
from asperity.study.datasets import SWEEP_TABLES
from asperity.study.design.design_file import read_design

#: Commands that write a file OUT of an ending, from the files JOINT, DATA, DESIGN, FRONT, HEIGHTS or TABLE.
COMMANDS = {
    "sweep csv": (
        ".csv",
        "sweep JOINT --over load.preload=900_N:1000_N:3 --results mass --out OUT --overwrite",
    ),
    "sweep nc": (
        ".nc",
        "sweep JOINT --over load.preload=900_N:1000_N:3 --results mass --out OUT --overwrite",
    ),
    "sweep parquet": (
        ".parquet",
        "sweep JOINT --over load.preload=900_N:1_kN:3 --results mass --out OUT --overwrite",
    ),
    "sweep plot": (".png", "sweep JOINT --over load.preload=900_N:1000_N:3 --plot OUT"),
    "joint": (".svg", "joint JOINT --plot OUT"),
    "roll": (".pdf", "roll JOINT --plot OUT"),
    "windup": (".csv", "windup JOINT --csv OUT"),
    "windup rolling": (".csv", "windup JOINT --rolling-csv OUT"),
    "windup plot": (".png", "windup JOINT --plot OUT"),
    "film plot": (".png", "film JOINT --plot OUT"),
    "accuracy plot": (".png", "accuracy JOINT --plot OUT"),
    "wear plot": (".png", "wear JOINT --plot OUT"),
    "window": (".csv", "window JOINT --csv OUT --points 2"),
    "window plot": (".png", "window JOINT --plot OUT --points 2"),
    "loads": (".csv", "loads JOINT --csv OUT"),
    "dynamics": (".csv", "dynamics JOINT --csv OUT"),
    "dynamics plot": (".png", "dynamics JOINT --plot OUT"),
    "sensitivity": (".png", "sensitivity JOINT --plot OUT"),
    "uncertainty": (".png", "uncertainty JOINT --plot OUT"),
    "design": (".toml", "design DESIGN --out OUT"),
    "design plot": (".png", "design DESIGN --plot OUT"),
    "design map": (".png", "design DESIGN --map OUT"),
    "front": (".csv", "design FRONT --out OUT"),
    "calibrate": (".toml", "calibrate JOINT DATA -u load.preload --out OUT"),
    "calibrate plot": (".png", "calibrate JOINT DATA -u load.preload --plot OUT"),
    "calibrate posterior": (
        ".png",
        "calibrate JOINT DATA -u load.preload --posterior 50 --plot-posterior OUT",
    ),
    "table": (".csv", "export JOINT --to table --out OUT"),
    "mat": (".mat", "export JOINT --to table --out OUT"),
    "mujoco": (".xml", "export JOINT --to mujoco --out OUT"),
    "fmu": (".fmu", "export JOINT --to fmu --out OUT"),
    "modelica": (".mo", "export JOINT --to modelica --out OUT"),
    "draw": (".svg", "draw JOINT --out OUT"),
    "draw dxf": (".dxf", "draw JOINT --out OUT"),
    "draw parts": (".pdf", "draw JOINT --parts --out OUT"),
    "report": (".html", "report JOINT --out OUT"),
    "report pdf": (".pdf", "report JOINT --out OUT"),
    "contact": (".csv", "contact --table TABLE --out OUT"),
    "measure": (".png", "surface measure HEIGHTS --plot OUT"),
    "verify map": (".png", "verify-contact --surface HEIGHTS --plot OUT"),
}
#: Those that read nothing.
READING_NOTHING = {
    "verify": (".png", "verify-contact --plot OUT"),
    "validate": (".json", "validate --out OUT"),
    "validate html": (".html", "validate --out OUT"),
    "synthesize": (
        ".npy",
        "surface synthesize OUT --kind weierstrass -D 1.5 -G 1e-9_m --points 64 --spacing 1_um --seed 1",
    ),
}
PAIRS_HEAD = ",".join([*INPUT_COLUMNS, MODEL_COLUMN])
SURFACE_POINTS = "x [m],z [m]\n" + "".join(f"{k}e-6,{np.sin(k):.6g}e-9\n" for k in range(64))


@pytest.fixture
def inputs(tmp_path, zou_file):
    """Letters of a command → its file."""
    files = {
        "JOINT": "joint.toml",
        "DATA": "data.csv",
        "DESIGN": "design.toml",
        "FRONT": "front.toml",
        "HEIGHTS": "heights.csv",
        "TABLE": "table.csv",
    }
    found = {word: tmp_path / name for word, name in files.items()}
    text = zou_file.with_name("planetary.toml").read_text(encoding="utf-8")
    found["JOINT"].write_text(text, encoding="utf-8")
    found["DATA"].write_text("torque [N*m],angle [mrad]\n0,0\n1,1\n2,2\n")
    free = 'joint = "joint.toml"\n[variables]\n"drive.contact_length" = { lower = "6 mm", upper = "9 mm" }\n'
    free += "[objective]\n"
    found["DESIGN"].write_text(free + 'minimise = "mass"\n')
    found["FRONT"].write_text(free + 'minimise = "mass"\nmaximise = "stiffness"\n')
    found["HEIGHTS"].write_text(SURFACE_POINTS)
    found["TABLE"].write_text("D\n")
    return found


def arguments(line, files, out):
    words = {**files, "OUT": out}
    return [
        words.get(word, word.replace("_", " ") if "=" in word or word[0].isdigit() else word)
        for word in line.split()
    ]


def read_by(line, files):
    """The files that a command reads; a design also reads its joint file."""
    names = [word for word in line.split() if word in files]
    return [files[name] for name in (*names, *(["JOINT"] if {"DESIGN", "FRONT"} & set(names) else []))]


@pytest.mark.parametrize(("suffix", "line"), COMMANDS.values(), ids=COMMANDS)
@pytest.mark.parametrize("way", ["link", "hard link"])
def test_what_is_read_stays_behind_a_link(call, tmp_path, inputs, suffix, line, way):
    for file in read_by(line, inputs):
        before = file.read_bytes()
        out = tmp_path / f"{file.stem}-out{suffix}"
        out.symlink_to(file.name) if way == "link" else os.link(file, out)
        refused = call(*arguments(line, inputs, out))
        assert (refused.code, refused.out) == (2, "")
        assert "this is the file that is read; give another name" in refused.err
        assert file.read_bytes() == out.read_bytes() == before


@pytest.mark.parametrize(
    ("suffix", "line", "options"),
    [
        (".png", "design DESIGN --plot OUT --map SAME", "--plot and --map"),
        (".toml", "design DESIGN --out OUT --plot SAME", "--out and --plot"),
        (".csv", "design FRONT --out OUT --plot SAME", "--out and --plot"),
        (
            ".png",
            "calibrate JOINT DATA -u load.preload --posterior 50 --plot OUT --plot-posterior SAME",
            "--plot and --plot-posterior",
        ),
        (".toml", "calibrate JOINT DATA -u load.preload --out OUT --plot SAME", "--out and --plot"),
        (".csv", "windup JOINT --csv OUT --rolling-csv SAME", "--csv and --rolling-csv"),
        (".png", "windup JOINT --csv OUT --plot SAME", "--csv and --plot"),
        (".png", "dynamics JOINT --csv OUT --plot SAME", "--plot and --csv"),
        (".csv", "sweep JOINT --over load.preload=900_N:1000_N:3 --out OUT --plot SAME", "--out and --plot"),
    ],
)
@pytest.mark.parametrize("other", ["a{}", "./a{}", "../{folder}/a{}", "link{}"])
def test_two_files_of_one_command_have_two_names(
    call, tmp_path, inputs, monkeypatch, suffix, line, options, other
):
    monkeypatch.chdir(tmp_path)
    same = other.format(suffix, folder=tmp_path.name)
    if other.startswith("link"):
        (tmp_path / same).symlink_to(f"a{suffix}")
    refused = call(*arguments(line, {**inputs, "SAME": same}, f"a{suffix}"))
    assert (refused.code, refused.out) == (2, "")
    assert f"{options} name the same file, " in refused.err
    assert not (tmp_path / f"a{suffix}").exists()


@pytest.mark.parametrize(
    ("suffix", "line"), (COMMANDS | READING_NOTHING).values(), ids=COMMANDS | READING_NOTHING
)
def test_what_another_has_written_stays(call, tmp_path, inputs, suffix, line):
    (tmp_path / "notes.txt").write_text("my notes")
    link, plain = tmp_path / f"link{suffix}", tmp_path / f"plain{suffix}"
    link.symlink_to("notes.txt")
    shutil.copy(tmp_path / "notes.txt", plain)
    for out in (link, plain):
        refused = call(*arguments(line, inputs, out))
        assert (refused.code, refused.out) == (2, "")
        assert "give another name, or remove it" in refused.err
        assert out.read_text() == (tmp_path / "notes.txt").read_text() == "my notes"
    assert not list(tmp_path.glob(".*"))


def test_a_table_of_a_front_is_known_by_the_columns_of_this_front(tmp_path, inputs):
    problem = read_design(inputs["FRONT"])
    own = "assembly_stiffness_output [N*m/rad],mass [kg],drive.contact_length [m]"
    assert ",".join(front_columns(problem).values()) == own
    for head, made in (
        (own, True),
        (f"{own},comment", False),
        ("mass [kg],drift [arcmin/turn]", False),
        ("drive.contact_length [m]", False),
        ("mass [kg],costs [EUR]", False),
        ("a,b", False),
    ):
        (tmp_path / "front.csv").write_text(f"{head}\n1.0,2.0\n")
        assert front_table(problem).is_made(tmp_path / "front.csv") is made


def test_a_table_of_a_sweep_has_a_number_of_the_joint_file(tmp_path):
    for head, made in (
        ("load.preload [N],status,status_meaning,mass [kg],slip_ratio_sp [1]", True),
        ("load.preload [kN],drive.sun_radius [m],status,status_meaning", True),
        ("speed,status,status_meaning", False),
        ("load.preload,status,status_meaning", False),
        ("status,status_meaning,mass [kg]", False),
        ("load.preload [N],status,mass [kg],status_meaning", False),
        ("load.preload [N],status,status_meaning,mass [kg],comment", False),
        ("load.preload [N],costs [EUR],status,status_meaning", False),
    ):
        (tmp_path / "sweep.csv").write_text(f"{head}\n1.0,0,solved\n")
        assert SWEEP_TABLES[".csv"].is_made(tmp_path / "sweep.csv") is made


def test_a_table_of_results_is_written_again_and_another_is_not(tmp_path):
    table = tmp_path / "table.csv"
    table.write_text(f"{PAIRS_HEAD}\n1.4,1e-8,1000,50,0.12,4,13.5,1,5,206000,206000,0.29,0.29,2000,printed\n")
    for _ in range(2):
        convert_contact_table(
            table, tmp_path / "out.csv", frequency_ratio=1.5, asperity_base="majumdar_bhushan_1991"
        )
    shutil.copy(table, tmp_path / "other.csv")
    with pytest.raises(InputError, match="not a table of results that asperity has made"):
        convert_contact_table(
            table, tmp_path / "other.csv", frequency_ratio=1.5, asperity_base="majumdar_bhushan_1991"
        )


def test_a_reproduction_leaves_a_folder_of_others_as_it_is(call, tmp_path):
    for name in ("figure_4a.png", "figure_4a.csv", "table_1.csv", "claims.json"):
        folder = tmp_path / name.replace(".", "-")
        folder.mkdir()
        (folder / name).write_text("mine")
        refused = call("reproduce", "--out", folder)
        assert (refused.code, refused.out) == (2, "")
        assert f"{name} is of no earlier run of 'asperity reproduce'" in refused.err
        assert [file.read_text() for file in folder.iterdir()] == ["mine"]


def test_a_joint_file_is_not_written_through_a_link(call, tmp_path):
    (tmp_path / "mine.txt").write_text("mine")
    (tmp_path / "joint.toml").symlink_to("mine.txt")
    refused = call("init", tmp_path / "joint.toml", "--force")
    assert refused.code == 2
    assert "this is a link; give the name of the file itself" in refused.err
    assert (tmp_path / "mine.txt").read_text() == "mine"


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [
        *(
            "sweep csv",
            "sweep nc",
            "sweep parquet",
            "windup",
            "windup rolling",
            "window",
            "loads",
            "dynamics",
            "table",
            "mat",
        ),
        *("mujoco", "fmu", "modelica", "draw", "draw dxf", "draw parts", "report"),
        *("sensitivity", "joint", "roll", "report pdf"),
    ],
)
def test_what_a_command_has_written_it_writes_again(call, tmp_path, inputs, name):
    suffix, line = COMMANDS[name]
    for _ in range(2):
        done = call(*arguments(line, inputs, tmp_path / f"out{suffix}"))
        assert done.code == 0, done.err
    other = line.replace("900_N:1", "800_N:1").replace("mass", "preload")
    done = call(*arguments(other, inputs, tmp_path / f"out{suffix}"))
    assert done.code == 0, done.err

"""``asperity draw``: files of every kind, and refusals before anything is written."""

import re
from pathlib import Path

import pytest

from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case

EXAMPLE = Path(__file__).parents[2] / "examples" / "zou2025.toml"


@pytest.mark.parametrize(
    "suffix", ["svg", *(pytest.param(end, marks=pytest.mark.slow) for end in ("pdf", "png"))]
)
def test_drawing_is_written_and_does_not_change(call, joint_file, tmp_path, suffix):
    file, found = joint_file(), []
    for name in "ab":
        outcome = call("draw", file, "--out", tmp_path / f"{name}.{suffix}")
        assert (outcome.code, outcome.out) == (0, "")
        found.append((tmp_path / f"{name}.{suffix}").read_bytes())
    assert found[0] == found[1]


def test_dxf_has_the_radii_and_forces_of_the_file(call, joint_file, tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="the extra 'report' is not installed")
    assert call("draw", joint_file(), "--forces", "--out", tmp_path / "d.dxf").code == 0
    document = ezdxf.readfile(tmp_path / "d.dxf")
    radii = [c.dxf.radius for c in document.query('CIRCLE[layer=="OUTLINE"]')]
    for radius, count in ((4.0, 1), (13.5, 3), (5.0, 6), (40.0, 1)):
        assert sum(abs(each - radius) < 1e-9 for each in radii) == count
    texts = {text.dxf.text for text in document.query("TEXT")}
    assert "sun %%c8" in texts
    assert "Torque at the sun 0.5556 N·m, at the carrier 5 N·m." in texts_of(tmp_path / "d.dxf")
    assert "sp: N = 1001 N" in texts  # machine.md and model.md: 1001.05 N at 5 N*m


@pytest.mark.parametrize(
    ("change", "arguments", "said"),
    [
        (("planets = 3", "planets = 3"), ("--out", "d.step"), "must end in .svg, .pdf, .png or .dxf"),
        (('"5 mm"\nring', '"3 mm"\nring'), ("--out", "d.svg"), "there is no place for right_loading_roller"),
        (("planets = 3", "planets = 4"), ("--out", "d.svg"), "neighbours of planet overlap by 2.25126 mm"),
        (("5 N*m", "50 N*m"), ("--forces", "--out", "d.svg"), "beyond the standing torque capacity"),
        (
            ("5 N*m", "5 N*m"),
            ("--project", "x" * 61, "--out", "d.svg"),
            "--project: at most 60 characters, got 61",
        ),
    ],
)
def test_refusals_write_nothing(call, joint_file, tmp_path, monkeypatch, change, arguments, said):
    monkeypatch.chdir(tmp_path)
    outcome = call("draw", joint_file(change), *arguments)
    assert outcome.code == 2
    assert said in outcome.err
    assert not list(tmp_path.glob("d.*"))


@pytest.mark.slow
def test_parts_are_pages_of_a_pdf_and_files_of_their_own_otherwise(call, joint_file, tmp_path):
    file = joint_file(('"13.5 mm"', '"13.5 mm +- 2 um"'))
    assert call("draw", file, "--parts", "--out", tmp_path / "d.pdf").code == 0
    assert (tmp_path / "d.pdf").read_bytes().count(b"/Type /Page ") == 5
    outcome = call(
        "draw", file, "--parts", "--out", tmp_path / "d.svg", "--project", "Wrist", "--revision", "B"
    )
    assert outcome.code == 0
    assert {path.name for path in tmp_path.glob("*.svg")} == {
        "d.svg", "d_sun.svg", "d_planet.svg", "d_right_loading_roller.svg", "d_ring.svg",
    }  # fmt: skip
    planet = texts_of(tmp_path / "d_planet.svg")
    for text in ("Wrist", "3 of 5", "⌀27.0000 ±0.0040", "3 × planet"):
        assert text in planet
    assert "Wrist" in texts_of(tmp_path / "d.svg")


def test_a_part_does_not_replace_the_file_that_is_read(call, joint_file, tmp_path):
    file = joint_file().rename(tmp_path / "d_sun.svg")
    outcome = call("draw", file, "--parts", "--out", tmp_path / "d.svg")
    assert outcome.code == 2
    assert "this is the file that is read" in outcome.err
    assert not (tmp_path / "d.svg").exists()


def texts_of(path):
    """Every text of a drawing: of DXF from its entities, broken lines together."""
    if path.suffix == ".dxf":
        ezdxf = pytest.importorskip("ezdxf", reason="the extra 'report' is not installed")
        texts = " ".join(each.dxf.text for each in ezdxf.readfile(path).query("TEXT"))
        return " ".join(texts.split()).replace("%%c", "⌀")
    return path.read_text()


def preload_of(joint):
    """Force that the interference of a joint makes [N]."""
    return float(solve_joint(joint).result.preload)


@pytest.mark.slow
@pytest.mark.parametrize("forces", [(), ("--forces",)])
@pytest.mark.parametrize(
    "name",
    [
        "planetary",
        *(
            pytest.param(name, marks=pytest.mark.long)
            for name in ("zou2025", "stepped_planet", "multiroller", "planar")
        ),
    ],
)
def test_a_ring_under_a_preload_is_as_small_as_one_under_the_interference_that_makes_it(
    call, tmp_path, name, forces
):
    """The force of the stated interference gives its bore back, also far beyond the torque that the drive carries."""
    text = EXAMPLE.with_name(f"{name}.toml").read_text()
    load = text[text.index("[load]") :]
    stated = next(line for line in load.splitlines() if line.startswith(("preload", "interference")))
    by_interference = text.replace(stated, 'interference = "30 um"')
    joint = joint_from_case(parse_case(by_interference, source="test"))
    force = preload_of(joint)
    file, said = tmp_path / "joint.toml", []
    for line in ('interference = "30 um"', f'preload = "{force!r} N"'):
        file.write_text(text.replace(stated, line))
        outcome = call("draw", file, "--out", tmp_path / "d.dxf", *forces)
        assert (outcome.code, outcome.out) == (0, "")
        said.append(texts_of(tmp_path / "d.dxf"))
    assert said[0] == said[1]
    assert "interference 30 µm on the radius" in said[0]


@pytest.mark.slow
def test_the_bore_is_known_at_any_torque_and_in_every_format(call, joint_file, tmp_path):
    """A preload of 1000 N at 500 N·m, which no contact carries; the interference is that of the rest."""
    joint = joint_file(("5 N*m", "500 N*m"))
    for suffix in ("dxf", "svg"):
        assert call("draw", joint, "--out", tmp_path / f"d.{suffix}").code == 0
    said = texts_of(tmp_path / "d.dxf")
    bore = float(re.search(r"ring inside ⌀([0-9.]+)", said)[1])
    assert 79.9 < bore < 79.99
    made = EXAMPLE.read_text().replace('preload = "1000 N"', f'interference = "{500.0 * (80.0 - bore)!r} um"')
    # the bore has a tenth of a micrometre
    assert preload_of(joint_from_case(parse_case(made, source="x"))) == pytest.approx(1000.0, rel=1e-2)


def test_a_bore_that_is_not_known_is_said(call, joint_file, tmp_path):
    """A temperature, and materials whose expansion the file does not give."""
    warm = ("[model]", '[temperature]\nassembly = "20 degC"\nworking = "60 degC"\n\n[model]')
    outcome = call("draw", joint_file(warm), "--out", tmp_path / "d.dxf")
    assert outcome.code == 0
    assert "warning" in outcome.err
    assert "thermal_expansion of steel" in outcome.err
    assert "⌀80 less 2 × interference" in texts_of(tmp_path / "d.dxf")


@pytest.mark.filterwarnings("default:Glyph")
def test_a_letter_that_the_font_lacks_is_a_note_without_a_place_in_a_source(call, zou_file, tmp_path):
    told = call("draw", zou_file, "--out", tmp_path / "a.svg", "--project", "\u6f22")
    assert told.code == 0
    assert "asperity: note: Glyph" in told.err
    assert "Warning" not in told.err
    assert ".py" not in told.err

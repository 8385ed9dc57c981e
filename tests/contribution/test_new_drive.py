"""A new drive is one file: sun, two meshing planets and ring, added to a copy of the package with a joint file."""

import json

import pytest
from package_copy import changed_files, package_copy, run

pytestmark = pytest.mark.slow

TYPE = '''"""Sun, two meshing planets in a row, and a ring: the carrier turns against the sun."""

from asperity.drive.layout.drive import CARRIER
from asperity.drive.layout.drive_type import Branches, DriveType, Pairing, Part, Places, Sectors
from asperity.drive.layout.sizes import SUN_CROWN, ContactLength, bore, radius, ring_support, wall
from asperity.engine.arrays import xp


def _layout(sizes):
    sun, inner, outer = (xp.asarray(sizes[f"{name}_radius"], dtype=float) for name in ("sun", "inner", "outer"))
    return Places(
        centres={
            "inner": xp.stack([0.0 * sun, sun + inner]),
            "outer": xp.stack([0.0 * sun, sun + 2.0 * inner + outer]),
        },
        radii={"ring": sun + 2.0 * inner + 2.0 * outer},
    )


DOUBLE_PLANET = DriveType(
    name="double_planet",
    words="double-planet",
    summary="Drive with two meshing planets in a row between sun and ring.",
    sectors=Sectors("planets", "Number of pairs of planets, equally spaced.", "pairs of planets"),
    parts=(Part("sun", "axis"), Part("inner", "pin"), Part("outer", "pin"), Part("ring", "axis")),
    contacts=(
        Pairing("si", "sun", "inner"),
        Pairing("io", "inner", "outer"),
        Pairing("or", "outer", "ring", internal=True),
    ),
    sizes=(
        radius("sun", "Radius of the sun, the input.", start="20 mm"),
        radius("inner", "Radius of the planets at the sun.", start="10 mm"),
        radius("outer", "Radius of the planets at the ring.", start="10 mm"),
        wall("ring", "Wall of the ring."),
        ContactLength(),
        ring_support(),
        bore("inner", "Diameter of the bore of the planets at the sun; solid if absent."),
        SUN_CROWN,
    ),
    input="sun",
    output=CARRIER,
    grounded="ring",
    layout=_layout,
    branches=Branches(
        "One pair of planets; write [[branch]] above each, as many as pairs.",
        "Sizes of each pair of planets, where they differ: a section [[branch]] for each.",
        {"inner": "Radius of the planet at the sun above inner_radius.", "outer": "Of the other above outer_radius."},
    ),
)
'''
FILE = "drive/types/double_planet.py"


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """The folder of the copy, with the new type and the joint file that its template makes, on pins that give way."""
    folder = package_copy(tmp_path_factory.mktemp("drive"))
    (folder / "asperity" / FILE).write_text(TYPE, encoding="utf-8")
    made = run(folder, "init", "double.toml", "--type", "double_planet")
    assert made.returncode == 0, made.stderr
    return folder


def json_of(folder, *arguments):
    """The JSON document that a command prints."""
    found = run(folder, *arguments, "--json")
    assert found.returncode == 0, found.stderr
    return json.loads(found.stdout)


def test_one_file_is_enough(copy):
    assert changed_files(copy) == {FILE}


def test_the_joint_is_solved_from_the_template(copy):
    """R_r = 20 + 20 + 20 = 60 mm: ratio 1 - 60/20; one force in the row of contacts; torque 1 N·m by three pairs."""
    document = json_of(copy, "joint", "double.toml")
    assert document["input"]["type"] == "double_planet"
    assert document["geometry"]["speed_ratio"] == pytest.approx(-2.0, rel=1e-9)
    # M_sun = 1/2 N·m, by three contacts at 20 mm; the planets pass on the same force
    force = pytest.approx(0.5 / 3.0 / 20e-3, rel=1e-6)
    tangential = document["standing"]["forces"]["tangential_N"]
    assert {name: abs(size) for name, size in tangential.items()} == {"si": force, "io": force, "or": force}
    shown = run(copy, "joint", "double.toml").stdout
    assert "3 pairs of planets" in shown


def test_it_is_wound_up_drawn_and_reported(copy):
    assert json_of(copy, "windup", "double.toml")["lost_motion_rad"] > 0.0
    written = run(copy, "report", "double.toml", "--out", "report.html")
    assert written.returncode == 0, written.stderr
    page = (copy / "report.html").read_text(encoding="utf-8")
    assert "double-planet" in page.lower() or "double planet" in page.lower()
    assert "outer" in page
    drawn = run(copy, "draw", "double.toml", "--out", "double.svg")
    assert drawn.returncode == 0, drawn.stderr
    assert "3 × outer ⌀20" in (copy / "double.svg").read_text(encoding="utf-8")


def test_a_ratio_stands_for_a_radius(copy):
    """1 - R_r/R_s = -3 makes R_r = 80 mm, and the planets at the ring 20 mm."""
    text = (copy / "double.toml").read_text(encoding="utf-8")
    (line,) = [line for line in text.splitlines() if line.startswith("outer_radius")]
    (copy / "open.toml").write_text(text.replace(line, "ratio = 3"), encoding="utf-8")
    document = json_of(copy, "joint", "open.toml")
    assert document["geometry"]["speed_ratio"] == pytest.approx(-3.0, rel=1e-9)
    assert document["input"]["drive"]["outer_radius"] == pytest.approx(20e-3, rel=1e-9)


def test_schema_and_messages_know_it(copy):
    schema = json.loads(run(copy, "schema", "--type", "double_planet").stdout)
    keys = schema["$defs"]["DoublePlanetDrive"]["properties"]
    assert list(keys)[:5] == ["ratio", "planets", "sun_radius", "inner_radius", "outer_radius"]
    assert keys["contact_length"]["description"].endswith("or a table with si, io, or.")
    assert set(schema["$defs"]["DoublePlanetBranch"]["properties"]) == {"inner_deviation", "outer_deviation"}
    text = (copy / "double.toml").read_text(encoding="utf-8")
    (copy / "wrong.toml").write_text(text.replace('outer = "52100"', 'outter = "52100"'), encoding="utf-8")
    assert (
        "a double_planet drive has no such body; did you mean 'outer'?"
        in run(copy, "joint", "wrong.toml").stderr
    )
    (copy / "near.toml").write_text(text.replace('"double_planet"', '"double_planets"'), encoding="utf-8")
    assert "did you mean 'double_planet'?" in run(copy, "joint", "near.toml").stderr


def test_own_branches_have_its_sizes(copy):
    text = (copy / "double.toml").read_text(encoding="utf-8")
    (line,) = [line for line in text.splitlines() if line.startswith("preload")]
    sizes = '\n[[branch]]\nouter_deviation = "1 um"\n[[branch]]\n[[branch]]\ninner_deviation = "-1 um"\n'
    (copy / "branches.toml").write_text(
        text.replace(line, 'interference = "20 um"') + sizes, encoding="utf-8"
    )
    unequal = json_of(copy, "joint", "branches.toml")["branches"]
    sizes = [(each["inner_deviation_m"], each["outer_deviation_m"]) for each in unequal["branches"]]
    assert sizes == [(0.0, pytest.approx(1e-6)), (0.0, 0.0), (pytest.approx(-1e-6), 0.0)]
    # a planet is as much thicker as twice its radius
    first, second, third = (each["interference_m"] for each in unequal["branches"])
    assert (first - second, second - third) == pytest.approx((2e-6, 2e-6), rel=1e-6)
    for state in ("standing", "rolling"):
        first, second, third = unequal[state]["share"]
        assert first > second > third > 0.0
        assert first + second + third == pytest.approx(1.0, rel=1e-9)


def test_a_type_that_is_not_complete_is_told_with_its_file(copy, tmp_path):
    broken = package_copy(tmp_path)
    (broken / "asperity" / FILE).write_text(TYPE.replace("    layout=_layout,\n", ""), encoding="utf-8")
    failed = run(broken, "joint", str(copy / "double.toml"))
    assert "TypeError: drive/types/double_planet.py: " in failed.stderr
    assert "'layout'" in failed.stderr

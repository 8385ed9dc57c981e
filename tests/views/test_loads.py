"""Loads of the structure, its bearings and bodies that bend, as they are shown: by statics, kinematics and ISO 281."""

import math

import pytest
from shown_blocks import four, sentences, tables

import asperity
from asperity.views.loads import loads, rims

LOADS, BEARINGS = "Loads of the structure", "Rolling bearings, each one alone"
SECTIONS = (
    '\n[pin_bearing]\ntype = "roller"\ndynamic_rating = "8 kN"\nstatic_rating = "9 kN"\ncount = 1\n'
    '\n[[duty]]\noutput_torque = "6 N*m"\nsun_speed = "3000 rpm"\nshare = 1.0\n'
    '\n[bearings]\npin_diameter = "12 mm"\npin_length = "20 mm"\n'
)
#: Of each of three pins on a circle of 30 mm [N].
FORCE, FORCE_OF_DUTY = 10.0 / 3.0 / 0.030, 6.0 / 3.0 / 0.030
#: Of a planet on its pin [rpm]: the carrier turns at a sixth of the sun, and the planet rolls in a ring of 50 mm.
ON_PIN, ON_PIN_IN_DUTY = 1500.0 / 6.0 * 50.0 / 20.0, 3000.0 / 6.0 * 50.0 / 20.0


@pytest.fixture(scope="module")
def document(zou_file, tmp_path_factory):
    """The planetary example with rated bearings and a duty."""
    file = tmp_path_factory.mktemp("loads") / "planetary.toml"
    file.write_text(zou_file.with_name("planetary.toml").read_text(encoding="utf-8") + SECTIONS)
    return asperity.loads(asperity.load(file)).document


def test_pins_carry_what_statics_says(document):
    """10 N·m at the carrier of three planets on a circle of 30 mm; 6 N·m in the duty."""
    shown = tables(loads(document))[LOADS]
    assert shown.head[0] == "part"
    assert shown.head[2:] == (
        "unit",
        "without torque",
        "working torque, in rolling\n10 N·m\n1500 rpm",
        "duty 1, in rolling\n6 N·m\n3000 rpm",
    )
    place = next(n for n, row in enumerate(shown.rows) if row[0] == "carrier pin, planet")
    of_pin = {row[1]: row for row in shown.rows[place : place + 6]}
    row = of_pin["tangential force"]
    assert [float(cell) for cell in row[3:]] == [0.0, four(FORCE), four(FORCE_OF_DUTY)]
    assert row[2] == "N"
    # a part is named once
    assert [each[0] for each in of_pin.values()] == ["carrier pin, planet"] + 5 * [""]
    # 10 mm of planet in the middle of a beam of 20 mm: M = F/2 (l/2 - b/4); sigma = M / (pi d^3/32), d = 12 mm
    row = of_pin["bending stress"]
    modulus = math.pi * 12.0**3 / 32.0
    stresses = [force / 2.0 * (20.0 / 2.0 - 10.0 / 4.0) / modulus for force in (FORCE, FORCE_OF_DUTY)]
    assert (row[2], [float(cell) for cell in row[3:]]) == ("MPa", [0.0, *map(four, stresses)])
    # creep takes less than a thousandth
    row = of_pin["speed, roller on pin"]
    assert row[2] == "rpm"
    assert [float(cell) for cell in row[3:]] == pytest.approx([0.0, ON_PIN, ON_PIN_IN_DUTY], rel=1e-3)
    assert {row[2] for row in shown.rows} >= {"N", "N·m", "rpm"}


def test_numbers_that_do_not_exist_are_dashes(document):
    shown = tables(loads(document))[LOADS]
    (mounting,) = (row for row in shown.rows if row[1] == "axial mounting force")
    assert mounting[4:] == ("–", "–")


def test_bearings_by_their_ratings(document):
    """C over P to the power of 10/3 of a roller bearing, in millions of turns; C_0 over P."""
    shown = tables(loads(document))[BEARINGS]
    ((name, kind, *numbers),) = shown.rows
    heads = [head.replace("\n", " ") for head in shown.head[2:]]
    found = dict(zip(heads, numbers, strict=True))
    assert (name, kind) == ("planet pin", "roller")
    assert (found["C N"], found["C_0 N"]) == ("8000", "9000")
    assert float(found["load N"]) == four(FORCE)
    for head, force, speed in (
        ("life L10 h", FORCE, ON_PIN),
        ("under the duty h", FORCE_OF_DUTY, ON_PIN_IN_DUTY),
    ):
        hours = 1e6 * (8000.0 / force) ** (10.0 / 3.0) / (60.0 * speed)
        assert float(found[head]) == pytest.approx(hours, rel=2e-3)  # creep and four digits
    assert float(found["largest P/C -"]) == four(FORCE / 8000.0)
    assert float(found["static safety -"]) == four(9000.0 / FORCE)  # 81


def test_reasons_and_notes_stand_below_the_tables(document):
    (bearing,) = document["bearings"]
    silent = bearing | {"life_hours": None, "absent_because": ["no life: it slips"]}
    cases = [*document["cases"][:-1], document["cases"][-1] | {"unknown_because": "slips"}]
    said = sentences(loads(document | {"bearings": [silent], "cases": cases}))
    assert said[:2] == ["duty 1: slips.".capitalize(), "Planet pin bearing: no life: it slips."]
    assert said[2:] == list(document["notes"])
    assert BEARINGS not in tables(loads(document | {"bearings": []}))


def test_bodies_that_bend(planetary_view, paper_view):
    """Amplitude: half the range. Safeties by Mises in plane strain, and by fatigue and yield strength of 52100."""
    table, said = rims(planetary_view.document)
    ring = planetary_view.document["rims"]["ring"]
    numbers = {row[1]: [float(cell) for cell in row[2:]] for row in table.rows}
    largest, used = [], []
    for rim, (rest, under, mean, amplitude, *_) in numbers.items():
        assert (rest, under) == (
            four(1e-6 * ring["stress_at_rest_Pa"][rim]),
            four(1e-6 * ring["stress_Pa"][rim]),
        )
        assert amplitude == pytest.approx(under - mean, rel=1e-3)  # from the mean up to the largest
        largest.append(abs(mean) + amplitude)
        used.append(amplitude / 588.0 + max(mean, 0.0) / 2034.0)  # a mean in compression is no help
    mises = math.sqrt(1.0 - 0.29 + 0.29**2)  # sigma and nu sigma across
    for row in numbers.values():
        assert row[4:] == pytest.approx([2034.0 / (mises * max(largest)), 1.0 / max(used)], rel=1e-3)
    assert {row[0] for row in table.rows} == {"ring"}
    assert [row[1] for row in table.rows] == ["inner", "outer"]
    assert "plane strain" in said.text
    assert list(rims(paper_view.document)) == []
    unknown = {"rims": {"held_ring": ring | {"fatigue_safety": None}}}
    table, _ = rims(unknown)
    assert (table.rows[0][0], table.rows[0][-1]) == ("held ring", "–")

"""Sheets of parts: one for each kind, everything stated or said not to be."""

import pytest

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.stated_parts import stated_parts
from asperity.show.part_sheets import part_sheets
from asperity.show.title_block import Title


@pytest.fixture
def sheets(planar_case):
    def draw(name, replaced=None, interference=None):
        case = planar_case(name, replaced=replaced or {})
        joint = joint_from_case(case)
        return part_sheets(
            joint,
            name=name,
            stated=stated_parts(case, joint),
            title=Title(part="W-100"),
            interference=interference,
        )

    return draw


def test_one_sheet_for_each_kind(sheets):
    drawn = sheets("zou2025")
    assert list(drawn) == ["sun", "planet", "right_loading_roller", "ring"]
    for number, (sheet, words) in enumerate(
        zip(drawn.values(), ("sun", "3 × planet", "6 × right and left loading roller", "ring"), strict=True),
        start=2,
    ):
        assert {words, f"{number} of 5", "W-100", "steel", "material steel"} <= set(sheet.texts)


def test_a_part_states_what_the_file_states_and_names_what_it_does_not(sheets):
    changed = {
        'planet_radius = "20 mm"': 'planet_radius = "20 mm +- 3 um"\nplanet_length = "14 mm +- 0.1 mm"',
        '"26 mm"': '"26 mm +- 10 um"',
    }
    drawn = sheets("planetary_hollow", changed)
    planet = drawn["planet"].texts
    assert {
        "⌀40.0000 ±0.0060 (IT5)", "bore ⌀26.000 ±0.010 (IT6)", "14.00 ±0.10", "hardness 746 HV, of steel 62 HRC",
        "roundness, runout, edges: not stated",
    } <= set(planet)  # fmt: skip
    assert not any(text.startswith(("tolerance", "length:")) for text in planet)
    sun = drawn["sun"].texts
    assert {"⌀20", "tolerance of track sp: not stated"} <= set(sun)
    ring = " ".join(" ".join(drawn["ring"].texts).split())
    assert "⌀99.94, made bore" in ring
    assert "⌀160" in ring  # 50 mm and a wall of 30 mm
    assert "interference 30 µm on the radius: all contacts just touch at ⌀100" in ring


def test_a_ring_is_made_as_it_is_before_it_is_pressed_into_its_housing(sheets):
    """60 um on a diameter of 116 mm, in 150 mm of the same steel; what that takes from the bore by hand."""
    changed = {
        'ring_support = "free"': 'ring_support = "rigid_housing"',
        "[load]": '[housing]\nouter_diameter = "150 mm"\ninterference = "60 um"\nfriction_coefficient = 0.12\n\n[load]',
        'ring = "52100"': 'ring = "52100"\nhousing = "52100"',
    }
    ring = " ".join(sheets("planetary", changed)["ring"].texts)
    a, b, c = 50.0, 58.0, 75.0
    over_modulus = 30e-3 / b / ((b**2 + a**2) / (b**2 - a**2) + (c**2 + b**2) / (c**2 - b**2))  # p/E
    narrower = 4.0 * over_modulus * a * b**2 / (b**2 - a**2)
    assert f"⌀{99.94 + narrower:.4f}, made bore" in ring
    assert f"narrows it by {1e3 * narrower:.4g} µm" in ring.replace("    ", " ")
    assert "outer diameter 60 µm larger than the bore of the housing" in ring.replace("    ", " ")


def test_tracks_of_a_stepped_roller_are_dimensioned_and_their_distance_is_not_known(sheets):
    sheet = sheets("stepped_planet")["planet"]
    assert {"⌀40", "⌀36"} <= set(sheet.texts)
    assert [dimension.items[-1].text for dimension in sheet.dimensions].count("10") == 2
    assert "distance between the tracks along the axis: not" in sheet.texts


def test_form_errors_are_full_readings(sheets):
    form = '[[form]]\npart = "ring"\nrunout = "6 um"\nharmonics = { 3 = "0.5 um" }\n\n[surface]'
    drawn = sheets("zou2025", {"[surface]": form})
    ring = " ".join(" ".join(drawn["ring"].texts).split())
    assert "runout 6 µm, roundness 1 µm in 3 waves (full readings)" in ring  # twice the amplitude
    assert "edges: not stated" in ring
    assert "roundness, runout, edges: not stated" in drawn["sun"].texts

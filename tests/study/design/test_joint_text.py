"""Joint files written back."""

import pytest

from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.values import numeric_keys, si_values
from asperity.study.design.joint_text import joint_file_text


def test_unchanged_file_says_the_same(zou_file):
    case = read_case(zou_file)
    again = parse_case(joint_file_text(case, {}, comment="two\nlines"), source="test")
    assert si_values(again) == si_values(case)


def test_every_digit_survives(zou_file):
    case = read_case(zou_file)
    changes = {
        "load.preload": 1234.5678901234567,
        "surface.fractal_roughness": 3.3333333333333333e-12,
        "surface.fractal_dimension": 1.7182818284590452,
        "drive.contact_length.sp": 0.0123456789012345678,
        "materials.steel.youngs_modulus": 2.0612345678901234e11,
    }
    again = numeric_keys(parse_case(joint_file_text(case, changes, comment=""), source="test"))
    for path, value in changes.items():
        assert again[path].value == pytest.approx(value, rel=3e-16)
    assert again["drive.contact_length.wlo"].value == 0.005


def test_tolerances_stay(zou_file):
    text = zou_file.read_text().replace('planet_radius = "13.5 mm"', 'planet_radius = "13.5 mm +- 5 um"')
    case = parse_case(text, source="test")
    again = numeric_keys(
        parse_case(joint_file_text(case, {"drive.planet_radius": 0.0134}, comment=""), source="test")
    )
    assert again["drive.planet_radius"].value == pytest.approx(0.0134, rel=1e-15)
    assert again["drive.planet_radius"].tolerance == pytest.approx(5e-6, rel=1e-15)

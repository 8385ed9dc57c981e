"""The section [temperature]: what it needs, and what it excludes."""

import pytest

from asperity.errors import InputError
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import numeric_keys, si_values

SECTION = '[temperature]\nassembly = "20 °C"\nworking = "333.15 K +- 5 K"\n\n'


def read(text, *changes, section=SECTION):
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return parse_case(text.replace("[model]", section + "[model]"), source="x")


def test_temperatures_are_in_degrees_celsius_with_tolerances_in_kelvin(joint_text):
    case = read(joint_text)
    assert si_values(case)["temperature"] == {"assembly": 20.0, "working": 60.0}
    assert numeric_keys(case)["temperature.working"].tolerance == 5.0


def test_every_material_needs_its_expansion_where_the_preload_is_an_interference(joint_text):
    by_length = ('preload = "1000 N"', 'interference = "13 um"')
    with pytest.raises(InputError, match="thermal_expansion of every material: give it for steel"):
        read(joint_text, by_length)
    bodies = [
        (f'{body} = "steel"', f'{body} = "52100"') for body in ("sun", "planet", "loading_roller", "ring")
    ]
    assert read(joint_text, by_length, *bodies).temperature is not None


def test_a_ring_that_carries_itself_has_no_housing(joint_text):
    free = ('ring_support = "rigid_housing"', 'ring_support = "free"')
    with pytest.raises(InputError, match=r"leave out temperature\.housing_expansion"):
        read(joint_text, free, section=SECTION.rstrip() + '\nhousing_expansion = "23e-6 1/K"\n\n')


def test_wrong_units_are_told(joint_text):
    with pytest.raises(InputError, match="expected a temperature"):
        read(joint_text, section=SECTION.replace("20 °C", "20 mm"))
    with pytest.raises(InputError, match=r"at least -273\.1 degC"):
        read(joint_text, section=SECTION.replace("20 °C", "-300 °C"))

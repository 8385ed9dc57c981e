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


def test_other_drives_have_the_same_section(planar_case):
    by_section = ("[model]", SECTION + "[model]")
    case = planar_case("planetary", by_section)
    assert si_values(case)["temperature"] == {"assembly": 20.0, "working": 60.0}
    own = '[materials.mine]\nyoungs_modulus = "206 GPa"\npoisson_ratio = 0.3\ndensity = "7850 kg/m^3"\n'
    own += 'yield_strength = "450 MPa"\nhardness_factor = 2.8\n\n'
    with pytest.raises(InputError, match="thermal_expansion of every material: give it for mine"):
        planar_case(
            "planetary", by_section, ("[surface]", own + "[surface]"), ('planet = "52100"', 'planet = "mine"')
        )


@pytest.mark.parametrize(
    ("name", "held", "said"),
    [
        (
            "planetary",
            ('ring_support = "free" ', 'ring_support = "rigid_housing" '),
            r'drive\.ring_support = "free"',
        ),
        ("planar", ('ring_support = "free" ', 'ring_support = "rigid_housing" '), "whose rings all have"),
    ],
)
def test_other_drives_without_a_housing(planar_case, name, held, said):
    housing = SECTION.rstrip() + '\nhousing_expansion = "23e-6 1/K"\n\n'
    with_it = ("[model]", housing + "[model]")
    free, rigid = held
    here = (rigid, free) if name == "planar" else ("ring_support", "ring_support")
    with pytest.raises(InputError, match=f"{said}.* has no housing: leave out temperature"):
        planar_case(name, with_it, here)
    back = ("ring_support", "ring_support") if name == "planar" else (free, rigid)
    assert planar_case(name, with_it, back).temperature.housing_expansion is not None

"""Sections that are made of what a type of drive states."""

import pytest

from asperity.drive.types import TYPES
from asperity.errors import InputError
from asperity.joint_file.case_types import CASES
from asperity.joint_file.made_sections import drive_section
from asperity.joint_file.section import meaning


@pytest.mark.parametrize(
    "kind", [kind for kind in TYPES.values() if not kind.is_listed], ids=lambda kind: kind.name
)
def test_a_section_has_the_keys_of_its_type_in_their_order_with_their_meanings(kind):
    section = drive_section(kind)
    count = [] if kind.sectors is None else [kind.sectors.key]
    assert [*section.model_fields] == ["ratio", *count, *(entry.key for entry in kind.sizes)]
    for entry in kind.sizes:
        if hasattr(entry, "meaning"):
            assert meaning(section, entry.key) == entry.meaning
            assert section.model_fields[entry.key].is_required() == entry.required
    assert meaning(section, "contact_length").endswith(", ".join(kind.contact_names({})) + ".")
    assert ("branch" in CASES[kind.name].model_fields) == (kind.branches is not None)


def test_keys_by_names_of_a_type_of_its_own_take_the_place_of_the_common_ones():
    own, common = CASES["wedge"].model_fields, CASES["planetary"].model_fields
    assert {"sun_bearing", "carrier_bearing"} <= set(own) - set(common)
    assert {"input_bearing", "output_bearing"} <= set(common) - set(own)


@pytest.mark.parametrize(
    ("name", "old", "key"),
    [("planetary", "planets = 3", "planets"), ("multiroller", "rollers_per_row = 4", "rollers_per_row")],
)
def test_a_single_sector_is_refused_with_the_reason(planar_case, name, old, key):
    with pytest.raises(InputError) as refused:
        planar_case(name, (old, f"{key} = 1"))
    assert (
        f"drive.{key}: 1 is not allowed; it must be a whole number, at least 2 and at most 100: the forces of a single "
        "one would push the members on the axis off it" in str(refused.value)
    )
    with pytest.raises(InputError, match=r"at most 100$"):
        planar_case(name, (old, f"{key} = 101"))

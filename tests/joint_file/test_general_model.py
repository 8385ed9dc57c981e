"""Rollers and contacts as a joint file lists them."""

import pytest
from pydantic import ValidationError

from asperity.joint_file.general_model import ContactEntry, RollerEntry

CONTACT = {
    "name": "sp",
    "first": "sun",
    "second": "planet",
    "first_radius": "4 mm",
    "second_radius": "13.5 mm",
}


def test_a_contact_is_external_and_in_its_own_sector_unless_stated():
    plain = ContactEntry.model_validate(CONTACT)
    assert (plain.internal, plain.sector) == (False, 0)
    assert plain.second_radius.value == pytest.approx(13.5e-3)
    assert ContactEntry.model_validate({**CONTACT, "sector": -1}).sector == -1


@pytest.mark.parametrize(
    ("key", "value"),
    [("sector", 2), ("sector", 0.5), ("first_radius", "0 mm"), ("name", "a b"), ("internal", "perhaps")],
)
def test_what_no_contact_has_is_refused(key, value):
    with pytest.raises(ValidationError, match=key):
        ContactEntry.model_validate({**CONTACT, key: value})


def test_places_of_rollers():
    roller = RollerEntry.model_validate(
        {"name": "left", "place": "pin", "orbit": "35 mm", "angle": "104 deg"}
    )
    assert roller.orbit.value == pytest.approx(35e-3)
    assert roller.bore_diameter is None
    with pytest.raises(ValidationError, match="place"):
        RollerEntry.model_validate({"name": "left", "place": "shaft"})

"""Rolling bearings in a joint file: ratings in any unit of force, and what is refused."""

import pytest
from pydantic import ValidationError

from asperity.joint_file.sections import HeldBearing, PinBearing

PIN = {"type": "roller", "dynamic_rating": "3.2 kN", "static_rating": "2900 N", "count": 2}
HELD = {"type": "ball", "dynamic_rating": "5 kN", "static_rating": "3 kN", "outside_force": "200 N"}


def test_ratings_are_forces():
    pin, held = PinBearing.model_validate(PIN), HeldBearing.model_validate(HELD)
    assert (pin.dynamic_rating.value, pin.static_rating.value, pin.count.value) == (3200.0, 2900.0, 2.0)
    assert held.outside_force.value == 200.0


@pytest.mark.parametrize(
    ("model", "entry", "key", "value"),
    [
        (PinBearing, PIN, "type", "needle"),
        (PinBearing, PIN, "dynamic_rating", "3.2 mm"),
        (PinBearing, PIN, "dynamic_rating", "0 N"),
        (PinBearing, PIN, "static_rating", "-1 N"),
        (PinBearing, PIN, "count", 1.5),
        (PinBearing, PIN, "count", 0),
        (HeldBearing, HELD, "outside_force", "-1 N"),
    ],
)
def test_what_no_bearing_has_is_refused(model, entry, key, value):
    with pytest.raises(ValidationError, match=key):
        model.model_validate({**entry, key: value})


@pytest.mark.parametrize(("model", "entry"), [(PinBearing, PIN), (HeldBearing, HELD)])
def test_every_key_is_needed(model, entry):
    for key in entry:
        with pytest.raises(ValidationError, match=key):
            model.model_validate({name: value for name, value in entry.items() if name != key})

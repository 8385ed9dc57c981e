"""What a body of a drive is besides its tracks."""

import pytest

from asperity.joint.body_shape import SOLID, BodyShape


@pytest.mark.parametrize(
    ("shape", "bore"),
    [(SOLID, None), (BodyShape("hollow", 24e-3), 24e-3), (BodyShape("ring", 8e-3, "rigid_housing"), None)],
)
def test_only_a_hollow_roller_has_a_bore(shape, bore):
    """The size of a ring is its wall."""
    assert shape.bore_diameter == bore


def test_a_ring_is_free_unless_it_is_held():
    assert BodyShape("ring", 8e-3).support == "free"

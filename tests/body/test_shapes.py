"""Kolosov's constant and what a body refuses."""

import pytest

from asperity.body.shapes import Annulus, kolosov_constant
from asperity.errors import InputError


def test_kolosov_constant_in_both_plane_states():
    assert kolosov_constant(poisson_ratio=0.25, plane_state="plane_strain") == pytest.approx(2.0)
    assert kolosov_constant(poisson_ratio=0.25, plane_state="plane_stress") == pytest.approx(2.2)


def test_unknown_names_are_refused():
    with pytest.raises(InputError, match="plane state 'plane'"):
        kolosov_constant(poisson_ratio=0.3, plane_state="plane")
    with pytest.raises(InputError, match="loaded rim 'both'"):
        Annulus(1.0, 2.0, 1.0, 1.0, 0.3, 0.0, 0.0, "both", "plane_strain")

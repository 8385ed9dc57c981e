"""Crowns of the planetary example for a tilt, by hand where a hand can."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint.description import joint_contacts
from asperity.results.crown_document import crown_document
from asperity.results.solved import solved_with_capacities


@pytest.fixture(scope="module")
def contacts(planetary):
    joint, solution, _ = planetary
    return crown_document(solved_with_capacities(joint, solution), 0.5e-3)["contacts"]


def test_the_file_first_then_half_all_and_twice_the_recommended_drop(planetary, contacts):
    _, solution, _ = planetary
    assert list(contacts) == ["sp", "pr"]
    for number, contact in enumerate(contacts.values()):
        states = (solution.result.rest, solution.result.forces, solution.result.rolling)
        assert contact["normal_force_N"] == max(float(state.normal[number]) for state in states)
        stated, *others = contact["profiles"]
        assert (stated["end_drop_m"], stated["crown_radius_m"]) == (0.0, None)
        assert [(entry["profile"], entry["share_of_recommended"]) for entry in others] == [
            *((kind, share) for kind in ("circular", "logarithmic", "lundberg") for share in (0.5, 1.0, 2.0)),
            ("iso_16281", None),
        ]
        for half, recommended, double in (others[:3], others[3:6]):
            assert 2.0 * half["end_drop_m"] == pytest.approx(recommended["end_drop_m"])
            assert half["end_over_mean"] > recommended["end_over_mean"] == double["end_over_mean"] == 0.0
            assert recommended["peak_pressure_Pa"] < double["peak_pressure_Pa"]
            assert recommended["peak_over_mean"] < stated["peak_over_mean"]
            assert half["edge"]
            assert not recommended["edge"]
            assert not double["edge"]
        circular = others[1]
        assert 8.0 * circular["end_drop_m"] * circular["crown_radius_m"] == pytest.approx(0.01**2)
        at_end = (
            others[4]["end_drop_m"] / others[4]["coefficient_m"]
        )  # 1.193 + ln(B/2b), here of a contact 60 times
        assert 1.193 + 3.0 < at_end < 1.193 + 5.0  # to 150 times as long as wide
        assert others[4]["peak_pressure_Pa"] < circular["peak_pressure_Pa"]


def test_a_contact_without_force_has_no_profile(planetary):
    joint, *_ = planetary
    states = {
        state: SimpleNamespace(normal=np.array([0.0, 800.0])) for state in ("rest", "forces", "rolling")
    }
    solved = SimpleNamespace(joint=joint, result=SimpleNamespace(**states))
    contacts = crown_document(solved, 0.5e-3)["contacts"]
    assert contacts["sp"]["profiles"] == []
    assert len(contacts["pr"]["profiles"]) == 11


def test_a_loaded_end_has_no_peak_pressure(contacts):
    """Boundary elements have 1775, 2312, 3127 MPa at such an edge with 80, 160, 320 elements along it."""
    for contact in contacts.values():
        for entry in contact["profiles"]:
            assert entry["edge"] == (entry["end_over_mean"] > 0.0) == (entry["peak_pressure_Pa"] is None)


def test_profiles_without_bound_at_the_ends(planetary, contacts):
    """Lundberg's coefficient is at least P'/(pi E*), the standard's .00035 times the smaller diameter."""
    joint, *_ = planetary
    modulus = np.asarray(joint_contacts(joint).pairs.moduli.contact_modulus)
    radii = np.minimum(joint.drive.first_radius, joint.drive.second_radius)
    for number, contact in enumerate(contacts.values()):
        *_, half, best, double, standard = contact["profiles"]
        even = (
            contact["normal_force_N"]
            / contact["contact_length_m"]
            / np.pi
            / np.ravel(modulus)[number % modulus.size]
        )
        assert best["coefficient_m"] > even
        assert best["peak_pressure_Pa"] <= min(half["peak_pressure_Pa"], double["peak_pressure_Pa"])
        assert (
            best["peak_pressure_Pa"] < 1.01 * contact["profiles"][5]["peak_pressure_Pa"]
        )  # Johns and Gohar's
        assert standard["coefficient_m"] == pytest.approx(0.00035 * 2.0 * radii[number], rel=1e-9)

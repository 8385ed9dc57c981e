"""The checks of contacts with oil pass, and find a formula that is off."""

import pytest

from asperity.contact import load_sharing
from asperity.validation import film_checks as checks
from asperity.validation import oiled_rollers


def test_a_film_that_is_off_is_found(monkeypatch):
    honest = oiled_rollers.central_film_thickness
    monkeypatch.setattr(oiled_rollers, "central_film_thickness", lambda **given: 1.005 * honest(**given))
    assert [check.passed for check in checks.films()] == [False, True, True]


def test_a_share_that_is_off_is_found(monkeypatch):
    monkeypatch.setattr(load_sharing, "SEPARATION_FACTOR", 1.01 * load_sharing.SEPARATION_FACTOR)
    assert [check.passed for check in checks.films()] == [True, False, False]


@pytest.mark.parametrize(
    ("name", "failing"),
    [
        ("elastic_layers_factor", ["factor of film and asperities as elastic layers"]),
        ("traction_capacity", ["largest traction over load"]),
    ],
)
def test_a_law_that_is_off_is_found(monkeypatch, name, failing):
    honest = getattr(checks, name)

    def off(**given):
        found = honest(**given)
        return (
            found._replace(traction=1.005 * found.traction) if hasattr(found, "_replace") else 1.005 * found
        )

    monkeypatch.setattr(checks, name, off)
    assert [check.quantity for check in checks._tractions() if not check.passed] == failing


def test_numbers_of_the_table():
    """Its first row as it is printed, in SI units."""
    first = oiled_rollers.known_contacts()[0]
    assert (first.oil, first.celsius, first.speed) == ("M100", 25.0, 1.0)
    assert first.rms_height == pytest.approx(1e-7)
    assert first.full_film == first.film_thickness == pytest.approx(0.8122e-6)
    assert first.tractions == (0.00417, 0.01157, 0.02878, 0.0384, 0.0427)
    assert (first.elastic_factor, first.capacity) == (2.1791, 0.04409)

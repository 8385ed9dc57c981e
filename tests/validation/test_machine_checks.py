"""The checks of oil, asperities, fits, temperature, cams and pins pass, and find a formula that is off."""

import pytest

from asperity.validation import machine_checks as checks


@pytest.mark.parametrize(
    ("module", "name", "group", "failing"),
    [
        (checks.film_thickness, "minimum_film_thickness", checks.oil, "smallest thickness"),
        (checks.rolling_losses, "inlet_rolling_force", checks.oil, "power lost at the inlet"),
        (checks.flash_temperature, "flash_temperature", checks.oil, "rise"),
        (checks.flash_temperature, "thermal_effusivity", checks.oil, "rise"),
        (checks.creep_layer, "layer_creepage_factor", checks.layers, "creepage over Carter's"),
        (checks.creep_layer, "peak_pressure_factor", checks.layers, "peak pressure"),
        (checks, "ring_expansion", checks.fits, "expansion of the bore"),
        (checks, "ring_interference", checks.fits, "interference that it takes"),
        (checks, "cam_preload", checks.structure, "preload at"),
        (checks, "cam_angle", checks.structure, "angle at the output"),
        (checks, "pin_bending_moment", checks.structure, "bending"),
        (checks, "pin_bending_stress", checks.structure, "bending stress"),
    ],
)
def test_a_formula_that_is_off_by_half_a_percent_is_found(monkeypatch, module, name, group, failing):
    assert [check for check in group() if not check.passed] == []
    honest = getattr(module, name)
    monkeypatch.setattr(module, name, lambda **given: honest(**given) * 1.005)
    found = [check.quantity for check in group() if not check.passed]
    assert found
    assert all(quantity.startswith(failing) for quantity in found)


def test_a_fit_of_another_interference_is_found(monkeypatch):
    honest = checks.press_fit
    monkeypatch.setattr(
        checks, "press_fit", lambda **given: honest(**given | {"interference": 1.001 * given["interference"]})
    )
    assert [check.passed for check in checks.fits()] == [False, False, True, True]

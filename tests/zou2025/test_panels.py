"""The fourteen panels: all there, in engineers' units."""

import numpy as np
import pytest

from asperity.zou2025.curves import Curves
from asperity.zou2025.panels import Panel, all_panels


@pytest.fixture(scope="module")
def panels(curves: Curves) -> dict[str, Panel]:
    return {panel.name: panel for panel in all_panels(curves)}


@pytest.mark.slow
def test_fourteen_panels_in_the_order_of_the_paper(panels: dict[str, Panel]) -> None:
    assert list(panels) == [
        "4a",
        "4b",
        "4c",
        "4d",
        "4e",
        "4f",
        "5a",
        "5b",
        "6a",
        "6b",
        "7a",
        "7b",
        "8a",
        "8b",
    ]


def test_columns_name_units_and_are_distinct(panels: dict[str, Panel]) -> None:
    dimensionless = {"fractal_dimension", "friction_coefficient"}
    for panel in panels.values():
        assert len(panel.columns) == 1 + len(panel.curves)
        for column in panel.columns:
            assert column in dimensionless or column.endswith(
                ("_N", "_mm", "_N_per_mm", "_Nm", "_Nm_per_rad")
            )
        assert panel.y.unit


def test_every_curve_has_the_length_of_its_abscissa(panels: dict[str, Panel]) -> None:
    for panel in panels.values():
        assert all(values.shape == panel.abscissa.shape for values in panel.curves.values())
        assert np.all(np.diff(panel.abscissa) > 0.0)


def test_units_are_converted(panels: dict[str, Panel], curves: Curves) -> None:
    assert panels["4d"].abscissa[-1] == pytest.approx(1e-8)  # mm
    assert panels["4e"].abscissa[-1] == pytest.approx(50.0)  # mm
    at_end = panels["4d"].curves[""][-1]
    assert at_end == pytest.approx(3.904e6, rel=2e-4)  # N/mm, model reference at D = 1.4


def test_interchanged_captions_are_noted(panels: dict[str, Panel]) -> None:
    assert panels["4e"].x.column == "second_radius_mm"  # as Table 1 has it
    assert panels["4f"].x.column == "contact_length_mm"
    assert "caption" in panels["4e"].note


def test_friction_panel_leaves_the_unloaded_joint_out(panels: dict[str, Panel]) -> None:
    assert list(panels["8b"].curves) == ["1", "2", "3", "4", "5"]

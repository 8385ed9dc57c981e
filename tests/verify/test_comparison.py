"""The comparison: each route against a statement that does not come from it."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.verify.comparison import QUANTITIES, Sample, compare, comparison_figure

STEEL = {"youngs_modulus": 206e9, "poisson_ratio": 0.3, "hardness": 1.26e9}
FORCE = np.array([1.0, 10.0])


def sample(dimension):
    return Sample(
        fractal_dimension=dimension,
        fractal_roughness=1e-11,
        frequency_ratio=1.5,
        side=1e-3,
        points=64,
        waves_per_side=2.0,
        pixels_per_wave=8.0,
        **STEEL,
    )


@pytest.fixture(scope="module")
def elastic_regime():
    calls = []
    found = compare(sample(1.7), seeds=2, relative_pressures=[0.02, 0.1], solved=lambda: calls.append(1))
    assert len(calls) == 4
    return found


@pytest.mark.slow
def test_persson_meets_the_boundary_elements_within_its_known_error(elastic_regime):
    """Area 10-20 % low in the literature, plus the rim of the pixels; mean stiffness of two small maps to 25 %."""
    found = elastic_regime
    area = np.asarray(found.persson_real_contact_area / found.real_contact_area)
    assert np.all((area > 0.5) & (area < 0.95))
    stiffness = np.asarray(found.persson_normal_stiffness / found.normal_stiffness).mean(axis=0)
    assert np.all((stiffness > 0.75) & (stiffness < 1.25))


@pytest.mark.slow
def test_tangential_over_normal_is_mindlins_ratio(elastic_regime):
    ratio = np.asarray(elastic_regime.tangential_stiffness / elastic_regime.normal_stiffness)
    np.testing.assert_allclose(ratio, 2.0 * 0.7 / 1.7, rtol=0.02)


@pytest.mark.slow
def test_without_elastic_spots_all_agree_on_the_area_of_a_plastic_contact():
    """D = 1.2 at this G: load over hardness, the only thing an all-plastic contact can do."""
    found = compare(sample(1.2), seeds=1, relative_pressures=[0.05])
    expected = float(found.normal_force[0]) / 1.26e9
    assert float(found.real_contact_area[0, 0]) == pytest.approx(expected, rel=0.05)
    assert float(found.law_real_contact_area[0]) == pytest.approx(expected, rel=1e-9)
    assert float(found.law_normal_stiffness[0]) == 0.0
    assert float(found.capped_fraction[0, 0]) > 0.9


@pytest.mark.slow
def test_elastic_solutions_know_no_hardness():
    found = compare(sample(1.3), seeds=1, relative_pressures=[0.1], elastic=True)
    capped = compare(sample(1.3), seeds=1, relative_pressures=[0.1])
    assert float(found.real_contact_area[0, 0]) < float(capped.real_contact_area[0, 0])


@pytest.mark.parametrize(("seeds", "pressures"), [(0, [0.1]), (1, []), (1, [0.2, 0.1]), (1, [1.5])])
def test_bad_series_are_named(seeds, pressures):
    with pytest.raises(InputError, match=f"seeds = {seeds}"):
        compare(sample(1.4), seeds=seeds, relative_pressures=pressures)


@pytest.fixture
def figure():
    found = {"normal_force": FORCE}
    for name in QUANTITIES:
        found[name] = np.array([[1.0, 8.0], [3.0, 12.0]])  # two seeds: means 2 and 10
        found[f"law_{name}"] = np.array([0.0, 15.0])  # no elastic spot at the smaller load
        found[f"persson_{name}"] = np.array([[2.0, 5.0], [6.0, 15.0]])  # means 4 and 10
    return comparison_figure([SimpleNamespace(fractal_dimension=1.4)], [SimpleNamespace(**found)])


def test_units_are_on_every_axis(figure, tmp_path):
    labels = [a.get_ylabel() for a in figure.axes] + [a.get_xlabel() for a in figure.axes[3:]]
    assert all("[" in label for label in labels)
    figure.savefig(tmp_path / "figure.png")


def test_curves_are_means_and_ratios_of_them(figure):
    above, below = figure.axes[0], figure.axes[3]
    points, law, theory = (above.lines[i].get_ydata() for i in (0, -2, -1))
    np.testing.assert_allclose(points, [2.0, 10.0])
    np.testing.assert_allclose(law, [np.nan, 15.0])
    np.testing.assert_allclose(theory, [4.0, 10.0])
    np.testing.assert_allclose(below.lines[0].get_ydata(), [np.nan, 1.5])
    np.testing.assert_allclose(below.lines[1].get_ydata(), [2.0, 1.0])
    # the scatter of the seeds, 1/2 and 2/10 of the mean, either way
    band = below.collections[0].get_paths()[0].vertices
    assert band[:, 1].max() == pytest.approx(1.5)
    assert band[:, 1].min() == pytest.approx(1.0 / 1.5)
    assert above.get_legend_handles_labels()[1] == ["D = 1.4"]

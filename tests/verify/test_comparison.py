"""The comparison: each route against a statement that does not come from it."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.verify.comparison import Sample, compare

STEEL = {"youngs_modulus": 206e9, "poisson_ratio": 0.3, "hardness": 1.26e9}


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

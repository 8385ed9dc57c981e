"""Means over two punch pressures against Bessel functions; sums over sectors and modes against their terms."""

import math

import jax
import numpy as np
import pytest
from scipy.special import j0

from asperity.body.annulus_modes import Wall, added_compliance, support_weights
from asperity.body.rim_kernel import separated_sums
from asperity.body.rim_moments import (
    MOMENTS,
    closed_kernel,
    other_rim,
    walls_resolved,
    weighted_mean,
)


@pytest.mark.parametrize("mode", [3, 40])
def test_a_mode_is_weighted_with_both_bessel_functions(mode):
    """cos(n theta) becomes J0(n a) J0(n b) cos(n theta), the Fourier coefficients of two punches."""
    a, b, angle = 4e-3, 7e-3, 0.3
    kernel = np.array([(-(mode**2.0)) ** k * math.cos(mode * angle) for k in range(MOMENTS)])
    found = float(weighted_mean(kernel, np.asarray(a**2), np.asarray(b**2)))
    assert found == pytest.approx(j0(mode * a) * j0(mode * b) * math.cos(mode * angle), rel=1e-9)


def test_sectors_add_up():
    angle, plus, minus = np.array([0.0, 0.4]), np.array([1.8, 1.0]), np.array([1.0, 1.8])
    found = jax.jit(closed_kernel)(angle=angle, plus=plus, minus=minus, sectors=np.array([5.0, 3.0]))
    for place, sectors in ((0, 5), (1, 3)):
        turned = [angle[place] + 2.0 * math.pi * k / sectors for k in range(sectors)][
            1 if place == 0 else 0 :
        ]
        sums = [separated_sums(angle=each, second_moment=0.0, fourth_moment=0.0) for each in turned]
        straight = sum(float(plus[place] * s.cosine_plus + minus[place] * s.cosine_minus) for s in sums)
        crossed = sum(float(plus[place] * s.sine_plus - minus[place] * s.sine_minus) for s in sums)
        assert float(found.radial[0, place]) == pytest.approx(straight, rel=1e-12)
        assert float(found.tangential[0, place]) == pytest.approx(straight, rel=1e-12)
        assert float(found.coupling[0, place]) == pytest.approx(crossed, abs=1e-12)


def test_derivatives_of_the_closed_sums_by_differences():
    def sums(angle):
        return closed_kernel(
            angle=np.asarray([angle]),
            plus=np.array([1.8]),
            minus=np.array([1.0]),
            sectors=np.array([1.0]),
        )

    step, here = 1e-2, sums(0.7)
    near = [sums(0.7 + k * step) for k in (-1, 0, 1)]
    for part in ("radial", "coupling"):
        values = [float(getattr(each, part)[0, 0]) for each in near]
        second = (values[0] - 2 * values[1] + values[2]) / step**2
        assert float(getattr(here, part)[1, 0]) == pytest.approx(second, rel=2e-3)
        curved = [float(getattr(each, part)[1, 0]) for each in near]
        fourth = (curved[0] - 2 * curved[1] + curved[2]) / step**2
        assert float(getattr(here, part)[2, 0]) == pytest.approx(fourth, rel=2e-2)


@pytest.mark.parametrize(("side", "ratio", "sectors"), [(-1.0, 1.15, 3.0), (1.0, 0.6, 1.0)])
def test_modes_of_the_far_rim_add_up(side, ratio, sectors):
    free = support_weights(support_stiffness=0.0, radius=1.0, shear_modulus=1.0)
    wall = Wall(side, ratio, 1.8, free, free)
    angle, alone = 0.5, sectors == 1.0
    found = other_rim(
        wall=wall, angle=np.array([angle]), sectors=np.asarray(sectors), one_sector=np.array([alone])
    )
    first = 2.0 if alone else sectors
    modes = first + sectors * np.arange(400)
    terms = added_compliance(mode=np.asarray(modes), decay=np.asarray((ratio**side) ** modes), wall=wall)
    for k in range(3):
        power = sectors * (-(modes**2)) ** k
        # without the translation of the mode 1, which belongs to a body of one sector
        shift = (-1.0) ** k
        plain = float(np.sum(power * np.asarray(terms.radial) * np.cos(modes * angle)))
        cross = float(np.sum(power * np.asarray(terms.coupling) * np.sin(modes * angle)))
        if alone:
            from asperity.body.rigid_modes import translation_compliance

            moved = translation_compliance(wall)
            plain += shift * float(moved.radial) * math.cos(angle)
            cross += shift * float(moved.coupling) * math.sin(angle)
        assert float(found.radial[k, 0]) == pytest.approx(plain, rel=1e-8 if k == 0 else 1e-6)
        assert float(found.coupling[k, 0]) == pytest.approx(cross, rel=1e-8 if k == 0 else 1e-6)


def test_walls_from_one_percent_of_the_radius_are_resolved():
    assert bool(walls_resolved(ratio=1.0 / 1.012, sectors=3.0, one_sector=False))
    assert not bool(walls_resolved(ratio=1.0 / 1.002, sectors=3.0, one_sector=False))
    assert bool(walls_resolved(ratio=0.98, sectors=3.0, one_sector=True))
    assert not bool(walls_resolved(ratio=0.99, sectors=3.0, one_sector=True))

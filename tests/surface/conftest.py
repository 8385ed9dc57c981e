"""Surfaces and spectra whose fractal parameters are known."""

import numpy as np
import pytest

from asperity.surface.spectrum import BinnedSpectrum
from asperity.surface.synthesis import self_affine_profile
from asperity.surface.topography import Topography


@pytest.fixture(scope="session")
def profile():
    """Maker of random profiles of D = 1.5 by their seed."""

    def make(seed, spacing=1e-7, G=1e-9):
        z = self_affine_profile(
            points=2000,
            spacing=spacing,
            fractal_dimension=1.5,
            fractal_roughness=G,
            random=np.random.default_rng(seed),
        )
        return Topography(z, spacing, source=f"p{seed}")

    return make


@pytest.fixture(scope="session")
def exact():
    """Maker of the spectrum of one profile that follows a density [m^3] of the frequency [1/m] without scatter."""

    def make(density, points=20000, independent=50.0):
        f = np.geomspace(1e2, 1e6, 80)
        return BinnedSpectrum(
            frequency=f,
            spread=np.zeros(80),
            ordinates=np.ones(80, dtype=np.int64),
            independent=np.full(80, independent),
            density=density(f),
            profiles=1,
            points=points,
            spacing=0.5e-6,
            rows_of_a_map=False,
        )

    return make

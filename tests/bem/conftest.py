"""Grids and surfaces shared by the boundary-element tests."""

import numpy as np
import pytest

from asperity.bem import ElasticPair, PeriodicHalfSpace, normal_contact


def axis(points, spacing):
    """Positions centred on the middle point."""
    return (np.arange(points) - points // 2) * spacing


def rough_surface(n=64, seed=0):
    """Periodic isotropic self-affine surface, Hurst exponent 0.8, waves n/2 to 8 pixels long, rms slope 1."""
    rng = np.random.default_rng(seed)
    q = 2.0 * np.pi * np.fft.fftfreq(n, 1.0 / n)
    qx, qy = np.meshgrid(q, q[: n // 2 + 1], indexing="ij")
    size = np.hypot(qx, qy)
    band = (size >= 2.0 * np.pi * 2) & (size <= 2.0 * np.pi * n / 8)
    spectrum = np.where(band, np.maximum(size, 1.0) ** -1.8, 0.0) * np.fft.rfft2(rng.standard_normal((n, n)))
    slopes = [np.fft.irfft2(1j * k * spectrum, s=(n, n)) for k in (qx, qy)]
    return np.fft.irfft2(spectrum, s=(n, n)) / np.sqrt(sum(np.mean(s**2) for s in slopes))


@pytest.fixture(scope="session")
def rough_half_space():
    """Unit square, contact modulus 1, Poisson's ratio 0.3."""
    pair = ElasticPair(contact_modulus=1.0, antiplane_modulus=0.35, dundurs_constant=0.0)
    return PeriodicHalfSpace(pair, shape=(64, 64), pixel_size=(1 / 64, 1 / 64))


@pytest.fixture(scope="session")
def rough_heights():
    return rough_surface()


@pytest.fixture(scope="session")
def rough_contact(rough_half_space, rough_heights):
    return normal_contact(rough_half_space, rough_heights, normal_force=0.05, tolerance=1e-10)


def pytest_collection_modifyitems(items):
    """Boundary elements are written for JAX, and their tests look at parts of its programs."""
    for item in items:
        if item.path.parent.name == "bem":
            item.add_marker(pytest.mark.programs("boundary elements are programs of JAX"))

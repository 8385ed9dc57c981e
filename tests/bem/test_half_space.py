"""The periodic response: single waves in closed form, symmetry, and the rough inverse."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.bem import ElasticPair, FreeHalfSpace, HalfSpace, PeriodicHalfSpace
from asperity.bem.elastic_pair import inside, positive
from asperity.bem.half_space import field_on_grid, grid, nearest_neighbour_weights, weighted_neighbours
from asperity.errors import InputError

PAIR = ElasticPair(contact_modulus=3.0, antiplane_modulus=1.1, dundurs_constant=0.0)
SHAPE, PIXEL = (16, 12), (0.5, 0.7)
HALF_SPACE = PeriodicHalfSpace(PAIR, shape=SHAPE, pixel_size=PIXEL)
X, Y = np.meshgrid(np.arange(16) * 0.5, np.arange(12) * 0.7, indexing="ij")
QX, QY = 2 * np.pi * 2 / 8.0, 2 * np.pi * 3 / 8.4
Q = np.hypot(QX, QY)
WAVE = np.cos(QX * X + QY * Y)


def test_a_pressure_wave_moves_the_surface_by_two_over_modulus_and_wavenumber():
    found = HALF_SPACE.normal_displacement(jnp.array(WAVE))
    np.testing.assert_allclose(found, 2.0 / (PAIR.contact_modulus * Q) * WAVE, atol=1e-14)


def test_shear_along_the_wave_moves_like_pressure_and_shear_across_it_like_antiplane_strain():
    along, across = np.array([QX, QY]) / Q, np.array([-QY, QX]) / Q
    for direction, compliance in (
        (along, 2.0 / (PAIR.contact_modulus * Q)),
        (across, 1.0 / (PAIR.antiplane_modulus * Q)),
    ):
        traction = direction[:, None, None] * WAVE
        found = HALF_SPACE.shear_displacement(jnp.array(traction))
        np.testing.assert_allclose(found, compliance * traction, atol=1e-14)


def test_one_component_is_the_diagonal_of_both():
    rng = np.random.default_rng(3)
    traction = rng.standard_normal(SHAPE)
    for axis in (0, 1):
        both = np.zeros((2, *SHAPE))
        both[axis] = traction
        np.testing.assert_allclose(
            HALF_SPACE.aligned_shear_displacement(jnp.array(traction), axis),
            HALF_SPACE.shear_displacement(jnp.array(both))[axis],
            atol=1e-14,
        )


def test_a_uniform_traction_moves_nothing():
    assert float(jnp.abs(HALF_SPACE.normal_displacement(jnp.ones(SHAPE))).max()) < 1e-14


def test_maxwell_and_betti_the_shear_response_is_symmetric():
    rng = np.random.default_rng(1)
    a, b = jnp.array(rng.standard_normal((2, 2, *SHAPE)))
    left = float(jnp.sum(a * HALF_SPACE.shear_displacement(b)))
    assert left == pytest.approx(float(jnp.sum(b * HALF_SPACE.shear_displacement(a))), rel=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize(("shape", "pixel"), [((10,), (0.3,)), ((9, 14), (0.3, 0.5))])
def test_the_nearest_neighbour_operator_is_symmetric_and_positive(shape, pixel):
    weights = nearest_neighbour_weights(shape, jnp.array(pixel))
    size = int(np.prod(shape))
    matrix = np.asarray(weighted_neighbours(jnp.eye(size).reshape(size, *shape), weights)).reshape(size, size)
    np.testing.assert_allclose(matrix, matrix.T, atol=1e-14)
    assert np.linalg.eigvalsh(matrix).min() > 0.0


def test_a_strip_is_one_axis_with_two_shear_directions():
    strip = PeriodicHalfSpace(PAIR, shape=(16,), pixel_size=(0.5,))
    wave = np.cos(QX * X[:, 0])
    found = strip.shear_displacement(jnp.array([wave, wave]))
    np.testing.assert_allclose(found[0], 2.0 / (PAIR.contact_modulus * QX) * wave, atol=1e-14)
    np.testing.assert_allclose(found[1], 1.0 / (PAIR.antiplane_modulus * QX) * wave, atol=1e-14)
    assert strip.force_unit == "N/m"


@pytest.mark.parametrize(
    ("shape", "pixel", "named"),
    [
        ((8, 8), (1.0,), "one pixel size per axis"),
        ((8, 1), (1.0, 1.0), "at least 2"),
        ((8,), (0.0,), "pixel_size = 0 m"),
    ],
)
def test_a_grid_that_is_none_is_refused(shape, pixel, named):
    with pytest.raises(InputError, match=named):
        PeriodicHalfSpace(PAIR, shape=shape, pixel_size=pixel)


def test_positive():
    assert positive("length", 2, "m") == 2.0
    assert positive("length", np.inf, "m", infinite=True) == np.inf


@pytest.mark.parametrize(
    ("value", "infinite", "said"),
    [
        (0.0, False, "length = 0 m: it must be positive and finite"),
        (-3.0, True, "length = -3 m: it must be positive$"),
        (np.nan, True, "length = nan m: it must be positive$"),
        (np.inf, False, "length = inf m: it must be positive and finite"),
    ],
)
def test_what_is_not_positive(value, infinite, said):
    with pytest.raises(InputError, match=said):
        positive("length", value, "m", infinite=infinite)


def test_inside_takes_the_upper_bound_but_not_the_lower():
    assert inside("poisson_ratio", 0.5, -1.0, 0.5) == 0.5
    for value in (-1.0, 0.51, np.nan):
        with pytest.raises(InputError, match=r"poisson_ratio = .*: it must lie above -1 and be at most 0\.5"):
            inside("poisson_ratio", value, -1.0, 0.5)


def test_a_field_becomes_double_and_keeps_its_numbers():
    found = field_on_grid("height", np.array([[1, 2], [3, 4]], dtype=np.float32), (2, 2))
    assert found.dtype == np.float64
    np.testing.assert_array_equal(found, [[1.0, 2.0], [3.0, 4.0]])


def test_a_field_of_another_shape_or_with_holes():
    with pytest.raises(InputError, match=r"height has shape \(3,\): the grid of the half-space has \(4,\)"):
        field_on_grid("height", np.zeros(3), (4,))
    with pytest.raises(InputError, match="height has 2 of 4 values that are not finite"):
        field_on_grid("height", [0.0, np.nan, np.inf, 1.0], (4,))


def test_grids_of_one_and_two_axes():
    points, spacing = grid((4, 8), (1e-6, 2e-6))
    assert points == (4, 8)
    np.testing.assert_array_equal(spacing, [1e-6, 2e-6])
    assert grid((2,), (1.0,))[0] == (2,)


@pytest.mark.parametrize(
    ("shape", "pixel"), [((1,), (1.0,)), ((4, 4, 4), (1.0, 1.0, 1.0)), ((4, 4), (1.0,)), ((4,), (0.0,))]
)
def test_what_is_no_grid(shape, pixel):
    with pytest.raises(InputError, match=r"a grid has one or two axes|pixel_size = 0 m"):
        grid(shape, pixel)


@pytest.mark.parametrize("kind", [PeriodicHalfSpace, FreeHalfSpace])
def test_jax_copies_a_half_space_and_computes_nothing_anew(kind):
    half_space = kind(PAIR, shape=(6, 8), pixel_size=(1e-6, 2e-6))
    doubled = jax.tree.map(lambda leaf: 2.0 * leaf, half_space)
    assert type(doubled) is kind
    assert doubled.shape == (6, 8)
    np.testing.assert_array_equal(doubled.pixel_size, [2e-6, 4e-6])
    pressure = jnp.zeros((6, 8)).at[2, 3].set(1e6)
    np.testing.assert_array_equal(
        doubled.normal_displacement(pressure), 2.0 * half_space.normal_displacement(pressure)
    )


def test_a_surface_without_responses_is_no_half_space():
    with pytest.raises(TypeError, match="abstract"):
        HalfSpace(PAIR, shape=(2, 2), pixel_size=jnp.ones(2), _operators=None)

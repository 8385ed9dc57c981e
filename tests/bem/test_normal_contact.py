"""Normal contact against Hertz, Westergaard, CONTACT, asperity tables, and its own first principles."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.bem import ElasticPair, FreeHalfSpace, PeriodicHalfSpace, elastic_pair, normal_contact
from asperity.errors import InputError, NoSolutionError

UNLIKE = elastic_pair(
    youngs_modulus_1=206e9, youngs_modulus_2=70e9, poisson_ratio_1=0.3, poisson_ratio_2=0.33
)


def centred(points, spacing):
    return (np.arange(points) - points // 2) * spacing


def sphere(points, spacing, radius):
    x = centred(points, spacing)
    return -(x[:, None] ** 2 + x**2) / (2.0 * radius)


def test_hertz_point_contact_of_unlike_spheres():
    """Johnson 1985, (4.22)-(4.24); 16 pixels to the radius: 0.1 %, and 1.5 % for the area counted in pixels."""
    E, R, F = UNLIKE.contact_modulus, 10e-3, 100.0
    a = (3.0 * F * R / (4.0 * E)) ** (1 / 3)
    n, spacing = 41, a / 16
    found = normal_contact(
        FreeHalfSpace(UNLIKE, shape=(n, n), pixel_size=(spacing, spacing)),
        sphere(n, spacing, R),
        normal_force=F,
    )
    assert float(found.approach) == pytest.approx(a**2 / R, rel=1e-3)
    assert float(found.pressure.max()) == pytest.approx(3.0 * F / (2.0 * np.pi * a**2), rel=1e-3)
    assert float(found.real_contact_area) == pytest.approx(np.pi * a**2, rel=1.5e-2)
    x = centred(n, spacing)
    hertz = np.sqrt(np.maximum(1.0 - (x[:, None] ** 2 + x**2) / a**2, 0.0)) * 3.0 * F / (2.0 * np.pi * a**2)
    inside = x[:, None] ** 2 + x**2 < (0.9 * a) ** 2
    assert np.abs(np.asarray(found.pressure) - hertz)[inside].max() < 4e-3 * hertz.max()


def test_contact_of_kalkers_ball_by_the_program_contact():
    """Case 'cattaneo' of CONTACT's examples (Vollebregt, Kalker; Apache-2.0), same 19 x 19 grid: all digits
    printed.

    G = 200 MPa, nu = 0.42, R = 50 mm, Fn = 9.1954 N: approach 1.998e-2 mm, pmax 4.393 MPa, 177 elements.
    """
    young = 2.0 * 200e6 * 1.42
    pair = elastic_pair(
        youngs_modulus_1=young, youngs_modulus_2=young, poisson_ratio_1=0.42, poisson_ratio_2=0.42
    )
    spacing = 0.13333e-3
    found = normal_contact(
        FreeHalfSpace(pair, shape=(19, 19), pixel_size=(spacing, spacing)),
        sphere(19, spacing, 50e-3),
        normal_force=9.1954,
    )
    assert round(float(found.approach) * 1e3, 5) == 1.998e-2
    assert round(float(found.pressure.max()) / 1e6, 3) == 4.393
    assert int((found.pressure > 0.0).sum()) == 177


def test_hertz_line_contact():
    """Johnson 1985, (4.43)-(4.45); 1.28 MN/m on steel on aluminium, far reference for the approach."""
    E, R, load, far = UNLIKE.contact_modulus, 10e-3, 1.28e6, 0.5
    b = np.sqrt(4.0 * load * R / (np.pi * E))
    n, spacing = 129, b / 50
    strip = FreeHalfSpace(UNLIKE, shape=(n,), pixel_size=(spacing,), reference_distance=far)
    found = normal_contact(strip, -(centred(n, spacing) ** 2) / (2.0 * R), normal_force=load)
    assert float(found.pressure.max()) == pytest.approx(2.0 * load / (np.pi * b), rel=1e-4)
    assert float(found.real_contact_area) == pytest.approx(2.0 * b, rel=2e-2)
    approach = (
        2.0 * load / (np.pi * E) * (np.log(2.0 * far / b) + 0.5)
    )  # from Johnson (2.43) for the Hertz ellipse
    assert float(found.approach) == pytest.approx(approach, rel=1e-5)


def test_line_contact_of_contacts_carter2d():
    """Cylinder R = 500 mm, G = 82 GPa, nu = 0.28, 35780 N over 200 mm: CONTACT prints pmax = 113.9 MPa."""
    young = 2.0 * 82e9 * 1.28
    pair = elastic_pair(
        youngs_modulus_1=young, youngs_modulus_2=young, poisson_ratio_1=0.28, poisson_ratio_2=0.28
    )
    strip = FreeHalfSpace(pair, shape=(129,), pixel_size=(2e-5,), reference_distance=0.5)
    heights = -(centred(129, 2e-5) ** 2) / (2.0 * 0.5)
    found = normal_contact(strip, heights, normal_force=35780.0 / 0.2)
    assert float(found.pressure.max()) / 1e6 == pytest.approx(113.9, abs=0.05)


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_westergaards_wavy_surface(share):
    """Johnson 1985, section 13.2: p/p* = sin^2(pi a/lambda) and the peak pressure 2 sqrt(p p*)."""
    n, wavelength, amplitude = 256, 1e-3, 1e-6
    strip = PeriodicHalfSpace(UNLIKE, shape=(n,), pixel_size=(wavelength / n,))
    closing = np.pi * UNLIKE.contact_modulus * amplitude / wavelength
    heights = amplitude * np.cos(2.0 * np.pi * np.arange(n) / n)
    found = normal_contact(strip, heights, normal_force=share * closing * wavelength)
    assert float(found.contact_fraction) == pytest.approx(
        2.0 / np.pi * np.arcsin(np.sqrt(share)), abs=1.0 / n
    )
    assert float(found.pressure.max()) == pytest.approx(2.0 * closing * np.sqrt(share), rel=1e-4)


def test_waves_pressed_flat_carry_their_own_pressure_wave():
    """Above p* the contact is complete and linear: p = p_mean + p* cos, whatever the load."""
    n = 256
    strip = PeriodicHalfSpace(ElasticPair(1.0, 0.5, 0.0), shape=(n,), pixel_size=(1.0 / n,))
    wave = np.cos(2.0 * np.pi * np.arange(n) / n)
    found = normal_contact(strip, 1e-3 * wave, normal_force=0.01)
    np.testing.assert_allclose(found.pressure, 0.01 + np.pi * 1e-3 * wave, atol=1e-9)
    assert float(found.contact_fraction) == 1.0


#: Porter & Brake 2023 (tmdsimpy, MIT): normal_asperity.yaml, elastic branch. E [Pa], nu, R [m], approach [m],
#: force [N], contact radius [m]. The tables' E and nu are of one body on its like, R of one sphere on its
# like.
ASPERITIES = [
    (1.92e11, 0.3, 1.4e-3, 8.815764255743e-08, 1.377598138669e-01, 1.110948691796e-05),
    (2.50e11, 0.2, 5.0e-3, 6.552213226661e-08, 2.058944081667e-01, 1.810001826886e-05),
]


@pytest.mark.parametrize(("young", "nu", "radius", "approach", "force", "contact_radius"), ASPERITIES)
def test_elastic_asperities_of_a_measured_joint(young, nu, radius, approach, force, contact_radius):
    pair = elastic_pair(
        youngs_modulus_1=young, youngs_modulus_2=young, poisson_ratio_1=nu, poisson_ratio_2=nu
    )
    n, spacing = 41, contact_radius / 16
    half_space = FreeHalfSpace(pair, shape=(n, n), pixel_size=(spacing, spacing))
    found = normal_contact(half_space, sphere(n, spacing, radius), normal_force=force)
    assert float(found.approach) == pytest.approx(approach, rel=1e-3)
    assert float(found.real_contact_area) == pytest.approx(np.pi * contact_radius**2, rel=1.5e-2)


def test_complementarity_and_balance_on_a_rough_surface(rough_contact):
    pressure, gap = np.asarray(rough_contact.pressure), np.asarray(rough_contact.gap)
    scale = float(np.std(gap))
    assert pressure.min() == 0.0
    assert gap.min() > -1e-8 * scale
    assert np.abs(gap[pressure > 0.0]).max() < 1e-8 * scale
    assert pressure.mean() == pytest.approx(0.05, rel=1e-12)
    assert float(rough_contact.load_balance_error) < 1e-12
    assert 0.0 < float(rough_contact.residual) <= 1e-10
    assert 0 < int(rough_contact.iterations) < 100


def test_scaling_heights_and_load_together_scales_the_pressure(
    rough_half_space, rough_heights, rough_contact
):
    scaled = normal_contact(rough_half_space, 3.0 * rough_heights, normal_force=0.15, tolerance=1e-10)
    np.testing.assert_allclose(scaled.pressure, 3.0 * rough_contact.pressure, atol=1e-8)


def test_a_nearby_start_changes_the_iterations_and_not_the_result(
    rough_half_space, rough_heights, rough_contact
):
    again = normal_contact(
        rough_half_space, rough_heights, normal_force=0.05, start=rough_contact, tolerance=1e-10
    )
    np.testing.assert_allclose(again.pressure, rough_contact.pressure, atol=1e-8)
    assert int(again.iterations) < int(rough_contact.iterations)


def test_the_energy_is_the_work_of_the_load(rough_half_space, rough_heights):
    """dU/d(approach) = F: an independent check of load, approach and pressure together."""
    energy, approach = [], []
    for force in (0.049, 0.05, 0.051):
        found = normal_contact(rough_half_space, rough_heights, normal_force=force, tolerance=1e-11)
        energy.append(0.5 * float(jnp.sum(found.pressure * found.displacement) * rough_half_space.pixel_area))
        approach.append(float(found.approach))
    assert (energy[2] - energy[0]) / (approach[2] - approach[0]) == pytest.approx(0.05, rel=1e-3)


def test_hardness_caps_the_pressure_and_spreads_the_load(rough_half_space, rough_heights, rough_contact):
    limit = 0.4
    capped = normal_contact(
        rough_half_space, rough_heights, normal_force=0.05, hardness=limit, tolerance=1e-10
    )
    pressure, gap = np.asarray(capped.pressure), np.asarray(capped.gap)
    assert pressure.max() == limit
    assert pressure.mean() == pytest.approx(0.05, rel=1e-12)
    assert capped.contact_fraction > rough_contact.contact_fraction
    assert gap[pressure == limit].max() < 1e-9  # flown material: the surfaces overlap there, and nowhere else
    assert np.abs(gap[(pressure > 0.0) & (pressure < limit)]).max() < 1e-8


def test_a_soft_body_yields_almost_everywhere_it_touches(rough_half_space, rough_heights):
    """Hardness far below E times slope: the area tends to load over hardness (Bowden and Tabor)."""
    hardness = 0.02
    found = normal_contact(rough_half_space, rough_heights, normal_force=0.1 * hardness, hardness=hardness)
    assert 0.1 < float(found.contact_fraction) < 0.105
    assert int(found.iterations) < 60


def test_a_hardness_beyond_every_pressure_changes_nothing(rough_half_space, rough_heights, rough_contact):
    limit = 2.0 * float(rough_contact.pressure.max())
    free = normal_contact(rough_half_space, rough_heights, normal_force=0.05, hardness=limit, tolerance=1e-10)
    np.testing.assert_allclose(free.pressure, rough_contact.pressure, atol=1e-8)


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"normal_force": 0.0}, "normal_force = 0 N: it must be positive"),
        ({"normal_force": 0.5, "hardness": 0.4}, "carries less than 0.4 N"),
        ({"heights": np.zeros((8, 8))}, r"heights has shape \(8, 8\)"),
        ({"heights": np.full((64, 64), np.nan)}, "4096 of 4096 values"),
        ({"tolerance": 0.0}, "tolerance = 0"),
    ],
)
def test_bad_input_is_named(rough_half_space, rough_heights, change, named):
    arguments = {"heights": rough_heights, "normal_force": 0.05} | change
    heights = arguments.pop("heights")
    with pytest.raises(InputError, match=named):
        normal_contact(rough_half_space, heights, **arguments)


def test_an_unconverged_state_is_an_error(rough_half_space, rough_heights):
    with pytest.raises(NoSolutionError, match=r"not converged after 3 iterations.*tolerance 1e-08"):
        normal_contact(rough_half_space, rough_heights, normal_force=0.05, max_iterations=3)

"""A joint with crowned rollers: cylinders as the limit, virtual work, compatibility, integrals over the slices."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.contact.crowned_line import crown_compression, crowned_line
from asperity.contact.hertz_line import peak_pressure
from asperity.contact.rolling_fatigue import BEARING_STEEL, line_contact_life
from asperity.errors import InputError
from asperity.joint.contacts import bulk_springs
from asperity.joint.crowned_contacts import (
    contact_of_slices,
    crown_compliances,
    rough_slices,
    slice_slip_ratios,
)
from asperity.joint.description import joint_contacts
from asperity.joint.solve import refuse_short_contacts
from asperity.rolling.life import sliced_track_lives, track_lives

RADII = np.array([np.inf, 1e5, 2.0, 0.5, 0.1, 0.5])
TORQUES = np.array([5.0, 5.0, 5.0, 5.0, 5.0, 0.02])
#: A steel that stays elastic under every crown, so that the joint has a life [Pa].
HARD = {"yield_strength": 1e10}


@pytest.fixture(scope="module")
def springs_joint(paper_joint):
    return paper_joint(body_model="springs", **HARD)


@pytest.fixture(scope="module")
def crowned(paper_joint, evaluated_together):
    return evaluated_together(
        paper_joint(body_model="springs", drive__planet_crown_radius=RADII, output_torque=TORQUES, **HARD)
    )


@pytest.mark.long
def test_cylinders_are_crowns_of_infinite_radius(springs_joint, crowned, evaluated_together):
    even = evaluated_together(springs_joint)
    for name in ("forces", "contacts", "assembly", "interference", "published"):
        one, many = getattr(even, name), getattr(crowned, name)
        for (path, value), other in zip(
            jax.tree_util.tree_leaves_with_path(one), jax.tree.leaves(many), strict=True
        ):
            if "residual" not in jax.tree_util.keystr(path):
                np.testing.assert_allclose(other[..., 0], value, rtol=1e-9, atol=1e-12, err_msg=name)


def _lines(joint, radius):
    """Length, effective radius and modulus of the contacts, and the curvatures of the planets' crowns."""
    pairs = joint_contacts(joint).pairs
    numbers = {
        "contact_length": float(pairs.contact_length[0]),
        "effective_radius": np.asarray(pairs.effective_radius),
        "contact_modulus": float(pairs.moduli.contact_modulus[0]),
    }
    return numbers, np.array([1.0, 1.0, 1.0, 0.0, 0.0]) / radius


def _approaches(joint, radius, normal):
    """Approach of each contact, the line's by its spring and the crown's by the pure function."""
    contacts = joint_contacts(joint)
    line = bulk_springs(contacts=contacts, half_width=contacts.pairs.half_width(normal)).secant_compliance
    numbers, curvature = _lines(joint, radius)
    crown = jax.jit(crown_compression)(normal_force=normal, crown_curvature=curvature, **numbers)
    return np.asarray(line * normal + crown)


@pytest.mark.long
@pytest.mark.parametrize("place", [2, 4])
def test_closure_and_interference_by_their_definition(springs_joint, crowned, place):
    """(A3) with approaches written anew; the interference is the virtual work of the forces at rest."""
    loaded, rest = crowned.forces.normal[:, place], crowned.rest.normal[:, place]
    at_rest = _approaches(springs_joint, RADII[place], rest)
    sp, pwr, pwl, wro, wlo = _approaches(springs_joint, RADII[place], loaded) - at_rest
    wedge = (35.0**2 + 18.5**2 - 17.5**2) / (2.0 * 35.0 * 18.5)  # law of cosines in the triangle of centres
    theta = -(17.5**2 + 18.5**2 - 35.0**2) / (2.0 * 17.5 * 18.5)
    misfit = 2.0 * theta * sp + pwr + pwl + wedge * (wro + wlo)
    assert abs(misfit) < 1e-9 * np.sum(at_rest)
    work = np.sum(rest * at_rest) / (rest[3] + rest[4])
    assert crowned.interference[place] == pytest.approx(work, rel=1e-9)


@pytest.mark.long
def test_what_more_crown_does(crowned):
    found = jax.tree.map(lambda leaf: leaf[..., :5], crowned)
    assert np.all(found.solved & found.walls_hold & found.contact_law_holds)
    for falls in (
        found.assembly.stiffness.output,
        found.published.output,
        found.rolling.life_hours.drive,
        found.rolling.power.efficiency,
        *found.diagnostics.loaded_length_share[:3],
        *found.diagnostics.end_line_load_ratio[:3],
    ):
        assert np.all(np.diff(falls) <= 0.0)
    for grows in (
        found.interference,
        found.rolling.drift_per_output_turn,
        *found.diagnostics.hertz_pressure[:3],
        *found.diagnostics.peak_line_load_ratio[:3],
        *found.rolling.shakedown_ratio[:3],
        *found.rolling.crown_creepage_factor[:3],
    ):
        assert np.all(np.diff(grows) > -1e-12 * np.abs(grows[:-1]))
    np.testing.assert_allclose(found.diagnostics.loaded_length_share[3:], 1.0)
    np.testing.assert_allclose(found.rolling.crown_creepage_factor[3:], 1.0, rtol=1e-12)


@pytest.mark.long
def test_creep_at_a_small_torque_is_that_of_the_mean_width(springs_joint, crowned):
    """Carter's slope is proportional to the half-width: the slices' mean takes the place of the even one."""
    at = crowned.forces.normal[:, 5]
    numbers, curvature = _lines(springs_joint, RADII[5])
    lines = jax.jit(crowned_line)(normal_force=at, crown_curvature=curvature, **numbers)
    even = np.sqrt(
        4
        * at
        * numbers["effective_radius"]
        / (math.pi * numbers["contact_length"] * numbers["contact_modulus"])
    )
    mean = np.sum(np.asarray(lines.length_share * lines.half_width), axis=0)
    np.testing.assert_allclose(crowned.rolling.crown_creepage_factor[:, 5], even / mean, rtol=2e-3)


@pytest.mark.long
def test_peak_pressure_is_that_of_the_middle(springs_joint, crowned):
    numbers, curvature = _lines(springs_joint, RADII[4])
    lines = jax.jit(crowned_line)(
        normal_force=crowned.forces.normal[:, 4], crown_curvature=curvature, **numbers
    )
    expected = 2 * lines.line_load[0] / (math.pi * lines.half_width[0])
    np.testing.assert_allclose(crowned.diagnostics.hertz_pressure[:, 4], expected, rtol=1e-12)


@pytest.fixture(scope="module")
def pair(springs_joint):
    """One contact with a crown of 0.5 m: pairs, curvature, and its load along the line at 800 N."""
    contacts = joint_contacts(springs_joint)
    first = lambda leaf: leaf[:1] if jnp.ndim(leaf) else leaf  # noqa: E731
    one = jax.tree.map(first, contacts.pairs)
    numbers, _ = _lines(springs_joint, 1.0)
    numbers["effective_radius"] = numbers["effective_radius"][:1]
    force = jnp.array([800.0])
    lines = jax.jit(crowned_line)(normal_force=force, crown_curvature=jnp.array([2.0]), **numbers)
    return one, jax.tree.map(first, contacts), force, lines


@pytest.mark.slow
def test_tangential_compliance_is_jaegers(pair):
    """Integrated over T, the added compliance is mu times a difference of approaches; without the term of the ends."""
    pairs, contacts, force, _ = pair
    steel = contacts.driving
    rigid = dataclasses.replace(steel, poisson_ratio=0.0 * steel.poisson_ratio)  # without that part
    nodes, weights = np.polynomial.legendre.leggauss(8)
    friction = float(pairs.friction_coefficient[0])
    most = 0.8 * friction * float(force[0])
    forces = 0.5 * most * (nodes + 1)
    compliance = jax.jit(crown_compliances)

    def added(tangential):
        return compliance(
            pairs=pairs,
            crown_curvature=jnp.array([2.0]),
            driving=rigid,
            driven=rigid,
            normal_force=force,
            tangential_force=jnp.array([tangential]),
        )

    integral = (
        0.5 * most * sum(w * float(added(t).tangential[0]) for w, t in zip(weights, forces, strict=True))
    )
    lines = {
        "crown_curvature": 2.0,
        "contact_length": pairs.contact_length[0],
        "effective_radius": pairs.effective_radius[0],
        "contact_modulus": pairs.moduli.contact_modulus[0],
    }
    approach = jax.jit(crown_compression)
    difference = approach(normal_force=force[0], **lines) - approach(
        normal_force=force[0] - most / friction, **lines
    )
    assert integral == pytest.approx(friction * float(difference), rel=1e-5)
    assert float(added(2 * friction * 800.0).tangential[0]) == 0.0


@pytest.mark.slow
def test_asperities_add_over_the_slices(pair):
    pairs, contacts, force, lines = pair
    rough = jax.jit(rough_slices, static_argnames="model")
    numbers = {"pairs": pairs, "model": contacts.contact_factor_model}
    slices = rough(lines=lines, normal_force=force, tangential_force=0.2 * force, **numbers)
    whole = contact_of_slices(slices=slices, lines=lines)
    assert float(whole.elastic_load[0] + whole.plastic_load[0]) == pytest.approx(800.0, rel=1e-12)
    even = dataclasses.replace(lines, line_load=0.0 * lines.line_load + force / pairs.contact_length)
    scale = float(jnp.sum(lines.length_share[:, 0]))
    flat = rough(lines=even, normal_force=force, tangential_force=0.2 * force, **numbers)
    found = contact_of_slices(slices=flat, lines=even)
    one = jax.tree.map(lambda leaf: leaf[0], flat)  # every slice is the whole contact
    assert float(found.normal_stiffness[0]) == pytest.approx(
        scale * float(one.normal_stiffness[0]), rel=1e-12
    )
    assert float(found.tangential_stiffness[0]) == pytest.approx(
        scale * float(one.tangential_stiffness[0]), rel=1e-12
    )
    none = rough(lines=lines, normal_force=-force, tangential_force=0.0 * force, **numbers)
    assert float(contact_of_slices(slices=none, lines=lines).normal_stiffness[0]) == 0.0


@pytest.mark.slow
def test_slices_carry_the_tangential_force(pair):
    pairs, _, force, lines = pair
    ratios = jax.jit(slice_slip_ratios)(pairs=pairs, lines=lines, slip_ratio=jnp.array([-0.6]))
    carried = jnp.sum(lines.line_load * lines.length_share * ratios, axis=0) * pairs.contact_length
    assert float(carried[0]) == pytest.approx(-0.6 * float(force[0]), rel=1e-12)
    assert np.all(
        np.diff(np.abs(np.asarray(ratios)[:, 0])) >= 0.0
    )  # narrow slices towards the ends slip first


@pytest.mark.slow
def test_life_by_integration_over_the_line(pair):
    """Failure rates of pieces of track add, weighted by length; for cylinders it is the line's life."""
    pairs, _, force, lines = pair
    pressure = 2 * lines.line_load / (math.pi * lines.half_width)
    found = np.asarray(sliced_track_lives(pairs=pairs, lines=lines, peak_pressure=pressure))
    length = float(pairs.contact_length[0])
    y = np.linspace(0.0, float(lines.loaded_share[0]) * length / 2, 4001)
    # p0^2 and a^2 are both nearly parabolic in y
    width = np.sqrt(
        np.interp(y**2, np.asarray(lines.position[:, 0]) ** 2, np.asarray(lines.half_width[:, 0]) ** 2)
    )
    peak = width * float(pressure[0, 0] / lines.half_width[0, 0])
    pieces = 1e6 * np.asarray(
        line_contact_life(
            peak_pressure=peak,
            half_width=width,
            contact_length=2.0,
            track_radius=pairs.radius_1[0],
            material_constant=BEARING_STEEL,
        )
    )
    rate = np.trapezoid(pieces ** (-10 / 9), y)
    assert found[0, 0] == pytest.approx(rate ** (-0.9), rel=0.01)
    even = peak_pressure(normal_force=force, contact_length=length, half_width=pairs.half_width(force))
    line = track_lives(pairs=pairs, half_width=pairs.half_width(force), peak_pressure=even)
    assert np.all(found < np.asarray(line))


@pytest.mark.long
def test_a_contact_too_short_is_refused(crowned):
    one = jax.tree.map(lambda leaf: leaf[..., 2], crowned)
    refuse_short_contacts(one)
    short = dataclasses.replace(
        one,
        diagnostics=dataclasses.replace(one.diagnostics, slices_hold=np.array([True, False] + [True] * 3)),
    )
    with pytest.raises(InputError, match=r"touch at pwr over a length of .* mm .* larger crown radius"):
        refuse_short_contacts(short)

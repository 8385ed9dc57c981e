"""The whole chain in one readable function: a joint in, its forces, contacts and torsional stiffness out."""

from __future__ import annotations

import math
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

from asperity.contact.fractal import FractalContact, Surface, fractal_contact
from asperity.contact.hertz_line import (
    effective_radius,
    half_width,
    logarithmic_compliance,
    ring_secant_compliance,
    roller_secant_compliance,
)
from asperity.contact.population import ContactFactorModel, contact_factor
from asperity.diagnostics import Diagnostics, diagnose
from asperity.drive.force_balance import (
    Bearings,
    Closure,
    DriveForces,
    Mechanism,
    NormalSprings,
    force_balance,
    rest_state,
)
from asperity.drive.geometry import (
    CONTACT_NAMES,
    DriveAngles,
    DriveGeometry,
    angles,
    carrier_speed,
    contact_radii,
    speed_ratio,
)
from asperity.drive.torsional_stiffness import (
    TorsionalStiffness,
    contact_torsional_stiffness,
    driven_radii,
    series_torsional_stiffness,
)
from asperity.errors import NoSolutionError
from asperity.materials import ContactPair, Material, pair
from asperity.precision import require_double_precision
from asperity.types import Real

#: Largest relative residual of the force balance and of its closure that counts as solved.
BALANCE_TOLERANCE = 1e-9


class Bodies(eqx.Module):
    """Materials of the four bodies of the drive.

    Parameters
    ----------
    sun, planet, loading_roller, ring : Material
        One material each.
    """

    sun: Material
    planet: Material
    loading_roller: Material
    ring: Material


class Joint(eqx.Module):
    """A planetary traction drive under load: everything that decides its stiffness. SI units.

    Numbers may be arrays: every number broadcasts over trailing batch axes, so one joint can stand for a
    million. What differs between contacts is a tuple of one entry (for all) or five, in the order of
    :data:`asperity.drive.geometry.CONTACT_NAMES`.

    Parameters
    ----------
    geometry : DriveGeometry
        Radii and arrangement.
    bodies : Bodies
        Materials.
    surfaces : tuple of Surface
        Fractal roughness, for all contacts or for each.
    contact_lengths : tuple of Real
        Contact line lengths B [m], for all contacts or for each.
    friction_coefficients : tuple of Real
        Friction coefficients mu [-], for all contacts or for each.
    planet_length, loading_roller_length : Real
        Lengths of the solid rollers [m]; they make the masses.
    ring_wall_thickness : Real
        Wall of the outer ring [m]; it enters the normal springs of the ring contacts.
    bearings : Bearings
        Friction of the bearings.
    preload : Real
        Normal force N_0 between sun and planet at rest [N].
    output_torque : Real
        Torque at the carrier [N·m], >= 0.
    sun_speed : Real
        Angular velocity of the sun [rad/s].
    closure : {"elastic", "constant_pin_force"}
        Closure of the force balance, :func:`asperity.drive.force_balance.force_balance`.
    contact_factor_model : {"printed", "hertz_area", "unity"}
        Model of lambda, :func:`asperity.contact.population.contact_factor`.
    """

    geometry: DriveGeometry
    bodies: Bodies
    surfaces: tuple[Surface, ...]
    contact_lengths: tuple[Real, ...]
    friction_coefficients: tuple[Real, ...]
    planet_length: Real
    loading_roller_length: Real
    ring_wall_thickness: Real
    bearings: Bearings
    preload: Real
    output_torque: Real
    sun_speed: Real
    closure: Closure = eqx.field(static=True)
    contact_factor_model: ContactFactorModel = eqx.field(static=True)


class JointResult(eqx.Module):
    """Everything the chain says about a joint. SI units; contact arrays have the contact axis first.

    Parameters
    ----------
    angles : DriveAngles
        alpha, theta and the wedge angle [rad].
    speed_ratio : Real
        Sun over carrier speed [-].
    carrier_speed : Real
        Angular velocity of the carrier [rad/s].
    planet_mass, loading_roller_mass : Real
        Masses of one planet and of one loading roller [kg].
    forces : DriveForces
        Contact and pin forces, torques and the residuals of the balance.
    contacts : FractalContact
        Spots and stiffnesses of the five contacts, shape (5, ...).
    contact_torsional_stiffness : Array
        Each contact's own K_T at its driven roller, shape (5, ...) [N·m/rad].
    published : TorsionalStiffness
        Torsional stiffness as published: the asperities' tangential springs alone.
    diagnostics : Diagnostics
        Limits of the model and how close this joint is to each.
    solved : Array
        True where the balance closed to :data:`BALANCE_TOLERANCE`.
    """

    angles: DriveAngles
    speed_ratio: Real
    carrier_speed: Real
    planet_mass: Real
    loading_roller_mass: Real
    forces: DriveForces
    contacts: FractalContact
    contact_torsional_stiffness: Any
    published: TorsionalStiffness
    diagnostics: Diagnostics
    solved: Array

    def contact(self, name: str) -> dict[str, Array]:
        """All quantities of one contact by name, for reading by eye.

        Parameters
        ----------
        name : {"sp", "pwr", "pwl", "wro", "wlo"}
            Which contact.

        Returns
        -------
        dict
            Name of the quantity → its value, SI.
        """
        index = CONTACT_NAMES.index(name)
        values = {key: value[index] for key, value in vars(self.contacts).items()}
        return {
            "normal_force": self.forces.normal[index],
            "tangential_force": self.forces.tangential[index],
            **values,
            "torsional_stiffness": self.contact_torsional_stiffness[index],
        }


def per_contact(values: tuple[Any, ...]) -> Any:
    """Stack a tuple of one or five like things along a first contact axis of length 1 or 5.

    Parameters
    ----------
    values : tuple
        Numbers or modules of numbers, one for all contacts or one for each.

    Returns
    -------
    The same kind of thing with leaves of shape (1, ...) or (5, ...).
    """
    return jax.tree.map(lambda *leaves: jnp.stack(jnp.broadcast_arrays(*map(jnp.asarray, leaves))), *values)


def contact_pairs(bodies: Bodies) -> ContactPair:
    """Moduli and limits of the five contacts, shape (5, ...).

    Parameters
    ----------
    bodies : Bodies
        Materials.

    Returns
    -------
    ContactPair
        Leaves of shape (5, ...).
    """
    sun_planet = pair(bodies.sun, bodies.planet)
    planet_roller = pair(bodies.planet, bodies.loading_roller)
    roller_ring = pair(bodies.loading_roller, bodies.ring)
    result: ContactPair = per_contact((sun_planet, planet_roller, planet_roller, roller_ring, roller_ring))
    return result


def normal_springs(*, joint: Joint, rest_force: Real) -> NormalSprings:
    """Secant and incremental bulk compliance of the five contacts at rest.

    Parameters
    ----------
    joint : Joint
        The joint.
    rest_force : Real
        Normal forces at rest, shape (5, ...) [N].

    Returns
    -------
    NormalSprings
        Compliances, shape (5, ...) [m/N]: two solid rollers in series, or a roller and the ring's wall.
    """
    geometry, bodies = joint.geometry, joint.bodies
    driving, driven, sign = contact_radii(geometry)
    length = per_contact(joint.contact_lengths)
    width = half_width(
        normal_force=rest_force,
        contact_length=length,
        effective_radius=effective_radius(radius_1=driving, radius_2=driven, sign=sign),
        contact_modulus=contact_pairs(bodies).contact_modulus,
    )
    sun, planet, roller, ring = bodies.sun, bodies.planet, bodies.loading_roller, bodies.ring
    first = per_contact((sun, planet, planet, roller, roller))
    second = per_contact((planet, roller, roller, ring, ring))
    body_1 = {
        "contact_length": length,
        "youngs_modulus": first.youngs_modulus,
        "poisson_ratio": first.poisson_ratio,
    }
    body_2 = {
        "contact_length": length,
        "youngs_modulus": second.youngs_modulus,
        "poisson_ratio": second.poisson_ratio,
    }
    as_roller = roller_secant_compliance(radius=driven, half_width=width, **body_2)
    as_ring = ring_secant_compliance(wall_thickness=joint.ring_wall_thickness, half_width=width, **body_2)
    secant = roller_secant_compliance(radius=driving, half_width=width, **body_1) + jnp.where(
        sign > 0.0, as_roller, as_ring
    )
    bend = logarithmic_compliance(**body_1) + logarithmic_compliance(**body_2)
    return NormalSprings(secant_compliance=secant, incremental_compliance=secant - bend)


def roller_mass(*, density: Real, radius: Real, length: Real) -> Real:
    r"""Mass of a solid roller, :math:`m = \rho \pi R^2 L`.

    Parameters
    ----------
    density : Real
        Density [kg/m^3].
    radius, length : Real
        Radius R and length L [m].

    Returns
    -------
    Real
        Mass [kg].
    """
    return density * math.pi * radius**2 * length


def _with_one_rank(joint: Joint) -> Joint:
    """Give every number the rank of the batch, so that contact and batch axes never meet in broadcasting."""
    leaves = [jnp.asarray(leaf) for leaf in jax.tree.leaves(joint)]
    rank = max(leaf.ndim for leaf in leaves)
    return jax.tree.unflatten(
        jax.tree.structure(joint), [leaf.reshape((1,) * (rank - leaf.ndim) + leaf.shape) for leaf in leaves]
    )


def mechanism(joint: Joint) -> Mechanism:
    """The joint's drive with its masses, springs and speed, ready for the force balance.

    Parameters
    ----------
    joint : Joint
        The joint.

    Returns
    -------
    Mechanism
        Input of :func:`asperity.drive.force_balance.force_balance`.
    """
    geometry = joint.geometry
    rest = rest_state(geometry=geometry, preload=joint.preload)
    return Mechanism(
        geometry=geometry,
        bearings=joint.bearings,
        springs=normal_springs(joint=joint, rest_force=rest.normal_force),
        preload=joint.preload,
        carrier_speed=carrier_speed(geometry=geometry, sun_speed=joint.sun_speed),
        planet_mass=roller_mass(
            density=joint.bodies.planet.density, radius=geometry.planet_radius, length=joint.planet_length
        ),
        loading_roller_mass=roller_mass(
            density=joint.bodies.loading_roller.density,
            radius=geometry.loading_roller_radius,
            length=joint.loading_roller_length,
        ),
        closure=joint.closure,
    )


def evaluate(joint: Joint) -> JointResult:
    """The chain itself: pure, for ``jit``, ``vmap`` and ``grad``; never raises.

    Points without a solution carry ``solved = False`` and must be looked at by the caller;
    :func:`solve` does that.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.

    Returns
    -------
    JointResult
        Everything, in the broadcast shape.
    """
    joint = _with_one_rank(joint)
    geometry = joint.geometry
    drive = mechanism(joint)
    rest = rest_state(geometry=geometry, preload=joint.preload)
    forces = force_balance(mechanism=drive, output_torque=joint.output_torque)

    pairs = contact_pairs(joint.bodies)
    driving, driven, sign = contact_radii(geometry)
    length = per_contact(joint.contact_lengths)
    friction = per_contact(joint.friction_coefficients)
    touching_force = jnp.where(forces.normal > 0.0, forces.normal, 1.0)
    contacts = fractal_contact(
        surface=per_contact(joint.surfaces),
        normal_force=forces.normal,
        tangential_force=jnp.abs(forces.tangential),
        friction_coefficient=friction,
        contact_factor=contact_factor(
            model=joint.contact_factor_model,
            radius_1=driving,
            radius_2=driven,
            sign=sign,
            contact_length=length,
            contact_modulus=pairs.contact_modulus,
            normal_force=touching_force,
        ),
        contact_modulus=pairs.contact_modulus,
        tangential_contact_modulus=pairs.tangential_contact_modulus,
        hardness=pairs.hardness,
    )
    stiffness = contacts.tangential_stiffness
    return JointResult(
        angles=angles(geometry),
        speed_ratio=speed_ratio(geometry),
        carrier_speed=drive.carrier_speed,
        planet_mass=drive.planet_mass,
        loading_roller_mass=drive.loading_roller_mass,
        forces=forces,
        contacts=contacts,
        contact_torsional_stiffness=contact_torsional_stiffness(
            tangential_stiffness=stiffness, radius=driven_radii(geometry)
        ),
        published=series_torsional_stiffness(geometry=geometry, tangential_stiffness=stiffness),
        diagnostics=diagnose(
            geometry=geometry,
            forces=forces,
            contacts=contacts,
            pairs=pairs,
            contact_length=length,
            friction_coefficient=friction,
            rest_force=rest.normal_force,
        ),
        solved=(forces.balance_residual < BALANCE_TOLERANCE) & (forces.closure_residual < BALANCE_TOLERANCE),
    )


_evaluate_compiled = eqx.filter_jit(evaluate)


def solve(joint: Joint) -> JointResult:
    """Solve a joint, or a batch of joints, and refuse to return an unbalanced state.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.

    Returns
    -------
    JointResult
        Forces, contacts, stiffness and diagnostics. Gross slip and lift-off are results, reported by the
        diagnostics; look at them before using the stiffness.

    Raises
    ------
    NoSolutionError
        Where the force balance did not close to :data:`BALANCE_TOLERANCE`, for instance because the rollers do
        not close a triangle. Inside ``jit`` or ``vmap`` the error is raised when the program runs.
    PrecisionError
        If JAX is in single precision.
    """
    require_double_precision()
    result = _evaluate_compiled(joint)
    unsolved = ~result.solved
    if isinstance(unsolved, jax.core.Tracer):
        checked: JointResult = eqx.error_if(
            result, unsolved, "the force balance of a joint did not close; evaluate() shows where"
        )
        return checked
    if bool(jnp.any(unsolved)):
        balance, closure = result.forces.balance_residual, result.forces.closure_residual
        raise NoSolutionError(
            f"the force balance did not close for {int(jnp.sum(unsolved))} of {unsolved.size} joints: largest relative "
            f"residual {float(jnp.max(balance)):.3g} (balance) and {float(jnp.max(closure)):.3g} (closure), allowed "
            f"{BALANCE_TOLERANCE:g}; check radii, preload and torque"
        )
    return result

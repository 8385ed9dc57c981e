"""What a joint is: the input of the chain, as frozen modules. SI units."""

from __future__ import annotations

from typing import Any, Literal

import equinox as eqx
import jax
import jax.numpy as jnp

from asperity.body.shapes import PlaneState
from asperity.contact.fractal import Surface
from asperity.contact.population import ContactFactorModel
from asperity.drive.assembly import StructureSprings
from asperity.drive.bearing_life import RatedBearing
from asperity.drive.geometry import CONTACT_NAMES, DriveGeometry
from asperity.drive.loading_cam import cam_preload
from asperity.drive.mechanism import Bearings, Closure, leading_sense
from asperity.drive.structure_loads import BEARING_NAMES, PinSupport
from asperity.joint.play import Play
from asperity.joint.rolling_conditions import PLAIN_ROLLING, RollingConditions
from asperity.materials import Material
from asperity.types import Real

ClosureSprings = Literal["bulk", "bulk_and_asperities"]
#: Bodies of the assembly: discs and annuli by plane elasticity, or one spring for each contact.
BodyModel = Literal["exact", "springs"]
#: What holds the outer rim of the ring.
RingSupport = Literal["rigid_housing", "free", "elastic_housing"]


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


class Fit(eqx.Module):
    """How a drive whose preload is made by interference was assembled, and what temperature does to it.

    Parameters
    ----------
    interference : Real
        Interference at the assembly [m].
    change_per_kelvin : Real
        What a kelvin more adds to it [m/K].
    assembly_temperature, working_temperature : Real
        Temperatures of the whole drive [degC].
    """

    interference: Real
    change_per_kelvin: Real
    assembly_temperature: Real
    working_temperature: Real

    @property
    def temperature_rise(self) -> Real:
        """Working temperature above that of the assembly [K]."""
        return self.working_temperature - self.assembly_temperature

    @property
    def thermal_change(self) -> Real:
        """What the working temperature adds to the interference [m]."""
        return self.change_per_kelvin * self.temperature_rise


class PinBeam(eqx.Module):
    """The carrier pin of a loading roller as a beam.

    Parameters
    ----------
    free_length : Real
        Length between its two supports, or from its support to its end [m]; the roller is in the middle of it.
    support : {"both_ends", "one_end"}
        How the carrier holds it.
    """

    free_length: Real
    support: PinSupport = eqx.field(static=True)


class Crowns(eqx.Module):
    """Curvature of the crowns of the rollers along their axes, :math:`1/R_c`; 0 for a cylinder.

    Parameters
    ----------
    sun, planet, loading_roller, ring : Real
        Curvatures [1/m]; each crown is highest in the middle of the roller's contact lines.
    """

    sun: Real
    planet: Real
    loading_roller: Real
    ring: Real


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
        Wall of the outer ring [m].
    bearings : Bearings
        Friction of the bearings.
    preload : Real
        Normal force N_0 between sun and planet at rest [N]; with a cam the least one, see :func:`preload_at`.
    output_torque : Real
        Torque at the carrier, of either sign [N·m]; positive where it resists a positive rotation.
    sun_speed : Real
        Angular velocity of the sun, of either sign [rad/s]; see :func:`sense_of_rotation`.
    structure : StructureSprings
        Springs of pins, shafts, planet supports and ring; :data:`asperity.drive.assembly.IDEAL_STRUCTURE` for none.
    play : Play
        Play at the output, :data:`asperity.joint.play.NO_PLAY` for none; part of every torque–angle curve, but not of
        the stiffness at the operating point.
    closure : {"elastic", "constant_pin_force"}
        Closure of the force balance, :func:`asperity.drive.force_balance.force_balance`.
    closure_springs : {"bulk", "bulk_and_asperities"}
        Normal springs of the elastic closure: the bodies alone, or with the asperities' normal stiffness at rest in
        series. The assembly always has both.
    contact_factor_model : {"printed", "hertz_area", "unity"}
        Model of lambda, :func:`asperity.contact.population.contact_factor`.
    body_model : {"exact", "springs"}, optional
        Bodies of the assembly: exact plane elasticity, :mod:`asperity.joint.elastic_bodies`, or one spring for each
        contact, :mod:`asperity.contact.hertz_line`. The force balance uses the springs.
    plane_state : {"plane_strain", "plane_stress"}, optional
        Of the exact bodies.
    ring_support : {"rigid_housing", "free", "elastic_housing"} or None, optional
        What holds the outer rim of the ring: a rigid housing into which it is shrunk, nothing, or a housing with the
        ``ring_housing_stiffness`` of the structure. None: not stated, and taken as a rigid housing.
    planet_bore, loading_roller_bore : Real or None, optional
        Diameter of the bore of hollow rollers [m]; None for solid ones.
    crowns : Crowns or None, optional
        Crowns of the rollers; None where all are cylinders, whose contacts are loaded evenly.
    rolling : RollingConditions, optional
        Skew, losses, reliability and duty of the joint that turns; by default
        :data:`asperity.joint.rolling_conditions.PLAIN_ROLLING`.
    fit : Fit or None, optional
        Interference at the assembly, from which the preload at the working temperature was found; None where the
        preload does not depend on temperature. No result depends on it.
    pin : PinBeam or None, optional
        The carrier pins as beams; None where their length is not known.
    pin_bearing, sun_bearing, carrier_bearing : RatedBearing or None, optional
        Bearings of the loading rollers, of the sun and of the carrier; None where no life is asked for.
    cam_force_per_torque : Real or None, optional
        Loading cam: what each unit of output torque, of either sign, adds to the preload [N/(N·m)]; None without.
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
    structure: StructureSprings
    play: Play
    closure: Closure = eqx.field(static=True)
    closure_springs: ClosureSprings = eqx.field(static=True)
    contact_factor_model: ContactFactorModel = eqx.field(static=True)
    body_model: BodyModel = eqx.field(static=True, default="exact")
    plane_state: PlaneState = eqx.field(static=True, default="plane_strain")
    ring_support: RingSupport | None = eqx.field(static=True, default=None)
    planet_bore: Real | None = None
    loading_roller_bore: Real | None = None
    crowns: Crowns | None = None
    rolling: RollingConditions = PLAIN_ROLLING
    fit: Fit | None = None
    pin: PinBeam | None = None
    pin_bearing: RatedBearing | None = None
    sun_bearing: RatedBearing | None = None
    carrier_bearing: RatedBearing | None = None
    cam_force_per_torque: Real | None = None

    @property
    def contact_names(self) -> tuple[str, ...]:
        """Names of the contacts."""
        return CONTACT_NAMES

    @property
    def ends(self) -> tuple[str, str]:
        """Names of input and output."""
        return "sun", "carrier"

    @property
    def bearing_names(self) -> tuple[str, ...]:
        """Names of the rolling bearings, in the order of every bearing axis."""
        return BEARING_NAMES

    @property
    def rated_bearings(self) -> tuple[RatedBearing | None, ...]:
        """Ratings of these bearings; None where the file has none."""
        return (self.pin_bearing, self.pin_bearing, self.sun_bearing, self.carrier_bearing)


def preload_at(joint: Joint, output_torque: Real) -> Real:
    """Preload of a joint under a torque.

    Parameters
    ----------
    joint : Joint
        The joint.
    output_torque : Real
        Torque at the carrier, of either sign [N·m].

    Returns
    -------
    Real
        Normal force between sun and planet at rest [N]; of a joint without a loading cam the same at every torque.
    """
    if joint.cam_force_per_torque is None:
        return joint.preload
    return cam_preload(
        least_preload=joint.preload,
        force_per_torque=joint.cam_force_per_torque,
        output_torque=output_torque,
    )


def sense_of_rotation(joint: Joint) -> Any:
    """Sense in which the joint turns: +1 or −1; the friction of its bearings opposes it.

    Parameters
    ----------
    joint : Joint
        The joint.

    Returns
    -------
    Array
        Sign of the sun's speed; of the output torque where the sun stands still, because a joint that begins to
        move follows its torque. A torque against the sense of rotation brakes.
    """
    return leading_sense(rotation=joint.sun_speed, output_torque=joint.output_torque)


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


def with_one_rank(joint: Joint) -> Joint:
    """Give every number the rank of the batch, so that contact and batch axes never meet in broadcasting.

    Parameters
    ----------
    joint : Joint
        Numbers of any ranks that broadcast.

    Returns
    -------
    Joint
        The same joint; every leaf has the rank of the batch.
    """
    leaves = [jnp.asarray(leaf) for leaf in jax.tree.leaves(joint)]
    rank = max(leaf.ndim for leaf in leaves)
    return jax.tree.unflatten(
        jax.tree.structure(joint), [leaf.reshape((1,) * (rank - leaf.ndim) + leaf.shape) for leaf in leaves]
    )

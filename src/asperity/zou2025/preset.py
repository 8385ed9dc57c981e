"""What the paper prints (Tables 1 and 2) and what it leaves open and we had to choose, as data.

Lengths, forces and stresses of the tables are written here in SI. Everything in :data:`ASSUMPTIONS` is ours.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax.typing import ArrayLike

from asperity.contact.fractal import Surface
from asperity.contact.roller_pairs import RollerPairs, roller_pairs
from asperity.drive.assembly import IDEAL_STRUCTURE
from asperity.drive.geometry import DriveGeometry
from asperity.drive.mechanism import Bearings
from asperity.joint.evaluation import Bodies, Joint
from asperity.materials import Material, hardness, pair
from asperity.types import Real

YIELD_STRENGTH = 450e6  # Pa, Tables 1 and 2
FRACTAL_DIMENSION = 1.4  # Table 1
FRACTAL_ROUGHNESS = 1e-11  # m, Table 1
DIMENSION_RANGE = (1.3, 1.95)  # Table 1 case c
ROUGHNESS_RANGE = (1e-13, 1e-11)  # m, Table 1 case d
CONTACT_LENGTH = 5e-3  # m, Tables 1 and 2
CONTACT_LENGTH_RANGE = (5e-3, 30e-3)  # m, Table 1 case f
PAIR_NORMAL_FORCE = 1000.0  # N, Table 1
PAIR_RADII = (10e-3, 20e-3)  # m, Table 1
SECOND_RADIUS_RANGE = (10e-3, 50e-3)  # m, Table 1 case e
TANGENTIAL_RANGE = (0.0, 119.0)  # N, Table 1 case b
OUTPUT_TORQUE_RANGE = (0.0, 5.0)  # N·m, section 5.2
SUN_SPEED = 6000.0 * 2.0 * math.pi / 60.0  # rad/s, section 5.2
SCALING_PARAMETER = 1.5  # gamma, below equation (7)
PEAK_DIMENSION = 1.85  # sections 5.1, 5.2 and conclusions
DESIGN_WINDOW = (1.7, 1.85)  # fractal dimension, section 5.2

#: The numbers of a roller pair that the cases of Table 1 vary, at their common values; SI units.
TABLE_1 = {
    "normal_force": PAIR_NORMAL_FORCE,
    "tangential_force": 0.0,
    "fractal_dimension": FRACTAL_DIMENSION,
    "fractal_roughness": FRACTAL_ROUGHNESS,
    "second_radius": PAIR_RADII[1],
    "contact_length": CONTACT_LENGTH,
}

FRICTION_COEFFICIENT = 0.12  # ours
PRELOAD = 1000.0  # N, ours
YOUNGS_MODULUS = 206e9  # Pa, ours
POISSON_RATIO = 0.3  # ours
DENSITY = 7850.0  # kg/m^3, ours
HARDNESS_FACTOR = 2.8  # ours
RING_WALL = 60e-3  # m, ours


@dataclass(frozen=True)
class Assumption:
    """A number or rule that the paper does not give.

    Parameters
    ----------
    what : str
        The quantity.
    value : str
        What we take, with its unit.
    reason : str
        Why.
    """

    what: str
    value: str
    reason: str


#: What the paper leaves open and this reproduction had to choose.
ASSUMPTIONS = (
    Assumption("bodies", "steel, E = 206 GPa, nu = 0.3, 7850 kg/m^3", "only the yield strength is printed"),
    Assumption(
        "hardness", "H = 2.8 sigma_y = 1260 MPa", "Tabor's factor; the paper names a factor, no value"
    ),
    Assumption("friction coefficient", "mu = 0.12", "Table 1 case b ends at T = 119 N for F_n = 1000 N"),
    Assumption("preload", "N_0 = 1000 N at the sun", "'sufficiently high' in the paper; the load of Table 1"),
    Assumption(
        "closure of (1)-(5)",
        "elastic, equation (A3), bulk springs",
        "13 unknowns, 11 equations",
    ),
    Assumption(
        "ring wall", "60 mm", "not given; 1.5 R_o compresses like a solid body; bulk and closure only"
    ),
    Assumption("bearing friction", "none", "T_B is not given"),
    Assumption("carrier push", "gamma_l = gamma_r = 0", "not given"),
    Assumption(
        "roller length", "equal to the contact length", "makes the masses; centrifugal forces are below 1 %"
    ),
    Assumption("D, G of the joint", "1.4, 1e-8 mm where not varied", "the values of Table 1"),
    Assumption("contact factor", "equation (11) as printed, in mm, N, MPa", "only this gives Fig. 4f"),
    Assumption("torque of Fig. 6", "5 N*m", "not given; the end of the stated range"),
    Assumption("friction range of Fig. 8b", "0.04 to 0.30", "not given"),
)

#: What a reader who holds the paper beside the figures must know.
REMARKS = (
    "Table 1 varies the radius in case e and the length in case f; the caption of Fig. 4 names them the other way "
    "round. Panels 4e and 4f follow the table.",
    "Case b goes on from the 119 N of Table 1 to 132 N, to show that nothing is left beyond gross slip.",
    "The caption of Fig. 8 names contact length and radius; its panels show contact length and friction coefficient.",
    "Fig. 6 multiplies by the square of the driven roller's radius: only so is sun-planet the highest.",
    "The joint stiffness counts the tangential springs of the asperities alone; the bodies and the floating planet, "
    "which make a real joint far softer, are not in the paper's equations.",
)


class OperatingPoint(eqx.Module):
    """What the figures vary in the joint of Table 2. Fields are numbers or arrays of one shape. SI units.

    Parameters
    ----------
    output_torque : Real
        Torque at the carrier [N·m].
    fractal_dimension : Real
        Profile fractal dimension D [-].
    fractal_roughness : Real
        Fractal roughness G [m].
    contact_length : Real
        Contact line length B of all contacts, also the length of the rollers [m].
    friction_coefficient : Real
        Friction coefficient mu [-].
    radius_scale : Real
        Factor on all four radii of Table 2 [-].
    """

    output_torque: Real
    fractal_dimension: Real
    fractal_roughness: Real
    contact_length: Real
    friction_coefficient: Real
    radius_scale: Real


def operating_grid(**varied: ArrayLike) -> OperatingPoint:
    """The paper's operating point with some fields varied over the grid of their values.

    Parameters
    ----------
    **varied : array_like
        Field of :class:`OperatingPoint` → its values, shape (n,). What is not named keeps the value of Tables 1
        and 2 at the full output torque.

    Returns
    -------
    OperatingPoint
        All fields in the shape (n_1, n_2, ...), in the order of the arguments.

    Examples
    --------
    >>> point = operating_grid(output_torque=[1.0, 5.0], fractal_dimension=[1.3, 1.4, 1.5])
    >>> point.contact_length.shape
    (2, 3)
    """
    values: dict[str, ArrayLike] = {
        "output_torque": OUTPUT_TORQUE_RANGE[1],
        "fractal_dimension": FRACTAL_DIMENSION,
        "fractal_roughness": FRACTAL_ROUGHNESS,
        "contact_length": CONTACT_LENGTH,
        "friction_coefficient": FRICTION_COEFFICIENT,
        "radius_scale": 1.0,
    }
    axes = np.meshgrid(*(np.asarray(v, dtype=float) for v in varied.values()), indexing="ij")
    values.update(zip(varied, axes, strict=True))
    shape = axes[0].shape if axes else ()
    return OperatingPoint(**{name: jnp.asarray(np.broadcast_to(v, shape)) for name, v in values.items()})


def steel() -> Material:
    """The steel of the preset: yield strength from the paper, everything else ours.

    Returns
    -------
    Material
        SI units.
    """
    return Material(
        youngs_modulus=YOUNGS_MODULUS,
        poisson_ratio=POISSON_RATIO,
        density=DENSITY,
        yield_strength=YIELD_STRENGTH,
        hardness=hardness(hardness_factor=HARDNESS_FACTOR, yield_strength=YIELD_STRENGTH),
    )


def rough_surface(*, fractal_dimension: Real, fractal_roughness: Real) -> Surface:
    """The paper's kind of surface.

    Parameters
    ----------
    fractal_dimension : Real
        Profile fractal dimension D [-].
    fractal_roughness : Real
        Fractal roughness G [m].

    Returns
    -------
    Surface
        With gamma = 1.5 and the asperity base of equation (20).
    """
    return Surface(
        fractal_dimension=fractal_dimension,
        fractal_roughness=fractal_roughness,
        frequency_ratio=SCALING_PARAMETER,
        asperity_base="majumdar_bhushan_1991",
    )


def table_1_pair(**varied: Real) -> RollerPairs:
    """The single roller pair of Table 1, without its load.

    Parameters
    ----------
    **varied : Real
        What a case varies: ``normal_force``, ``tangential_force``, ``fractal_dimension``,
        ``fractal_roughness``, ``second_radius``, ``contact_length``. SI units.

    Returns
    -------
    RollerPairs
        The pair, the other numbers as in Table 1.
    """
    unknown = set(varied) - set(TABLE_1)
    if unknown:
        raise TypeError(f"Table 1 has no column {sorted(unknown)}; it has {sorted(TABLE_1)}")
    values: dict[str, Real] = {**TABLE_1, **varied}
    return roller_pairs(
        radius_1=PAIR_RADII[0],
        radius_2=values["second_radius"],
        sign=1.0,
        contact_length=values["contact_length"],
        friction_coefficient=FRICTION_COEFFICIENT,
        moduli=pair(steel(), steel()),
        surface=rough_surface(
            fractal_dimension=values["fractal_dimension"], fractal_roughness=values["fractal_roughness"]
        ),
    )


def table_2_joint(point: OperatingPoint) -> Joint:
    """The planetary joint of Table 2 at an operating point.

    Parameters
    ----------
    point : OperatingPoint
        What the figures vary, :func:`operating_grid`.

    Returns
    -------
    Joint
        Input of :func:`asperity.joint.evaluation.evaluate`; numbers have the shape of the point's fields.
    """
    scale = np.asarray(point.radius_scale)  # NumPy: a single product is not worth compiling
    return Joint(
        geometry=DriveGeometry(
            sun_radius=jnp.asarray(4e-3 * scale),
            planet_radius=jnp.asarray(13.5e-3 * scale),
            loading_roller_radius=jnp.asarray(5e-3 * scale),
            ring_radius=jnp.asarray(40e-3 * scale),
            planet_count=3.0,
            left_push_angle=0.0,
            right_push_angle=0.0,
        ),
        bodies=Bodies(sun=steel(), planet=steel(), loading_roller=steel(), ring=steel()),
        surfaces=(
            rough_surface(
                fractal_dimension=point.fractal_dimension, fractal_roughness=point.fractal_roughness
            ),
        ),
        contact_lengths=(point.contact_length,),
        friction_coefficients=(point.friction_coefficient,),
        planet_length=point.contact_length,
        loading_roller_length=point.contact_length,
        ring_wall_thickness=RING_WALL,
        bearings=Bearings(
            sun_torque=0.0,
            loading_roller_torque=0.0,
            carrier_torque=0.0,
            pin_friction_coefficient=0.0,
            pin_diameter=0.0,
        ),
        preload=PRELOAD,
        output_torque=point.output_torque,
        sun_speed=SUN_SPEED,
        structure=IDEAL_STRUCTURE,
        closure="elastic",
        closure_springs="bulk",
        contact_factor_model="printed",
    )


def joined(points: tuple[OperatingPoint, ...]) -> OperatingPoint:
    """Many grids as one flat batch, so that one compiled program serves every figure.

    Parameters
    ----------
    points : tuple of OperatingPoint
        Grids of any shapes.

    Returns
    -------
    OperatingPoint
        Fields of shape (total number of points,).
    """
    flat: OperatingPoint = jax.tree.map(
        lambda *leaves: jnp.asarray(np.concatenate([np.ravel(leaf) for leaf in leaves])), *points
    )
    return flat

"""The inputs that the paper prints (Tables 1 and 2) and those that it leaves open and we assume. SI units."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from asperity.contact.interface import RoughContact
from asperity.contact.laws.zou_2025 import Zou2025
from asperity.contact.roller_pairs import contact_factors, roller_pairs, rough_contacts
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.materials import Material, hardness, pair
from asperity.types import ArrayLike, Real
from asperity.zou2025.published import PublishedJoint

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
SUN_RADIUS = 4e-3  # m, Table 2
PLANET_RADIUS = 13.5e-3  # m, Table 2
LOADING_ROLLER_RADIUS = 5e-3  # m, Table 2
RING_RADIUS = 40e-3  # m, Table 2
OUTPUT_TORQUE_RANGE = (0.0, 5.0)  # N·m, section 5.2
SUN_SPEED = 6000.0 * 2.0 * math.pi / 60.0  # rad/s, section 5.2
SCALING_PARAMETER = 1.5  # gamma, below equation (7)
PEAK_DIMENSION = 1.85  # sections 5.1, 5.2 and conclusions
DESIGN_WINDOW = (1.7, 1.85)  # fractal dimension, section 5.2

FRICTION_COEFFICIENT = 0.12  # assumed
PRELOAD = 1000.0  # N, assumed
YOUNGS_MODULUS = 206e9  # Pa, assumed
POISSON_RATIO = 0.3  # assumed
DENSITY = 7850.0  # kg/m^3, assumed
HARDNESS_FACTOR = 2.8  # assumed
RING_WALL = 60e-3  # m, assumed

#: The numbers of a roller pair that the cases of Table 1 vary, at their common values; SI units.
TABLE_1 = {
    "normal_force": PAIR_NORMAL_FORCE,
    "tangential_force": 0.0,
    "fractal_dimension": FRACTAL_DIMENSION,
    "fractal_roughness": FRACTAL_ROUGHNESS,
    "second_radius": PAIR_RADII[1],
    "contact_length": CONTACT_LENGTH,
}


@dataclass(frozen=True)
class Assumption:
    """A number, with its unit, or a rule that the paper does not give, and why this one, or why one is needed."""

    what: str
    value: str
    reason: str


#: What the paper leaves open and this reproduction assumes.
ASSUMPTIONS = (
    Assumption("bodies", "steel, E = 206 GPa, nu = 0.3, 7850 kg/m^3", "only the yield strength is given"),
    Assumption("hardness", "H = 2.8 sigma_y = 1260 MPa", "Tabor's factor; the paper gives no value"),
    Assumption("friction coefficient", "mu = 0.12", "Table 1 case b ends at T = 119 N for F_n = 1000 N"),
    Assumption("preload", "N_0 = 1000 N at the sun", "the load of Table 1; 'sufficiently high' in the paper"),
    Assumption(
        "closure of (1)-(5)",
        "elastic, equation (A3), bulk springs, equal traction coefficients of the planet's rollers",
        "13 unknowns, 11 equations; split by the slip of the contacts the first one slips at 9.59, not at 13.16 N*m",
    ),
    Assumption(
        "ring wall",
        "60 mm",
        "not given; 1.5 R_o, compresses like a solid body; used for bulk springs and closure only",
    ),
    Assumption("bearing friction", "none", "T_B is not given"),
    Assumption("carrier push", "gamma_l = gamma_r = 0", "not given"),
    Assumption(
        "roller length",
        "equal to the contact length",
        "not given; used for the masses; centrifugal forces are below 1 %",
    ),
    Assumption("D, G of the joint", "1.4, 1e-8 mm where not varied", "the values of Table 1"),
    Assumption("contact factor", "equation (11) as printed, in mm, N, MPa", "only this reproduces Fig. 4f"),
    Assumption("torque of Fig. 6", "5 N*m", "not given; the upper end of the stated range"),
    Assumption("friction range of Fig. 8b", "0.04 to 0.30", "not given"),
)

#: Notes for a reader who compares the figures with those of the paper.
REMARKS = (
    "Table 1 varies the radius in case e and the length in case f; the caption of Fig. 4 interchanges them. Panels 4e "
    "and 4f follow the table.",
    "Case b extends beyond the 119 N of Table 1 to 132 N, to show that no stiffness remains after gross slip.",
    "The caption of Fig. 8 names contact length and radius; its panels show contact length and friction coefficient.",
    "Fig. 6 uses the square of the radius of the driven roller: only then is the sun-planet contact the stiffest.",
    "The joint stiffness includes only the tangential springs of the asperities; the elastic bodies and the floating "
    "planet, which make a real joint far softer, are not in the equations of the paper.",
)


class OperatingPoint(Module):
    """What the figures vary in the joint of Table 2. Fields are numbers or arrays of one shape. SI units.

    Torque at the carrier [N·m]; D [-] and G [m]; contact line length B of all contacts, also the length of the rollers
    [m]; mu [-]; factor on all four radii of Table 2 [-].
    """

    output_torque: Real
    fractal_dimension: Real
    fractal_roughness: Real
    contact_length: Real
    friction_coefficient: Real
    radius_scale: Real


def operating_grid(**varied: ArrayLike) -> OperatingPoint:
    """The paper's operating point with some fields varied over the grid of their values, each of shape (n,).

    All other fields keep the values of Tables 1 and 2 at the full output torque. All have the shape (n_1, n_2, ...), in
    the order of the arguments.

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
    return OperatingPoint(**{name: xp.asarray(np.broadcast_to(v, shape)) for name, v in values.items()})


def steel() -> Material:
    """The steel of the preset: the yield strength is given in the paper, the rest is assumed."""
    return Material(
        youngs_modulus=YOUNGS_MODULUS,
        poisson_ratio=POISSON_RATIO,
        density=DENSITY,
        yield_strength=YIELD_STRENGTH,
        hardness=hardness(hardness_factor=HARDNESS_FACTOR, yield_strength=YIELD_STRENGTH),
    )


def _rough_surface(fractal_dimension: Real, fractal_roughness: Real) -> Zou2025:
    """A surface with the paper's scaling parameter and the asperity base of equation (20)."""
    return Zou2025(
        fractal_dimension=fractal_dimension,
        fractal_roughness=fractal_roughness,
        frequency_ratio=SCALING_PARAMETER,
        asperity_base="majumdar_bhushan_1991",
    )


def table_1_contact(**varied: Real) -> RoughContact:
    """Contact spots and stiffnesses of the roller pair of Table 1."""
    unknown = set(varied) - set(TABLE_1)
    if unknown:
        raise TypeError(f"Table 1 has no column {sorted(unknown)}; it has {sorted(TABLE_1)}")
    values: dict[str, Real] = {**TABLE_1, **varied}
    pairs = roller_pairs(
        radius_1=PAIR_RADII[0],
        radius_2=values["second_radius"],
        sign=1.0,
        contact_length=values["contact_length"],
        friction_coefficient=FRICTION_COEFFICIENT,
        moduli=pair(steel(), steel()),
        surface=_rough_surface(values["fractal_dimension"], values["fractal_roughness"]),
    )
    return rough_contacts(
        pairs=pairs,
        contact_factor=contact_factors(pairs=pairs, model="printed", normal_force=values["normal_force"]),
        normal_force=values["normal_force"],
        tangential_force=values["tangential_force"],
    )


def table_2_joint(point: OperatingPoint) -> PublishedJoint:
    """The planetary joint of Table 2 at an operating point."""
    scale = np.asarray(point.radius_scale)  # NumPy: a single product is not worth compiling
    return PublishedJoint(
        geometry=DriveGeometry(
            sun_radius=xp.asarray(SUN_RADIUS * scale),
            planet_radius=xp.asarray(PLANET_RADIUS * scale),
            loading_roller_radius=xp.asarray(LOADING_ROLLER_RADIUS * scale),
            ring_radius=xp.asarray(RING_RADIUS * scale),
            planet_count=3.0,
            left_push_angle=0.0,
            right_push_angle=0.0,
        ),
        material=steel(),
        surface=_rough_surface(point.fractal_dimension, point.fractal_roughness),
        contact_length=point.contact_length,
        friction_coefficient=point.friction_coefficient,
        ring_wall_thickness=RING_WALL,
        preload=PRELOAD,
        output_torque=point.output_torque,
        sun_speed=SUN_SPEED,
    )

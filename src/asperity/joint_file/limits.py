"""The allowed range of every numeric key of a joint file, as data.

Physics sets some bounds (1 < D < 2, Poisson's ratio up to 1/2); the others only catch slips of the pen such as
a wrong prefix, and are wider than any machine. All bounds are part of the JSON schema and of error messages.
"""

from __future__ import annotations

from asperity.joint_file.key import Key
from asperity.unit_table import Dimension

PLANETS = Key(Dimension.DIMENSIONLESS, 2, 100, whole=True)
ROLLER_RADIUS = Key(Dimension.LENGTH, 1e-3, 1e5, "mm")
WALL_THICKNESS = Key(Dimension.LENGTH, 1e-3, 1e5, "mm")
CONTACT_LENGTH = Key(Dimension.LENGTH, 1e-3, 1e5, "mm")
BODY_LENGTH = Key(Dimension.LENGTH, 0.0, 1e5, "mm")
PUSH_ANGLE = Key(Dimension.ANGLE, -60.0, 60.0, "deg")

PRELOAD = Key(Dimension.FORCE, 1e-3, 1e9, "N")
OUTPUT_TORQUE = Key(Dimension.TORQUE, -1e9, 1e9, "N*m")
SUN_SPEED = Key(Dimension.ANGULAR_VELOCITY, 0.0, 1e6, "rpm")
FRICTION_COEFFICIENT = Key(Dimension.DIMENSIONLESS, 0.0, 10.0, open_lower=True)

PLAY_ANGLE = Key(Dimension.ANGLE, 0.0, 21600.0, "arcmin")
TAKE_UP_TORQUE = Key(Dimension.TORQUE, 0.0, 1e9, "N*m")

BEARING_TORQUE = Key(Dimension.TORQUE, 0.0, 1e6, "N*m")
PIN_FRICTION_COEFFICIENT = Key(Dimension.DIMENSIONLESS, 0.0, 10.0)
PIN_DIAMETER = Key(Dimension.LENGTH, 0.0, 1e5, "mm")

SPRING = Key(Dimension.STIFFNESS, 1e-6, 1e15, "N/mm")
TORSION_SPRING = Key(Dimension.TORSIONAL_STIFFNESS, 1e-6, 1e15, "N*m/rad")

YOUNGS_MODULUS = Key(Dimension.PRESSURE, 1e-4, 1e4, "GPa")
POISSON_RATIO = Key(Dimension.DIMENSIONLESS, -1.0, 0.5, open_lower=True)
DENSITY = Key(Dimension.DENSITY, 0.0, 1e5, "kg/m^3")
YIELD_STRENGTH = Key(Dimension.PRESSURE, 1e-3, 1e6, "MPa")
HARDNESS_FACTOR = Key(Dimension.DIMENSIONLESS, 0.1, 100.0)
HARDNESS = Key(Dimension.PRESSURE, 1e-3, 1e6, "MPa")

FRACTAL_DIMENSION = Key(Dimension.DIMENSIONLESS, 1.0, 2.0, open_lower=True, open_upper=True)
# Fits of rough surfaces near D = 1 have a G far below any length of nature: G^(D-1) is what has a meaning.
FRACTAL_ROUGHNESS = Key(Dimension.LENGTH, 1e-60, 1.0, "mm", open_lower=True)
FREQUENCY_RATIO = Key(Dimension.DIMENSIONLESS, 1.0, 100.0, open_lower=True)

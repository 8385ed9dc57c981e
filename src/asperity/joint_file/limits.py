"""The allowed range of every numeric key of a joint file, as data.

Physics sets some bounds (1 < D < 2, Poisson's ratio up to 1/2); the others only catch typing errors such as
a wrong prefix, and are wider than any machine needs. All bounds are part of the JSON schema and of error messages.
"""

from __future__ import annotations

from asperity.drive.layout import sizes
from asperity.joint_file.quantity_key import Key
from asperity.unit_table import Dimension


def key_of(size: sizes.Range) -> Key:
    """The key of a number whose range a type of drive states."""
    return Key(
        Dimension[size.dimension],
        size.lower,
        size.upper,
        size.unit,
        open_lower=size.open_lower,
        integer=size.integer,
        example=size.example,
        reason=size.reason,
    )


PLANETS = key_of(sizes.SECTORS)
ROLLER_RADIUS = key_of(sizes.RADIUS)
WALL_THICKNESS = key_of(sizes.WALL_THICKNESS)
CONTACT_LENGTH = Key(Dimension.LENGTH, 1e-3, 1e5, "mm", example="5 mm")
BODY_LENGTH = key_of(sizes.BODY_LENGTH)
RATIO = Key(
    Dimension.DIMENSIONLESS, 0.0, 1e6, open_lower=True, exact=True, example="11",
    reason="write it without its sign, which follows from the type of drive",
)  # fmt: skip
PUSH_ANGLE = key_of(sizes.PUSH_ANGLE)
POLAR_ANGLE = Key(Dimension.ANGLE, -360.0, 360.0, "deg", example="90 deg")

PRELOAD = Key(Dimension.FORCE, 1e-3, 1e9, "N")
INTERFERENCE = Key(Dimension.LENGTH, 0.0, 1e6, "um", open_lower=True, example="13 um")
CAM_FORCE = Key(Dimension.FORCE_PER_TORQUE, 0.0, 1e9, "N/Nm", example="150 N/Nm")
DEVIATION = key_of(sizes.DEVIATION)
TRANSMISSION_ERROR = Key(
    Dimension.ANGLE, 0.0, 1e6, "arcsec", open_lower=True, exact=True, example="20 arcsec"
)
RUNOUT = Key(Dimension.LENGTH, 0.0, 1e6, "um", open_lower=True, example="4 um")
FORM_AMPLITUDE = Key(Dimension.LENGTH, 0.0, 1e6, "um", open_lower=True, example="1 um")
FORM_PHASE = Key(Dimension.ANGLE, -360.0, 360.0, "deg", example="40 deg")
OUTPUT_TORQUE = Key(Dimension.TORQUE, -1e9, 1e9, "N*m")
SUN_SPEED = Key(Dimension.ANGULAR_VELOCITY, 0.0, 1e6, "rpm")
OUTPUT_SPEED = Key(Dimension.ANGULAR_VELOCITY, 0.0, 1e6, "rpm", open_lower=True, example="100 rpm")
FRICTION_COEFFICIENT = Key(Dimension.DIMENSIONLESS, 0.0, 10.0, open_lower=True)

PLAY_ANGLE = Key(Dimension.ANGLE, 0.0, 21600.0, "arcmin", example="1.5 arcmin")
TAKE_UP_TORQUE = Key(Dimension.TORQUE, 0.0, 1e9, "N*m", example="0.2 N*m")

BEARING_TORQUE = key_of(sizes.BEARING_TORQUE)
PIN_FRICTION_COEFFICIENT = key_of(sizes.PIN_FRICTION_COEFFICIENT)
PIN_LENGTH = Key(Dimension.LENGTH, 1e-3, 1e5, "mm", example="8 mm")
PIN_DIAMETER = Key(Dimension.LENGTH, 0.0, 1e5, "mm", example="4 mm")
PIN_CLEARANCE = Key(Dimension.LENGTH, 0.0, 1e6, "um", example="5 um")

LOAD_RATING = Key(Dimension.FORCE, 0.0, 1e9, "N", open_lower=True, example="3200 N")
BEARING_COUNT = Key(Dimension.DIMENSIONLESS, 1, 100, integer=True, example="2")
OUTSIDE_FORCE = Key(Dimension.FORCE, 0.0, 1e9, "N", example="200 N")

BORE_DIAMETER = key_of(sizes.BORE_DIAMETER)
CROWN_RADIUS = key_of(sizes.CROWN_RADIUS)
PROFILE_LOAD = key_of(sizes.PROFILE_LOAD)
HOUSING_DIAMETER = Key(Dimension.LENGTH, 1e-3, 1e5, "mm", example="140 mm")
HOUSING_INTERFERENCE = Key(Dimension.LENGTH, 0.0, 1e6, "um", open_lower=True, example="40 um")
HOUSING = Key(Dimension.STIFFNESS_PER_AREA, 0.0, 1e9, "MPa/mm", example="500 MPa/mm")

SPRING = key_of(sizes.SPRING)
SUPPORT = Key(Dimension.STIFFNESS, 0.0, 1e15, "N/mm", example="5e4 N/mm")
TORSION_SPRING = Key(Dimension.TORSIONAL_STIFFNESS, 1e-6, 1e15, "N*m/rad", example="5e4 N*m/rad")

YOUNGS_MODULUS = Key(Dimension.PRESSURE, 1e-4, 1e4, "GPa", example="206 GPa")
POISSON_RATIO = Key(Dimension.DIMENSIONLESS, -1.0, 0.5, open_lower=True, example="0.3")
DENSITY = Key(Dimension.DENSITY, 0.0, 1e5, "kg/m^3")
YIELD_STRENGTH = Key(Dimension.PRESSURE, 1e-3, 1e6, "MPa")
FATIGUE_STRENGTH = Key(Dimension.PRESSURE, 1e-3, 1e6, "MPa", example="300 MPa")
TENSILE_STRENGTH = Key(Dimension.PRESSURE, 1e-3, 1e6, "MPa", example="1000 MPa")
HARDNESS_FACTOR = Key(Dimension.DIMENSIONLESS, 0.1, 100.0, example="2.8")
HARDNESS = Key(Dimension.HARDNESS, 1e-3, 1e6, "MPa", example="1260 MPa")

THERMAL_CONDUCTIVITY = Key(Dimension.THERMAL_CONDUCTIVITY, 1e-3, 1e4, "W/m/K", example="21 W/m/K")
SPECIFIC_HEAT_CAPACITY = Key(Dimension.SPECIFIC_HEAT_CAPACITY, 1.0, 1e5, "J/kg/K", example="475 J/kg/K")

THERMAL_EXPANSION = Key(Dimension.THERMAL_EXPANSION, -100.0, 500.0, "um/m/K", example="11.5e-6 1/K")
TEMPERATURE = Key(Dimension.TEMPERATURE, -273.15, 1000.0, "degC", example="20 degC")
COOLED_AREA = Key(Dimension.AREA, 0.0, 1e4, "m^2", open_lower=True, example="0.05 m^2")
HEAT_TRANSFER = Key(Dimension.HEAT_TRANSFER, 0.0, 1e6, "W/m^2/K", open_lower=True, example="10 W/m^2/K")
THERMAL_RESISTANCE = Key(Dimension.THERMAL_RESISTANCE, 0.0, 1e6, "K/W", open_lower=True, example="3 K/W")
ROLLER_RESISTANCE = Key(Dimension.THERMAL_RESISTANCE, 0.0, 1e6, "K/W", example="0.5 K/W")
DUTY_TIME = Key(Dimension.TIME, 0.0, 1e9, "min", open_lower=True, example="30 min")
HEAT_CAPACITY = Key(Dimension.HEAT_CAPACITY, 0.0, 1e9, "J/K", open_lower=True, example="600 J/K")

AXIS_TILT = Key(Dimension.ANGLE, -100.0, 100.0, "mrad", example="1 mrad")
SKEW = Key(Dimension.ANGLE, -100.0, 100.0, "mrad", example="0.5 mrad")
HYSTERESIS_FACTOR = Key(Dimension.DIMENSIONLESS, 0.0, 1.0, example="0.01")
RELIABILITY = Key(Dimension.DIMENSIONLESS, 0.0, 1.0, open_lower=True, open_upper=True, example="0.9")
REQUIRED_LIFE = Key(Dimension.TIME, 0.0, 1e9, "h", open_lower=True, exact=True, example="20000 h")
WEAR_COEFFICIENT = Key(
    Dimension.WEAR_COEFFICIENT, 0.0, 1e-11, "1/Pa", open_lower=True, example="1e-17 1/Pa",
    hint="severe wear of soft metals is 1e-12 1/Pa; 1 mm^3/(N*m) is 1e-9 1/Pa",
)  # fmt: skip
VISCOSITY = Key(Dimension.VISCOSITY, 1e-6, 1e4, "Pa*s", example="30 mPa*s")
PRESSURE_COEFFICIENT = Key(Dimension.INVERSE_PRESSURE, 0.0, 1e3, "1/GPa", open_lower=True, example="20 1/GPa")
SUPPLY = Key(
    Dimension.DIMENSIONLESS,
    0.0,
    1.0,
    open_lower=True,
    example="0.5",
    hint="it is a share, 1 for a flooded inlet",
)
CREEP_LIMIT = Key(Dimension.DIMENSIONLESS, 1e-4, 1.0, example="0.02")
SLIP_SPEED = Key(Dimension.SPEED, 1e-9, 1e3, "m/s", example="0.01 m/s")
CLEANLINESS = Key(
    Dimension.DIMENSIONLESS,
    0.0,
    1.0,
    open_lower=True,
    example="0.5",
    hint="it is the contamination factor e_C of ISO 281, 1 for the cleanest oil",
)
ROUGHNESS = Key(Dimension.LENGTH, 1e-3, 1e3, "um", example="0.2 um")
KINEMATIC_VISCOSITY = Key(Dimension.KINEMATIC_VISCOSITY, 1.0, 1e5, "mm^2/s", example="34 mm^2/s")
OIL_DENSITY = Key(Dimension.DENSITY, 100.0, 1e4, "kg/m^3", example="880 kg/m^3")
# Of the oils of publications 0.035 to 0.1; a table of a data sheet may print 4.7 for 4.7 %.
LIMITING_TRACTION = Key(
    Dimension.DIMENSIONLESS, 0.01, 0.2, example="0.047", hint="it is a share of the pressure, not %"
)
MAXIMUM_TRACTION = Key(
    Dimension.DIMENSIONLESS, 0.01, 0.2, example="0.09", hint="it is a share of the load, not %"
)
TRACTION_SLOPE = Key(Dimension.DIMENSIONLESS, 0.1, 1e4, example="55")
SHEAR_MODULUS = Key(Dimension.PRESSURE, 1e-3, 100.0, "GPa", example="0.5 GPa")
OIL_CONDUCTIVITY = Key(Dimension.THERMAL_CONDUCTIVITY, 0.01, 10.0, "W/m/K", example="0.14 W/m/K")
PEAK_PRESSURE = Key(Dimension.PRESSURE, 1e-3, 100.0, "GPa", example="1.5 GPa")
ROLLING_SPEED = Key(Dimension.SPEED, 1e-6, 1e3, "m/s", example="2 m/s")
RIG_RADIUS = Key(Dimension.LENGTH, 1e-3, 1e5, "mm", example="20 mm")
RIG_LOAD = Key(Dimension.FORCE, 1e-3, 1e9, "N", example="2000 N")
SHARE = Key(Dimension.DIMENSIONLESS, 0.0, 1.0, open_lower=True, example="0.4")
DUTY_TORQUE = Key(Dimension.TORQUE, -1e9, 1e9, "N*m")

INPUT_INERTIA = Key(Dimension.MOMENT_OF_INERTIA, 0.0, 1e6, "kg*m^2", example="2e-6 kg*m^2")
OUTPUT_INERTIA = Key(Dimension.MOMENT_OF_INERTIA, 0.0, 1e6, "kg*m^2", example="0.05 kg*m^2")
LOSS_FACTOR = Key(Dimension.DIMENSIONLESS, 0.0, 1.0, example="0.01")

FRACTAL_DIMENSION = Key(Dimension.DIMENSIONLESS, 1.0, 2.0, open_lower=True, open_upper=True, example="1.4")
# Fits of rough surfaces near D = 1 have a G far below any length of nature: G^(D-1) is what has a meaning.
FRACTAL_ROUGHNESS = Key(Dimension.LENGTH, 1e-60, 1.0, "mm", open_lower=True, example="1e-8 mm")
ROUGHNESS_AVERAGE = Key(Dimension.LENGTH, 1e-4, 100.0, "um", example="0.2 um")
# 4.4 to 8 times Ra
RMS_HEIGHT = Key(Dimension.LENGTH, 1e-4, 100.0, "um", example="0.15 um")
# 0.1 to 0.5 times the rms of the heights
DECAY_LENGTH = Key(Dimension.LENGTH, 1e-5, 100.0, "um", example="0.07 um")
MEAN_ROUGHNESS_DEPTH = Key(Dimension.LENGTH, 1e-3, 100.0, "um", example="1.6 um")
PARTNER_AVERAGE = Key(Dimension.LENGTH, 0.0, 100.0, "um", example="0.1 um")
CUT_OFF = Key(Dimension.LENGTH, 0.01, 100.0, "mm", example="0.8 mm")
FREQUENCY_RATIO = Key(Dimension.DIMENSIONLESS, 1.0, 100.0, open_lower=True, example="1.5")

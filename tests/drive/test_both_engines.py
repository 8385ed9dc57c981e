"""The formulas of drives by NumPy and within a program of JAX: equal numbers and slopes, also at borders."""

import math

import numpy as np
from both_engines import Engines, Formula, rows
from steel_laws import steel_laws

from asperity.contact.crowned_line import CrownedLines
from asperity.drive import bearings
from asperity.drive.layout import drive as layout
from asperity.drive.layout import existence, expansion, wedge
from asperity.drive.layout.unfolding import forces_on_centre, unfolded
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.normal_springs import NormalSprings, compression, crowned_springs, total_approach
from asperity.drive.state import first_limit, loads
from asperity.drive.state.creep import CreepLaw, creepages, drift_per_turn
from asperity.drive.state.state import DriveLoad, contact_approach, slip_at_rest, surface_speeds
from asperity.drive.state.states import drive_states, rest_forces
from asperity.drive.state.supports import carrier_supports
from asperity.drive.stiffness import loading_cam
from asperity.drive.stiffness.network import network_stiffness, with_shafts
from asperity.drive.stiffness.torsional_stiffness import contact_torsional_stiffness
from asperity.drive.structure import bearing_life, inertia, pin_beam
from asperity.drive.types.multiroller import two_row_multiroller
from asperity.drive.types.planetary import planetary_drive
from asperity.drive.types.stepped_planet import stepped_planet_drive
from asperity.drive.types.wedge import wedge_drive
from asperity.engine.arrays import xp

LENGTH, FORCE = (5e-3, 20e-3), (100.0, 2000.0)
SPRINGS = {"secant": (1e-8, 2e-8), "incremental": (8e-9, 9e-9), "normal_force": FORCE, "rest_force": FORCE}
CROWNS = {
    "crown_curvature": (0.1, 3.0),
    "contact_length": LENGTH,
    "effective_radius": LENGTH,
    "contact_modulus": (80e9, 150e9),
}
BEARINGS = {
    "input_torque": (0.0, 5e-3),
    "roller_torque": (0.0, 5e-3),
    "output_torque": (0.0, 5e-2),
    "pin_friction_coefficient": (0.0, 5e-3),
    "pin_friction_diameter": (2e-3, 6e-3),
}
CREEP = {
    "friction_coefficient": (0.06, 0.12),
    "gross_slip_scale": (1e-5, 1e-4),
    "normal": FORCE,
    "tangential": (-5.0, 5.0),
}
PIN = {
    "free_length": (12e-3, 15e-3),
    "roller_length": (5e-3, 10e-3),
    "diameter": (4e-3, 8e-3),
    "youngs_modulus": (1e11, 2e11),
    "poisson_ratio": (0.2, 0.4),
}
RING = {
    "ring": (1e-5, 2e-5),
    "housing": (1e-5, 3e-5),
    "inner_radius": (30e-3, 40e-3),
    "wall_thickness": LENGTH,
    "youngs_modulus": (1e11, 2e11),
    "poisson_ratio": (0.2, 0.4),
    "housing_stiffness": (1e13, 1e15),
}
CAM = {"least_preload": (100.0, 200.0), "force_per_torque": (50.0, 150.0), "output_torque": (-8.0, 8.0)}


def approach(*, secant, incremental, normal_force, rest_force):
    springs = NormalSprings(secant, incremental)
    at = {"springs": springs, "normal_force": normal_force, "rest_force": rest_force}
    return compression(**at), total_approach(**at)


def crowned_approach(*, secant, incremental, normal_force, rest_force, **line):
    crowns = crowned_springs(lines=CrownedLines(**line), rest_force=rest_force)
    springs = NormalSprings(secant, incremental, crowns)
    return total_approach(springs=springs, normal_force=normal_force, rest_force=rest_force)


def bearing_torque(*, pin_force, **friction):
    return bearings.bearing_torque(bearings=bearings.Bearings(**friction), pin_force=pin_force)


def carter_creepages(*, normal, tangential, **law):
    return creepages(law=CreepLaw(**law), normal=normal, tangential=tangential)


def planetary(sun_radius, planet_radius, **_):
    return planetary_drive(sun_radius=sun_radius, planet_radius=planet_radius, planet_count=3)


def multiroller(sun_radius, planet_radius, small_radius, **_):
    rows_of = {"first_row_radii": (planet_radius, 10e-3), "second_row_radii": (18e-3, small_radius)}
    return two_row_multiroller(sun_radius=sun_radius, **rows_of, roller_count=4)


def stepped(sun_radius, planet_radius, small_radius, **_):
    radii = (planet_radius, small_radius)
    return stepped_planet_drive(sun_radius=sun_radius, planet_radii=radii, planet_count=3)


def wedged(sun_radius, planet_radius, small_radius, **_):
    geometry = DriveGeometry(sun_radius, planet_radius, small_radius, 40e-3, 3.0, 0.05, -0.1)
    return wedge_drive(geometry, planet_count=3)


#: Makers of drives from a few radii, and these.
DRIVES = {
    "planetary": (planetary, {"sun_radius": 10e-3, "planet_radius": 20e-3}),
    "multiroller": (multiroller, {"sun_radius": 10e-3, "planet_radius": 16e-3, "small_radius": 9.4e-3}),
    "stepped": (stepped, {"sun_radius": 10e-3, "planet_radius": 20e-3, "small_radius": 18e-3}),
    "wedge": (wedged, {"sun_radius": 4e-3, "planet_radius": 13.5e-3, "small_radius": 5e-3}),
}


def places(drive):
    """Where the bodies are, and what that means for their contacts."""
    return (
        drive.second_radius + layout.gaps(drive),
        layout.incidence(drive),
        layout.sector_rotation(drive, 1.0),
        existence.neighbour_gaps(drive),
        rest_forces(drive=drive, pattern=internal(drive)),
    )


def angles(drive):
    return layout.contact_angles(drive)


def speeds(drive):
    """How fast the members turn, with and without creep."""
    creepage = np.linspace(1e-4, 3e-4, len(drive.contacts))
    ideal = layout.speeds(drive)
    creeping = layout.creeping_speeds(drive=drive, creepage=creepage)
    return ideal, existence.output_share(drive), creeping, surface_speeds(drive=drive, speed=ideal)


def room(drive):
    return existence.has_room(drive)


def internal(drive):
    return np.array([1.0 if contact.internal else 0.0 for contact in drive.contacts])


def forces(drive):
    """What forces of the contacts do to the bodies."""
    count = len(drive.contacts)
    normal, tangential = np.linspace(900.0, 1100.0, count), np.linspace(-20.0, 30.0, count)
    drag = np.linspace(0.1, 0.2, count)
    found = loads.member_loads(
        drive=drive,
        normal=normal,
        tangential=tangential,
        body_force=np.linspace(0.0, 5.0, 2 * len(drive.floating)).reshape(-1, 2),
    )
    moments = loads.member_moments(drive, layout.incidence(drive), tangential, found.pin)
    pair, levers = loads.drag_pairs(drive, drag), loads.drag_levers(drive)
    sizes = expansion.interference_of_sizes(drive=drive, first=1e-6 * drag, second=2e-6 * drag)
    ring = expansion.ring_interference(drive=drive, forces=normal, interference=sizes)
    # what is in balance is so but for rounding
    return found.pin, found.moments + 0.0 * moments, moments, pair, levers, sizes, ring


def alone(drive):
    """Every sector by itself, and what their unlike forces do to the members in the middle."""
    whole = unfolded(drive, sectors=3, floating=("sun",))
    count, pins = len(whole.contacts), len(whole.pinned)
    left = forces_on_centre(
        drive=whole,
        bodies=("sun", "ring"),
        normal=np.linspace(900.0, 1100.0, count),
        tangential=np.linspace(-20.0, 30.0, count),
        pin_force=np.linspace(10.0, 20.0, pins),
    )
    return layout.incidence(whole), left


def held(drive, normal_compliance, tangential_compliance, pin_compliance, pin_spring, planet_spring):
    """Stiffness of springs between the bodies, and with shafts."""
    supports = carrier_supports(
        drive=drive, pin_transverse_stiffness=pin_spring, planet_support_stiffness=planet_spring, planets=()
    )
    network = network_stiffness(
        drive=drive,
        normal_compliance=normal_compliance,
        tangential_compliance=tangential_compliance,
        pin_compliance=pin_compliance,
        supports=supports,
    )
    shafts = {"input_shaft_stiffness": 500.0, "output_shaft_stiffness": 5e4}
    return (
        network.output,
        network.tangential_share,
        with_shafts(stiffness=network.output, ratio=9.0, **shafts),
    )


def states(maker):
    """A drive assembled, standing and rolling; numbers of states that are 0 but for rounding are left out."""

    def of(torque, preload, **radii):
        drive = maker(**radii)
        laws = steel_laws(drive=drive)
        found = drive_states(
            drive=drive, laws=laws, pattern=internal(drive), preload=preload, load=DriveLoad(torque)
        )
        both = (found.standing, found.rolling)
        slip = slip_at_rest(laws=laws, normal=found.standing.normal, tangential=found.standing.tangential)
        shown = [
            (state.normal, state.tangential, state.displacement, state.speed, state.input_torque)
            for state in both
        ]
        return shown, found.rest.normal, slip, contact_approach(laws=laws, normal=found.rest.normal)

    return of


def limit_of(excess):
    """The first limit of two, the second of which is never reached."""

    def found(number):
        return first_limit.first_limit(
            excesses=lambda value: xp.stack([excess(value, number), value - 1e3]),
            first_guess=xp.ones_like(number),
        ).value

    return found


def straight(value, number):
    return value - number


def steep(value, number):
    """Which hardly changes where the search halves its interval."""
    return xp.expm1(30.0 * (value / number - 1.0))


def given(label, function, **numbers):
    return label, Formula(lambda these: function(**these), numbers)


def entry(function, ranges, *borders, label=None, **fixed):
    return label or function.__name__, rows(function, ranges, *borders, **fixed)


def of_drives(what, names=DRIVES, **numbers):
    """A function of drives, whose radii are the numbers."""

    def formula(name):
        maker, radii = DRIVES[name]

        def of(these):
            these = dict(these)
            return what(maker(**{key: these.pop(key) for key in radii}), **these)

        return f"{what.__name__} of {name}", Formula(of, {**radii, **numbers})

    return [formula(name) for name in names]


def tied(friction_coefficient):
    """Equal friction of both inner contacts, whose smaller one counts."""
    maker, radii = DRIVES["wedge"]
    return wedge.self_locking_ratio(maker(**radii), friction_coefficient)


STANDS = {"rotation": 0.0, "output_torque": 0.0}
LIFTED, LEAST = {"normal_force": -10.0}, {"normal_force": lambda row: 1e-6 * row["rest_force"]}
FULL = {"tangential_force": lambda row: row["friction_coefficient"] * row["normal_force"]}
LIMITS = np.array([0.3, 1.0, 2.0, 49.0])
FORMULAS = dict([
    entry(approach, SPRINGS, LIFTED, LEAST),
    entry(bearing_torque, {**BEARINGS, "pin_force": (-200.0, 200.0)}),
    entry(bearings.leading_sense, {"rotation": (-600.0, 600.0), "output_torque": (-5.0, 5.0)}, STANDS),
    entry(carter_creepages, CREEP, {"tangential": lambda row: row["friction_coefficient"] * row["normal"]}),
    entry(drift_per_turn, {"loss": (-1e-3, 1e-3)}, {"loss": 1.0}),
    entry(
        first_limit.slip_ratio,
        {"normal_force": FORCE, "tangential_force": (-5.0, 5.0), "friction_coefficient": (0.06, 0.12)},
        FULL, {"normal_force": 0.0, "tangential_force": 0.0},
    ),
    entry(expansion.ring_expansion, RING, {"housing_stiffness": math.inf}, plane_state="plane_strain"),
    entry(expansion.loosening_rise, {"interference": (1e-6, 3e-5), "change_per_kelvin": (-1e-7, 1e-7)}),
    entry(loading_cam.cam_preload, CAM),
    entry(contact_torsional_stiffness, {"tangential_stiffness": (1e7, 1e9), "radius": LENGTH}),
    entry(pin_beam.pin_beam_compliance, PIN, support="both_ends", label="pin held at both ends"),
    entry(pin_beam.pin_beam_compliance, PIN, support="one_end", label="pin held at one end"),
    entry(pin_beam.pin_bending_stress, {"moment": (0.1, 2.0), "diameter": (4e-3, 8e-3)}),
    entry(inertia.roller_inertia, {"mass": (0.01, 1.0), "radius": LENGTH, "bore_diameter": (0.0, 5e-3)}),
    entry(bearing_life.basic_rating_life, {"dynamic_rating": FORCE, "load": FORCE}, exponent=10.0 / 3.0),
    entry(bearing_life.static_safety, {"static_rating": FORCE, "load": FORCE}),
    *of_drives(places, names=("planetary",)),
    *of_drives(angles),
    *of_drives(speeds, names=("planetary",)),
    *of_drives(room),
    *of_drives(forces),
    *of_drives(alone, names=("planetary",)),
    *of_drives(
        held,
        names=("planetary",),
        normal_compliance=np.array([1e-9, 4e-9]),
        tangential_compliance=np.array([2e-9, 3e-9]),
        pin_compliance=7e-9,
        pin_spring=1e8,
        planet_spring=5e7,
    ),
    given("self-locking with equal friction", tied, friction_coefficient=np.full(5, 0.12)),
    given("first limit, straight", limit_of(straight), number=LIMITS),
    given("first limit, steep", limit_of(steep), number=LIMITS),
])  # fmt: skip
TORQUES = {"planetary": 8.0, "multiroller": 20.0, "stepped": 6.0, "wedge": 5.0}
LARGE = dict([
    entry(crowned_approach, {**SPRINGS, **CROWNS}, LIFTED, edges=(np.nan,)),
    *(
        given(f"states of {name}", states(maker), torque=TORQUES[name], preload=1000.0, **radii)
        for name, (maker, radii) in DRIVES.items()
    ),
    *of_drives(places, names=("multiroller", "stepped", "wedge")),
    *of_drives(speeds, names=("multiroller", "stepped", "wedge")),
])  # fmt: skip

test_both_engines_compute_the_same_numbers, test_slopes_under_numpy_are_those_of_jax = Engines(
    FORMULAS, alone=LARGE
).tests()

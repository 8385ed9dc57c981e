"""The formulas of elastic bodies by NumPy and within programs of JAX: equal numbers and slopes."""

import math

import numpy as np
from both_engines import Engines, Formula, rows

from asperity.body import (
    annulus_modes,
    bore,
    compliance,
    conforming_pin,
    coupling,
    pin_contact,
    press_fit,
    punch,
    rigid_modes,
    rim_kernel,
    rim_moments,
    rim_range,
    rim_stress,
    shapes,
    stepped,
)
from asperity.engine.arrays import xp
from asperity.materials import Material

# between -0.414 and -0.35 XLA's log1p has 2e-14 of error, which third derivatives amplify
ARC = {"arc": (0.42, 0.6)}
#: Arcs below, where the logarithm changes over to its series and in it, and all round.
ARCS = ({"arc": 0.2}, {"arc": 0.049}, {"arc": 0.02}, {"arc": 1.0})
STRESS = (-500e6, 500e6)
PLANE_STRESS = {"first": STRESS, "second": STRESS, "shear": STRESS, "poisson_ratio": (0.2, 0.4)}
FATIGUE = {"mean": STRESS, "amplitude": (1e7, 1e8), "fatigue_strength": (4e8, 5e8), "strength": (8e8, 9e8)}
MODULUS = (100e9, 210e9)
SEAT = {
    "bore_radius": (5e-3, 6e-3),
    "seat_radius": (7e-3, 9e-3),
    "outer_radius": (10e-3, 20e-3),
    "interference": (1e-6, 2e-5),
    "ring_modulus": MODULUS,
    "housing_modulus": MODULUS,
}
RIMS = {"rim": (5e-3, 6e-3), "other": (10e-3, 20e-3), "youngs_modulus": MODULUS, "poisson_ratio": (0.2, 0.4)}
SEPARATED = {"angle": (0.1, 6.0), "second_moment": (0.0, 1e-4), "fourth_moment": (0.0, 1e-8)}
SUPPORT = {"support_stiffness": (1e12, 1e16), "radius": (5e-3, 40e-3), "shear_modulus": (30e9, 80e9)}

DISC = shapes.Disc(13.5e-3, 5e-3, 206e9, 0.3, "plane_strain")
RING = shapes.Annulus(40e-3, 50e-3, 5e-3, 206e9, 0.3, 0.0, 0.0, "inner", "plane_strain")
HOUSED = shapes.Annulus(40e-3, 50e-3, 5e-3, 206e9, 0.3, 4e14, math.inf, "inner", "plane_stress")
PLANET = shapes.Annulus(13e-3, 20e-3, 10e-3, 208e9, 0.3, 0.0, 0.0, "outer", "plane_strain")
THIN = shapes.Annulus(40e-3, 40.1e-3, 5e-3, 206e9, 0.3, 0.0, 0.0, "inner", "plane_strain")
STEPPED = stepped.SteppedRoller((16e-3, 10e-3), (10e-3, 8e-3), 4e-3, 206e9, 0.3, "plane_strain")

ANGLES = np.array([0.3, 2.0, 4.4])
WIDTHS = {"half_widths": np.array([8e-5, 7e-5, 6e-5]), "stick_half_widths": np.array([6e-5, 7e-5, 1e-5])}


def given(function, label=None, **numbers):
    """A formula of modules and arrays that are no rows."""
    return label or function.__name__, Formula(lambda these: function(**these), numbers)


def entry(function, ranges, *borders, **fixed):
    label = " ".join((function.__name__, *map(str, fixed.values())))
    return label, rows(function, ranges, *borders, **fixed)


def walls(body, mode):
    """What follows from the wall of an annulus for several modes."""
    wall = compliance.wall_of(body)
    decay = wall.ratio ** (wall.side * mode)
    field = annulus_modes.mode_field(mode=mode, decay=decay, wall=wall)
    return (
        annulus_modes.added_compliance(mode=mode, decay=decay, wall=wall),
        rim_stress.mode_stress(wall, field, 1.0, -1.0),
        rigid_modes.uniform_field(wall),
        rigid_modes.uniform_compliance(wall),
        compliance.loaded_radius(body),
    )


def moved(body):
    """What follows from the first mode of a wall that nothing supports."""
    wall = compliance.wall_of(body)
    field = rigid_modes.translation_field(wall=wall, plus=1.0, minus=-1.0)
    return field, rigid_modes.translation_compliance(wall)


def matrix(label, body, copies, mode_count):
    def compliances(**numbers):
        return compliance.compliance_matrix(copies=copies, mode_count=mode_count, **numbers)

    return given(compliances, label, body=body, contact_angles=ANGLES, **WIDTHS)


def machine(body, disc, contact_angles, contact_lengths, **widths):
    """A ring of three sectors around rollers of one sector each, which share its three contacts."""
    bodies = [
        coupling.BodyInMachine(body, (0, 1, 2), contact_angles, np.asarray(3.0)),
        *(coupling.BodyInMachine(disc, (k,), contact_angles[k : k + 1], None) for k in range(3)),
    ]
    kernel = coupling.machine_kernel(bodies)
    found = coupling.coupled_compliance(
        bodies=bodies, contact_lengths=contact_lengths, kernel=kernel, **widths
    )
    return kernel, found


def machine_of(label, body):
    sizes = {"contact_angles": ANGLES, "contact_lengths": np.full(3, 4e-3)}
    return given(machine, label, body=body, disc=DISC, **sizes, **WIDTHS)


def rims(label, body, fineness, sectors):
    def stresses(body, **forces):
        loads = rim_range.RimLoads(**forces, sectors=sectors)
        found = rim_range.rim_stresses(body=body, loads=loads, fineness=fineness)
        # one scale for all of them: a free rim has no radial stress
        together = (found.other_hoop, found.other_radial, found.other_shear)
        span = rim_range.rim_range(body=body, stresses=found)
        places = rim_range.places_of(loads, fineness)
        return places, found.loaded_hoop, xp.stack(together), span._replace(pull=xp.zeros(()))

    return given(
        stresses,
        label,
        body=body,
        angles=0.2 * ANGLES,
        radial=np.array([1.0, 0.3, -0.4]),
        tangential=np.array([0.2, -0.1, 0.3]),
        half_widths=WIDTHS["half_widths"],
    )


def pressed_pin(body, contact_angles, push_angle, clearance, force):
    """A pin in a bore: its contact under a force, and the stresses that it makes."""
    modes = bore.bore_modes(body=body, contact_angles=contact_angles, push_angle=push_angle)
    track = {"shift": modes.shift, "scale": modes.scale, "wall": modes.wall}
    law = pin_contact.pin_contact(
        **{name: number[None, None] for name, number in track.items()},
        pressed=np.array([[True]]),
        clearance=clearance,
    )
    angle = law.angle(force)
    stress = bore.pin_stress(body=body, force=force[0], arc=np.asarray(0.3), away=contact_angles)
    return modes, law, angle, law.approach(force, angle), law.slopes(force, angle), stress


def pin_with(label, clearance):
    at = {"contact_angles": np.array([0.0, math.pi]), "push_angle": 1.2}
    return given(
        pressed_pin, label, body=PLANET, clearance=np.array([clearance]), force=np.array([110.0]), **at
    )


def press_fit_of(*, ring_modulus, housing_modulus, bore_radius, seat_radius, outer_radius, interference):
    ring, housing = (Material(modulus, 0.3, 7800.0, 1e9, 3e9) for modulus in (ring_modulus, housing_modulus))
    return press_fit.press_fit(
        ring=ring,
        housing=housing,
        bore_radius=bore_radius,
        seat_radius=seat_radius,
        outer_radius=outer_radius,
        interference=interference,
    )


def addition(roller, contact_angles):
    tracks = (0, 1, 1)
    return stepped.bore_addition(
        roller=roller, contact_angles=contact_angles, contact_tracks=tracks, sectors=np.asarray(2.0)
    )


def closed_kernel(angle, plus, minus):
    sectors = np.array([1.0, 3.0, 4.0, 1.0])
    return rim_moments.closed_kernel(angle=angle, plus=plus, minus=minus, sectors=sectors)


THREE, MODES = np.asarray(3.0), np.array([2.0, 3.0, 9.0, 60.0])
FORMULAS = dict([
    entry(shapes.kolosov_constant, {"poisson_ratio": (0.0, 0.5)}, plane_state="plane_strain"),
    entry(shapes.kolosov_constant, {"poisson_ratio": (0.0, 0.5)}, plane_state="plane_stress"),
    entry(annulus_modes.support_weights, SUPPORT),
    given(walls, body=HOUSED, mode=MODES),
    given(moved, body=PLANET),
    matrix("compliance of a disc of three sectors", DISC, 3, 0),
    entry(conforming_pin.conforming_pressure, {"angle": (-1.6, 1.6), **ARC}, *ARCS[:3]),
    entry(conforming_pin.clearance_share, ARC, *ARCS),
    entry(conforming_pin.conforming_compliance, ARC, *ARCS),
    entry(conforming_pin.fitting_load, ARC, *ARCS),
    entry(conforming_pin.pressure_shares, ARC, *ARCS),
    entry(conforming_pin.half_angle, ARC, *ARCS),
    entry(conforming_pin.clearance_slopes, ARC, *ARCS),
    entry(conforming_pin.fitting_slopes, ARC, *ARCS),
    entry(press_fit.rim_compliance, RIMS),
    entry(press_fit_of, SEAT, {"interference": -1e-6}),
    entry(punch.punch_factor, {"argument": (0.0, 12.0)}, {"argument": 1e-9}),
    entry(punch.distance_moments, {"half_width_1": (1e-3, 1e-2), "half_width_2": (1e-3, 1e-2)}),
    entry(rim_kernel.separated_sums, SEPARATED, {"angle": math.pi}),
    entry(rim_kernel.separated_derivatives, {"angle": (0.1, 6.0)}, {"angle": math.pi}),
    entry(rim_kernel.self_sums, {"punch_angle": (1e-4, 1e-2)}),
    given(
        rim_moments.weighted_mean,
        kernel=np.random.default_rng(3).normal(size=(rim_moments.MOMENTS, 4)),
        square_1=np.array([0.0, 1e-4, 1e-3, 1e-2]),
        square_2=np.array([1e-3, 1e-4, 0.0, 1e-2]),
    ),
    given(closed_kernel, angle=np.array([0.0, 0.7, -1.3, 2.9]), plus=np.full(4, 1.8), minus=np.ones(4)),
    entry(rim_moments.walls_resolved, {"ratio": (0.5, 0.999), "sectors": (1.0, 6.0)}, one_sector=False),
    entry(rim_range.mises_stress, PLANE_STRESS, dict.fromkeys(PLANE_STRESS, 0.0), plane_state="plane_strain"),
    entry(rim_range.fatigue_safety, FATIGUE, {"mean": 0.0, "amplitude": 0.0}),
])  # fmt: skip
LARGE = dict(
    [
        given(walls, "walls of a free ring", body=RING, mode=MODES),
        given(walls, "walls of a hollow roller", body=PLANET, mode=MODES),
        matrix("compliance of a ring", RING, 3, 40),
        matrix("compliance of a ring in a housing", HOUSED, 1, 80),
        matrix("compliance with too few modes", PLANET, 1, 3),
        machine_of("machine", RING),
        machine_of("machine of a thin ring", THIN),
        pin_with("pin with clearance", 5e-6),
        pin_with("pin without clearance", 0.0),
        rims("rims of a ring in a housing", HOUSED, 1, THREE),
        rims("rims of a hollow roller", PLANET, 2, None),
        rims("rims of a thin ring", THIN, 1, THREE),
        given(addition, roller=STEPPED, contact_angles=ANGLES),
    ]
)

test_both_engines_compute_the_same_numbers, test_slopes_under_numpy_are_those_of_jax = Engines(
    FORMULAS, alone=LARGE
).tests()

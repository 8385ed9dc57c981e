"""The formulas of contacts by NumPy and within programs of JAX: equal numbers and slopes."""

import functools
import inspect

import numpy as np
from both_engines import Engines, Formula, rows
from traction_contacts import oiled_contact, same_layer

from asperity.contact import (
    asperity,
    carter,
    creep_capacity,
    creep_inverse,
    creep_law,
    creep_layer,
    crowned_line,
    crowned_shear,
    exponential,
    film_thickness,
    film_traction,
    flash_temperature,
    fluid,
    fractal,
    hertz_line,
    interface,
    life_factor,
    load_sharing,
    measured_traction,
    persson_2007,
    population,
    roller_pairs,
    roller_profiles,
    rolling_fatigue,
    rolling_in,
    rolling_losses,
    shakedown,
    skew,
    stress_peaks,
    strip_theory,
    subsurface_stress,
    tilt_stiffness,
    tilted_line,
)
from asperity.contact.laws.exponential import Exponential
from asperity.contact.laws.zou_2025 import Zou2025
from asperity.materials import ContactPair

#: Numbers of the contacts of steel rollers, by the names of the arguments. SI units.
RANGES = {
    "base_length": (3e-6, 9e-6),
    "centre": (-1e-4, 1e-4),
    "cleanliness": (0.1, 1.0),
    "conductivity": (20.0, 60.0),
    "contact_factor": (0.1, 2.0),
    "contact_length": (3e-3, 20e-3),
    "contact_modulus": (80e9, 150e9),
    "creepage": (-2e-3, 2e-3),
    "crown_curvature": (0.05, 3.0),
    "deformation": (1e-9, 1e-7),
    "decay_length": (1e-8, 1e-6),
    "density": (7e3, 8e3),
    "depth": (1e-5, 1e-4),
    "effective_radius": (5e-3, 20e-3),
    "effusivity_1": (1e4, 2e4),
    "effusivity_2": (1e4, 2e4),
    "elastic_load_coefficient": (0.5, 1.0),
    "entrainment_speed": (0.1, 5.0),
    "even_half_width": (5e-5, 2e-4),
    "fatigue_load_ratio": (0.1, 0.6),
    "film_ratio": (0.2, 3.0),
    "film_thickness": (1e-8, 1e-6),
    "fractal_dimension": (1.1, 1.9),
    "fractal_roughness": (1e-11, 1e-9),
    "frequency_ratio": (1.2, 2.0),
    "friction_coefficient": (0.06, 0.12),
    "friction_power": (1.0, 1e4),
    "gross_slip_creepage": (5e-4, 3e-3),
    "half_width": (5e-5, 2e-4),
    "hardness": (1e9, 8e9),
    "heat_capacity": (400.0, 500.0),
    "largest_area": (1e-10, 2e-9),
    "lateral_creepage": (-3e-3, 3e-3),
    "lateral_gross_slip_creepage": (7e-4, 4e-3),
    "lateral_slip_ratio": (-0.65, 0.65),
    "lateral_strain_compliance": (1e-12, 3e-12),
    "layer_ratio": (1e-3, 3.0),
    "life": (1.0, 1e4),
    "line_load": (1e4, 3e5),
    "log_load_ratio": (-3.0, 30.0),
    "logarithmic_compliance": (1e-10, 1e-9),
    "longitudinal_creepage": (-3e-3, 3e-3),
    "longitudinal_slip_ratio": (-0.65, 0.65),
    "loss_factor": (0.005, 0.05),
    "material_constant": (1e60, 1e62),
    "mean_pressure": (1e7, 1e9),
    "model_number": (1.0, 1.0),
    "normal_compliance": (1e-9, 1e-8),
    "normal_force": (600.0, 3000.0),
    "normal_stiffness": (1e8, 1e10),
    "peak_pressure": (5e8, 2e9),
    "peak_traction": (1e7, 1e8),
    "poisson_ratio": (0.2, 0.45),
    "poisson_ratio_1": (0.2, 0.45),
    "poisson_ratio_2": (0.2, 0.45),
    "position": (-1e-4, 1e-4),
    "pressure_coefficient": (1e-8, 3e-8),
    "radius": (5e-3, 30e-3),
    "radius_1": (4e-3, 10e-3),
    "radius_2": (12e-3, 30e-3),
    "reliability": (0.5, 0.99),
    "rms_height": (1e-8, 1e-6),
    "rms_slope": (0.01, 0.2),
    "rolled_distance": (0.0, 1e-3),
    "rolling_force": (1.0, 10.0),
    "rolling_speed": (0.1, 5.0),
    "rolling_share": (0.05, 0.95),
    "roughness": (1e-8, 1e-6),
    "share": (0.05, 0.95),
    "shear_stress": (1e8, 5e8),
    "sign": (-1.0, -1.0),
    "slip_factor": (0.1, 1.0),
    "slip_ratio": (-0.95, 0.95),
    "spot_area": (1e-12, 1e-9),
    "stick_force": (100.0, 600.0),
    "stick_fraction": (0.0, 0.99),
    "stiffness_1": (1e7, 1e9),
    "stiffness_2": (1e7, 1e9),
    "stiffness_ratio": (0.7, 1.2),
    "stressed_volume": (1e-9, 1e-7),
    "stroke": (0.0, 1e-3),
    "summit_radius": (1e-6, 1e-4),
    "surface_speed_1": (0.1, 5.0),
    "surface_speed_2": (0.1, 5.0),
    "tangential_contact_modulus": (30e9, 60e9),
    "tangential_force": (0.0, 30.0),
    "target": (1.0, 20.0),
    "track_radius": (5e-3, 30e-3),
    "viscosity": (0.01, 0.1),
    "viscosity_ratio": (0.15, 3.9),
    "wall_thickness": (3e-3, 20e-3),
    "yield_strength": (5e8, 2e9),
    "youngs_modulus": (1e11, 3e11),
    "youngs_modulus_1": (1e11, 3e11),
    "youngs_modulus_2": (1e11, 3e11),
}
CROWN = ("crown_curvature", "contact_length", "effective_radius", "contact_modulus")
PAIR = ("radius_1", "radius_2", "sign", "contact_length", "friction_coefficient")
MODULI = ("contact_modulus", "tangential_contact_modulus", "hardness", "yield_strength")
SURFACE = ("fractal_dimension", "fractal_roughness", "frequency_ratio")
FORCES = ("normal_force", "tangential_force")


def takes(*names):
    """Marks a function of a dictionary of numbers as one of these keywords."""

    def of(function):
        def by_keywords(**numbers):
            return function(numbers)

        by_keywords.takes, by_keywords.__name__ = names, function.__name__
        return by_keywords

    return of


def part(numbers, names):
    return {name: numbers[name] for name in names}


def surface_of(numbers):
    return Zou2025(**part(numbers, SURFACE), asperity_base="circular_spot")


def pairs_of(numbers, surface):
    moduli = ContactPair(**part(numbers, MODULI))
    return roller_pairs.roller_pairs(**part(numbers, PAIR), moduli=moduli, surface=surface)


@takes(*SURFACE, *FORCES, "friction_coefficient", "contact_factor", *MODULI[:3])
def fractal_contact(numbers):
    others = part(numbers, numbers.keys() - set(SURFACE))
    return fractal.fractal_contact(surface=surface_of(numbers), **others)


@takes("decay_length", *FORCES, "friction_coefficient", *MODULI[:2], "contact_length")
def random_contact(numbers):
    others = part(numbers, numbers.keys() - {"decay_length"})
    return exponential.random_contact(
        roughness=exponential.RandomRoughness(numbers["decay_length"]), **others
    )


@takes(*PAIR, *MODULI, *SURFACE, *FORCES, "contact_factor")
def rough_contacts(numbers):
    under = part(numbers, (*FORCES, "contact_factor"))
    return roller_pairs.rough_contacts(pairs=pairs_of(numbers, surface_of(numbers)), **under)


@takes(*PAIR, *MODULI, "decay_length", "normal_force", "model_number")
def numbered_contact_factors(numbers):
    pairs = pairs_of(numbers, Exponential(numbers["decay_length"]))
    under = part(numbers, ("model_number", "normal_force"))
    return roller_pairs.numbered_contact_factors(pairs=pairs, **under), pairs.half_width(
        under["normal_force"]
    )


@takes("longitudinal_slip_ratio", "lateral_creepage", "gross_slip_creepage", "lateral_gross_slip_creepage")
def skewed_contact(numbers):
    found = skew.skewed_contact(**numbers)
    return found, found.slip_ratio


ROLLING = ("position", "depth", "half_width", "peak_pressure", "friction_coefficient", "slip_ratio")


@takes(*ROLLING, "poisson_ratio")
def mises_stress(numbers):
    stress = subsurface_stress.rolling_stress(**part(numbers, ROLLING))
    return subsurface_stress.mises_stress(stress=stress, poisson_ratio=numbers["poisson_ratio"])


def oiled_numbers(oil):
    """Three contacts with an oil, their dry factors of creepage, and tractions of which one is beyond the capacity."""
    oiled = oiled_contact(oil, 50.0, np.array([0.02, 0.4, 4.0]), 2e-7)
    return {
        "contact": oiled.contact,
        "inlet": oiled.inlet,
        "layer_factor": oiled.layer_factor,
        "share": np.array([-0.3, 0.9, 1.4]),
    }


def creep_of_oiled_contacts(contact, inlet, layer_factor, share):
    shares = load_sharing.shared_load(
        inlet=inlet,
        decay_length=1e-7 * layer_factor,
        rms_height=2e-7 * layer_factor,
        half_width=contact.half_width,
        mean_pressure=0.8 * contact.peak_pressure,
    )
    capacity = creep_capacity.traction_capacity(contact=contact, layer_factor=layer_factor)
    creepage = creep_inverse.creepage_at_traction(
        contact=contact,
        traction=share * capacity.traction,
        layer=same_layer(layer_factor),
        capacity=capacity,
    )
    return {"shares": shares, "capacity": capacity.traction, "creepage": creepage}


def measured_numbers():
    """Contacts whose oil has curves of two temperatures, with what is a number of them, and values over pressure."""
    creepage = np.geomspace(1e-4, 2e-2, 7)
    curves = tuple(
        measured_traction.traction_curve(creepage=creepage, coefficient=most * creepage / (creepage + 1e-3))
        for most in (0.06, 0.08)
    )
    at = measured_traction.TractionConditions
    over = functools.partial(measured_traction.TractionTable, at(pressures=(0.5e9, 1.5e9), speeds=(0.1, 1.0)))
    sheet = fluid.DataSheetTraction(over((0.08, 0.07, 0.1, 0.09)), over((200.0, 180.0, 150.0, 140.0)))
    return {
        "contact": oiled_contact("M100", 50.0, np.array([0.02, 0.4, 4.0]), 2e-7).contact,
        "measured": measured_traction.MeasuredTraction(at(temperatures=(300.0, 340.0)), curves),
        "sheet": sheet,
    }


def creep_of_measured_contacts(contact, measured, sheet):
    tractions = [
        creep_law.traction_at_creepage(
            contact=film_traction.MixedContact(**vars(contact) | {"fluid": oil}),
            creepage=np.array([3e-4, 2e-3, 1e-2]),
            layer_factor=np.array([1.1, 1.2, 1.3]),
        )
        for oil in (
            fluid.Fluid(contact.fluid.viscosity, each, contact.fluid.conductivity)
            for each in (measured, sheet)
        )
    ]
    return [each.traction for each in tractions]


def entry(function, *borders, own=None, **fixed):
    """A formula by its name: its numbers from the ranges, or from its own ones, and rows at its borders."""
    names = getattr(function, "takes", None)
    if names is None:
        given = inspect.signature(function).parameters.items()
        names = [name for name, one in given if name not in fixed and one.default is inspect.Parameter.empty]
    if "line" in names:
        names = [name for name in names if name != "line"] + list(CROWN)
    ranges = part(RANGES | (own or {}), names)
    place = function.__module__.rpartition(".")[2].replace("test_both_engines", "roller_pairs")
    label = " ".join((f"{place}.{function.__name__}", *fixed.values()))
    return label, rows(function, ranges, *borders, **fixed)


def arrays(function, **numbers):
    """A formula of arrays that are no rows."""
    return function.__name__, Formula(lambda given: function(**given), numbers)


def lines_with_profiles(normal_force):
    """A circle between two logarithmic profiles, and what they add to the approach."""
    given = {
        "normal_force": normal_force,
        "crown_curvature": np.array([0.2, 0.5, 1.5]),
        "contact_length": 10e-3,
        "effective_radius": 7e-3,
        "contact_modulus": 113e9,
        "logarithmic": np.array([1.0, 0.0, 1.0]),
    }
    line = crowned_line.crowned_line(**given)
    return line.line_load, line.loaded_share, crowned_line.crown_compression(**given)


def persson_decay_length(mean_pressure, contact_modulus, **waves):
    spectrum = persson_2007.WaveSpectrum(**waves)
    return persson_2007.persson_decay_length(
        spectrum=spectrum, mean_pressure=mean_pressure, contact_modulus=contact_modulus
    )


#: Numbers of tilted contacts.
TILTED = {
    "half_width": (5e-5, 3e-4),
    "loaded_length": (5e-3, 2e-2),
    "line_load_stiffness": (3e10, 6e10),
    "line_load": (1e4, 3e5),
    "peak_pressure": (3e8, 2e9),
    "tilt": (0.0, 1e-3),
    "freeing_tilt": (3e-4, 2e-3),
}
# rows at the borders of the regimes
SINGULAR = {"fractal_dimension": 1.5}
GROSS_SLIP = {"tangential_force": lambda row: row["friction_coefficient"] * row["normal_force"]}
BEYOND = {"tangential_force": lambda row: 1.1 * row["friction_coefficient"] * row["normal_force"]}
ALL_FRICTION = ({"slip_ratio": 1.0}, {"slip_ratio": -1.0}, {"slip_ratio": 1.2})
CYLINDERS, ENDS_LOADED = {"crown_curvature": 0.0}, {"crown_curvature": 1e-4}
AT_EDGE = {"position": lambda row: row["half_width"]}
PARALLEL, WHOLE = {"lateral_creepage": 0.0}, {"longitudinal_slip_ratio": 1.0}
END_OF_TABLE = {"friction_coefficient": stress_peaks.SHEAR_FRICTION}
BASE = {"asperity_base": "circular_spot"}

GENERATOR = np.random.default_rng(7)
# slices of six contacts, of which the last slice does not touch
TOUCHES = np.arange(5)[:, None] < 4
# lives of four parts at three loads: one does not tire at the last of them, one never turns, one is not known
LIVES = GENERATOR.uniform(1e5, 1e7, (3, 4))
LIVES[2, 1], LIVES[0, 3] = np.inf, np.nan
VARIANCE = np.cumsum(GENERATOR.uniform(0.0, 1e-3, 20))
SPECTRUM = {
    "lives": LIVES,
    "cycle_rates": GENERATOR.uniform(1.0, 50.0, (3, 4)) * np.array([1.0, 1.0, 0.0, 1.0]),
    "time_shares": np.array([[0.2], [0.3], [0.5]]),
}

FORMULAS = dict(
    [
        entry(asperity.base_length, asperity_base="majumdar_bhushan_1991"),
        entry(asperity.base_length, **BASE),
        entry(asperity.asperity_height, SINGULAR, own={"position": (-6e-6, 6e-6)}),
        entry(asperity.summit_radius, SINGULAR),
        entry(asperity.elastic_spot_area),
        entry(asperity.hertz_load),
        entry(asperity.plastic_spot_area),
        entry(asperity.plastic_spot_load),
        entry(asperity.base_factor, **BASE),
        entry(asperity.elastic_spot_load, SINGULAR, **BASE),
        entry(asperity.slip_factor, GROSS_SLIP, BEYOND),
        entry(asperity.tangential_spot_stiffness),
        entry(asperity.normal_spot_stiffness),
        entry(carter.gross_slip_creepage),
        entry(carter.creepage, *ALL_FRICTION),
        entry(carter.slip_ratio_at_creepage, {"creepage": lambda row: -row["gross_slip_creepage"]}),
        entry(carter.stick_half_width, *ALL_FRICTION),
        entry(carter.stick_centre, *ALL_FRICTION),
        entry(carter.rolling_traction, *ALL_FRICTION, AT_EDGE),
        entry(creep_layer.layer_ratio),
        entry(creep_layer.width_factor),
        entry(creep_layer.peak_pressure_factor),
        entry(creep_layer.layer_creepage_factor, *ALL_FRICTION, {"layer_ratio": 2000.0}),
        entry(exponential.decay_length),
        entry(exponential.lay_factor, {"rolling_share": 0.5}),
        entry(exponential.lay_stiffness_ratio, {"share": 0.5}),
        entry(exponential.line_contact_factor),
        entry(random_contact, GROSS_SLIP, BEYOND),
        entry(film_thickness.minimum_film_thickness),
        entry(film_thickness.film_ratio),
        entry(flash_temperature.thermal_effusivity),
        entry(flash_temperature.flash_temperature),
        entry(flash_temperature.partial_slip_flash_factor, {"stick_fraction": 1.0}),
        entry(fractal.elastic_load_coefficient, **BASE),
        entry(fractal.log_area_ratio, SINGULAR, {"log_load_ratio": 0.0}),
        entry(fractal_contact, SINGULAR, GROSS_SLIP, BEYOND, {"normal_force": 1e-9}),  # all spots plastic
        entry(hertz_line.effective_radius),
        entry(hertz_line.half_width),
        entry(hertz_line.peak_pressure),
        entry(hertz_line.first_yield_pressure),
        entry(hertz_line.logarithmic_compliance),
        entry(hertz_line.roller_secant_compliance),
        entry(hertz_line.ring_secant_compliance),
        entry(hertz_line.stick_half_width, GROSS_SLIP, BEYOND),
        entry(hertz_line.partial_slip_compliance, GROSS_SLIP, BEYOND),
        entry(interface.series_stiffness, {"stiffness_1": 0.0, "stiffness_2": 0.0}),
        entry(interface.bulk_tangential_stiffness, GROSS_SLIP, BEYOND),
        entry(life_factor.viscosity_ratio),
        entry(life_factor.fatigue_load_ratio, {"peak_pressure": 0.0}),
        entry(
            life_factor.life_modification_factor,
            *({"viscosity_ratio": ratio} for ratio in (0.05, 0.3, 0.6, 5.0)),
            {"fatigue_load_ratio": 50.0},
            {"fatigue_load_ratio": np.inf},
        ),
        entry(persson_2007.contact_fraction, {"mean_pressure": 1e12}),  # complete contact
        entry(population.domain_extension_factor, SINGULAR),
        entry(population.critical_area, SINGULAR),
        entry(population.contact_factor, model="printed"),
        entry(population.contact_factor, model="hertz_area"),
        entry(population.contact_factor, model="unity"),
        entry(population.spot_density, SINGULAR, {"spot_area": lambda row: row["largest_area"]}),
        entry(rough_contacts, SINGULAR, GROSS_SLIP),
        entry(numbered_contact_factors, *({"model_number": number} for number in (0.0, 1.0, 2.0, 3.0))),
        entry(rolling_fatigue.stressed_track_life),
        entry(rolling_fatigue.line_contact_life),
        entry(rolling_fatigue.life_at_reliability),
        entry(rolling_in.rolling_in_length, *ALL_FRICTION),
        entry(rolling_in.rolling_in_lag, *ALL_FRICTION),
        entry(rolling_in.rolling_in_shift, *ALL_FRICTION, {"rolled_distance": 1.0}),
        entry(rolling_in.still_stroke, *ALL_FRICTION),
        entry(rolling_in.swing_drift_share, *ALL_FRICTION, {"slip_ratio": 0.97}, {"stroke": 1.0}),
        entry(rolling_losses.creep_power),
        entry(rolling_losses.hysteresis_moment),
        entry(rolling_losses.inlet_rolling_force),
        entry(rolling_losses.inlet_rolling_power),
        entry(shakedown.shear_yield_strength),
        entry(shakedown.shakedown_limit, END_OF_TABLE, {"friction_coefficient": 0.5}),
        entry(shakedown.mises_elastic_limit, END_OF_TABLE, {"poisson_ratio": 0.5}, {"poisson_ratio": 0.1}),
        entry(shakedown.tresca_elastic_limit, END_OF_TABLE, {"poisson_ratio": 0.5}),
        entry(skew.lateral_compliance_ratio),
        entry(skew.stick_fraction, {"longitudinal_slip_ratio": 0.6, "lateral_slip_ratio": 0.8}),
        entry(skew.skewed_slip_ratios, {"longitudinal_creepage": 0.0, "lateral_creepage": 0.0}),
        entry(skewed_contact, WHOLE, PARALLEL, WHOLE | PARALLEL),
        entry(skew.axial_force),
        entry(
            skew.longitudinal_capacity_ratio,
            {"lateral_creepage": lambda row: row["lateral_gross_slip_creepage"]},
        ),
        entry(stress_peaks.mises_friction),
        entry(strip_theory.strip_logarithm, {"target": 1.0}),
        entry(tilted_line.logarithmic_end_drop),
        arrays(
            strip_theory.strip_creepage,
            slip_ratio=np.array([0.0, 0.4, -0.7, 1.0, 1.1, np.nan]),
            capacity=np.where(TOUCHES, GENERATOR.uniform(5.0, 50.0, (5, 6)), 0.0),
            gross_slip_creepage=np.where(TOUCHES, GENERATOR.uniform(5e-4, 3e-3, (5, 6)), 0.0),
        ),
        arrays(rolling_fatigue.spectrum_life, **SPECTRUM),
        arrays(rolling_fatigue.damage_shares, **SPECTRUM),
        arrays(
            persson_decay_length,
            mean_pressure=np.array(
                [0.0, 1e6, 1e9, 1e11, np.nan, np.inf]
            ),  # the fourth makes a complete contact
            contact_modulus=113e9,
            wavenumber=np.geomspace(1e4, 1e7, 20),
            slope_variance=VARIANCE,
            rms_height=3e-7,
            rms_slope=VARIANCE[-1] ** 0.5,
        ),
        *(arrays(creep_of_oiled_contacts, **oiled_numbers(oil)) for oil in ("M100",)),
        arrays(creep_of_measured_contacts, **measured_numbers()),
        arrays(tilted_line.logarithmic_drop, even_half_width=1e-4, contact_length=10e-3),
        arrays(lines_with_profiles, normal_force=np.array([300.0, 900.0, 2000.0])),
        entry(roller_profiles.lundberg_coefficient, own={"line_load": (1e4, 3e5)}),
        entry(roller_profiles.iso_16281_coefficient, own={"roller_diameter": (5e-3, 0.1)}),
        entry(roller_profiles.johns_gohar_share),
        arrays(roller_profiles.logarithmic_profile, coefficient=6e-7, end_share=0.99),
        entry(tilt_stiffness.line_load_stiffness, own=TILTED),
        entry(tilt_stiffness.tilt_stiffness, own=TILTED),
        entry(tilt_stiffness.freeing_tilt, own=TILTED),
        entry(tilt_stiffness.pressed_end_pressure, own=TILTED),
        arrays(
            tilt_stiffness.tilting_moment, line_load=1e5 * (1.0 + tilted_line.PLACES), contact_length=10e-3
        ),
        arrays(
            tilted_line.profiled_line,
            gap=3e-7 * tilted_line.PLACES + 2e-6 * tilted_line.PLACES**4,
            normal_force=1000.0,
            contact_length=10e-3,
            effective_radius=8e-3,
            contact_modulus=113e9,
        ),
    ]
)

LARGE = dict(
    [
        entry(crowned_line.crowned_line, CYLINDERS, ENDS_LOADED),
        entry(crowned_line.compression_and_shortening, CYLINDERS, ENDS_LOADED),
        entry(crowned_line.crown_compliance, CYLINDERS, ENDS_LOADED),
        entry(crowned_shear.crown_shear_compliance, CYLINDERS, ENDS_LOADED),
        entry(crowned_shear.crown_slip, CYLINDERS, {"stick_force": lambda row: row["normal_force"]}),
        entry(stress_peaks.full_slip_stress, own={"position": (-1.5, 1.5), "depth": (0.1, 1.5)}),
        entry(subsurface_stress.traction_stress),
        entry(mises_stress, *ALL_FRICTION, AT_EDGE | {"depth": 0.0}),
    ]
)

test_both_engines_compute_the_same_numbers, test_slopes_under_numpy_are_those_of_jax = Engines(
    FORMULAS, alone=LARGE
).tests()

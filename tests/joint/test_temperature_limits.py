"""What a joint loses as its temperature changes: by hand, and against the joint solved at that temperature."""

import math

import numpy as np
import pytest

from asperity.engine.arrays import as_numbers
from asperity.errors import NoSolutionError
from asperity.joint.solve import joint_state
from asperity.joint.temperature_limits import (
    AtTemperature,
    TemperatureLimit,
    limit_words,
    limits_document,
    temperature_limits,
)
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solve_case

SECTIONS = '\n[temperature]\nassembly = "20 degC"\nworking = "{working} degC"\n'
HOUSING = '\n[housing]\nouter_diameter = "150 mm"\ninterference = "{fit} um"\nfriction_coefficient = 0.12\n'


@pytest.fixture(scope="module")
def text_of(zou_file):
    """The planetary example, its ring free or pressed into a housing of aluminium as its comments describe."""

    def text(*, working, fit=None, ring="52100", load='interference = "30 um"'):
        said = zou_file.with_name("planetary.toml").read_text(encoding="utf-8")
        said = said.replace('ring = "52100"', f'ring = "{ring}"').replace('interference = "30 um"', load, 1)
        said += SECTIONS.format(working=working)
        if fit is None:
            return said
        said = said.replace('ring_support = "free" ', 'ring_support = "elastic_housing" ')
        said = said.replace('sun = "52100"', 'sun = "52100"\nhousing = "6061-T6"')
        return said + HOUSING.format(fit=fit)

    return text


@pytest.fixture(scope="module")
def solved_of(text_of):
    return lambda **given: solve_case(parse_case(text_of(**given), source="planetary.toml"))


@pytest.mark.slow
def test_a_ring_of_another_material_outgrows_its_rollers(solved_of):
    """440C in place of 52100, 10.1 instead of 12.6e-6 1/K on 50 mm: cooling takes 30 um in 240 K."""
    _, document = solved_of(working=20, ring="440C")
    (limit,) = document["preload"]["temperature_limits"]
    assert (limit["lost"], limit["side"]) == ("interference", "below")
    assert limit["temperature_degC"] == pytest.approx(20.0 - 30.0 / (50e-3 * 2.5e-6 * 1e6), rel=1e-9)
    assert document["preload"]["at_assembly"]["loose_temperature_degC"] == limit["temperature_degC"]


@pytest.mark.slow
def test_the_seat_in_a_warm_housing_is_lost_before_the_interference(solved_of):
    """6061-T6 around 52100, 23.6 and 12.6e-6 1/K on 116 mm: 60 um last 47 K; between the rollers less."""
    solved, document = solved_of(working=20, fit=60)
    between, alone = document["preload"]["temperature_limits"]
    assert (between["lost"], between["part"], between["side"]) == ("seat_between_rollers", "ring", "above")
    assert (alone["lost"], alone["part"], alone["side"]) == ("seat", "ring", "above")
    assert alone["temperature_degC"] == pytest.approx(20.0 + 60.0 / (0.116 * 11.0), rel=1e-9)
    assert document["preload"]["at_assembly"]["loose_temperature_degC"] is None
    assert document["envelope_diameter_m"] == pytest.approx(0.150, rel=1e-12)
    # the joint at that temperature: nothing presses where its loads show the smallest pressure
    at_limit, _ = solved_of(working=between["temperature_degC"], fit=60)
    least, there = (float(each.rims.seat_pressure[2]) for each in (solved, at_limit))
    assert abs(there) < 1e-4 * least
    assert np.all(np.asarray(at_limit.result.rest.normal) > 1000.0)


@pytest.mark.slow
def test_a_preload_by_force_keeps_its_force_and_loses_the_seat(solved_of):
    _, document = solved_of(working=40, fit=60, load='preload = "800 N"')
    preload = document["preload"]
    assert preload["at_assembly"] is None
    between, alone = preload["temperature_limits"]
    assert between["lost"] == "seat_between_rollers"
    assert alone["temperature_degC"] == pytest.approx(20.0 + 60.0 / (0.116 * 11.0), rel=1e-9)
    assert 20.0 < between["temperature_degC"] < alone["temperature_degC"]


@pytest.mark.slow
def test_one_of_two_rings_lets_go_where_the_joint_solved_there_loses_its_contact(zou_file):
    """A driven ring of 440C around stepped planets of 52100 is the first to have no force in the cold."""
    text = zou_file.with_name("stepped_planet.toml").read_text(encoding="utf-8")
    text = text.replace('driven_ring = "52100"', 'driven_ring = "440C"')

    def case_at(celsius):
        return parse_case(text + SECTIONS.format(working=celsius), source="x")

    solved, document = solve_case(case_at(20))
    first, *_ = (each for each in document["preload"]["temperature_limits"] if each["side"] == "below")
    assert (first["lost"], first["part"]) == ("contact", "pr2")
    joint = joint_from_case(case_at(first["temperature_degC"] + 0.1))
    near = joint_state(as_numbers(joint)).rest
    forces = np.asarray(near.normal) / np.asarray(solved.result.rest.normal)
    assert 0.0 < forces[2] < 2e-3
    assert np.all(forces[:2] > 0.5)
    with pytest.raises(NoSolutionError):
        solve_case(case_at(first["temperature_degC"] - 0.1))


def described(text_of, **given):
    return joint_from_case(parse_case(text_of(**given), source="x"))


def test_a_contact_that_loses_its_force_before_the_others_is_named(text_of):
    """Of made-up forces: one falls by 1/80 and the other by 1/200 in a kelvin, backwards they grow."""
    joint = described(text_of, working=20, ring="440C")
    change = np.array([1.0 / 200.0, 1.0 / 80.0])

    def at(celsius):
        normal = 1000.0 * (1.0 - change * (celsius - 20.0))
        return AtTemperature(np.where(np.all(normal > 0.0), normal, np.nan), np.full(3, np.nan))

    (limit,) = temperature_limits(joint, at)
    assert limit[:2] == ("contact", "pr")
    assert limit.above
    assert limit.temperature == pytest.approx(100.0, abs=1e-2)


def test_both_sides_are_stated_and_nothing_after_a_seat(text_of):
    """Forces fall to zero at -80 and at 120 degC, of different contacts; the seat opens at 40 degC, or never."""
    joint = described(text_of, working=20, fit=60)

    def at(celsius, opens=40.0):
        sp, pr = 1.0 + (celsius - 20.0) / 100.0, 1.0 - (celsius - 20.0) / 100.0
        return AtTemperature(1000.0 * np.array([sp, pr]), np.array([np.nan, np.nan, opens - celsius]))

    found = temperature_limits(joint, at)
    fit = 20.0 + 60.0 / (0.116 * 11.0)
    assert [(limit.lost, limit.part, limit.above) for limit in found] == [
        ("seat_between_rollers", "ring", True),
        ("seat", "ring", True),
        ("contact", "sp", False),
    ]
    assert [limit.temperature for limit in found] == pytest.approx([40.0, fit, -80.0], abs=1e-2)
    pressed = temperature_limits(joint, lambda celsius: at(celsius, opens=1e3))
    assert [limit.lost for limit in pressed] == ["seat", "contact"]
    never = temperature_limits(joint, lambda celsius: at(celsius, opens=0.0))
    assert never[0] == TemperatureLimit("seat_between_rollers", "ring", 20.0, True)


def test_a_drive_of_one_material_loses_nothing(text_of):
    joint = described(text_of, working=60)
    nothing = AtTemperature(np.array([900.0, 900.0]), np.full(3, math.nan))
    assert temperature_limits(joint, lambda _: nothing) == ()
    assert limit_words(limits_document(())) == []

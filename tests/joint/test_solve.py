"""Joints that cannot exist are refused with their numbers; those that can are solved."""

import math
from types import SimpleNamespace

import jax
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from asperity.errors import AsperityError, InputError, NoSolutionError
from asperity.joint.solve import (
    _beyond_what_is_computed,
    _press_that_carries,
    refuse_no_rolling,
    refuse_short_contacts,
    solve_joint,
    states_and_limits,
)
from asperity.joint.torque_limits import LIMIT_KINDS, TorqueCapacity
from asperity.joint_file.solved_document import solved_case


def refusal(joint) -> str:
    with pytest.raises(InputError) as refused:
        solve_joint(joint)
    return str(refused.value)


def test_the_papers_joint(solved_paper, paper_joint):
    """T_sp by hand: 5 N·m/9/(3 * 4 mm); 5.0e6 N·m/rad at the output for a small torque, about 4.3e6 at 5 N·m."""
    result = solved_paper[1].result
    assert float(result.forces.tangential[0]) == pytest.approx(5.0 / 9.0 / 0.012, rel=1e-9)
    assert float(result.published.output) == pytest.approx(4.3e6, rel=0.02)
    small = solve_joint(paper_joint(output_torque=1e-6)).result
    assert float(small.published.output) == pytest.approx(5.0e6, rel=0.02)
    assert isinstance(result.forces.normal, np.ndarray)
    # the carrier turns against the sun, 1 + 40/4 - 2 times as slowly
    assert float(result.speed_ratio) == pytest.approx(-9.0)
    assert float(result.output_speed) == pytest.approx(-6000.0 * math.pi / 30.0 / 9.0)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"ring_radius": 30e-3}, "planet and ring overlap by 1 mm"),
        ({"ring_radius": 60e-3}, "there is no place for right_loading_roller"),
        ({"loading_roller_radius": 50e-3}, "there is no place for right_loading_roller"),
        # as large as the ring
        ({"loading_roller_radius": 40e-3}, "there is no place for right_loading_roller"),
        ({"planet_count": 5.0}, r"neighbours of planet overlap by 6\.42752 mm"),
        # OW sin(alpha) against R_w, both from the radii by hand
        ({"ring_radius": 40.9e-3}, "right_loading_roller and left_loading_roller overlap"),
        ({"preload": 1e8}, "with a preload of 1e8 N no state was found"),
        # the wedge angle is 13.158 degrees
        ({"right_push_angle": -1.4}, "wro would have to pull"),
        ({"left_push_angle": -1.4}, "wlo would have to pull"),
        (
            {"pin_diameter": 20e-3},
            "the pin diameter 20 mm must be below the diameter of right_loading_roller, 10 mm",
        ),
        ({"pin_friction_coefficient": 2.0, "pin_diameter": 8e-3}, "the pins lock"),
        ({"output_torque": -30.0}, "the output torque -30 N·m is beyond the standing torque capacity -13.1"),
    ],
)
def test_what_cannot_exist_is_refused_with_its_numbers(paper_joint, changes, said):
    with pytest.raises(AsperityError, match=said):
        solve_joint(paper_joint(**changes))


def test_the_message_on_the_torque_tells_capacity_and_contact(paper_joint):
    """At 13.17 N·m the sun–planet contact, the most used one, reaches mu N: T_sp = T_out/(9 n R_s)."""
    message = refusal(paper_joint(output_torque=30.0))
    capacity = float(message.split("standing torque capacity ")[1].split(" ")[0])
    assert "contact sp slips" in message
    assert capacity / 9.0 / 0.012 == pytest.approx(0.12 * 1000.0, rel=0.03)  # N_sp stays near the preload
    solve_joint(paper_joint(output_torque=capacity * 0.999))
    refusal(paper_joint(output_torque=capacity * 1.001))


@pytest.mark.parametrize("torque", [30.0, -16.0])
def test_the_message_on_the_torque_tells_the_preload_that_carries_it(paper_joint, torque):
    """About as many times the preload as the torque is times the capacity."""
    message = refusal(paper_joint(output_torque=torque))
    preload = float(message.split("raise the preload (load.preload) to ")[1].split(" ")[0])
    assert preload == pytest.approx(1000.0 * abs(torque) / 13.16, rel=0.03)
    solve_joint(paper_joint(output_torque=torque, preload=preload))
    assert "beyond the standing torque capacity" in refusal(
        paper_joint(output_torque=torque, preload=0.98 * preload)
    )


def capacity_of(torque, kind="gross_slip"):
    return TorqueCapacity(np.asarray(torque), np.asarray(LIMIT_KINDS.index(kind)), np.asarray(0))


@pytest.mark.parametrize(
    ("torque", "capacity", "said"),
    [
        # 10 mN·m a newton: 1500 N would do just so, a thousandth more does, in three digits
        (15.0, lambda preload: 0.01 * preload, ", raise the preload (load.preload) to 1510 N"),
        (
            -15.0,
            lambda preload: 0.01 * preload,
            ", raise the preload (load.preload) to 3010 N",
        ),  # half as much the other way
        # grows with the square root: tried again until it is within a hundredth
        (
            15.0,
            lambda preload: 10.0 * math.sqrt(preload / 1000.0),
            ", raise the preload (load.preload) to 2260 N",
        ),
        (15.0, lambda preload: min(10.0, 0.01 * preload), ""),  # never
        (15.0, lambda preload: 0.0, ""),
    ],
)
def test_the_preload_that_carries_a_torque_is_found_by_trials(
    paper_joint, monkeypatch, torque, capacity, said
):
    def standing_capacity(joint, direction):
        limit = capacity(float(joint.preload))
        return capacity_of(limit if direction > 0.0 else 0.5 * limit)

    monkeypatch.setattr("asperity.joint.solve._standing_capacity", standing_capacity)
    assert _press_that_carries(paper_joint(preload=1000.0), torque) == said


def test_no_preload_is_told_where_something_else_limits_the_torque(paper_joint, monkeypatch):
    too_wide = capacity_of(20.0, "contact_too_wide")
    monkeypatch.setattr("asperity.joint.solve._standing_capacity", lambda joint, direction: too_wide)
    assert _press_that_carries(paper_joint(preload=1000.0), 15.0) == ""


@pytest.mark.parametrize(("torque", "rolls_up_to"), [(5.0, "4 N·m"), (-5.0, "-3 N·m")])
def test_a_joint_that_stands_but_does_not_roll_is_told_how_far_it_rolls(torque, rolls_up_to):
    joint = SimpleNamespace(output_torque=torque, interference=None, rolling=SimpleNamespace(skew=None))
    solution = SimpleNamespace(
        result=SimpleNamespace(
            rolling=SimpleNamespace(residual=math.nan),
            contact_law_holds=True,
            contact_names=("sp", "pr"),
            inlet_heat_factor=None,
        ),
        rolling_capacity=capacity_of(4.0),
        reverse_rolling_capacity=capacity_of(3.0),
    )
    with pytest.raises(
        NoSolutionError, match=f"rolls up to {rolls_up_to}, at which contact sp slips; lower the"
    ):
        refuse_no_rolling(joint, solution)


def test_forces_of_a_cam_beyond_what_is_computed(monkeypatch):
    """200 N of preload and 100 N for each newton metre."""
    monkeypatch.setattr("asperity.joint.solve.mean_preload", lambda joint, normal: 200.0)
    joint = SimpleNamespace(output_torque=-9.0, cam=SimpleNamespace(force_per_torque=100.0))
    result = SimpleNamespace(rest=SimpleNamespace(normal=None), contact_names=("sp",))
    words = _beyond_what_is_computed(
        joint, SimpleNamespace(result=result), capacity_of(6.0, "contact_too_wide")
    )
    assert "under the output torque -9 N·m the loading cam presses with 1100 N" in words
    assert "computed up to 800 N, at -6 N·m, where contact sp becomes too wide" in words


def test_the_capacity_is_that_of_the_drive_whatever_torque_it_carries(paper_joint):
    capacities = [
        solve_joint(paper_joint(output_torque=torque)).standing_capacity for torque in (0.0, 5.0, 13.0)
    ]
    assert {int(found.limiting_contact) for found in capacities} == {0}
    torques = [float(found.output_torque) for found in capacities]
    assert torques == pytest.approx([torques[0]] * 3, rel=1e-9)


@pytest.mark.slow
def test_a_negative_torque_has_the_limits_of_its_own_direction(paper_joint):
    """Wedges of unlike angles: the limits of the mirrored drive under the opposite torque, by another search."""
    one, other = (
        paper_joint(
            left_push_angle=left, right_push_angle=right, output_torque=torque, friction_coefficient=0.25
        )
        for left, right, torque in ((0.1, -0.1, -5.0), (-0.1, 0.1, 5.0))
    )
    solution, mirrored = solve_joint(one), solve_joint(other)
    limits = states_and_limits(one)[1]
    back = float(solution.reverse_standing_capacity.output_torque)
    assert abs(back / float(solution.standing_capacity.output_torque) - 1.0) > 0.02
    assert float(mirrored.standing_capacity.output_torque) == pytest.approx(back, rel=1e-9)
    assert float(limits.standing.output_torque) == pytest.approx(back, rel=1e-9)
    message = refusal(
        paper_joint(
            left_push_angle=0.1, right_push_angle=-0.1, output_torque=-40.0, friction_coefficient=0.25
        )
    )
    told = float(message.split("standing torque capacity ")[1].split(" ")[0])
    assert told == pytest.approx(-back, abs=5.01e-3)  # four digits are told


def test_one_joint_needs_no_double_precision_of_jax(paper_joint):
    joint = paper_joint()
    expected = solve_joint(joint).result.assembly.stiffness.output
    with jax.enable_x64(False):
        assert solve_joint(joint).result.assembly.stiffness.output == expected


@pytest.mark.long
@settings(max_examples=40, deadline=None)
@given(data=st.data())
def test_any_joint_is_refused_or_has_a_finite_balanced_result(paper_joint, data):
    ranges = {
        "sun_radius": (1e-6, 100.0),
        "planet_radius": (1e-6, 100.0),
        "loading_roller_radius": (1e-6, 100.0),
        "ring_radius": (1e-6, 100.0),
        "preload": (1e-3, 1e9),
        "output_torque": (1e-9, 1e9),
        "sun_speed": (1e-3, 1e5),
        "friction_coefficient": (1e-6, 10.0),
        "youngs_modulus": (1e5, 1e13),
        "poisson_ratio": (-0.99, 0.5),
        "fractal_dimension": (1.001, 1.999),
        "fractal_roughness": (1e-30, 1e-3),
        "contact_length": (1e-6, 100.0),
        "density": (1.0, 1e5),
        "ring_wall_thickness": (1e-6, 100.0),
        "left_push_angle": (-1.0, 1.0),
    }
    names = data.draw(st.lists(st.sampled_from(sorted(ranges)), min_size=1, max_size=4, unique=True))
    changes = {}
    for name in names:
        low, high = ranges[name]
        if low > 0.0 and high / low > 1e2:
            changes[name] = math.exp(data.draw(st.floats(math.log(low), math.log(high))))
        else:
            changes[name] = data.draw(st.floats(low, high))
    try:
        result = solve_joint(paper_joint(**changes)).result
    except AsperityError as error:
        assert error.exit_code in (2, 3)  # noqa: PT017
        return
    for numbers in (result.forces.normal, result.forces.tangential, result.forces.pins):
        assert np.all(np.isfinite(numbers)), changes
    assert np.all(result.forces.normal >= 0.0)
    assert not float(result.published.output) < 0.0


def test_the_levels_of_stiffness_have_no_value_where_every_spot_is_plastic(solved_paper, paper_joint):
    """D = 1.2: the law says 0, boundary elements 13 to 780 N/um of a square millimetre (docs/validity.md)."""
    result = solve_joint(paper_joint(fractal_dimension=1.2)).result
    assert not bool(result.contact_law_holds)
    for level in (result.published, result.series_with_bulk, result.assembly.stiffness):
        assert math.isnan(float(level.output))
        assert math.isnan(float(level.input))
    assert np.isfinite(result.forces.normal).all()
    assert bool(solved_paper[1].result.contact_law_holds)


def test_short_crowned_contacts_are_named_as_their_drive_names_them():
    """0.3 mm of half-width: 0.6 mm wide, and 1.5 times as long."""
    diagnostics = SimpleNamespace(
        slices_hold=np.array([True, False]),
        hertz_half_width=np.array([0.1e-3, 0.3e-3]),
        loaded_length_over_width=np.array([20.0, 1.5]),
    )
    result = SimpleNamespace(contact_names=("sp", "pr"), diagnostics=diagnostics)
    with pytest.raises(InputError, match=r"touch at pr over a length of 0\.9 mm and a width of 0\.6 mm"):
        refuse_short_contacts(result)
    diagnostics.slices_hold = None  # cylinders
    refuse_short_contacts(result)


#: By which keys a file states what presses its contacts, and what temperature and sizes do besides.
PRESSED = {
    "preload": ({'interference = "30 um"': 'preload = "800 N"'}, "load.preload", "N"),
    "temperature": (
        {
            'sun = "52100"': 'sun = "440C"',
            "# Friction of the": '[temperature]\nassembly = "20 degC"\nworking = "50 degC"\n# Friction of the',
        },
        "load.interference",
        "um",
    ),
    "cam": (
        {'interference = "30 um"': 'interference = "30 um"\ncam_force_per_torque = "20 N/Nm"'},
        "load.interference",
        "um",
    ),
    "branches": (
        {
            "[model]\n": '[[branch]]\nplanet_deviation = "0.5 um"\n\n[[branch]]\nplanet_deviation = "0 um"\n\n'
            '[[branch]]\nplanet_deviation = "-0.2 um"\n\n[model]\n'
        },
        "load.interference",
        "um",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("kind", PRESSED)
def test_the_message_names_the_number_for_the_key_that_the_file_has(planar_case, kind):
    """The file with that number carries the torque, with two hundredths less it does not."""
    replaced, key, unit = PRESSED[kind]
    replaced = replaced | {'output_torque = "10 N*m"': 'output_torque = "22 N*m"'}
    with pytest.raises(InputError) as refused:
        solved_case(planar_case("planetary", replaced=replaced))
    stated, found = str(refused.value).split(f"({key}) to ")[1].split(",")[0].split(" ")
    assert found == unit
    name = key.removeprefix("load.")
    old = next(text for text in ('preload = "800 N"', 'interference = "30 um"') if text.startswith(name))

    def changed(number):
        new = {text: put.replace(old, f'{name} = "{number!r} {unit}"') for text, put in replaced.items()}
        return (
            new
            if any(old in put for put in replaced.values())
            else new | {old: f'{name} = "{number!r} {unit}"'}
        )

    solved_case(planar_case("planetary", replaced=changed(float(stated))))
    with pytest.raises(InputError, match="beyond the standing torque capacity"):
        solved_case(planar_case("planetary", replaced=changed(0.98 * float(stated))))


def test_a_torque_and_a_capacity_that_look_alike_get_more_digits(paper_joint):
    """Both were 13.16 N·m."""
    capacity = float(solve_joint(paper_joint()).standing_capacity.output_torque)
    message = refusal(paper_joint(output_torque=capacity * (1.0 + 1e-6)))
    torque, told = (
        float(message.split(before)[1].split(" ")[0])
        for before in ("output torque ", "standing torque capacity ")
    )
    assert torque > told
    assert told == pytest.approx(capacity, rel=1e-6)


def test_without_a_torque_nothing_is_left_of_what_balances(paper_joint):
    """Statics without torque: no contact passes a tangential force, and what nothing drives does not creep."""
    solved = solve_joint(paper_joint(output_torque=0.0))
    forces, rolling = solved.result.forces, solved.result.rolling
    for nothing in (forces.tangential, forces.input_torque, rolling.creepage, rolling.drift_per_output_turn):
        assert not np.any(nothing)
    assert np.all(forces.normal > 500.0)
    # 1000 N at the sun and the wedge: the pins bear what the planet pushes outwards
    assert np.all(np.abs(forces.pins) > 100.0)


def test_a_force_is_rounding_only_below_the_last_digits_of_those_that_it_balances(paper_joint):
    """A thousandth of a millionth of the torque still makes its tangential forces, in proportion."""
    torques = np.array([1e-9, 1.0])
    small, one = (solve_joint(paper_joint(output_torque=float(torque))).result.forces for torque in torques)
    np.testing.assert_allclose(small.tangential[0] / 1e-9, one.tangential[0], rtol=1e-3)

"""Runout and roundness that keep limits: closed forms, both sums, the least cost, and back through the file."""

import re

import numpy as np
import pytest
from form_errors import ARCSECONDS, EXAMPLES

from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.accuracy import joint_accuracy
from asperity.joint_file.reader import parse_case
from asperity.study.tolerances.form_errors import joint_forms
from asperity.study.tolerances.runout import FormLimit, allowed_amplitudes, form_limits

TEXT = (EXAMPLES / "accuracy.toml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def case():
    return parse_case(TEXT, source="accuracy")


@pytest.mark.parametrize("rms", [False, True])
def test_amplitudes_keep_the_sum_at_its_limit(rms):
    influence, weight = np.array([2.0, 0.5, 1.0]), np.array([1.0, 3.0, 2.0])
    found = allowed_amplitudes(influence=influence, weight=weight, limit=7.0, rms=rms)
    swings = influence * found
    assert (np.sqrt(0.5 * np.sum(swings**2)) if rms else swings.sum()) == pytest.approx(7.0)
    np.testing.assert_allclose(found / found[0], weight)


def test_limits_are_read():
    assert form_limits(["torque_capacity >= 12 N*m"]) == ()
    (limit,) = form_limits(["transmission_error <= 20 arcsec"])
    assert limit.largest * ARCSECONDS == pytest.approx(20.0)
    assert form_limits(["turn_slip_ratio<=90 %"]) == (FormLimit("turn_slip_ratio", 0.9),)


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        (["transmission_error>=2 arcsec"], "has a largest value; write transmission_error<=VALUE"),
        (["transmission_error<=2 mm"], "expected an angle"),
        (["transmission_error<=0 arcsec"], "must be above 0"),
        (["transmission_error<=2 arcsec", "drive_life>=5 h"], "in two calls"),
    ],
)
def test_limits_that_are_refused(texts, said):
    with pytest.raises(InputError, match=said):
        form_limits(texts)


def with_amplitudes(text, allowed):
    """A joint file whose form errors are those that are allowed."""
    text = text[: text.index("[[form]]")]
    for form in allowed.forms:
        key = (
            f'runout = "{form.reading * 1e6} um"'
            if form.harmonic == 1
            else f'harmonics = {{ {form.harmonic} = "{form.amplitude * 1e6} um" }}'
        )
        text += f'\n[[form]]\npart = "{form.part}"\n{key}\n'
    return text


@pytest.mark.parametrize("sharing", ["stated", "equal", "grade", "cost"])
@pytest.mark.parametrize("name", ["transmission_error", "transmission_error_rms"])
def test_a_drive_with_what_is_allowed_is_at_the_limit(case, sharing, name):
    allowed = joint_forms(case, [FormLimit(name, 15.0 / ARCSECONDS)], sharing=sharing)
    found = joint_accuracy(
        parse_case(with_amplitudes(TEXT, allowed), source="allowed")
    ).forward.transmission_error
    assert float(found.rms if name.endswith("rms") else found.worst) * ARCSECONDS == pytest.approx(
        15.0, rel=1e-6
    )
    assert allowed.transmission_error == pytest.approx(float(found.worst), rel=1e-6)
    assert allowed.without_influence == ("sun 1", "ring 1", "ring 2")


def test_proportions_are_those_of_the_file(case):
    allowed = joint_forms(case, [FormLimit("transmission_error", 1e-4)], sharing="stated")
    sizes = {(form.part, form.harmonic): form.amplitude for form in allowed.forms}
    assert sizes["ring", 3] / sizes["ring", 6] == pytest.approx(2.5)
    assert sizes["right_loading_roller", 1] / sizes["ring", 3] == pytest.approx(3.0)
    assert all(form.reading == 2.0 * form.amplitude for form in allowed.forms)


def test_the_least_cost_is_least(case):
    """Other amplitudes that keep the same limit cost more, where each costs 1/A."""
    limit = FormLimit("transmission_error", 1e-4)
    cheapest = joint_forms(case, [limit], sharing="cost").forms

    def cost(forms):
        return sum(form.sectors / form.amplitude for form in forms)

    for other in ("stated", "equal", "grade"):
        assert cost(joint_forms(case, [limit], sharing=other).forms) > cost(cheapest)


def test_slip_over_a_turn(case):
    allowed = joint_forms(case, [FormLimit("turn_slip_ratio", 0.8)], sharing="stated")
    found = joint_accuracy(parse_case(with_amplitudes(TEXT, allowed), source="allowed")).forward
    assert float((found.slip + found.budget("slip").worst).max()) == pytest.approx(0.8, rel=1e-6)


def test_limits_without_a_solution(case):
    with pytest.raises(InputError, match=re.escape("turn_slip_ratio<=0.1: the contact ")):
        joint_forms(case, [FormLimit("turn_slip_ratio", 0.1)], sharing="stated")
    held = parse_case(
        TEXT[: TEXT.index("[[form]]")] + '\n[[form]]\npart = "sun"\nrunout = "1 um"\n', source="sun"
    )
    with pytest.raises(NoSolutionError, match="no harmonic"):
        joint_forms(held, [FormLimit("transmission_error", 1e-4)], sharing="stated")

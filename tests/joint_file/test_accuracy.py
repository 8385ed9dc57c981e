"""Form errors of a joint file over a turn: budget of a prototype, both directions, what is refused."""

import math

import numpy as np
import pytest
from form_errors import ARCSECONDS, EXAMPLES, SET, check_joint

from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.accuracy import joint_accuracy
from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solved_case
from asperity.results.accuracy_document import accuracy_document
from asperity.results.all_limits import further_checks


def accuracy(text, **options):
    return joint_accuracy(parse_case(text, source="joint"), **options)


@pytest.fixture(scope="module")
def both():
    return accuracy(check_joint() + SET, reverse=True)


def test_budget_of_the_prototype(both):
    error, normal = both.forward.transmission_error, both.forward.budget("normal")
    found = np.array([error.worst, error.rms]) * ARCSECONDS
    np.testing.assert_allclose(found, [107.10, 19.23], rtol=2e-3)
    np.testing.assert_allclose([normal.worst[0], normal.rms[0]], [1040.9, 251.1], rtol=2e-3)
    assert both.forward.may_slip[0]
    assert both.forward.slip[0] + both.forward.budget("slip").worst[0] > 1.0  # and is not cut off


def test_budget_with_a_floating_sun():
    text = check_joint().replace("[model]", '[compliance]\nsun_support_stiffness = "0 N/mm"\n\n[model]', 1)
    normal = accuracy(text + SET.replace('runout = "4 um"\n', "", 1)).forward.budget("normal")
    # the runout of a floating sun is nothing
    np.testing.assert_allclose([normal.worst[0], normal.rms[0]], [443.1, 66.1], rtol=5e-3)


@pytest.mark.parametrize(
    ("part", "harmonic", "forward", "backward", "differ"),
    [("ring", 3, 22.23, 13.22, 9.02), ("planet", 2, 5.22, 8.34, 3.13)],
)
def test_both_directions_of_the_prototype(both, part, harmonic, forward, backward, differ):
    found = [
        next(one for one in of.components if (one.error.part, one.error.harmonic) == (part, harmonic))
        for of in (both.forward, both.backward)
    ]
    over = [one.transmission_error / one.error.amplitude * 1e-6 * ARCSECONDS for one in found]
    assert [abs(each) for each in over] == pytest.approx([forward, backward], rel=0.01)
    assert abs(over[0] - over[1]) == pytest.approx(differ, rel=0.02)


def test_without_torque():
    text = check_joint().replace('output_torque = "5 N*m"', 'output_torque = "0 N*m"')
    found = accuracy(text + '\n[[form]]\npart = "ring"\nharmonics = { 3 = "1 um" }\n')
    assert float(found.forward.transmission_error.worst) * ARCSECONDS == pytest.approx(17.73, rel=0.01)


def test_an_input_that_stands_has_no_other_direction():
    text = check_joint() + '\n[[form]]\npart = "ring"\nharmonics = { 3 = "1 um" }\n'
    ways = accuracy(text, reverse=True)
    there, back = (way.components[0].transmission_error for way in (ways.forward, ways.backward))
    assert abs(there - back) > 0.1 * abs(there)
    stands = text.replace('sun_speed = "6000 rpm"', 'sun_speed = "0 rpm"')
    assert stands != text
    with pytest.raises(InputError, match=r"the input stands .* no other direction"):
        accuracy(stands, reverse=True)


def test_a_turn_is_the_sum_of_the_components():
    stated = """
[[form]]
part = "ring"
harmonics = { 3 = "1 um" }
phase = "40 deg"

[[form]]
part = "sun"
runout = "4 um"
phase = "0 deg"
"""
    found = accuracy(check_joint() + stated)
    turn = found.over_turn
    budget = found.forward.transmission_error
    assert np.ptp(turn.transmission_error) == pytest.approx(2.0 * float(budget.worst), rel=2e-3)
    assert np.sqrt(np.mean(turn.transmission_error[1:] ** 2)) == pytest.approx(float(budget.rms), rel=1e-3)
    # three waves of the ring in a turn of the carrier, and the phase of the ring is that of its crest
    crossings = np.flatnonzero(np.diff(np.sign(turn.transmission_error)))
    assert len(crossings) == 6
    assert turn.normal[:, 0].max() == pytest.approx(
        found.forward.normal[0] + float(found.forward.budget("normal").worst[0]), rel=0.02
    )


def test_known_phases_of_alike_parts_add_up_with_them():
    """Alike rollers with known phases count as one wave, with unknown ones as three."""
    alike = '\n[[form]]\npart = "right_roller"\nharmonics = { 2 = "0.5 um" }\n'
    apart = "".join(
        f'\n[[form]]\npart = "right_roller"\nsector = {k + 1}\nphase = "{phase} deg"\nharmonics = {{ 2 = "0.5 um" }}\n'
        for k, phase in enumerate((0, 120, 240))
    )
    unknown, known = (accuracy(check_joint() + stated).forward for stated in (alike, apart))
    one = abs(unknown.components[0].transmission_error)
    assert float(unknown.transmission_error.worst) == pytest.approx(3.0 * one)
    assert float(unknown.transmission_error.rms) == pytest.approx(math.sqrt(1.5) * one)
    values = np.array([each.transmission_error for each in known.components])
    assert float(known.transmission_error.worst) == pytest.approx(abs(values.sum()))


@pytest.mark.parametrize(
    "example", ["planetary", "planetary_hollow", "stepped_planet", "multiroller", "wheel_pair"]
)
def test_every_type_of_drive(example):
    text = (EXAMPLES / f"{example}.toml").read_text(encoding="utf-8")
    part = "driver" if example == "wheel_pair" else "sun"
    found = accuracy(
        text + f'\n[[form]]\npart = "{part}"\nrunout = "1 um"\nharmonics = {{ 4 = "0.1 um" }}\n', reverse=True
    )
    document = accuracy_document(found)["accuracy"]
    assert math.isfinite(document["transmission_error_rad"]["worst"])
    assert len(document["components"]) == 2


def test_a_listed_drive():
    text = (EXAMPLES / "planar.toml").read_text(encoding="utf-8")
    found = accuracy(text + '\n[[form]]\npart = "ring"\nharmonics = { 3 = "1 um" }\n')
    assert float(found.forward.transmission_error.worst) > 0.0


def test_unlike_branches_have_form_errors_too():
    branches = '\n[[branch]]\nplanet_deviation = "1 um"\n\n[[branch]]\n\n[[branch]]\n'
    found = accuracy(check_joint() + branches + '\n[[form]]\npart = "sun"\nrunout = "1 um"\n')
    # unlike sectors do not select the harmonics of the sun any more
    assert float(found.forward.transmission_error.worst) * ARCSECONDS > 0.01
    assert found.forward.normal[0] - found.forward.normal[5] > 100.0


@pytest.mark.parametrize(
    ("section", "said"),
    [
        (
            'part = "sun"\nharmonics = { 20 = "0.1 um" }',
            "harmonic 20 of the sun.*shorter than 20 half-widths.*up to 1[45]",
        ),
        (
            'part = "ring"\nharmonics = { 2 = "8 um", 3 = "6 um" }',
            "of the ring add up to 14 um, more than the interference",
        ),
    ],
)
def test_refusals(section, said):
    with pytest.raises(InputError, match=said):
        accuracy(check_joint() + f"\n[[form]]\n{section}\n")


def test_a_round_joint_is_told_what_to_state():
    with pytest.raises(InputError, match=r"states no form errors.*\[\[form\]\]"):
        accuracy(check_joint())


def test_a_joint_that_slips():
    text = check_joint().replace('output_torque = "5 N*m"', 'output_torque = "50 N*m"')
    with pytest.raises(NoSolutionError, match="does not roll steadily"):
        accuracy(text + SET)


def checks_of(text):
    solved = solved_case(parse_case(text, source="joint"))
    return {check.result.name: check for check in further_checks(solved)}


def test_limits_of_a_joint_with_form_errors():
    form = '\n[[form]]\npart = "ring"\nharmonics = { 3 = "1 um" }\n'
    checks = checks_of(check_joint() + form)
    assert set(checks) == {"turn_slip_ratio"}
    assert checks["turn_slip_ratio"].ok
    for allowed, kept in (("20 arcsec", False), ("25 arcsec", True)):
        stated = f'\n[rolling]\nallowed_transmission_error = "{allowed}"\n'
        check = checks_of(check_joint() + stated + form)["transmission_error"]
        assert check.value * ARCSECONDS == pytest.approx(22.23, rel=0.01)
        assert check.ok is kept


def test_a_contact_that_may_slip_is_told():
    check = checks_of(check_joint() + '\n[[form]]\npart = "sun"\nrunout = "20 um"\n')["turn_slip_ratio"]
    assert not check.ok
    assert check.value > 1.0
    assert check.contact in {f"{name}_{k}" for name in ("sp", "pwr", "pwl", "wro", "wlo") for k in (1, 2, 3)}
    assert "may slip within a turn" in check.meaning


def test_without_form_errors_nothing_is_judged():
    assert checks_of(check_joint()) == {}
    with pytest.raises(InputError, match=r"allowed_transmission_error = '20 arcsec'.*\[\[form\]\]"):
        parse_case(check_joint() + '\n[rolling]\nallowed_transmission_error = "20 arcsec"\n', source="joint")

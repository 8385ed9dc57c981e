"""What form errors do over a turn as one function, for studies: a prototype, and the components one by one."""

import numpy as np
import pytest
from form_errors import ARCSECONDS, EXAMPLES, SET, check_joint

from asperity.joint_file.accuracy import joint_accuracy, turn_errors_of
from asperity.joint_file.part_names import with_structure
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values

PHASES = "".join(
    f'\n[[form]]\npart = "{part}"\nsector = {k + 1}\nphase = "{phase} deg"\n'
    'harmonics = { 2 = "0.5 um", 3 = "0.2 um" }\n'
    for part in ("right_roller", "left_roller")
    for k, phase in enumerate((0, 50, 240))
)
BRANCHES = '\n[[branch]]\nplanet_deviation = "1 um"\n\n[[branch]]\n\n[[branch]]\n'
FLOATING = ("[model]", '[compliance]\nsun_support_stiffness = "0 N/mm"\n\n[model]')


def sums(text):
    with np.errstate(all="ignore"):
        return [
            float(each)
            for each in turn_errors_of(with_structure(si_values(parse_case(text, source="joint"))))
        ]


def test_the_budget_of_the_prototype():
    worst, rms, slip = sums(check_joint() + SET)
    np.testing.assert_allclose(np.array([worst, rms]) * ARCSECONDS, [107.10, 19.23], rtol=2e-3)
    assert slip > 1.0


def joints():
    yield pytest.param(check_joint() + PHASES, id="phases")
    yield pytest.param(check_joint().replace(*FLOATING, 1) + PHASES, id="floating sun")
    yield pytest.param(check_joint() + BRANCHES + PHASES, id="branches")
    for example in ("planetary", "stepped_planet", "multiroller", "planar", "wheel_pair", "accuracy"):
        text = (EXAMPLES / f"{example}.toml").read_text(encoding="utf-8")
        part = "driver" if example == "wheel_pair" else "ring" if example == "planar" else "sun"
        form = f'\n[[form]]\npart = "{part}"\nrunout = "1 um"\nharmonics = {{ 3 = "0.1 um" }}\n'
        yield pytest.param(text + (form if example != "accuracy" else ""), id=example)


@pytest.mark.parametrize("text", list(joints()))
def test_the_components_of_every_drive_one_by_one(text):
    found = joint_accuracy(parse_case(text, source="joint")).forward
    slip = found.slip + found.budget("slip").worst
    error = found.transmission_error
    # what symmetry leaves of waves that move nothing is rounding, of 1 µm at the ring
    np.testing.assert_allclose(sums(text), [error.worst, error.rms, slip.max()], rtol=1e-6, atol=1e-12)


@pytest.mark.parametrize(
    "form",
    [
        '\n[[form]]\npart = "sun"\nharmonics = { 20 = "0.1 um" }\n',
        '\n[[form]]\npart = "ring"\nharmonics = { 2 = "8 um", 3 = "6 um" }\n',
    ],
)
def test_what_one_joint_refuses_has_no_number(form):
    assert np.all(np.isnan(sums(check_joint() + form)))


def test_a_joint_that_slips_has_no_number():
    text = check_joint().replace('output_torque = "5 N*m"', 'output_torque = "50 N*m"')
    assert np.all(np.isnan(sums(text + SET)))

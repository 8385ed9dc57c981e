"""Unfolded joints that roll, on which form errors are tested; the check joint S0 of the wedge drive."""

from pathlib import Path

import numpy as np

from asperity.drive.layout.form import lobes_of
from asperity.joint.unfolding import SectorSizes, settled_sectors, unfolded_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.rolling.accuracy import rolling_balance_of, under_interference

EXAMPLES = Path(__file__).parents[2] / "examples"
ARCSECONDS = 648000.0 / np.pi
#: The set of form errors of the prototype [µm]: runout is twice the first amplitude.
SET = """
[[form]]
part = "sun"
runout = "4 um"
harmonics = { 2 = "0.5 um", 3 = "0.3 um" }

[[form]]
part = "planet"
harmonics = { 2 = "0.5 um", 3 = "0.3 um", 4 = "0.2 um", 5 = "0.2 um" }

[[form]]
part = "loading_roller"
runout = "4 um"
harmonics = { 2 = "0.5 um", 3 = "0.3 um", 4 = "0.2 um", 5 = "0.2 um" }

[[form]]
part = "ring"
runout = "6 um"
harmonics = { 2 = "2 um", 3 = "1 um", 4 = "0.5 um", 5 = "0.5 um", 6 = "0.3 um" }
"""


def check_joint():
    """S0: the paper's joint with smooth bodies as springs, their split by slip, 5 N·m, 6000 rpm, clockwise sun."""
    text = (EXAMPLES / "zou2025.toml").read_text()
    for stated, instead in (
        ('preload = "1000 N"', 'interference = "12.9043 um"'),
        ('traction_split = "equal_coefficients"', 'traction_split = "springs"'),
        ('closure_springs = "bulk"', "#"),
        ('bodies = "exact"', 'bodies = "springs"'),
    ):
        assert stated in text
        text = text.replace(stated, instead)
    return text[: text.index("[surface]")] + '[surface]\nfinish = "ground"\nroughness_average = "0.5 nm"\n'


def balance_of(text, *, floating=(), backwards=False, torque=None):
    """A joint file with every sector by itself in steady rolling."""
    joint = joint_from_case(parse_case(text, source="joint"))
    sectors = round(float(joint.drive.sectors))
    with np.errstate(all="ignore"):
        joint = under_interference(joint)
        if sectors > 1:
            nothing = np.zeros((sectors, len(joint.drive.contacts)))
            settled = settled_sectors(sectors, floating, joint, SectorSizes(nothing, nothing, 0.0))
            joint = unfolded_joint(joint, settled.sizes, sectors=sectors, floating=floating)
        rolling = rolling_balance_of(joint, torque=torque, backwards=backwards)
    assert rolling.state.residual < 1e-10
    return rolling


def lobes(rolling, body, harmonic, contacts=None):
    """A harmonic of a body, of all its tracks or of the one with these contacts."""
    drive = rolling.machine.drive
    sides = {
        (contact.name, side)
        for contact in drive.contacts
        for side, name in (("first", contact.first), ("second", contact.second))
        if name == body and (contacts is None or contact.name in contacts)
    }
    return lobes_of(drive, sides, harmonic)

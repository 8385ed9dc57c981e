"""The joint of a file with its own branches."""

from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.reader import parse_case

EXAMPLES = Path(__file__).parents[2] / "examples"
BRANCHES = '[[branch]]\nplanet_deviation = "2 um"\n\n[[branch]]\n\n[[branch]]\nplanet_deviation = "-1 um"\n\n'


def described(name, *changes):
    text = (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")
    for old, new in changes:
        text = text.replace(old, new, 1)
    return with_own_branches(parse_case(text, source="x"))


@pytest.mark.parametrize("name", ["zou2025", "planetary"])
def test_without_sections_they_are_equal(name):
    joint = described(name)
    assert joint.unlike is None
    assert len(joint.contact_names) in (2, 5)


@pytest.mark.long
def test_the_papers_drive_unfolded():
    joint = described(
        "zou2025", ('preload = "1000 N"', 'interference = "13 um"'), ("[model]", f"{BRANCHES}[model]")
    )
    assert joint.contact_names[:6] == ("sp_1", "pwr_1", "pwl_1", "wro_1", "wlo_1", "sp_2")
    assert joint.interference == pytest.approx(13e-6, rel=1e-15)
    expected = [*3 * [2e-6], *7 * [0.0], *3 * [-1e-6], 0.0, 0.0]
    np.testing.assert_allclose(joint.unlike.added, expected, atol=1e-18)


@pytest.mark.slow
def test_every_planet_by_itself():
    """Twice the deviation of its radius is what a planet adds to the interference; its own torque, whatever it is."""
    springs = (
        ('bodies = "exact"', 'bodies = "springs"'),
        ('ring_support = "free"', 'ring_support = "rigid_housing"'),
    )
    joint = described(
        "planetary",
        *springs,
        ("[model]", f"{BRANCHES}[model]"),
        ('output_torque = "10 N*m"', 'output_torque = "900 N*m"'),
    )
    assert joint.contact_names == ("sp_1", "pr_1", "sp_2", "pr_2", "sp_3", "pr_3")
    assert float(joint.output_torque) == 900.0
    np.testing.assert_allclose(joint.unlike.added, [2e-6, 2e-6, 0.0, 0.0, -1e-6, -1e-6], atol=1e-18)
    with pytest.raises(InputError, match="is loose"):
        described("planetary", *springs, ("[model]", f"{BRANCHES.replace('-1 um', '-16 um')}[model]"))

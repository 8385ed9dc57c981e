"""Kinematics of every drive against Willis' and the multiroller's formulas."""

import numpy as np
import pytest

from asperity.drive.planar.existence import refuse_impossible
from asperity.drive.planar.layout import gaps, incidence, speed_ratio, speeds


@pytest.mark.parametrize(
    ("name", "ratio"),
    [
        ("wedge", -(40.0 / 4.0 - 1.0)),
        ("planetary", 1.0 + 50.0 / 10.0),
        ("stepped", (1.0 + 50.0 / 10.0) / (1.0 - 50.0 * 18.0 / (48.0 * 20.0))),
    ],
)
def test_ratio_is_that_of_the_formula(drives, name, ratio):
    assert float(speed_ratio(drives[name])) == pytest.approx(ratio, rel=1e-12)


def test_ratio_of_the_multiroller(drives):
    drive = drives["multiroller"]
    ring = float(drive.second_radius[-1])
    assert abs(float(speed_ratio(drive))) == pytest.approx(
        (22.0 / 10.0) * (25.0 / 9.0) * (ring / 14e-3), rel=1e-12
    )
    assert 20.0 < abs(float(speed_ratio(drive))) < 50.0


@pytest.mark.parametrize("name", ["wedge", "planetary", "multiroller", "stepped"])
def test_no_contact_slips_and_all_touch(drives, name):
    drive = drives[name]
    np.testing.assert_allclose(incidence(drive).turning @ speeds(drive), 0.0, atol=1e-15)
    np.testing.assert_allclose(gaps(drive), 0.0, atol=1e-15)
    refuse_impossible(drive)

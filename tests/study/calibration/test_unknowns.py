"""Unknowns of a calibration from text: bounds stated, bounds by default, and what is refused."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.unknowns import read_unknowns, si_unit_of

ANGLE = np.array([-1.0, 0.0, 3.0]) * 1e-4
TORQUE = np.array([-2.0, 0.5, 4.0])


def measured(**changes):
    given = {"angle": ANGLE, "stiffness": None, "time": None, "repetition": np.zeros(3)} | changes
    return Measurement(
        TORQUE, given["angle"], given["stiffness"], given["time"], given["repetition"], "synthetic"
    )


def read(case, *texts, **changes):
    return read_unknowns(texts, case=case, measurements=(measured(**changes),))


def test_stated_bounds_are_taken_in_their_unit(case):
    (preload,) = read(case, "load.preload=0.5 kN : 2 kN")
    assert (preload.path, preload.lower, preload.upper) == ("load.preload", 500.0, 2000.0)


def test_bounds_by_default(case):
    """A fifth to five times the file's 1000 N; play up to the whole range of the angles; offset about their mean."""
    preload, play, width, offset = read(case, "load.preload", "play.angle", "play.take_up_torque", "offset")
    assert (preload.lower, preload.upper) == pytest.approx((200.0, 5000.0))
    assert (play.lower, play.upper) == pytest.approx((0.0, 4e-4))
    assert (width.lower, width.upper) == pytest.approx((4e-3, 4.0))
    assert (offset.lower, offset.upper) == pytest.approx((2e-4 / 3.0 - 4e-4, 2e-4 / 3.0 + 4e-4))


def test_a_dimension_keeps_off_both_ends_and_what_may_be_zero_has_no_logarithm(case):
    (dimension,) = read(case, "surface.fractal_dimension")
    assert (dimension.lower - 1.0, 2.0 - dimension.upper) == pytest.approx((0.05, 0.05))
    assert read(case, "load.preload")[0].logarithmic
    assert read(case, "bearings.pin_friction_coefficient=0.001:0.01")[0].logarithmic
    assert not read(case, "bearings.pin_friction_coefficient=0:0.01")[0].logarithmic


def test_one_offset_for_each_repetition_and_a_drift_over_the_time(case):
    found = read(
        case, "offset", "drift", repetition=np.array([1.0, 1.0, 2.0]), time=np.array([0.0, 5.0, 10.0])
    )
    assert [each.path for each in found] == ["offset 1", "offset 2", "drift"]
    assert (found[2].lower, found[2].upper) == pytest.approx((-4e-5, 4e-5))


@pytest.mark.parametrize(
    ("texts", "told"),
    [
        ((), "nothing to calibrate"),
        (("load.preload", "load.preload"), "named twice"),
        (
            ("load.preload", "load.interference=1 um:20 um"),
            "load.preload and load.interference: two unknowns for the same number; vary it once",
        ),
        (("play.take_up_torque",), "needs the unknown 'play.angle'"),
        (("load.preload=500 N",), "expected KEY=LOWER:UPPER"),
        (("load.preload=2 kN:1 kN",), "the lower bound 2 kN must be below the upper 1 kN"),
        (("load.preload=1 mm:2 mm",), "expected a force"),
        (("drift",), "drift needs a column 'time'"),
        (("play.angle=-1 arcmin:1 arcmin",), "must not be negative"),
    ],
)
def test_refusals(case, texts, told):
    with pytest.raises(InputError, match=told):
        read(case, *texts)


def test_properties_of_a_curve_need_angles(case):
    with pytest.raises(InputError, match="measured angles only"):
        read(case, "play.angle", angle=None, stiffness=np.ones(3))


def test_si_units():
    assert [si_unit_of(path) for path in ("offset 2", "play.take_up_torque", "load.preload")] == [
        "rad",
        "N*m",
        "N",
    ]


def test_unknowns_of_another_drive_are_numbers_of_its_file(planar_case):
    planetary, listed = planar_case("planetary"), planar_case("planar")
    (interference,) = read(planetary, "load.interference")
    assert (interference.lower, interference.upper) == pytest.approx((6e-6, 150e-6))
    with pytest.raises(InputError, match=r"a drive of type planetary has no number 'drive.ring_radius'"):
        read(planetary, "drive.ring_radius=40 mm:60 mm")
    data = Measurement(TORQUE, None, None, None, np.zeros(3), "synthetic", ANGLE, unloaded_ratio=6.0)
    for case, path in ((planetary, "drive.planet_radius"), (listed, "contact.1.first_radius")):
        with pytest.raises(InputError, match=f"'{path}' sets the speed ratio without creep"):
            read_unknowns((path,), case=case, measurements=(data,))

"""Every check of the installation passes, and none is lost or made easier.

What it compares is not computed a second time by the tests of its room.
"""

import pytest

from asperity.validation.run import GROUPS

#: Groups that take longer than a second.
SLOW = (
    "wear",
    "creep with oil",
    "heat",
    "unlike branches",
    "form errors over a turn",
    "rings",
    "half-space",
    "partial slip",
    "rolling",
    "the paper's figures",
)
ABSOLUTE = "absolute"
#: Of each check of each group how many values it compares, and the largest tolerance that it may have, relative unless
#: it is absolute.
CHECKS = {
    "units": [(7, 1e-15)],
    "roughness": [(3, 0.0001), (2, 1e-06, ABSOLUTE), (3, 0.001)],
    "contact law": 9 * [(40, 1e-10)],
    "Hertz": [(1, 0.0001), (1, 1e-05)],
    "creep": [(5, 6e-05), (1, 0.015), (1, 0.0001), (1, 0.0001)],
    "onset of rolling": [(4, 0.008, ABSOLUTE), (4, 0.008, ABSOLUTE)],
    "crowned rollers": [(2, 0.02), (2, 0.02), (2, 0.02), (2, 1e-12)],
    "tilted rollers": [(3, 0.0001), *(4 * [(2, 2e-3)]), (1, 1e-4)],
    "skewed rollers": [(2, 1e-06), (5, 1e-12), (5, 1e-12), (3, 1e-12), (2, 1e-05)],
    "asperities in rolling": [(20, 0.004), (5, 0.0006, ABSOLUTE)],
    "lay": [(5, 0.02), (5, 0.01), (5, 0.01)],
    "running in": [(10, 1e-12)],
    "oil": [(1, 0.0005), (1, 0.0007), (1, 0.0025)],
    "oil films and shares": [(11, 1.1e-4, ABSOLUTE), (11, 1.1e-5, ABSOLUTE), (11, 1.1e-4, ABSOLUTE)],
    "creep with oil": [
        (11, 1.1e-4, ABSOLUTE),
        (55, 1.1e-5, ABSOLUTE),
        (11, 1.1e-5, ABSOLUTE),
        (3, 1e-9),
        (3, 0.003),
        (11, 0.1),
    ],
    "heat": [(3, 0.01), (3, 0.01), (1, 1e-6)],
    "wear": [(5, 2e-3), (1, 1e-3), (2, 2e-3)],
    "stresses": [(3, 1e-09), (2000, 1e-09), (2, 0.002), (10, 0.0002)],
    "fatigue": [(5, 0.0002), (1, 1e-12), (3, 1e-12), (8, 1e-5)],
    "discs": [(1, 0.0005), (1, 0.02)],
    "rings": [(3, 2e-05), (3, 2e-05), (2, 0.002), (2, 0.002)],
    "fits and temperature": [(4, 1e-09), (1, 1e-09), (1, 1e-09), (1, 1e-09)],
    "cam and pins": [(3, 1e-12), (1, 1e-12), (2, 1e-12), (1, 1e-12)],
    "kinematics": [(1, 1e-12), (1, 1e-12), (1, 1e-12), (1, 1e-12)],
    "drive": [(1, 0.0001), (5, 0.00079), (3, 0.0005), (1, 0.0001), (1, 0.005)],
    "unlike branches": [(4, 1e-06), (1, 1e-06), (1, 1e-06), (4, 1e-05), (2, 1e-10)],
    "form errors over a turn": [(10, 0.01), (10, 0.01), (6, 0.01), (1, 0.005), (2, 0.003)],
    "rolling bearings": [(1, 0.001), (2, 1e-12), (2, 1e-12)],
    "wind-up and its models": [
        (2, 1e-09),
        (1, 1e-09),
        (3, 1e-09),
        (6, 2e-05, ABSOLUTE),
        (3, 0.01),
        (3, 0.01),
    ],
    "vibrations": [(2, 1e-08), (4, 1e-08)],
    "half-space": [(3, 0.0001)],
    "partial slip": [(1, 0.003), (1, 0.01)],
    "rolling": [(5, 0.005)],
    "the paper's figures": [(1, 0.02, ABSOLUTE), (6, 0.02, ABSOLUTE), (1, 1e-09), (1, 1e-09), (1, 0.01)],
}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if name in SLOW else name for name in GROUPS]
)
def test_a_group_passes(name):
    checks = list(GROUPS[name]())
    assert [check for check in checks if not check.passed] == []
    assert [check.values for check in checks] == [values for values, *_ in CHECKS[name]]
    for check, (_, tolerance, *kind) in zip(checks, CHECKS[name], strict=True):
        assert check.tolerance <= tolerance, check.quantity
        assert check.absolute == (kind == [ABSOLUTE]), check.quantity


def test_no_group_is_lost():
    assert list(CHECKS) == list(GROUPS)
    assert set(SLOW) <= set(GROUPS)

"""The paper's joint with its traction split by springs and by the paper's assumption: what the assumption changes.

Figures with springs are those of the drive listed body by body in November 2026, those with equal coefficients of the
paper's own equations (1)-(5) then, two solvers that shared no code.
"""

import numpy as np
import pytest

from asperity.joint_file.solved_document import solved_case
from asperity.standing.windup import windup

pytestmark = pytest.mark.slow

SPRINGS = {
    'traction_split = "equal_coefficients"': 'traction_split = "springs"',
    'closure_springs = "bulk"': "",
}
EQUAL = {}


@pytest.fixture(scope="module")
def paper(planar_case):
    """The paper's joint under a torque."""

    def solved(torque, replaced):
        load = {'output_torque = "5 N*m"': f'output_torque = "{torque} N*m"'}
        return solved_case(planar_case("zou2025", replaced=load | replaced))

    return solved


@pytest.mark.parametrize(("replaced", "right", "left"), [(SPRINGS, 23.29, 23.00), (EQUAL, 27.11, 19.18)])
def test_standing_forces_at_5_newton_metres(paper, replaced, right, left):
    found = paper(5, replaced).solution.result.forces
    np.testing.assert_allclose(found.tangential[1:3], [right, left], atol=0.01)


@pytest.mark.parametrize(("replaced", "torque", "contact"), [(SPRINGS, 9.59, "wlo"), (EQUAL, 13.16, "sp")])
def test_first_slip(paper, replaced, torque, contact):
    solution = paper(5, replaced).solution
    assert float(solution.first_slip.output_torque) == pytest.approx(torque, abs=0.006)
    assert solution.result.contact_names[int(solution.first_slip.limiting_contact)] == contact
    # with equal coefficients nothing can take over what a contact that slips leaves
    carries = float(solution.standing_capacity.output_torque)
    assert (carries == pytest.approx(torque, abs=0.006)) == (replaced is EQUAL)
    assert carries < 13.2


@pytest.mark.parametrize(("replaced", "stiffness"), [(SPRINGS, 27784.0), (EQUAL, 30002.0)])
def test_assembled_stiffness_at_10_newton_metres(paper, replaced, stiffness):
    found = paper(10, replaced).solution.result.assembly.stiffness.output
    assert float(found) == pytest.approx(stiffness, rel=1e-4)


@pytest.mark.long
@pytest.mark.parametrize(
    ("replaced", "arcsec", "energy", "right_pin"),
    [(SPRINGS, 3.64, 3.25e-4, 34.6), (EQUAL, 0.85, 6.8e-5, 24.6)],
)
def test_hysteresis_at_12_newton_metres(paper, replaced, arcsec, energy, right_pin):
    solved = paper(12, replaced)
    loop = windup(solved.joint, largest_torque=12.0, level="assembly")
    assert np.degrees(float(loop.hysteresis)) * 3600.0 == pytest.approx(arcsec, rel=0.01)
    assert float(loop.dissipated_energy) == pytest.approx(energy, rel=0.01)
    assert abs(float(solved.solution.result.forces.pins[0])) == pytest.approx(right_pin, abs=0.06)


@pytest.mark.parametrize(
    ("replaced", "slip_ratio"), [(SPRINGS, 0.9985), pytest.param(EQUAL, 0.683, marks=pytest.mark.long)]
)
def test_a_free_ring_brings_the_first_slip_near(paper, replaced, slip_ratio):
    """A ring of 10 mm that carries itself and 13 µm at 5 N·m."""
    free = {
        'ring_wall_thickness = "60 mm"': 'ring_wall_thickness = "10 mm"',
        'ring_support = "rigid_housing"': 'ring_support = "free"',
        'preload = "1000 N"': 'interference = "13 um"',
    }
    found = paper(5, replaced | free).solution.result.diagnostics.slip_ratio
    assert float(found[4]) == pytest.approx(slip_ratio, abs=6e-4)

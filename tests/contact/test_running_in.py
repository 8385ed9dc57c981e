"""Running in: the table of boundary elements over its elastic value, between its entries, and beyond."""

import math

import pytest

from asperity.contact.running_in import UNCERTAINTY, run_in_factor
from asperity.errors import InputError

#: H/(E* h'), whether strips, and k u_0/p of boundary elements at the full load and at half of it, least and most.
ELEMENTS = [
    (0.85, False, (1.05, 1.10), (1.10, 1.16)),
    (0.38, False, (1.34, 1.36), (1.8, 1.8)),
    (0.19, False, (2.1, 2.3), (3.2, 3.4)),
    (0.53, True, (1.2, 1.3), (1.35, 1.35)),
    (0.27, True, (1.5, 1.9), (2.0, 2.3)),
]
ELASTIC = {False: 1.07, True: 1.15}


@pytest.mark.parametrize(("ratio", "strips", "full", "half"), ELEMENTS)
def test_factor_of_boundary_elements(ratio, strips, full, half):
    """Within the simulations, which scatter by less than the stated tenth, or 12 % of one."""
    for share, (low, high) in ((1.0, full), (0.5, half)):
        found = ELASTIC[strips] * run_in_factor(hardness_ratio=ratio, strips=strips, load_share=share)
        assert low * (1.0 - 1e-12) <= found <= high * (1.0 + 1e-12)
        assert (high - low) / (high + low) < 1.2 * UNCERTAINTY


def test_between_the_ratios_and_the_loads():
    """Logarithms between ratios, the factor itself between loads; harder surfaces run in less."""
    between = run_in_factor(hardness_ratio=math.sqrt(0.38 * 0.19), strips=False, load_share=1.0)
    assert between == pytest.approx(math.sqrt(1.35 * 2.2) / 1.07, rel=1e-12)
    at_load = [run_in_factor(hardness_ratio=0.5, strips=False, load_share=load) for load in (0.5, 0.75, 1.0)]
    assert at_load[1] == pytest.approx(0.5 * (at_load[0] + at_load[2]), rel=1e-12)
    ratios = (0.2, 0.3, 0.5, 0.84)
    factors = [run_in_factor(hardness_ratio=ratio, strips=False, load_share=1.0) for ratio in ratios]
    assert factors == sorted(factors, reverse=True)


@pytest.mark.parametrize(
    ("ratio", "strips", "load", "said"),
    [
        (0.86, False, 1.0, r"H/\(E h'\) = 0.86 is outside of the 0.19 to 0.85 .*rough surfaces"),
        (0.18, False, 1.0, "0.18 is outside of the 0.19 to 0.85"),
        (0.54, True, 1.0, "0.54 is outside of the 0.27 to 0.53 for which running in of grooves is known"),
        (0.4, False, 0.4, "a load of 0.4 times that of running in"),
        (0.4, False, 1.1, "a load of 1.1 times that of running in"),
        (math.nan, False, 1.0, "nan is outside"),
    ],
)
def test_beyond_what_was_simulated_it_is_refused(ratio, strips, load, said):
    with pytest.raises(InputError, match=said):
        run_in_factor(hardness_ratio=ratio, strips=strips, load_share=load)

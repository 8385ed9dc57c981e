import math

import pytest

from asperity.joint.diagnostics import Diagnostics, listing
from asperity.joint.solve import solve


@pytest.fixture(scope="module")
def paper_listing(paper_joint):
    return listing(solve(paper_joint()).result)


def by_name(entries, name):
    return {entry.contact: entry for entry in entries if entry.name == name}


def test_every_limit_is_listed_for_every_contact(paper_listing):
    names = {entry.name for entry in paper_listing}
    without_limit = {"hertz_half_width", "hertz_peak_pressure"}
    assert names == set(Diagnostics.__dataclass_fields__) - without_limit | {
        "balance_residual",
        "closure_residual",
    }
    assert set(by_name(paper_listing, "gross_slip")) == {"sp", "pwr", "pwl", "wro", "wlo"}
    assert set(by_name(paper_listing, "self_locking")) == {None}
    assert all(entry.meaning for entry in paper_listing)


def test_the_facts_about_the_paper_s_joint(paper_listing):
    """model page, section 7: tan(beta/2) = 0.1153 with mu = 0.12; twice first yield at the sun; A_r beyond 2bB."""
    locking = by_name(paper_listing, "self_locking")[None]
    assert locking.value == pytest.approx(0.1153 / 0.12, rel=1e-3)
    assert locking.ok
    sun = by_name(paper_listing, "pressure_over_first_yield")["sp"]
    assert sun.value == pytest.approx(1.53e9 / (1.67 * 450e6), rel=2e-3)
    assert not sun.ok
    assert not by_name(paper_listing, "real_area_over_hertz_area")["sp"].ok
    assert not by_name(paper_listing, "asperity_over_bulk_stiffness")["sp"].ok
    assert all(entry.ok for entry in by_name(paper_listing, "gross_slip").values())
    assert all(entry.ok for entry in by_name(paper_listing, "normal_over_rest").values())
    assert by_name(paper_listing, "balance_residual")[None].ok


def test_an_undefined_value_is_not_ok(paper_joint):
    """Spinning so fast that the planets leave the sun: no contact there, hence no stiffness to compare."""
    entries = listing(
        solve(paper_joint(output_torque=0.0, sun_speed=2e5, closure="constant_pin_force")).result
    )
    lifted = by_name(entries, "normal_over_rest")["sp"]
    assert (lifted.value, lifted.ok) == (0.0, False)
    undefined = by_name(entries, "asperity_over_bulk_stiffness")["sp"]
    assert math.isnan(undefined.value)
    assert not undefined.ok
    assert "undefined" in undefined.meaning

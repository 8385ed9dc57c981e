"""Why numbers of a joint that turns are absent, and its losses by cause."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.rolling.document import losses, no_life_because, rating_life_name, unknown_because


def joint(input_speed=100.0, duty=(), skew=None, cleanliness=None):
    rolling = SimpleNamespace(duty=duty, skew=skew, cleanliness=cleanliness)
    return SimpleNamespace(input_speed=input_speed, rolling=rolling, ends=("first ring", "carrier"))


def result(
    *, residual=1e-12, slip=(0.4,) * 5, holds=True, heat=None, efficiency=0.98, duty_life_hours=np.nan
):
    rolling = SimpleNamespace(
        residual=residual, power=SimpleNamespace(efficiency=efficiency), duty_life_hours=duty_life_hours
    )
    diagnostics = SimpleNamespace(slip_ratio=np.array(slip))
    names = ("sp", "pwr", "pwl", "wro", "wlo")
    return SimpleNamespace(
        rolling=rolling,
        diagnostics=diagnostics,
        contact_law_holds=holds,
        contact_names=names,
        inlet_heat_factor=heat,
    )


def test_nothing_is_missing_from_a_joint_that_turns():
    assert unknown_because(joint(), result()) == []
    assert unknown_because(joint(duty=(1,)), result(duty_life_hours=1e4)) == []


@pytest.mark.parametrize(
    ("found", "said"),
    [
        ({"slip": (0.4, 1.2, 0.4, np.nan, 0.4)}, "no steady rolling: pwr, wro slip or have lifted off"),
        ({"slip": (0.4, 1.02, 0.4, 0.4, 0.4)}, "no steady rolling: pwr slips or has lifted off"),
        ({"holds": False}, "no creep: every spot of a contact is plastic"),
        ({"heat": np.array([0.9, -0.2, 0.8, 0.7, 0.6])}, "no oil film at pwr: heat at its inlet"),
        (
            {},
            "no steady rolling: a contact slips or lifts off once the creepages share the torque among the contacts",
        ),
    ],
)
def test_a_joint_that_does_not_roll_has_one_reason(found, said):
    (reason,) = unknown_because(joint(), result(residual=np.nan, **found))
    assert reason.startswith(said)


def test_skew_is_a_possible_cause_where_rollers_are_skewed():
    unsolved = result(residual=np.nan)
    (straight,), (skewed,) = (
        unknown_because(joint(), unsolved),
        unknown_because(joint(skew=(1e-3,)), unsolved),
    )
    assert skewed == straight + ", or skew alone makes it slip"


def test_what_needs_time_power_or_a_duty_is_named():
    (still,) = unknown_because(joint(input_speed=0.0), result(efficiency=np.nan))
    assert still.startswith("the first ring stands")
    (driven,) = unknown_because(joint(), result(efficiency=np.nan))
    assert driven.startswith("no efficiency: the output torque drives the rotation")
    (duty,) = unknown_because(joint(duty=(1,)), result())
    assert duty.startswith("no life under the duty")


def test_a_life_that_its_film_leaves_out_has_a_reason():
    """κ = λ^1.3 is 0.1 at λ = 0.1701."""
    films = SimpleNamespace(
        film_ratio=np.array([1.2, 0.171, 0.169]), shakedown_ratio=np.full(3, 0.5), slip_ratio=np.full(3, 0.5)
    )
    films.duty_film_ratios, films.duty_life_hours = np.array([0.1, np.nan, 0.16]), np.nan
    films.residual, films.power = 1e-12, SimpleNamespace(efficiency=0.9)
    rolled = SimpleNamespace(rolling=films, contact_names=("sp", "pr", "wr"), diagnostics=films)
    because = no_life_because(joint(cleanliness=0.5), rolled)
    assert because.startswith("no rating life: at wr κ = λ^1.3 is below 0.1")
    assert no_life_because(joint(), rolled) is None
    assert "first ring stands" in no_life_because(joint(input_speed=0.0, cleanliness=0.5), rolled)
    (duty,) = unknown_because(joint(duty=(1,), cleanliness=0.5), rolled)
    assert duty.startswith("no life under the duty: under loads 1, 3 κ")
    (standing,) = unknown_because(joint(input_speed=0.0, cleanliness=0.5), rolled)
    assert "drift is per turn" in standing
    assert (rating_life_name(0.9), rating_life_name(0.99, with_film=True)[:17]) == (
        "Rating life L10",
        "Rating life L1m, ",
    )


def test_losses_of_all_contacts_by_cause():
    power = SimpleNamespace(
        creep=np.array([1.0, 2.0]), skew=np.zeros(2), hysteresis=np.array([0.5, 0.25]), oil=np.full(2, np.nan),
        bearings=0.125, loss=3.875,
    )  # fmt: skip
    found = losses(SimpleNamespace(power=power))
    assert {name: found[name] for name in ("creep", "skew", "hysteresis", "bearings", "total")} == {
        "creep": 3.0, "skew": 0.0, "hysteresis": 0.75, "bearings": 0.125, "total": 3.875,
    }  # fmt: skip
    assert np.isnan(found["oil"])

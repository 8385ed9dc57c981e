"""A drive that loses much of its power says so, with the main cause."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.results.loss_note import loss_notes, skew_notes

NAMES = ("sp", "pr")


def rolled(*, output=60.0, bearings=0.0, **losses):
    """Powers [W] of a drive with two contacts; by energy conservation what enters is what leaves and all losses."""
    each = {
        name: np.array(losses.get(name, (np.nan, np.nan))) for name in ("creep", "skew", "hysteresis", "oil")
    }
    lost = sum(np.nansum(value) for value in each.values()) + bearings
    power = SimpleNamespace(**each, bearings=bearings, loss=lost, input=output + lost, output=output)
    return SimpleNamespace(power=power)


@pytest.mark.parametrize(
    ("losses", "said", "remedy"),
    [
        ({"oil": (10, 20), "creep": (9, 1)}, "30 W of them by the oil at the inlet of the contacts, most at pr", "oil"),
        ({"oil": (1, 2), "creep": (36, 1)}, "37 W of them by the creep of the contacts, most at sp", "preload"),
        ({"bearings": 39, "creep": (1, 0)}, "39 W of them by bearings and pins", "less friction"),
        ({"skew": (0, 40), "creep": (0, 0)}, "40 W of them by the skew of the rollers, most at pr", "align"),
    ],
)  # fmt: skip
def test_the_main_cause_is_named(losses, said, remedy):
    (note,) = loss_notes(rolled(**losses), NAMES)
    assert (note.ok, note.severity) == (False, "function")
    assert note.value == pytest.approx(0.4)
    assert note.meaning == f"of 100 W that enter, 40 W are lost, {said}"
    assert remedy in note.remedy


def test_a_third_is_the_bound():
    (kept,) = loss_notes(rolled(output=67.0, creep=(33.0, 0.0)), NAMES)
    (crossed,) = loss_notes(rolled(output=66.0, creep=(34.0, 0.0)), NAMES)
    assert (kept.ok, kept.remedy, crossed.ok) == (True, None, False)


@pytest.mark.parametrize("output", [0.0, np.nan])
def test_a_drive_that_passes_no_power_has_no_share(output):
    assert loss_notes(rolled(output=output, oil=(1.0, 1.0)), NAMES) == ()


def skewed(ratios, losses):
    return SimpleNamespace(slip_ratio=np.array(ratios), capacity_loss=np.array(losses))


def test_skew_that_leaves_too_little_friction_is_a_warning():
    (kept,) = skew_notes(skewed([0.5, 0.9], [0.0, 0.3]), NAMES)
    (crossed,) = skew_notes(skewed([1.4, 0.9], [0.5, 0.3]), NAMES)
    assert (kept.ok, kept.contact, kept.value) == (True, "pr", 0.9)
    assert (crossed.ok, crossed.contact, crossed.severity) == (False, "sp", "function")
    assert "slips as a whole" in crossed.meaning
    assert crossed.remedy.startswith("align the axes")


@pytest.mark.parametrize("ratio", [np.inf, np.nan])  # of some traction, and of none
def test_skew_that_takes_all_friction_is_a_warning(ratio):
    (crossed,) = skew_notes(skewed([0.5, ratio], [0.9, 1.0]), NAMES)
    assert (crossed.ok, crossed.contact, crossed.value) == (False, "pr", np.inf)


@pytest.mark.parametrize(("ratios", "losses"), [([1.4, 0.9], [0.0, 0.0]), ([np.nan, 0.9], [0.1, 0.1])])
def test_without_skew_or_without_a_state_there_is_no_note(ratios, losses):
    assert skew_notes(skewed(ratios, losses), NAMES) == ()

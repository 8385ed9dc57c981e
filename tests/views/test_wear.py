"""Wear as it is shown: first figures, rates with or without hours, ends, the course, and what holds."""

import copy

import pytest
from shown_blocks import sentences, tables
from tests.support.worn import COEFFICIENT, check_case, check_wear

from asperity.joint_file.wear import wear_of_case
from asperity.results.wear_document import wear_document
from asperity.views.blocks import Figures
from asperity.views.wear import wear


@pytest.fixture(scope="module")
def found():
    return check_wear(COEFFICIENT, 2000.0 * 3600.0)


@pytest.fixture(scope="module")
def blocks(found):
    return list(wear(wear_document(found)))


def figures(blocks):
    return {item.name: item for block in blocks if isinstance(block, Figures) for item in block.items}


def test_first_figures(blocks):
    shown = figures(blocks)
    assert shown["first contact slides"].si == pytest.approx(5430.5 * 3600.0, rel=5e-3)
    assert shown["first contact slides"].detail == "wlo slides"
    assert shown["nothing left"].detail == "sp slides"
    assert shown["largest wear coefficient"].detail == "for 2000 h to the first slide"
    assert shown["preload"].unit == "N"


def test_depths_per_1000_hours_and_after_the_life(blocks):
    table = tables(blocks)["Depth of wear at the start"]
    assert table.head == ("part", "µm per 1000 h", "after 2000 h\nµm")
    assert [row[0] for row in table.rows][:2] == ["sun", "planet"]
    assert float(table.rows[0][1]) == pytest.approx(0.6482, rel=2e-3)
    assert table.rows[-1][0] == "interference of the drive"


def test_course(blocks):
    table = tables(blocks)["The joint over time"]
    assert float(table.rows[0][2]) == pytest.approx(1000.0, rel=1e-3)
    assert float(table.rows[0][3]) == pytest.approx(12.184, rel=5e-3)
    assert float(table.rows[0][5]) == 0.0


def test_without_a_coefficient():
    blocks = list(wear(wear_document(check_wear())))
    shown = figures(blocks)
    assert shown["first contact slides"].unit == "s/Pa"
    assert "All times are in proportion to 1/k" in " ".join(sentences(blocks))
    table = tables(blocks)["Depth of wear at the start"]
    assert float(table.rows[0][1]) == pytest.approx(0.6482, rel=2e-3)


def test_a_cam_prints_its_stroke():
    case = check_case(
        {'interference = "12.9043 um"': 'preload = "200 N"\ncam_force_per_torque = "160 N/Nm"'}, COEFFICIENT
    )
    blocks = list(wear(wear_document(wear_of_case(case, life=1e4 * 3600.0))))
    shown = figures(blocks)
    assert shown["stroke"].si == pytest.approx(10.18e-6, rel=5e-3)
    assert float(shown["preload"].shown) == pytest.approx(1000.0, rel=1e-3)
    assert set(tables(blocks)) == {"Depth of wear at the start"}
    assert "wear takes stroke instead" in " ".join(sentences(blocks))


def test_with_skew_or_oil_it_is_said_why_the_second_end_is_not_known(found):
    """A course as tests/rolling/test_wear_course.py has it with skew: one end, and other contacts that may carry on."""
    document = wear_document(found)
    document["wear"] |= {
        "nothing_left": None,
        "computed_until": {"limit": "gross_slip", "contact": "wlo"},
        "nothing_left_hours": None,
        "nothing_left_kt_s_per_Pa": None,
        "after_life": dict.fromkeys(("preload_N", "interference_m", "stroke_m", "depth_m")),
    }
    blocks = list(wear(document))
    shown = figures(blocks)
    left = shown["nothing left"]
    assert (left.shown, left.unit, left.si) == ("–", "", None)
    assert left.detail == "not known: with skew or oil nothing is computed beyond the first slide"
    assert shown["preload"].detail == "after 2000 h; not computed as far"
    assert tables(blocks)["How long the joint carries its load"].rows[1][1] == left.detail
    assert (
        "With skew or oil a contact that slides bears something else than its friction, so that nothing is computed "
        "beyond the first slide; other contacts may still carry the load."
    ) in " ".join(sentences(blocks))


def test_a_joint_that_does_not_carry_on_does_not_reach_a_longer_life(blocks):
    long = list(wear(wear_document(check_wear(COEFFICIENT, 1e5 * 3600.0))))
    assert figures(long)["preload"].detail == "after 100000 h; the joint does not reach it"
    assert "skew or oil" not in " ".join(sentences(long) + sentences(blocks))


def test_a_crown_that_is_worn_flat_ends_the_computation(found):
    document = wear_document(found)
    document["wear"] |= {
        "first_slide": None,
        "nothing_left": None,
        "computed_until": {"limit": "flat", "contact": "wlo"},
        "after_life": dict.fromkeys(("preload_N", "interference_m", "stroke_m", "depth_m")),
    }
    for end in ("first_slide", "nothing_left"):
        document["wear"] |= {f"{end}_hours": None, f"{end}_kt_s_per_Pa": None}
    shown = figures(list(wear(document)))
    for name in ("first contact slides", "nothing left"):
        assert shown[name].detail == "not computed beyond: the crown of wlo is worn flat"
    assert shown["preload"].detail == "after 2000 h; not computed as far"


def test_a_joint_that_ends_before_a_contact_slides_says_by_what(found):
    document = wear_document(found)
    document["wear"] |= {
        "first_slide": None,
        "first_slide_hours": None,
        "first_slide_kt_s_per_Pa": None,
        "nothing_left": {"limit": "lift_off", "contact": "wlo", "load": 1, "interference_m": 1e-6},
    }
    shown = figures(list(wear(document)))
    assert shown["first contact slides"].detail == "none before wlo lifts off"
    assert shown["nothing left"].detail == "wlo lifts off"


def test_what_is_left_out_is_said(found):
    document = wear_document(found)
    document["wear"] |= {"unlike_lengths": ["planet"], "crowned": True}
    said = " ".join(sentences(list(wear(document))))
    assert "Contacts of unlike lengths roll on one track (planet)" in said
    assert "Crowns wear flatter" in said


def test_years_beyond_all_meaning_are_bounded():
    """A full film leaves the asperities next to nothing: 7e89 h would be no answer."""
    document = copy.deepcopy(wear_document(check_wear(COEFFICIENT, 2000.0 * 3600.0)))
    document["wear"] |= {"first_slide_hours": 7e89, "allowed_coefficient_per_Pa": 3e60}
    blocks = list(wear(document))
    shown = figures(blocks)
    assert shown["first contact slides"].shown == "> 1e9"
    assert shown["largest wear coefficient"].shown == "> 1e-11"
    assert (
        next(block for block in wear(document) if "How long" in getattr(block, "title", "")).rows[0][-1]
        == "> 1e9"
    )

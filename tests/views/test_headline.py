"""The figures by which a joint is decided, from the numbers of its document."""

import pytest
from shown_blocks import amount

from asperity.views.headline import headline


def shown(view, **changes):
    return {figure.name: figure for figure in headline(view.document | changes)}


def test_their_numbers_are_those_of_the_document_in_the_units_of_a_designer(planetary_view):
    document = planetary_view.document
    found = shown(planetary_view)
    expected = {
        "Stiffness": document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"] / 3437.746770784939,
        "Drift": document["drift_rad_per_output_turn"] * 3437.746770784939,
        "Torque capacity": document["torque_capacity"]["output_torque_Nm"],
        "Life": document["life_hours"],
        "Efficiency": 100.0 * document["efficiency"],
        "Mass": document["mass_kg"],
        "Diameter": 1e3 * document["envelope_diameter_m"],
    }
    assert list(found) == list(expected)
    for name, value in expected.items():
        assert amount(found[name].text) == pytest.approx(value, rel=1e-3), name
    assert found["Torque capacity"].detail == "contact sp slips, in rolling"
    assert found["Stiffness"].detail == "upper bound: pins rigid"
    assert found["Efficiency"].detail.endswith(" W lost")


def test_what_is_not_known_says_why_in_a_few_words(paper_view, view_of):
    assert (shown(paper_view)["Life"].text, shown(paper_view)["Life"].detail) == ("–", "no rating life")
    standing = shown(view_of("tutorial_joint"))
    assert (standing["Efficiency"].text, standing["Efficiency"].detail) == ("–", "the sun stands")
    assert standing["Life"].unit == "output turns"
    assert standing["Life"].si == view_of("tutorial_joint").document["rolling"]["life_output_turns"]


def test_the_capacity_is_that_of_the_direction_of_the_torque(planetary_view):
    document = planetary_view.document
    forces = document["standing"]["forces"] | {"output_torque_Nm": -1.0}
    backwards = shown(planetary_view, standing=document["standing"] | {"forces": forces})
    assert backwards["Torque capacity"].si == document["torque_capacity"]["reverse"]["output_torque_Nm"]

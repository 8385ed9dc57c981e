"""The verdicts on the paper itself; the numbers named here come from the model reference, not from a run."""

from pathlib import Path

import numpy as np
import pytest

from asperity.zou2025.claims import contact_forces, contact_stiffnesses
from asperity.zou2025.criteria import CRITERIA, PEAK_NEAR, Claim

Claims = dict[str, Claim]
TORQUE = np.linspace(0.0, 5.0, 11)


def test_all_thirteen_and_the_window_are_judged(claims: Claims) -> None:
    assert list(claims) == [f"C{i}" for i in range(1, 14)] + ["window"]


@pytest.mark.parametrize("name", ["C1", "C2", "C3", "C4", "C5", "C6", "C7", "C9", "C10", "C11"])
def test_met(claims: Claims, name: str) -> None:
    assert claims[name].met


def test_the_peak_is_near_1_85_for_the_pair_and_the_joint(claims: Claims) -> None:
    assert claims["C3"].statements[0].numbers["peak_fractal_dimension"] == pytest.approx(1.85, abs=0.02)
    assert "in steps of 0.05 the maximum is at D = 1.85" in claims["C3"].statements[0].evidence


def test_length_gives_three_percent_and_not_a_significant_gain(claims: Claims) -> None:
    grows, significant, _ = claims["C12"].statements
    assert grows.met
    assert not significant.met
    assert grows.numbers["largest_change"] == pytest.approx(0.03, abs=0.005)


def test_friction_only_ever_helps(claims: Claims) -> None:
    assert [s.met for s in claims["C13"].statements] == [True, True, False]


def test_left_and_right_part_with_the_torque(claims: Claims) -> None:
    assert [s.met for s in claims["C8"].statements] == [False, False, True, True, True]


def test_every_verdict_names_numbers(claims: Claims) -> None:
    for claim in claims.values():
        for statement in claim.statements:
            assert statement.evidence
            assert statement.numbers
            assert all(value == value and abs(value) != float("inf") for value in statement.numbers.values())


def test_the_table_of_the_docs_is_the_computed_one(claims: Claims) -> None:
    page = (Path(__file__).parents[2] / "docs" / "reproduction.md").read_text(encoding="utf-8")
    for claim in claims.values():
        verdict = "met" if claim.met else "not met"
        assert f"| {claim.name} | {claim.title} | {', '.join(claim.panels)} | {verdict} |" in page
    for criterion in CRITERIA:
        number = f"{criterion.limit:.0%}".replace("%", " %") if criterion is not PEAK_NEAR else "0.02"
        assert f"| {criterion.name} | {number} | {criterion.meaning} |" in page


def test_the_numbers_of_the_docs_are_the_computed_ones(claims: Claims) -> None:
    numbers = {name: [s.numbers for s in claim.statements] for name, claim in claims.items()}
    assert round(numbers["C8"][0]["largest_difference"], 2) == 0.30
    assert round(numbers["C8"][1]["largest_difference"], 2) == 0.35
    assert round(numbers["C5"][0]["change_at_lowest_D"], 3) == -0.013
    assert round(numbers["C6"][0]["change_at_lowest_D"], 3) == -0.038
    assert round(numbers["C11"][1]["change_strongest"], 2) == -0.14
    window = numbers["window"][1]
    assert window["smallest_share"] == pytest.approx(0.5, abs=0.02)
    assert (round(window["optimal_from_D"], 2), round(window["optimal_to_D"], 2)) == (1.80, 1.91)


def verdicts(claim):
    return [statement.met for statement in claim.statements]


@pytest.fixture
def forces(made_up):
    def judged(normal_slopes, tangential_slopes):
        loads = {
            "output_torque": TORQUE,
            "normal_force": 500.0 + np.outer(normal_slopes, TORQUE)[..., None],
            "tangential_force": np.outer(tangential_slopes, TORQUE)[..., None],
        }
        return verdicts(contact_forces(made_up(loads=loads)))

    return judged


def test_contact_forces(forces):
    assert forces([0.5, 20, -20, 20, -20], [9, 5, 4, 5, 4]) == [True] * 4
    assert forces([-0.5, 20, -20, 20, -20], [9, 5, 4, 5, 4]) == [False, True, True, True]
    assert forces([0.5, 20, -20, 20, 20], [9, 5, 4, 5, 4]) == [True, False, True, True]
    assert forces([0.5, 20, -20, 20, -20], [9, 5, -4, 5, 4]) == [True, True, False, True]
    assert forces([0.5, 20, -20, 20, -20], [9, 4, 5, 5, 4]) == [True, True, True, False]


@pytest.fixture
def contacts(made_up):
    def claim(levels, split):
        """Left contacts are lower than right ones by ``split`` at full torque, in proportion to the torque."""
        base = np.array(levels)
        left = np.array([0.0, 0.0, 1.0, 0.0, 1.0])
        at_full = base * (1.0 - split * left)
        over_torque = base[:, None] * (1.0 - split * left[:, None] * TORQUE / 5.0)
        rising = np.linspace(1.0, 2.0, 21)
        return contact_stiffnesses(
            made_up(
                loads={"output_torque": TORQUE, "contact_torsional_stiffness": over_torque[..., None]},
                dimension={"contact_torsional_stiffness": np.outer(at_full, rising)[:, None]},
                roughness={"contact_torsional_stiffness": np.outer(at_full, rising[::-1])[:, None]},
            )
        )

    return claim


def test_contact_stiffnesses_that_agree(contacts):
    assert verdicts(contacts([9, 1, 1, 1, 1], 0.05)) == [True] * 5


def test_torque_up_to_which_left_and_right_agree(contacts):
    claim = contacts([9, 1, 1, 1, 1], 0.25)
    assert verdicts(claim) == [False, False, True, True, True]
    assert claim.statements[0].numbers["torque_up_to_which_nearly_the_same_Nm"] == 2.0
    assert abs(claim.statements[0].numbers["largest_difference"] - 0.25) < 1e-12


def test_sun_contact_must_be_significantly_stiffer(contacts):
    claim = contacts([1.1, 1, 1, 1, 1], 0.05)
    assert verdicts(claim) == [True, True, False, True, True]
    # the largest ratio, 1.1, with the sun's radius of 4 mm instead of the planet's of 13.5 mm
    ratio = claim.statements[2].numbers["largest_ratio_with_sun_radius"]
    assert ratio == pytest.approx(1.1 * (4.0 / 13.5) ** 2)

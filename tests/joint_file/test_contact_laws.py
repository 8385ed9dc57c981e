"""Which contact law a joint file has: stated or not, with every kind of surface; contradictions."""

import math
import tomllib
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from assumed import assumptions

from asperity.contact.laws.by_decay_length import ByDecayLength
from asperity.contact.laws.registry import LAWS
from asperity.contact.laws.zou_2025 import Zou2025
from asperity.errors import InputError, NoSolutionError
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.contact_laws import laws_of_file, with_law
from asperity.joint_file.drawn_surface import drawn_interval
from asperity.joint_file.material_entries import contact_law_of
from asperity.joint_file.reader import case_from_tables
from asperity.joint_file.si_tables import replace_values, si_values

EXAMPLES = Path(__file__).parents[2] / "examples"
FRACTAL = {"fractal_dimension": 1.4, "fractal_roughness": "1e-8 mm", "frequency_ratio": 1.5}
AVERAGE = {"finish": "ground", "roughness_average": "0.2 um"}
BARE = {"fractal_dimension": 1.4, "frequency_ratio": 1.5, "roughness_average": "0.2 um"}
HEIGHT = {"rms_height": "0.2 um"}
LENGTH = {"decay_length": "0.07 um"}


def case_of(surface, law=None, name="zou2025"):
    tables = tomllib.loads((EXAMPLES / f"{name}.toml").read_text(encoding="utf-8"))
    model = tables["model"] | ({} if law is None else {"contact_law": law})
    return case_from_tables(tables | {"surface": surface, "model": model}, source="a.toml")


@pytest.mark.parametrize(
    ("surface", "law", "chosen"),
    [
        (FRACTAL, None, "zou_2025"),
        (FRACTAL, "zou_2025", "zou_2025"),
        (AVERAGE, None, "exponential"),
        (BARE, None, "exponential"),
        (BARE, "exponential", "exponential"),
        (AVERAGE, "zou_2025", "zou_2025"),
        (AVERAGE, "exponential", "exponential"),
        (HEIGHT, None, "exponential"),
        (HEIGHT, "exponential", "exponential"),
        (LENGTH, None, "measured"),
        (LENGTH, "measured", "measured"),
        (LENGTH, "persson_2007", "persson_2007"),
    ],
)
def test_the_law_of_every_surface(surface, law, chosen):
    case = case_of(surface, law)
    assert case.contact_law() == chosen
    (built,) = joint_from_case(case).surfaces
    assert type(built) is LAWS[chosen]
    told = " ".join(assumptions(case))
    assert (f"contact law {chosen}, since the file does not state model.contact_law" in told) == (law is None)
    assert ("contact law exponential: randomly rough" in told) == (chosen == "exponential")
    by_average = "roughness_average" in surface and chosen == "exponential"
    assert ("exponential with roughness_average" in told) == by_average


@pytest.mark.parametrize(
    ("surface", "law", "remedy"),
    [
        (HEIGHT, "zou_2025", 'leave contact_law out, state "exponential", or give fractal_dimension'),
        (
            LENGTH,
            "exponential",
            'leave contact_law out, state "persson_2007" or "measured", or give rms_height',
        ),
        (
            FRACTAL,
            "exponential",
            'state "zou_2025", or give rms_height of all contacts; roughness_average stands',
        ),
        (LENGTH, "zou_2025", "needs D and G, while surfaces state decay_length"),
        (dict.fromkeys(("sp", "pwr", "pwl", "wro", "wlo"), HEIGHT), "zou_2025", "leave contact_law out"),
    ],
)
def test_a_contradiction_is_one_message_with_the_remedy(surface, law, remedy):
    with pytest.raises(InputError, match=remedy) as caught:
        case_of(surface, law)
    assert str(caught.value).count(remedy) == 1
    with pytest.raises(InputError, match=remedy):
        contact_law_of([surface.get("sp", surface)], stated=law)


@pytest.mark.parametrize("surface", [FRACTAL, AVERAGE, HEIGHT])
def test_perssons_theory_needs_more_than_a_file_states(surface):
    with pytest.raises(
        InputError, match=r"needs the spectrum of a measured surface .*neither Ra nor D and G"
    ):
        joint_from_case(case_of(surface, "persson_2007"))


@pytest.mark.long
def test_both_laws_of_an_average_side_by_side():
    """Those of joints with each law; a file that states no Ra, or a G beside it, has one law only."""
    case = case_of(AVERAGE, name="planetary")
    joints = {law: joint_from_case(with_law(case, law)) for law in ("zou_2025", "exponential")}
    results = {law: solve_joint(joint).result for law, joint in joints.items()}
    entries = laws_of_file(case, joints["exponential"], results["exponential"])
    assert [(entry["law"], entry["used"]) for entry in entries] == [
        ("zou_2025", False),
        ("exponential", True),
    ]
    for entry in entries:
        assembly = results[entry["law"]].assembly.stiffness.output
        assert entry["assembly_Nm_per_rad"] == pytest.approx(float(assembly), rel=1e-9)
        drift = results[entry["law"]].rolling.drift_per_output_turn
        assert entry["drift_rad_per_output_turn"] == pytest.approx(float(drift), rel=1e-9)
    for surface in (FRACTAL, HEIGHT, LENGTH, {"sp": AVERAGE, "pr": FRACTAL}):
        one_law = case_of(surface, name="planetary")
        assert laws_of_file(one_law, joints["exponential"], results["exponential"]) == []


def test_a_law_that_has_no_stiffness_has_no_numbers(monkeypatch):
    """All spots plastic by one law, no balance by the other: null, not an error."""
    plastic = SimpleNamespace(contact_law_holds=np.array(False))
    monkeypatch.setattr("asperity.joint_file.contact_laws.solve_joint", refuse)
    joint = joint_from_case(case_of(AVERAGE))
    entries = laws_of_file(case_of(AVERAGE), joint, plastic)
    assert [entry["assembly_Nm_per_rad"] for entry in entries] == [None, None]
    assert [entry["drift_rad_per_output_turn"] for entry in entries] == [None, None]


def refuse(joint):
    raise NoSolutionError("no balance")


def test_a_study_cannot_leave_the_stated_law():
    values = si_values(case_of(FRACTAL, "zou_2025"))
    with pytest.raises(InputError, match="needs D and G"):
        joint_from_values(replace_values(values, {"surface.rms_height": 2e-7}))
    values = si_values(case_of(HEIGHT))
    (built,) = joint_from_values(
        replace_values(values, {"surface.rms_height": np.array([2e-7, 3e-7])})
    ).surfaces
    assert built.decay_length.tolist() == [0.48 * 2e-7, 0.48 * 3e-7]


def test_one_law_for_surfaces_of_both_kinds():
    """A contact with D and G makes the others by their finish fractal; beside rms_height it is a mistake."""
    others = dict.fromkeys(("pwr", "pwl", "wro", "wlo"), AVERAGE)
    case = case_of({"sp": FRACTAL, **others})
    assert case.contact_law() == "zou_2025"
    assert all(isinstance(each, Zou2025) for each in joint_from_case(case).surfaces)
    values = si_values(case_of(dict.fromkeys(("sp", *others), AVERAGE)))
    changed = joint_from_values(replace_values(values, {"surface.sp.rms_height": 2e-7}))
    assert float(changed.surfaces[0].decay_length) == 0.48 * 2e-7
    assert all(isinstance(each, ByDecayLength) for each in changed.surfaces)
    with pytest.raises(InputError, match="one contact law for all contacts"):
        joint_from_values(replace_values(si_values(case), {"surface.pwr.rms_height": 2e-7}))


def test_heights_of_an_average_by_hand():
    """Normally distributed heights: Rq = sqrt(pi/2) Ra; two bodies of 0.2 and 0.15 um have 0.25 um together."""
    case = case_of(AVERAGE | {"partner_roughness_average": "0.15 um"}, "exponential")
    (built,) = joint_from_case(case).surfaces
    assert float(built.decay_length) == pytest.approx(0.48 * math.sqrt(math.pi / 2.0) * 0.25e-6, rel=1e-12)


@pytest.mark.long
def test_stiffnesses_and_interval_of_an_average():
    """K_n of u0 and K_t = kappa K_n (1 - T/mu N) of the joint's own forces; the law's ends in the interval."""
    case = case_of(AVERAGE | {"roughness_average": "0.2 um +- 0.02 um"}, "exponential", name="planetary")
    joint = joint_from_case(case)
    solved = solve_joint(joint)
    contacts, forces = solved.result.contacts, solved.result.forces
    length = 0.48 * math.sqrt(math.pi) * 0.2e-6  # both bodies alike: sqrt(2) times one
    normal, tangential = np.asarray(forces.normal), np.abs(np.asarray(forces.tangential))
    friction, ratio = case.load.friction_coefficient.value, float(joint.materials[0].poisson_ratio)
    modulus = float(joint.materials[0].youngs_modulus) / (2.0 * (1.0 - ratio**2))
    s = 0.25 * math.pi * modulus * case.drive.contact_length.value * length / normal
    expected = normal / length * (1.0 + 1.0 / (1.0 + 1.35 * s))
    np.testing.assert_allclose(contacts.normal_stiffness, expected, rtol=1e-9)
    np.testing.assert_allclose(
        contacts.tangential_stiffness,
        2.0 * (1.0 - ratio) / (2.0 - ratio) * expected * (1.0 - tangential / (friction * normal)),
        rtol=1e-9,
    )
    interval = drawn_interval(case)
    for end, factor in (("low", 1.24 * 1.1), ("high", 0.39 * 0.9)):
        there = case_of({"rms_height": f"{factor * length / 0.48 * 1e6:.10g} um"}, name="planetary")
        stiffness = float(solve_joint(joint_from_case(there)).result.assembly.stiffness.output)
        assert interval["assembly"][f"{end}_Nm_per_rad"] == pytest.approx(stiffness, rel=1e-5)
    law, heights = (interval["parts"][name]["assembly"] for name in ("contact_law", "rms_height"))
    for part in (law, heights):
        assert interval["assembly"]["low_Nm_per_rad"] < part["low_Nm_per_rad"] < part["high_Nm_per_rad"]
        assert part["high_Nm_per_rad"] < interval["assembly"]["high_Nm_per_rad"]

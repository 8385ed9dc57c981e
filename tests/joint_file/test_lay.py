"""A joint file with a stated lay: against its closed forms, with one on some contacts, and under laws without it."""

from pathlib import Path

import numpy as np
import pytest

from asperity.contact.creep_layer import layer_creepage_factor
from asperity.errors import InputError
from asperity.joint.contacts import rough_joint_contacts
from asperity.joint.description import joint_contacts
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.rolling.creep import contact_creep
from asperity.study.batch import derivatives_at, evaluate_points

TEXT = (Path(__file__).parents[2] / "examples" / "planetary.toml").read_text(encoding="utf-8")
NORMAL, SHARE = np.array([800.0, 900.0]), 0.3
NU = 0.29  # of the steel of the file


def case_with(surface):
    before, _, rest = TEXT.partition("[surface]\n")
    text = f"{before}[surface]\n{surface}\n{''.join(rest.partition(chr(10) + '[')[1:])}"
    return parse_case(text, source="a.toml")


def heights(lay):
    return case_with(f'rms_height = "0.2 um"\n{lay}')


def loaded(case, share=SHARE):
    contacts = joint_contacts(joint_from_case(case))
    tangential = share * np.asarray(contacts.pairs.friction_coefficient) * NORMAL
    return rough_joint_contacts(contacts=contacts, normal_force=NORMAL, tangential_force=tangential)


def creep(case, skew=None):
    contacts = joint_contacts(joint_from_case(case))
    tangential = SHARE * np.asarray(contacts.pairs.friction_coefficient) * NORMAL
    return contact_creep(contacts=contacts, skew=skew, normal_force=NORMAL, tangential_force=tangential)


def test_a_ratio_of_one_changes_nothing():
    plain, same = loaded(heights("")), loaded(heights('lay_ratio = 1\nlay = "axis"'))
    for name in plain.number_fields:
        np.testing.assert_array_equal(getattr(plain, name), getattr(same, name))
    np.testing.assert_array_equal(
        creep(heights("")).layer_factor, creep(heights('lay_ratio = 1\nlay = "axis"')).layer_factor
    )


@pytest.mark.parametrize(("lay", "share"), [("rolling", 1.0 / 11.0), ("axis", 10.0 / 11.0)])
def test_stiffness_and_creep_by_hand(lay, share):
    """The layer is f times as stiff whatever the direction; along grooves it yields sideways more than across them."""
    case = heights(f'lay_ratio = 10\nlay = "{lay}"')
    plain, found = loaded(heights(""), 0.0), loaded(case, 0.0)
    factor = 1.0 + 0.155 * (9.0 / 11.0) ** 1.5
    np.testing.assert_allclose(found.layer_stiffness / plain.layer_stiffness, factor, rtol=1e-12)
    kappa = (1.0 - NU) / (1.0 - NU * share)
    np.testing.assert_allclose(found.tangential_stiffness / found.normal_stiffness, kappa, rtol=1e-12)
    rolling, before = creep(case), creep(heights(""))
    np.testing.assert_allclose(rolling.layer_ratio, before.layer_ratio / factor, rtol=1e-12)
    expected = layer_creepage_factor(
        layer_ratio=before.layer_ratio / factor, slip_ratio=SHARE, stiffness_ratio=kappa
    )
    np.testing.assert_allclose(rolling.layer_factor, expected, rtol=1e-12)


def test_across_the_rolling_direction_grooves_act_the_other_way():
    """Creepage across over along at gross slip: bodies softer by 1/(1 - nu), the layer by the other share."""
    for lay, share in (("rolling", 1.0 / 11.0), ("axis", 10.0 / 11.0)):
        found = creep(heights(f'lay_ratio = 10\nlay = "{lay}"'), skew=(0.0,))
        along, across = (
            layer_creepage_factor(layer_ratio=found.layer_ratio, slip_ratio=SHARE, stiffness_ratio=kappa)
            for kappa in ((1.0 - NU) / (1.0 - NU * share), 1.0 / (1.0 - NU * (1.0 - share)))
        )
        np.testing.assert_allclose(found.lateral_ratio, across / along / (1.0 - NU), rtol=1e-9)


def test_contacts_without_a_lay_beside_one_with_it():
    per_contact = '[surface.sp]\nrms_height = "0.2 um"\n[surface.pr]\nrms_height = "0.2 um"\n'
    case = case_with(per_contact + 'lay_ratio = 10\nlay = "axis"')
    found, plain, grooved = (
        loaded(one) for one in (case, heights(""), heights('lay_ratio = 10\nlay = "axis"'))
    )
    for one, expected in ((0, plain), (1, grooved)):
        assert float(found.tangential_stiffness[one]) == float(expected.tangential_stiffness[one])


def test_of_a_decay_length_the_lay_is_the_tangential_part():
    plain, grooved = (
        loaded(case_with(f'decay_length = "0.1 um"\n{lay}'), 0.0)
        for lay in ("", 'lay_ratio = 10\nlay = "axis"')
    )
    np.testing.assert_array_equal(plain.normal_stiffness, grooved.normal_stiffness)
    ratio = (2.0 - NU) / (2.0 - 20.0 / 11.0 * NU)
    np.testing.assert_allclose(grooved.tangential_stiffness / plain.tangential_stiffness, ratio, rtol=1e-12)


def test_a_law_without_decay_length_refuses_a_lay_by_its_name():
    fractal = 'fractal_dimension = 1.4\nfractal_roughness = "1e-8 mm"\nfrequency_ratio = 1.5\n'
    with pytest.raises(InputError) as caught:
        case_with(fractal + 'lay_ratio = 10\nlay = "axis"')
    assert "surface.lay_ratio: the contact law zou_2025 takes no lay_ratio and no lay" in str(caught.value)
    assert "only exponential, persson_2007, measured do" in str(caught.value)


def test_a_share_in_place_of_ratio_and_direction():
    """3/4 of the waves across grooves of three times their width; on one contact beside a ratio on the other."""
    for lay, share in (("axis", 0.75), ("rolling", 0.25)):
        one, other = (
            loaded(heights(text)) for text in (f'lay_ratio = 3\nlay = "{lay}"', f"rolling_share = {share}")
        )
        np.testing.assert_allclose(one.tangential_stiffness, other.tangential_stiffness, rtol=1e-14)
    per_contact = (
        '[surface.sp]\nrms_height = "0.2 um"\nrolling_share = 0.75\n[surface.pr]\nrms_height = "0.2 um"\n'
    )
    found = loaded(case_with(per_contact + 'lay_ratio = 3\nlay = "rolling"'))
    for number, share in enumerate((0.75, 0.25)):
        alone = loaded(heights(f"rolling_share = {share}"))
        assert float(found.tangential_stiffness[number]) == float(alone.tangential_stiffness[number])
    with pytest.raises(InputError, match=r"it stands in place of .*: leave it out, or"):
        heights('lay_ratio = 3\nlay = "axis"\nrolling_share = 0.7')


def test_a_study_of_a_ratio_without_a_direction_is_refused():
    values = replace_values(si_values(heights("")), {"surface.lay_ratio": 3.0})
    with pytest.raises(InputError, match=r"lay: this key is missing, without which lay_ratio says nothing"):
        joint_from_values(values)


@pytest.mark.slow
def test_sweep_and_sensitivity_over_the_ratio():
    """The batch is the joint at each ratio, its slopes are those by differences; none at 1 is nan."""
    values = si_values(heights('lay_ratio = 3\nlay = "axis"'))
    results = ("assembly_stiffness_output", "drift")
    ratios = np.array([1.0, 1.0 + 1e-4, 3.0 - 1e-4, 3.0, 3.0 + 1e-4])
    points = {"surface.lay_ratio": ratios}
    status, found = evaluate_points(values, points, results)
    assert not status.any()
    for number in (0, 3):
        state = solve_joint(joint_from_values(replace_values(values, {"surface.lay_ratio": ratios[number]})))
        assert found[results[0]][number] == pytest.approx(
            float(state.result.assembly.stiffness.output), rel=1e-9
        )
    _, _, slopes = derivatives_at(values, points, results, ("surface.lay_ratio",))
    for name in results:
        assert np.all(np.isfinite(slopes[name]))
        by_difference = (found[name][4] - found[name][2]) / 2e-4
        assert slopes[name][0, 3, 0] == pytest.approx(by_difference, rel=1e-4)

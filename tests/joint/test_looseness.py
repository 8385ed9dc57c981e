"""A joint by interference at its working temperature."""

import dataclasses
import math

import numpy as np
import pytest
from assumed import assumptions

from asperity.errors import InputError
from asperity.joint.fit import fit_document, loose_temperature, refuse_loose
from asperity.joint.solve import solve_joint
from asperity.joint.status import STATUS_NAMES
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values
from asperity.study.batch import evaluate_points


def text_of(joint_text, *, working="40 degC", load='interference = "13 um"', ring="24e-6 1/K", housing=""):
    """The paper's joint of steel, 12e-6 1/K, in a ring of another material, its bodies as springs."""
    text = joint_text.replace('preload = "1000 N"', load).replace('bodies = "exact"', 'bodies = "springs"')
    steel = text[text.index("[materials.steel]") : text.index("[bodies]")]
    text = text.replace(steel, steel.rstrip() + '\nthermal_expansion = "12e-6 1/K"\n\n')
    other = steel.replace("steel", "other", 1).rstrip() + f'\nthermal_expansion = "{ring}"\n\n'
    temperature = f'[temperature]\nassembly = "20 degC"\nworking = "{working}"\n{housing}\n'
    return text.replace('ring = "steel"', 'ring = "other"').replace(
        "[bodies]", other + temperature + "[bodies]"
    )


@pytest.fixture(scope="module")
def case_of(joint_text):
    return lambda **changes: parse_case(text_of(joint_text, **changes), source="x")


def test_the_ring_outgrows_its_rollers(case_of):
    """12e-6 1/K of difference, 40 mm, 20 K: 9.6 um of the 13 um are gone."""
    joint = joint_from_case(case_of())
    assert float(joint.fit.thermal_change) == pytest.approx(-9.6e-6, rel=1e-12)
    found = fit_document(joint.fit, 1000.0, 47.0)
    assert found["interference_m"] == pytest.approx(13e-6, rel=1e-12)
    assert found["loose_temperature_degC"] == 47.0
    assert float(loose_temperature(joint.fit)) == pytest.approx(20.0 + 13.0 / 0.48)


def test_a_housing_moves_a_ring_of_steel(case_of):
    """A thin wall would follow an aluminium housing; this thick one widens more than that."""
    alone = joint_from_case(case_of(ring="12e-6 1/K"))
    held = joint_from_case(
        case_of(ring="12e-6 1/K", housing='housing_expansion = "24e-6 1/K"', working="21 degC")
    )
    assert float(alone.fit.thermal_change) == pytest.approx(0.0, abs=1e-20)
    nu = 0.3 / 0.7
    wide = 2.0 / (1.0 - nu + (1.0 + nu) * 0.4**2)  # 60 mm around 40 mm, plane strain
    assert float(held.fit.thermal_change) == pytest.approx(-0.48e-6 * wide, rel=1e-12)


def test_a_loose_joint_is_refused_with_its_temperature(case_of):
    joint = joint_from_case(case_of(working="60 degC"))
    with pytest.raises(InputError, match=r"loose .* 60 degC.*13 um.*40 K take 19.2 um.*above 47.08 degC"):
        refuse_loose(joint.fit)
    cold = joint_from_case(case_of(working="-60 degC", ring="0.5e-6 1/K"))
    assert float(loose_temperature(cold.fit)) < 0.0
    with pytest.raises(InputError, match="is left below"):
        refuse_loose(cold.fit)
    refuse_loose(joint_from_case(case_of()).fit)
    refuse_loose(None)


@pytest.mark.parametrize("rounding", [1e-22, -1e-22, -1e-9])
def test_bodies_that_expand_alike_never_come_loose(case_of, rounding):
    """13 um over 1e-22 m/K are 1e17 K; over -1e-9 m/K 13000 K: no temperature of a solid body."""
    joint = joint_from_case(case_of())
    alike = dataclasses.replace(joint, fit=dataclasses.replace(joint.fit, change_per_kelvin=rounding))
    assert float(loose_temperature(alike.fit)) == math.inf


@pytest.mark.long
def test_studies_follow_the_temperature_and_say_where_it_is_loose(case_of):
    values = si_values(case_of())
    temperatures = np.array([-20.0, 0.0, 20.0, 40.0, 60.0])
    status, found = evaluate_points(
        values,
        {"temperature.working": temperatures},
        ("preload", "interference", "thermal_interference"),
    )
    assert found["preload"][2] == pytest.approx(
        float(solve_joint(joint_from_case(case_of(working="20 degC"))).result.preload), rel=1e-9
    )
    assert np.all(np.diff(found["preload"][:4]) < 0.0)
    assert np.isnan(found["preload"][4])
    assert found["thermal_interference"] == pytest.approx(-0.48e-6 * (temperatures - 20.0), rel=1e-12)
    assert found["interference"][:4] == pytest.approx(13e-6 - 0.48e-6 * (temperatures[:4] - 20.0), rel=1e-6)
    assert STATUS_NAMES[status[4]] == "no_interference_left"
    assert status[2] == 0


def test_a_preload_by_force_does_not_change_and_the_file_is_told_how_much_it_would(case_of, joint_text):
    case = case_of(load='preload = "1000 N"')
    joint = joint_from_case(case)
    assert (joint.preload, joint.fit) == (1000.0, None)
    (note,) = (each for each in assumptions(case) if "load.preload is a force" in each)
    assert "-9.6 µm of interference by temperature does not move it" in note
    plain = joint_text.replace("[model]", '[temperature]\nassembly = "0 °C"\nworking = "9 °C"\n\n[model]')
    (note,) = (
        each for each in assumptions(parse_case(plain, source="x")) if "load.preload is a force" in each
    )
    assert "the thermal_expansion of steel, which the file does not state" in note
    assert any("elastic moduli, friction" in each for each in assumptions(case))

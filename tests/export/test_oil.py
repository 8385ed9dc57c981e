"""Exports of a joint with oil have the friction of its film and asperities, at a stated speed and temperature."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest

import asperity
from asperity.export.content import conditions_sentence, export_content, heading
from asperity.export.targets import csv_file
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case

OIL = Path(__file__).parents[2] / "examples" / "oil.toml"


def oiled(folder, *, warm=40):
    path = folder / f"oil_{warm}.toml"
    text = OIL.read_text().replace('working = "40 degC"', f'working = "{warm} degC"')
    path.write_text(text.replace('"10 N*m"', '"4 N*m"'))
    return path


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("oil")


def exported(path):
    joint = joint_from_case(read_case(path))
    return export_content(joint, inertias=None, source=path.name, largest_torque=None, level="assembly")


@pytest.fixture(scope="module")
def content(folder):
    return exported(oiled(folder))


def test_drift_friction_and_efficiency_are_those_of_rolling(content, folder, read_table):
    rolling = asperity.roll(asperity.load(oiled(folder))).document["rolling"]
    assert content.drift == pytest.approx(rolling["drift_rad_per_output_turn"], rel=1e-9)
    assert content.efficiency == pytest.approx(rolling["efficiency"], rel=1e-9)
    losses = rolling["losses_W"]
    speed = 1500.0 * np.pi / 30.0
    assert content.friction == pytest.approx((losses["total"] - losses["creep"]) / speed, rel=1e-9)
    last = {name: values[-1] for name, values in read_table(csv_file(content)).items()}
    assert last["drift_driving_rad_per_turn"] == pytest.approx(content.drift, rel=1e-12)
    assert last["efficiency"] == pytest.approx(content.efficiency, rel=1e-12)
    by_contact = {name: contact["traction_capacity"] for name, contact in rolling["contacts"].items()}
    assert dict(content.traction_capacities) == pytest.approx(by_contact, rel=1e-9)


def test_the_head_says_at_which_speed_and_temperature(content):
    (said,) = (line for line in heading(content, what="Table") if line.startswith("Drift, efficiency"))
    assert "at 1500 rpm of the sun and oil of 40 degC" in said
    assert "(largest T/N 0.10" in said
    assert said.endswith("has the stated friction 0.12.")
    (efficiency,) = (line for line in heading(content, what="Table") if line.startswith("Efficiency at"))
    assert efficiency == f"Efficiency at 4 N*m, steady rolling: {100.0 * content.efficiency:.4g} %"


def test_a_warmer_oil_exports_another_drift(content, folder):
    warm = exported(oiled(folder, warm=60))
    assert warm.drift > 1.02 * content.drift
    assert "oil of 60 degC" in conditions_sentence(warm)


def test_a_joint_without_oil_says_that_its_friction_is_stated(made_content):
    said = conditions_sentence(made_content())
    assert said.startswith(
        "Drift, efficiency and friction at the motor: at 6000 rpm of the sun, with the stated"
    )
    assert "Efficiency at 5 N*m: unknown." in heading(made_content(), what="Table")
    still = made_content()
    still = dataclasses.replace(still, joint=dataclasses.replace(still.joint, input_speed=0.0))
    assert conditions_sentence(still).startswith("Drift: of slow rolling, with the stated friction")

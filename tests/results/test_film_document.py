"""The document of the oil over speed: its keys, the numbers of `asperity roll` at the file's own speed, and gaps."""

import json
from pathlib import Path

import numpy as np
import pytest

import asperity
from asperity.joint_file.film import joint_film
from asperity.results.film_document import film_columns, film_document

OIL = Path(__file__).parents[2] / "examples" / "oil.toml"
KEYS = {
    "central_film_m",
    "minimum_film_m",
    "film_ratio",
    "lubrication",
    "asperity_share",
    "rival_asperity_share",
    "traction_capacity",
    "traction_coefficient",
    "creepage",
    "inlet_heat_factor",
    "deborah_number",
}


@pytest.fixture(scope="module")
def joint():
    return asperity.load(OIL)


@pytest.fixture(scope="module")
def film(joint):
    return joint_film(joint.case, temperatures=(40.0, 80.0), points=4)


def test_keys(film):
    document = film_document(film)
    assert json.loads(json.dumps(document, allow_nan=False)) == document
    assert document["oil_temperature_C"] == 40.0
    assert document["output_torque_Nm"] == 10.0
    assert document["input_speed_rad_per_s"] == pytest.approx(50.0 * np.pi)
    assert set(document["film"]["contacts"]) == {"sp", "pr"}
    for contact in document["film"]["contacts"].values():
        assert set(contact) == KEYS
    assert [each["oil_temperature_C"] for each in document["over_speed"]] == [40.0, 80.0]
    for each in document["over_speed"]:
        for contact in each["contacts"].values():
            assert set(contact) == KEYS
            assert {len(values) for values in contact.values()} == {len(each["input_speed_rad_per_s"])}


def test_the_speed_of_the_file_is_as_rolling(joint, film):
    rolling, document = asperity.roll(joint).document["rolling"], film_document(film)
    places = {"minimum_film_m": "film_thickness_m"}
    for name, contact in document["film"]["contacts"].items():
        for key in KEYS - {"lubrication"}:
            assert contact[key] == pytest.approx(rolling["contacts"][name][places.get(key, key)], rel=1e-9), (
                key
            )
    for key in ("drift_rad_per_output_turn", "efficiency"):
        assert document["film"][key] == pytest.approx(rolling[key], rel=1e-9)


def test_lubrication_follows_the_film_ratio(film):
    for each in film_document(film)["over_speed"]:
        for contact in each["contacts"].values():
            for ratio, band in zip(contact["film_ratio"], contact["lubrication"], strict=True):
                if ratio is None:
                    assert band is None
                else:
                    assert band == ("boundary" if ratio < 1.0 else "mixed" if ratio < 3.0 else "full")


def test_where_nothing_rolls_there_is_nothing(film):
    warm = film_document(film)["over_speed"][1]
    assert not all(warm["rolls"])
    for row, rolls in enumerate(warm["rolls"]):
        assert (warm["efficiency"][row] is None) == (not rolls)
        assert (warm["contacts"]["pr"]["traction_capacity"][row] is None) == (not rolls)


def test_columns(film):
    columns = film_columns(film)
    assert {len(column) for column in columns.values()} == {10}
    assert columns["oil_temperature_C"].tolist() == [40.0] * 5 + [80.0] * 5
    assert np.array_equal(columns["creepage_pr"][:5], film.curves[0].creepage[1])

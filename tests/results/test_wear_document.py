"""The document of wear: keys, units, hours, and what is null."""

import json

import numpy as np
import pytest
from tests.support.worn import COEFFICIENT, check_wear

from asperity.results.wear_document import wear_columns, wear_document


@pytest.fixture(scope="module")
def found():
    return check_wear(COEFFICIENT, 2000.0 * 3600.0)


@pytest.fixture(scope="module")
def document(found):
    return json.loads(json.dumps(wear_document(found)))["wear"]


def test_hours_and_depths(document):
    """An independent program has 5430.5 and 5593.8 h, and 0.6482 µm of the sun in 1000 h."""
    assert document["first_slide_hours"] == pytest.approx(5430.5, rel=5e-3)
    assert document["nothing_left_hours"] == pytest.approx(5593.8, rel=5e-3)
    assert document["depth_m_per_hour"]["sun"] * 1e9 == pytest.approx(0.6482, rel=2e-3)
    assert document["hours"][-1] == pytest.approx(document["nothing_left_hours"])
    assert document["hours"][0] == 0.0
    assert document["first_slide"]["contact"] == "wlo"
    assert document["coefficient_per_Pa"]["ring"] == pytest.approx(1e-17)


def test_lists_are_as_long_as_the_hours(document):
    for key in (
        "kt_s_per_Pa",
        "interference_m",
        "preload_N",
        "drift_rad_per_output_turn",
        "size_drift_rad_per_output_turn",
        "torque_capacity_Nm",
    ):
        assert len(document[key]) == len(document["hours"]), key
    assert None in document["torque_capacity_Nm"]
    assert set(document["depth_m"]) == set(document["depth_m_per_hour"])


def test_allowed_coefficient(document):
    assert document["allowed_coefficient_per_Pa"] * 2000.0 * 3600.0 == pytest.approx(
        document["first_slide_kt_s_per_Pa"]
    )


def test_after_the_life(document):
    at = document["hours"].index(pytest.approx(2000.0, rel=1e-9))
    after = document["after_life"]
    assert after["preload_N"] == pytest.approx(document["preload_N"][at], rel=1e-9)
    assert after["interference_m"] == pytest.approx(document["interference_m"][at], rel=1e-9)
    assert after["depth_m"]["sun"] == pytest.approx(document["depth_m"]["sun"][at], rel=1e-9)


def test_beyond_the_end_nothing_is_left(found):
    late = wear_document(found._replace(life=1e5 * 3600.0))["wear"]["after_life"]
    assert (late["preload_N"], late["interference_m"], late["depth_m"]) == (None, None, None)


def test_without_a_coefficient_everything_is_a_product():
    document = wear_document(check_wear())["wear"]
    for key in (
        "hours",
        "depth_m_per_hour",
        "first_slide_hours",
        "coefficient_per_Pa",
        "after_life",
        "life_hours",
    ):
        assert document[key] is None, key
    assert document["first_slide_kt_s_per_Pa"] == pytest.approx(1.955e-10, rel=5e-3)
    assert document["depth_per_kt_m_Pa_per_s"]["sun"] * 3.6e-11 * 1e6 == pytest.approx(0.6482, rel=2e-3)


def test_columns(found):
    columns = wear_columns(found)
    assert {len(values) for values in columns.values()} == {len(columns["hours"])}
    assert np.all(np.diff(columns["depth_m_sun"]) > 0.0)

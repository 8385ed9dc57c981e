"""Studies as plain data: JSON knows neither nan nor infinities."""

import json

import numpy as np
import pytest

from asperity.study.tolerances.documents import failures, sensitivity_document

xarray = pytest.importorskip("xarray")


def test_a_derivative_without_a_value_is_null():
    found = xarray.Dataset(
        {
            "derivative": (("result", "input"), [[2.0, np.nan]]),
            "elasticity": (("result", "input"), [[0.5, np.inf]]),
            "value": ("input", [1.0, 2.0]),
            "result_value": ("result", [4.0]),
        },
        coords={
            "result": ["drift"],
            "input": ["load.preload", "drive.sun_radius"],
            "result_unit": ("result", ["rad"]),
            "input_unit": ("input", ["N", "m"]),
            "result_name": ("result", ["drift"]),
        },
    )
    document = json.loads(json.dumps(sensitivity_document(found), allow_nan=False))
    assert document["inputs"]["drive.sun_radius"] == {"value": 2.0, "unit": "m", "finished_part": False}
    assert document["results"]["drift"]["derivative"] == {"load.preload": 2.0, "drive.sun_radius": None}
    assert document["results"]["drift"]["elasticity"]["load.preload"] == 0.5


def test_failures_are_told_by_share_and_none_where_all_have_a_value():
    found = xarray.Dataset({"failed": ("result", [0.0, 0.25, 0.5, 0.25])}, coords={"result": list("abcd")})
    called = {"a": "stiffness", "b": "drift", "d": "life"}
    (sentence,) = failures(found, called)
    assert sentence.startswith(
        "25 % of the drives fail and have no drift, life: the quantiles count them as the worst"
    )
    assert list(failures(found, {"a": "stiffness"})) == []

"""Studies as plain data: JSON knows neither nan nor infinities."""

import json

import numpy as np
import pytest

from asperity.study.tolerances.documents import sensitivity_document

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
    assert document["inputs"]["drive.sun_radius"] == {"value": 2.0, "unit": "m"}
    assert document["results"]["drift"]["derivative"] == {"load.preload": 2.0, "drive.sun_radius": None}
    assert document["results"]["drift"]["elasticity"]["load.preload"] == 0.5

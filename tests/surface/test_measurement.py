"""The document survives the way out and in, and wrong ones are refused."""

import json

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.measurement import (
    SurfaceMeasurement,
    measurement_document,
    measurement_from_document,
    read_measurement,
)


def measurement(D=1.5, G=1e-9, gamma=1.5, band=(1e-7, 1e-4), sd=0.01):
    return SurfaceMeasurement(
        fractal_dimension=jnp.asarray(D),
        fractal_roughness=jnp.asarray(G),
        frequency_ratio=jnp.asarray(gamma),
        covariance=jnp.asarray([[sd**2, 2 * sd**2], [2 * sd**2, 9 * sd**2]]),
        shortest_wavelength=jnp.asarray(band[0]),
        longest_wavelength=jnp.asarray(band[1]),
        estimator="likelihood",
        profiles=3,
        source="a.txt",
    )


def test_round_trip_through_a_file(tmp_path):
    file = tmp_path / "m.json"
    file.write_text(json.dumps(measurement_document(measurement=measurement())))
    back = read_measurement(path=file)
    assert float(back.fractal_dimension) == 1.5
    assert float(back.fractal_roughness) == 1e-9
    np.testing.assert_array_equal(back.covariance, measurement().covariance)
    assert (back.estimator, back.profiles, back.source) == ("likelihood", 3, "a.txt")


def test_intervals_are_those_of_the_normal_law():
    interval = measurement().interval(confidence=0.95)
    assert interval["fractal_dimension"] == pytest.approx((1.5 - 0.0195996, 1.5 + 0.0195996), abs=1e-6)
    assert interval["fractal_roughness"][1] == pytest.approx(1e-9 * np.exp(0.0587989), rel=1e-5)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"schema": "x"}, "not a surface measurement"),
        ({"schema_version": 9}, "version 9"),
        ({"refused": "no power law"}, "was refused: no power law"),
        ({"fractal_dimension": 2.4}, "between 1 and 2"),
        ({"fractal_roughness_m": "big"}, "not a number"),
        ({"covariance_of_dimension_and_log_roughness": [[1, 2], [2, 1]]}, "covariance"),
        ({"frequency_ratio": 0.5}, "gamma"),
        ({"estimator": None, "profiles": None}, "not a number"),
    ],
)
def test_wrong_documents(change, says):
    with pytest.raises(InputError, match=says):
        measurement_from_document(document=measurement_document(measurement=measurement()) | change)


def test_missing_key_and_wrong_files(tmp_path):
    document = measurement_document(measurement=measurement())
    del document["fractal_roughness_m"]
    with pytest.raises(InputError, match="fractal_roughness_m"):
        measurement_from_document(document=document)
    (tmp_path / "x.json").write_text("no json")
    with pytest.raises(InputError, match=r"not valid JSON.*; write it with"):
        read_measurement(path=tmp_path / "x.json")
    with pytest.raises(InputError, match=r"there is no such file|directory|cannot be read"):
        read_measurement(path=tmp_path / "none.json")

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
    expected = (1e-9 * np.exp(-0.0587989), 1e-9 * np.exp(0.0587989))
    assert interval["fractal_roughness"] == pytest.approx(expected, rel=1e-5, abs=0.0)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"schema": "x"}, "not a surface measurement"),
        ({"schema_version": 9}, "version 9"),
        ({"refused": "no power law"}, "refused by an earlier release: measure again; no power law"),
        ({"fractal_dimension": 2.4}, "between 1 and 2"),
        ({"fractal_roughness_m": "big"}, "finite number"),
        ({"covariance_of_dimension_and_log_roughness": [[1, 2], [2, 1]]}, "covariance"),
        ({"frequency_ratio": 0.5}, "gamma"),
        ({"profiles": None}, "finite number"),
        ({"estimator": None}, "no text"),
        ({"estimator": ["likelihood"]}, "no text"),
        ({"fractal_dimension": True}, "finite number"),
        ({"fractal_dimension": [1.5]}, "not a list"),
        ({"profiles": 1e400}, "finite number"),
        ({"profiles": 2.5}, "whole number"),
        ({"profiles": 10**400}, "finite number"),
        ({"frequency_ratio": float("nan")}, "finite number"),
        ({"longest_wavelength_m": 1e-9}, "below the longest"),
        ({"covariance_of_dimension_and_log_roughness": [[1, {}], [0, 1]]}, "covariance"),
        ({"covariance_of_dimension_and_log_roughness": [[1, 0.5], [0.2, 1]]}, "covariance"),
        ({"covariance_of_dimension_and_log_roughness": "wide"}, "covariance"),
        ({"covariance_of_dimension_and_log_roughness": [[float("nan"), 0], [0, 1]]}, "covariance"),
        ({"covariance_of_dimension_and_log_roughness": [[1e9, 0], [0, 1e9]]}, "covariance"),
        ({"fractal_roughness_m": 1e308}, "below 1 m"),
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
    with pytest.raises(
        InputError, match=r"not valid JSON.*; expected is the JSON document of a measured surface"
    ):
        read_measurement(path=tmp_path / "x.json")
    with pytest.raises(InputError, match=r"there is no such file|directory|cannot be read"):
        read_measurement(path=tmp_path / "none.json")


def test_nested_and_large_documents_get_one_message(tmp_path):
    file = tmp_path / "deep.json"
    file.write_text("[" * 100_000 + "]" * 100_000)
    with pytest.raises(InputError, match="nested too deeply"):
        read_measurement(path=file)
    file.write_text(json.dumps({"schema": "a" * 2_000_000}))
    with pytest.raises(InputError, match="at most 1000000 bytes"):
        read_measurement(path=file)
    deep = 1.5
    for _ in range(2000):
        deep = [deep]
    document = measurement_document(measurement=measurement())
    for key in ("fractal_dimension", "covariance_of_dimension_and_log_roughness", "source", "schema_version"):
        with pytest.raises(InputError):
            measurement_from_document(document=document | {key: deep})

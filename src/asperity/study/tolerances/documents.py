"""Sensitivities and intervals as plain data, which commands print and the page sends."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np

from asperity.study.datasets import number_or_null
from asperity.study.tolerances.sensitivity import FINISHED_PART
from asperity.types import Document

if TYPE_CHECKING:
    import xarray


#: What the rows of radii are, below a table of sensitivities.
ABOUT_FINISHED_PARTS = (
    "Radii are those of another drive with the same interference, as in joint and sweep; the bore of a ring that "
    "follows from the rollers follows them. Those of finished parts deviate while all other parts stay as they are: "
    "uncertainty and tolerances take deviations so."
)
#: What a tolerance of a radius is, where the preload is made by interference.
TOLERANCES_OF_PARTS = (
    "Radii are those of finished parts: each deviates while all other parts stay as they are, and adds to the "
    "interference."
)


def sensitivity_document(dataset: xarray.Dataset) -> Document:
    """The sensitivities as plain data: derivatives and elasticities by input; what has no value is null."""
    inputs = dataset["input"].values.tolist()
    return {
        "inputs": {
            name: {"value": float(value), "unit": str(unit), "finished_part": name.endswith(FINISHED_PART)}
            for name, value, unit in zip(
                inputs, dataset["value"].values, dataset["input_unit"].values, strict=True
            )
        },
        "results": {
            name: {
                "value": number_or_null(one["result_value"]),
                "unit": str(one["result_unit"].item()),
                "description": str(one["result_name"].item()),
                "derivative": {
                    i: number_or_null(value)
                    for i, value in zip(inputs, one["derivative"].values, strict=True)
                },
                "elasticity": {
                    i: number_or_null(value)
                    for i, value in zip(inputs, one["elasticity"].values, strict=True)
                },
            }
            for name in dataset["result"].values.tolist()
            for one in (dataset.sel(result=name),)
        },
    }


def failures(dataset: xarray.Dataset, called: Mapping[str, str]) -> Iterator[str]:
    """Sentences about the drives that fail: how many, and which of the results, by what they are called, they lack."""
    shares = {name: float(dataset["failed"].sel(result=name)) for name in called}
    for share in dict.fromkeys(share for share in shares.values() if share > 0.0):
        lost = ", ".join(word for name, word in called.items() if shares[name] == share)
        yield (
            f"{100.0 * share:.3g} % of the drives fail and have no {lost}: the quantiles count them as the worst, mean "
            "and standard deviation leave them out"
        )


def uncertainty_document(dataset: xarray.Dataset) -> Document:
    """Intervals and indices as plain data, without the samples; what has no value is null."""
    inputs = dataset["input"].values.tolist()
    indices = ("first_order", "first_order_half_width", "total_order", "total_order_half_width")

    def told(one: xarray.Dataset) -> Document:
        low, median, high = one["quantiles"].values
        return {
            "unit": str(one["unit"].item()),
            "description": str(one["result_name"].item()),
            "nominal": number_or_null(one["nominal"]),
            "failed_share": float(one["failed"]),
            "failing_ends": [
                name for name, end in (("0.025", low), ("0.5", median), ("0.975", high)) if np.isinf(end)
            ],
            "mean": number_or_null(one["mean"]),
            "standard_deviation": number_or_null(one["standard_deviation"]),
            "quantile_0.025": number_or_null(low),
            "median": number_or_null(median),
            "quantile_0.975": number_or_null(high),
            "sobol": {
                name: {key: number_or_null(one[key].values[k]) for key in indices}
                for k, name in enumerate(inputs)
            },
        }

    return {
        "samples": int(dataset.sizes["sample"]),
        "solved": int((dataset["status"] == 0).sum()),
        "seed": int(dataset.attrs["seed"]),
        "inputs": {
            name: {
                "tolerance": float(dataset["tolerance"].values[k]),
                "unit": str(dataset["input_unit"].values[k]),
                "distribution": str(dataset["distribution"].values[k]),
                "finished_part": bool(dataset["finished_part"].values[k]),
            }
            for k, name in enumerate(inputs)
        },
        "results": {name: told(dataset.sel(result=name)) for name in dataset["result"].values.tolist()},
    }

"""From the tolerances of a joint file to intervals of its results, and the contribution of each tolerance.

Monte-Carlo sampling for the intervals; Sobol indices, with a sample of their own, for the shares of the variance.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from asperity.errors import InputError
from asperity.joint.solve import refuse_impossible_joint
from asperity.joint.status import STATUS_NAMES
from asperity.joint_file.any_joint import results_of, sizes_of_parts, with_nominal_sizes
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.part_names import paths_of_track
from asperity.joint_file.quantity_key import FORMS, Distribution
from asperity.joint_file.si_tables import AnyCase, NumericKey, numeric_keys, si_values
from asperity.results import LEVELS, Result, chosen_results
from asperity.study.batch import evaluate_points
from asperity.study.datasets import common_attributes, require, result_rows
from asperity.study.parameters import long_name
from asperity.study.tolerances.sensitivity import refuse_failed
from asperity.types import Document

if TYPE_CHECKING:
    import xarray


#: Results that are followed unless others are asked for, where the drive has them.
DEFAULT_RESULTS = (*(f"{level}_stiffness_output" for level in LEVELS), "slip_ratio")
#: Share of the samples within the stated intervals.
COVERAGE = 0.95
_RESAMPLES = 100
_OPEN = 1e-12  # the ends of the unit interval are at infinity for a normal distribution
_FEWEST = 100
#: Numbers of inputs and results together that are held in memory.
_MOST_NUMBERS = 200_000_000
_LOW_IS_WORSE = ("capacity", "life", "assembly", "bearings")
_HIGH_IS_WORSE = ("losses", "stresses")


def toleranced_inputs(
    case: AnyCase, *, otherwise: Distribution | None
) -> dict[str, tuple[NumericKey, Distribution]]:
    """The numbers of a joint file that have a tolerance, by dotted path, with their distributions or ``otherwise``.

    An ``InputError`` is raised if there is none, or the distribution of one is stated nowhere.
    """
    values = si_values(case)
    toleranced = {
        path: entry
        for path, entry in numeric_keys(case).items()
        if entry.tolerance > 0.0 and path == paths_of_track(values, path)[0]
    }
    if not toleranced:
        raise InputError(
            'the joint file states no tolerances; write them as in sun_radius = "4 mm +- 5 um, uniform"'
        )
    unstated = [path for path, entry in toleranced.items() if entry.distribution is None]
    if unstated and otherwise is None:
        raise InputError(
            f"{', '.join(unstated)}: the file states a tolerance but not its distribution; state one for all of them, "
            f'such as uniform, or write it into the file behind a comma, as in "4 mm +- 5 um, uniform"; distributions '
            f"are {FORMS}",
            options=["distribution"],
        )
    return {path: (entry, entry.distribution or otherwise) for path, entry in toleranced.items()}  # type: ignore[misc]


def quantiles(entry: NumericKey, distribution: Distribution, shares: np.ndarray) -> np.ndarray:
    """Values of a toleranced number below which given shares of it lie."""
    from scipy import stats

    v, t = entry.value, entry.tolerance
    frozen = {
        "uniform": lambda: stats.uniform(v - t, 2.0 * t),
        "triangular": lambda: stats.triang(0.5, v - t, 2.0 * t),
        "normal": lambda: stats.norm(v, distribution.standard_deviation(t)),
    }[distribution.kind]()
    return np.asarray(frozen.ppf(shares))


def uncertainty(
    case: AnyCase,
    *,
    results: Sequence[str] | None = None,
    distribution: Distribution | None = None,
    samples: int = 100_000,
    seed: int = 0,
    block: int | None = None,
    report: Callable[[int, int], Any] | None = None,
) -> xarray.Dataset:
    """Intervals of a joint's results under its tolerances, and each tolerance's share in their variance.

    Parameters
    ----------
    case : Case
        The joint file, with tolerances.
    results : sequence of str, optional
        Results or groups of them; by default those of :data:`DEFAULT_RESULTS` that the drive has.
    distribution : Distribution, optional
        For the tolerances whose distribution the file does not state.
    samples, seed : int, optional
        Monte-Carlo samples, to which about as many are added for the Sobol indices; of the random numbers.
    block : int, optional
        Points after which progress is reported, at most; by default as many as run fastest.
    report : callable, optional
        Called with the number of points done and of all points.

    Returns
    -------
    xarray.Dataset
        Along ``result``: ``nominal``, ``mean``, ``standard_deviation``, ``quantiles`` (at 2.5, 50 and 97.5 %),
        ``first_order`` and ``total_order`` Sobol indices along ``input`` with 95 % confidence half-widths. Along
        ``sample``: the samples themselves and their ``status``. ``failed`` is the share of the samples without a value,
        as of a drive that slips: the quantiles count them as the worst, mean and standard deviation leave them out;
        Sobol indices are nan where any of their samples has no result. A result that is not a quantity, such as the
        contact that slips first, has samples only. An ``InputError`` is raised if the file has no tolerances, a
        distribution is missing, or the joint itself has no result.

    Notes
    -----
    Where the preload is made by interference, a radius is that of a finished part (``finished_part``): it deviates
    while all other parts stay as they are. The inputs scatter independently of each other; a number that stands for
    several parts, such as one friction coefficient for all contacts, scatters as one. Normal distributions are not cut
    off: samples outside the range of a key have no result and are counted.

    References
    ----------
    A. Saltelli et al., Comput. Phys. Commun. 181 (2010) 259; T. Iwanaga, W. Usher and J. Herman,
    Socio-Environ. Syst. Model. 4 (2022) 18155 (SALib).
    """
    values = si_values(case)
    table = results_of(values)
    asked = [name for name in DEFAULT_RESULTS if name in table] if results is None else results
    names, inputs = chosen_results(asked, table=table), toleranced_inputs(case, otherwise=distribution)
    rows = [table[name] for name in names]
    _refuse_samples(samples, sum(len(row.row_names) for row in rows), len(inputs))
    refuse_impossible_joint(with_own_branches(case))
    cube = _cube(len(inputs), samples, seed)
    points = {
        path: quantiles(entry, spread, cube[:, k]) for k, (path, (entry, spread)) in enumerate(inputs.items())
    }
    tables, counted = with_nominal_sizes(values), _counter(report, cube.shape[0])
    codes, found = evaluate_points(tables, points, names, batch=block, report=counted)
    refuse_failed(case, int(codes[0]))
    numbers = np.concatenate([np.atleast_2d(found[name]) for name in names])
    drawn, sizes = np.stack(list(points.values())), sizes_of_parts(values, inputs)
    return _dataset(rows, inputs, sizes, numbers, codes, drawn, samples, seed)


def _refuse_samples(samples: int, results: int, inputs: int) -> None:
    """Refuse samples that are too few for intervals, or too many for the memory."""
    if samples < _FEWEST:
        raise InputError(f"{samples} samples are too few for 95 % intervals; at least {_FEWEST} are needed")
    if samples > (most := _MOST_NUMBERS // (2 * (results + inputs))):
        raise InputError(
            f"{samples} samples of {results} results need too much memory; at most {most} are allowed; "
            "choose fewer samples, or fewer results"
        )


def _cube(inputs: int, samples: int, seed: int) -> np.ndarray:
    """The middle, random points and those for Sobol indices in the unit cube, shape (points, inputs)."""
    base = 1 << max(math.floor(math.log2(samples / (inputs + 2))), 3)
    sampler, problem = require("SALib.sample.sobol"), _problem(inputs)
    design = sampler.sample(problem, base, calc_second_order=False, seed=seed)
    random = np.random.default_rng(seed).uniform(size=(samples, inputs))
    return np.clip(np.concatenate([np.full((1, inputs), 0.5), random, design]), _OPEN, 1.0 - _OPEN)


def _problem(inputs: int) -> Document:
    """The unit cube as SALib takes it."""
    return {"num_vars": inputs, "names": list(map(str, range(inputs))), "bounds": [[0.0, 1.0]] * inputs}


def _counter(report: Callable[[int, int], Any] | None, total: int) -> Callable[[int], None]:
    """Adds up points done, and reports them with their total."""
    done = 0

    def count(points: int) -> None:
        nonlocal done
        done += points
        if report is not None:
            report(done, total)

    return count


def _dataset(
    rows: Sequence[Result],
    inputs: dict[str, tuple[NumericKey, Distribution]],
    sizes: tuple[str, ...],
    numbers: np.ndarray,
    codes: np.ndarray,
    drawn: np.ndarray,
    samples: int,
    seed: int,
) -> xarray.Dataset:
    """Statistics of results, shape (results, points), of the points of :func:`_cube`, which stand for inputs drawn.

    ``sizes`` are the paths of those that are sizes of finished parts.
    """
    mine, one, pair, unit = slice(1, 1 + samples), ("result",), ("result", "input"), "unit"
    sampled, status = numbers[:, mine], codes[mine]
    if (solved := int((status == 0).sum())) < _FEWEST:
        raise InputError(f"only {solved} of {samples} samples have a result: the tolerances are too wide")
    # a category, such as the contact that slips first, has samples, but no mean, no quantiles and no variance
    quantities = np.array([not row.categories for row in rows for _ in row.row_names])
    quantity = np.where(quantities[:, None], numbers, np.nan)
    indices = np.stack([_sobol(row, len(inputs), seed) for row in quantity[:, 1 + samples :]])
    known = [row[~np.isnan(row)] for row in quantity[:, mine]]
    mean, deviation = np.transpose(
        [(row.mean(), row.std(ddof=1)) if row.size > 1 else (np.nan, np.nan) for row in known]
    )
    shares = np.array([0.5 * (1.0 - COVERAGE), 0.5, 0.5 * (1.0 + COVERAGE)])
    ends = [worse_end(row) for row in rows for _ in row.row_names]
    ordered = [quantiles_with_failed(row, shares, worse=end) for row, end in zip(sampled, ends, strict=True)]
    below = "value that this share of all samples is below, those without a value as the worst"
    variables: dict[str, tuple[tuple[str, ...], np.ndarray, str, str]] = {
        "nominal": (one, quantity[:, 0], "result at the stated values", unit),
        "mean": (one, mean, "mean of those with a value", unit),
        "standard_deviation": (one, deviation, "standard deviation of those with a value", unit),
        "quantiles": (("result", "share"), np.where(quantities[:, None], ordered, np.nan), below, unit),
        "failed": (one, np.isnan(sampled).mean(axis=1), "share of the samples without a value", "1"),
        "first_order": (pair, indices[:, 0], "Sobol index of first order", "1"),
        "first_order_half_width": (pair, indices[:, 1], "95 % half-width", "1"),
        "total_order": (pair, indices[:, 2], "Sobol index of total order", "1"),
        "total_order_half_width": (pair, indices[:, 3], "95 % half-width", "1"),
        "status": (("sample",), status, "status", "1"),
        "samples": (("result", "sample"), sampled, "sampled results", unit),
        "sampled_inputs": (("input", "sample"), drawn[:, mine], "sampled inputs", "input_unit"),
    }
    named, keys = result_rows(rows), [entry for entry, _ in inputs.values()]
    made: xarray.Dataset = require("xarray").Dataset(
        {
            name: (dimensions, values, {"long_name": words, "units": of})
            for name, (dimensions, values, words, of) in variables.items()
        },
        coords={
            "result": [name for name, _, _ in named],
            "unit": ("result", [of for _, of, _ in named]),
            "result_name": ("result", [words for _, _, words in named]),
            "categories": ("result", [" ".join(row.categories) for row in rows for _ in row.row_names]),
            "share": shares,
            "input": list(inputs),
            "input_unit": ("input", [entry.key.dimension.si_unit for entry in keys]),
            "input_name": ("input", [long_name(path) for path in inputs]),
            "distribution": ("input", [str(spread) for _, spread in inputs.values()]),
            "tolerance": ("input", [entry.tolerance for entry in keys]),
            "finished_part": ("input", [path in sizes for path in inputs]),
        },
        attrs={
            **common_attributes("uncertainty of a joint"),
            "seed": seed,
            "sobol_samples": numbers.shape[1] - 1 - samples,
        },
    )
    made["status"].attrs["flag_meanings"] = " ".join(STATUS_NAMES)
    return made


def _sobol(row: np.ndarray, inputs: int, seed: int) -> np.ndarray:
    """First and total indices with their half-widths, shape (4, inputs); nan for a result that does not vary."""
    spread = np.ptp(row)
    if not np.isfinite(spread) or spread <= 1e-12 * np.max(np.abs(row)):
        return np.full((4, inputs), np.nan)
    indices = require("SALib.analyze.sobol").analyze(
        _problem(inputs),
        row,
        calc_second_order=False,
        num_resamples=_RESAMPLES,
        conf_level=COVERAGE,
        seed=seed,
    )
    return np.stack([indices[name] for name in ("S1", "S1_conf", "ST", "ST_conf")])


def worse_end(row: Result) -> Literal["low", "high", ""]:
    """Which values of a result are the worse ones; empty where neither are."""
    if row.limit is not None and math.isfinite(row.limit.lowest) != math.isfinite(row.limit.highest):
        return "low" if math.isfinite(row.limit.lowest) else "high"
    if any(word in row.name for word in ("stiffness", "safety", "efficiency")) or row.group in _LOW_IS_WORSE:
        return "low"
    worse = "pressure" in row.name or "drift" in row.name or row.group in _HIGH_IS_WORSE
    return "high" if worse else ""


def quantiles_with_failed(
    values: np.ndarray, shares: np.ndarray, *, worse: Literal["low", "high", ""]
) -> np.ndarray:
    """Values below which given shares of all samples lie, where those without a value (nan) are the worst.

    Infinite, low or high, where so many samples have no value; nan where a quantile may lie anywhere.

    Examples
    --------
    >>> quantiles_with_failed(np.array([1.0, 2.0, 3.0, np.nan]), np.array([0.1, 0.5]), worse="low").tolist()
    [-inf, 1.0]
    """
    known = values[~np.isnan(values)]
    failed = values.size - known.size
    if not failed:
        return np.quantile(known, shares)

    def counted_as(worst: float, method: Literal["lower", "higher"]) -> np.ndarray:
        return np.quantile(np.append(known, np.full(failed, worst)), shares, method=method)

    lowest, highest = counted_as(-math.inf, "lower"), counted_as(math.inf, "higher")
    if worse:
        return lowest if worse == "low" else highest
    widest = np.where(shares < 0.5, lowest, np.where(shares > 0.5, highest, np.nan))
    return np.where(np.isfinite(widest), widest, np.nan)

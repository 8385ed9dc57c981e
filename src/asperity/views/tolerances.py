"""What the numbers of a file do to its results: elasticities, intervals from tolerances, allowed deviations."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.joint_file.si_tables import AnyCase, key_at
from asperity.results import display_unit
from asperity.study.tolerances.documents import ABOUT_FINISHED_PARTS, TOLERANCES_OF_PARTS, failures
from asperity.study.tolerances.sensitivity import FINISHED_PART, path_of_input, ranking
from asperity.types import Document
from asperity.units import from_si
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import NONE, number, percent, quantity, sentence, unit_words, words

if TYPE_CHECKING:
    import xarray

    from asperity.study.tolerances.allowed_deviations import AllowedDeviations

_ROUNDING = 1e-12  # of an elasticity


def elasticities(
    dataset: xarray.Dataset, results: Sequence[str], *, most: int | None = None
) -> Iterator[Block]:
    """Elasticities of some results by the numbers of a file, those of most influence on the first result first.

    ``most``: how many of the numbers are shown; None for all. With one result also its derivative.
    """
    inputs = ranking(dataset, results[0])["input"].values.tolist()
    derivatives = dataset["derivative"].sel(result=list(results))
    without = [path for path in inputs if not np.any(derivatives.sel(input=path).values)]
    shown = [path for path in inputs if path not in without]
    left_out = len(shown) - len(shown[:most])
    of_one = results[0] if len(results) == 1 else ""
    title = f"Elasticities, ordered by those of the {said(dataset, results[0])}"
    heads = [_short(name) for name in results]
    if of_one:
        unit = display_unit(of_one)
        value = from_si(float(dataset["result_value"].sel(result=of_one)), unit)
        title = f"{said(dataset, of_one)}: {number(value, digits=5)} {unit_words(unit)}".rstrip()
        heads = ["elasticity", f"derivative\n{unit_words(unit) or '-'}"]
    rows, sizes = [], []
    for path in shown[:most]:
        key = key_at(path_of_input(path))
        one = dataset.sel(input=path)
        cells = [_elasticity(float(one["elasticity"].sel(result=name))) for name in results]
        if of_one:
            cells.append(
                _derivative(float(one["derivative"].sel(result=of_one)), display_unit(of_one), key.unit)
            )
        rows.append((path, quantity(float(one["value"]), key.unit), *cells))
        sizes.append(float(one["elasticity"].sel(result=results[0])))
    largest = max((abs(size) for size in sizes if not math.isnan(size)), default=0.0)
    shares = [None if math.isnan(size) else size / largest for size in sizes] if largest > 0.0 else []
    yield Table(title, ("number of the file", "value", *heads), rows, shares=shares)
    if any(path.endswith(FINISHED_PART) for path in inputs):
        yield Paragraph(ABOUT_FINISHED_PARTS)
    if left_out:
        yield Paragraph(f"Of the file's {len(inputs)} numbers, the {most} of most influence.")
    if without:
        yield Paragraph(f"No effect: {', '.join(without)}.")


def _elasticity(value: float) -> str:
    """An elasticity with its sign; 0 where it is only what rounding leaves of nothing."""
    if math.isnan(value):
        return NONE
    return "0" if abs(value) < _ROUNDING else f"{'+' if value > 0.0 else ''}{number(value)}"


def _derivative(value: float, unit: str, by: str) -> str:
    """A derivative in these units."""
    per = "" if by == "1" else f" per {unit_words(by)}"
    slope = from_si(value, unit) / from_si(1.0, by)
    return NONE if math.isnan(slope) else f"{number(slope + 0.0, digits=5)}{per}"


def intervals(spread: xarray.Dataset) -> Iterator[Block]:
    """Where 95 % of the drawn joints lie, result by result; shares of categories for what is no quantity."""
    names = spread["result"].values.tolist()
    rows, named = [], []
    for name in names:
        one, unit = spread.sel(result=name), display_unit(name)
        if one["categories"].item():
            named.append(f"{said(spread, name)}: {_categories(spread, name)}.")
            continue
        low, _, high = one["quantiles"].values
        numbers = (one["nominal"], one["mean"], one["standard_deviation"], low, high)
        cells = (_drawn(from_si(float(value), unit)) for value in numbers)
        rows.append((said(spread, name), unit_words(unit), *cells))
    head = ("result", "unit", "as stated", "mean", "standard\ndeviation", "2.5 %", "97.5 %")
    if rows:
        yield Table("95 % of the drawn joints", head, rows, words=(0, 1))
    for text in (*failures(spread, {name: said(spread, name) for name in names}), *named):
        yield Paragraph(sentence(text))
    if bool(spread["finished_part"].any()):
        yield Paragraph(TOLERANCES_OF_PARTS)


def _drawn(value: float) -> str:
    """A number; that of a drive that fails is infinitely bad."""
    return "fails" if math.isinf(value) else number(value, digits=5)


def _categories(spread: xarray.Dataset, name: str) -> str:
    """Words for the share of each category of a result that is not a quantity."""
    categories = str(spread["categories"].sel(result=name).item()).split(" ")
    solved = spread["samples"].sel(result=name).values[spread["status"].values == 0]
    codes, counts = np.unique(solved.astype(int), return_counts=True)
    pairs = sorted(zip(counts.tolist(), codes.tolist(), strict=True), reverse=True)
    return ", ".join(f"{categories[code]} in {100.0 * count / solved.size:.2f} %" for count, code in pairs)


def variance_shares(spread: xarray.Dataset, results: Sequence[str]) -> Iterator[Block]:
    """Sobol indices of every toleranced number, the largest for the first result first.

    Of one result of first and total order with their intervals, of several of total order.
    """
    first = spread["total_order"].sel(result=results[0]).values
    if np.all(np.isnan(first)):
        return
    alone = len(results) == 1
    rows, shares = [], []
    for place in np.argsort(-np.nan_to_num(first), kind="stable"):
        one = spread.isel(input=int(place))
        path = str(one["input"].item())
        if alone:
            pairs = [(one[order], one[f"{order}_half_width"]) for order in ("first_order", "total_order")]
            cells = [
                f"{float(value.sel(result=results[0])):.3f} ± {float(half.sel(result=results[0])):.3f}"
                for value, half in pairs
            ]
        else:
            cells = [number(float(one["total_order"].sel(result=name))) for name in results]
        tolerance = quantity(float(one["tolerance"]), key_at(path).unit, 3)
        rows.append((path, tolerance, str(one["distribution"].item()), *cells))
        shares.append(float(max(first[place], 0.0)))
    title = (
        f"Contributions to the variance of the {said(spread, results[0])} (Sobol indices, ± 95 %)"
        if alone
        else "Shares of the variance, total order"
    )
    heads = ("first order", "total order") if alone else tuple(map(_short, results))
    yield Table(title, ("tolerance", "± value", "distribution", *heads), rows, words=(0, 2), shares=shares)


def unlike_branches(scatter: Document, draws: int) -> Iterator[Block]:
    """Drives whose branches are drawn one by one."""
    rows = []
    for name, label, unit, factor in (
        ("first_slip_Nm", "first branch slips, standing", "N·m", 1.0),
        ("all_slip_Nm", "all branches slip, standing", "N·m", 1.0),
        ("rolling_first_slip_Nm", "first branch slips, rolling", "N·m", 1.0),
        ("largest_share", "largest share of a branch, standing", "%", 100.0),
        ("largest_rolling_share", "largest share of a branch, rolling", "%", 100.0),
        ("sun_force_N", "force on the sun's bearings", "N", 1.0),
    ):
        values = [None] * 3 if scatter[name] is None else scatter[name]
        rows.append((label, unit, *(number(value, factor) for value in values)))
    title = f"{draws} drives with branches of their own sizes"
    yield Table(title, ("", "unit", "2.5 %", "median", "97.5 %"), rows, words=(0, 1))
    alone = scatter["share_without_a_balance"]
    yield Paragraph(
        f"Equal branches pass {number(scatter['equal_branches_Nm'])} N·m; a branch is loose in "
        f"{percent(scatter['share_with_a_loose_branch'])} and slips under the torque of the file in "
        f"{percent(scatter['share_that_slips_under_the_torque'])} of the drives"
        + (f"; {percent(alone)} have no balance." if alone else ".")
    )


def allowed_sizes(allowed: AllowedDeviations, case: AnyCase) -> Iterator[Block]:
    """Which deviations of each size keep the limits that are asked for."""
    rows = [
        (
            f"{size.path}{_part(size.path, case)}",
            quantity(size.diameter, "mm"),
            quantity(size.deviation, "um", 3),
            quantity(4.0 * size.deviation, "um", 3),
            size.grade or "finer than IT01",
            f"{number(size.influence, 100.0, 3)} %/µm",
        )
        for size in allowed.sizes
    ]
    head = ("size", "diameter", "radius ±", "width of diameter", "grade", "influence")
    yield Table("Allowed sizes", head, rows)
    yield Paragraph(
        f"{allowed.kept} of {allowed.samples} drives keep all limits ({percent(allowed.share)} are asked for). Grade: "
        "the coarsest of ISO 286-1 within the width. Influence: share of the margin of a limit that 1 µm of the radius "
        f"uses. {TOLERANCES_OF_PARTS}"
    )
    if allowed.without_influence:
        yield Paragraph(f"No influence: {', '.join(allowed.without_influence)}.")


def _part(path: str, case: Any) -> str:
    """The part that a size belongs to, in parentheses, where its path does not tell."""
    section, *place = path.split(".")
    if section == "contact":
        entry = case.contact[int(place[0]) - 1]
        return f" ({getattr(entry, place[1].removesuffix('_radius'))})"
    return " (bore)" if path == "load.interference" else ""


def _short(name: str) -> str:
    """Head of a narrow column, in lines of a few words."""
    heads = {
        "assembly_stiffness_output": "stiffness,\nassembled",
        "standing_torque_capacity": "standing\ntorque\ncapacity",
        "drive_life": "life",
    }
    return heads.get(name, words(name))


def said(dataset: xarray.Dataset, name: str) -> str:
    """What a result is called for the drive at hand."""
    return str(dataset["result_name"].sel(result=name).item())

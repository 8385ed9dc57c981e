"""What is taken of surfaces that are stated by their Ra or Rz, or measured."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.joint_file import limits
from asperity.joint_file.assumed.described import Described
from asperity.joint_file.drawn_surface import surfaces_by_average
from asperity.joint_file.finish_in_surface import dimension_text
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.si_tables import DEPTH, PARTNER_DEPTH
from asperity.library import read_finishes
from asperity.units import format_quantity

_AVERAGES = ("roughness_average", "partner_roughness_average")


def averages(file: Described) -> Iterator[str]:
    """Surfaces that are stated by their Ra, one after the other."""
    for path, entry in surfaces_by_average(file.case).items():
        if entry.partner_roughness_average is None:
            yield f"no {path}.partner_roughness_average: both bodies have the same Ra"
        for key in _AVERAGES:
            stated = getattr(entry, key)
            if stated is not None and not stated.tolerance > 0.0:
                yield (
                    f"{path}.{key} without a tolerance: as measured over one evaluation length, not the upper "
                    "limit that a drawing states; surfaces below the limit are smoother"
                )
        yield from _finish(path, entry)


def _finish(path: str, entry: SurfaceEntry) -> Iterator[str]:
    """The finish of a surface: that of any where none is stated, and whether its Ra is one that is published."""
    finishes, average, dimension = read_finishes(), entry.roughness_average, entry.fractal_dimension
    assert average is not None
    known = finishes.get(entry.finish or "")
    if known is None:
        if dimension and dimension.text == dimension_text(*finishes.values()):
            yield (
                f"{path}.roughness_average without a finish: D is that of any finish, {dimension.text}; only "
                "the scatter of Ra and the published contact law take it"
            )
    elif not known.roughness_average[0] <= average.value <= known.roughness_average[1]:
        low, high = (format_quantity(bound, "um") for bound in known.roughness_average)
        yield (
            f"{path}.roughness_average {format_quantity(average.value, 'um')} lies outside the {low} to {high} "
            f"that are published for {known.name} surfaces"
        )


def depths(file: Described) -> Iterator[str]:
    """Surfaces that are stated by their Rz."""
    for path, entry in surfaces_by_average(file.case).items():
        for key, of in zip(_AVERAGES, (DEPTH, PARTNER_DEPTH), strict=True):
            average, depth = getattr(entry, key), getattr(entry, of)
            if depth is None or average is None:
                continue
            low, high = (average.value + sign * average.tolerance for sign in (-1.0, 1.0))
            yield (
                f"{path}.{of}: Rz {depth} taken of normally distributed heights, Ra "
                f"{format_quantity(low, 'um', 2)} to {format_quantity(high, 'um', 2)}; a single scratch raises Rz, and "
                "the surface is then smoother than computed"
            )
            if limits.MEAN_ROUGHNESS_DEPTH.read(depth).tolerance == 0.0:
                yield (
                    f"{path}.{of} without a tolerance: as measured over one evaluation length, not the "
                    "upper limit that a drawing states; surfaces below the limit are smoother"
                )


def measured(file: Described) -> Iterator[str]:
    """What is taken of a measured surface."""
    if file.case.measured is not None:
        yield from file.case.measured.assumed

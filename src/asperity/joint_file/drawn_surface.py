"""Surfaces of a joint file that are measured, or known by their Ra: D and G, and how far they let results range."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.contact.laws.registry import LAWS
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.joint.evaluation import JointResult
from asperity.joint.surface_interval import over_surfaces, result_ends
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import contacts_of
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.section_build import alike, rms_height_of_average, surface_of
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.surface.roughness_average import CUT_OFFS_EVALUATED, scatter_of_average, standard_cut_off
from asperity.types import Document
from asperity.units import format_quantity

if TYPE_CHECKING:
    from asperity.surface.measurement import SurfaceMeasurement

#: Path of a surface → lower end, middle and upper end of the rms of its heights [m].
Ends = dict[str, tuple[float, float, float]]
#: Values of D between the ends of its range, and of Ra between the ends of its scatter.
DIMENSIONS, AVERAGES = 15, 5
_AVERAGE, _PARTNER = "roughness_average", "partner_roughness_average"
_NORMAL_95 = 1.959963984540054


def surfaces_by_average(case: Case) -> dict[str, SurfaceEntry]:
    """The surfaces of a joint file that are stated by their Ra."""
    return {path: entry for path, entry in surface_entries(case) if entry.roughness_average is not None}


def surface_entries(case: Case) -> Iterator[tuple[str, SurfaceEntry]]:
    """Path of every surface of a joint file, and the surface."""
    if isinstance(case.surface, SurfaceEntry):
        yield "surface", case.surface
    else:
        yield from ((f"surface.{name}", entry) for name, entry in dict(case.surface).items())


def drawn_interval(case: Case) -> Document | None:
    """Intervals of stiffness and drift over what the Ra of a drawing leaves open.

    As :func:`asperity.joint.measured_surface.stiffness_interval`, with the smallest and the largest value in place of
    percentiles; ``surfaces``: path → the ranges of D and Ra; and ``words``, the same in sentences. None where no
    surface is stated by its Ra or by its rms_height. With a contact law of the rms of the heights the ends hold its
    own error, ``over_boundary_elements``.

    D runs over its tolerance in the file, which a finish fills in, and Ra over its own; an Ra without a tolerance is
    taken for the measurement over one evaluation length of five cut-offs, which scatters by about 10 %; likewise that
    of a partner. All bodies of all contacts move together. The contact law and the filter's cut-off stay.
    """
    law = LAWS[case.contact_law()]
    if "rms_height" in law.needs:
        heights, (low, high) = _ends_of_heights(case), law.over_boundary_elements
        return interval_of_heights(case, heights, dict.fromkeys(heights, (low, 1.0, high)))
    entries = surfaces_by_average(case)
    if not entries:
        return None
    across, along = np.meshgrid(np.linspace(-1.0, 1.0, DIMENSIONS), np.linspace(-1.0, 1.0, AVERAGES))
    changes: Document = {}
    surfaces = {}
    for path, entry in entries.items():
        average, stated = entry.roughness_average, entry.fractal_dimension
        assert average is not None
        assert stated is not None
        dimension = stated.value + stated.tolerance * across.ravel()
        averages = {
            key: of_body.value + _half_width(of_body, dimension) * along.ravel()
            for key in (_AVERAGE, _PARTNER)
            if (of_body := getattr(entry, key)) is not None
        }
        cut_off = entry.cut_off.value if entry.cut_off else standard_cut_off(roughness_average=average.value)
        changes[f"{path}.fractal_dimension"] = dimension
        changes |= {f"{path}.{key}": values for key, values in averages.items()}
        changes[f"{path}.cut_off"] = cut_off
        surfaces[path] = {
            "finish": entry.finish,
            "fractal_dimension": [float(dimension.min()), float(dimension.max())],
            **{f"{key}_m": [float(values.min()), float(values.max())] for key, values in averages.items()},
            "cut_off_m": float(cut_off),
        }
    values, shape = replace_values(si_values(case), changes), across.ravel().shape
    result = over_surfaces(joint_from_case(case), joint_from_values(values).surfaces, shape=shape)
    interval = {
        "states": DIMENSIONS * AVERAGES,
        **result_ends(result, shape=shape, percentiles=(0.0, 100.0), least_usable=1.0),
        "surfaces": surfaces,
    }
    return {
        **interval,
        "title": "Interval over what the Ra of the surfaces leaves open",
        "words": _words(interval),
    }


def _ends_of_heights(case: Case) -> Ends:
    """Lower end, middle and upper end of the rms of the heights of every surface [m]."""
    ends: Ends = {}
    for path, entry in surface_entries(case):
        values = si_values(entry)
        if entry.rms_height is not None:
            middle, half = entry.rms_height.value, entry.rms_height.tolerance
            ends[path] = (middle - half, middle, middle + half)
        else:
            stated = entry.fractal_dimension
            assert stated is not None
            dimension = stated.value + stated.tolerance * np.array([-1.0, 0.0, 1.0])
            averages = {
                key: of_body.value
                + float(np.max(_half_width(of_body, dimension))) * np.array([-1.0, 0.0, 1.0])
                for key in (_AVERAGE, _PARTNER)
                if (of_body := getattr(entry, key)) is not None
            }
            low, middle, high = (float(height) for height in rms_height_of_average(values | averages))
            ends[path] = (low, middle, high)
    return ends


def interval_of_heights(
    case: Case,
    heights: Ends,
    ratios: Ends,
    form: dict[str, float] | None = None,
    run_in: dict[str, float] | None = None,
) -> Document:
    """Intervals of stiffness and drift by a law of heights or of a decay length, from its error and the heights' own.

    ``heights``: path of a surface → lower end, middle and upper end of the rms of its heights [m]; ``ratios`` the same
    of the decay length over them [-], of which a law of the heights needs only the ratios to the middle; ``form``:
    contact → what the soft end has beside them [m]; ``run_in``: contact → how much stiffer its asperities are after
    running in, for ``run_in``, the joint with the middle of the heights.

    As :func:`drawn_interval`, the ends of both errors together;
    ``parts`` has those of each alone, ``contact_law``, with the form, and ``rms_height``; ``contacts`` has K_n and K_t
    of the asperities; ``surfaces``: path → the heights or decay lengths that are as soft as both ends.
    """
    names, law_of_case = contacts_of(si_values(case)), LAWS[case.contact_law()]
    key = "decay_length" if "decay_length" in law_of_case.needs else "rms_height"
    surfaces, shown = {}, {}
    paths, entries = zip(*surface_entries(case), strict=True)
    stated = dict(zip(paths, alike(map(si_values, entries)), strict=True))
    for path, (low, middle, high) in heights.items():
        least, here, most = ratios[path]
        name = path.removeprefix("surface.")
        height = np.array([low, high, middle, middle, low, high])
        softer = np.array([least, most, least, most, here, here]) / here
        softer[1:4:2] += (form or {}).get(name, 0.0) / (here * height[1:4:2])
        if run_in is not None:
            height, softer = np.append(height, middle), np.append(softer, 1.0 / run_in[name])
        numbers = here * height if key == "decay_length" else height
        surface = surface_of(
            stated[path] | {key: xp.asarray(numbers)},
            asperity_base=case.model.asperity_base,
            contact_law=law_of_case.name,
        )
        surfaces[path] = surface.softer(xp.asarray(softer))
        shown[path] = (numbers * softer)[:2]
    result = over_surfaces(
        joint_from_case(case),
        tuple(surfaces[path] for path in (f"surface.{name}" for name in names) if path in surfaces)
        or tuple(surfaces.values()),
        shape=(6 if run_in is None else 7,),
    )
    both, law, roughness = (
        result_ends(
            trees.map(lambda leaf, k=k: leaf[k : k + 2], result),
            shape=(2,),
            percentiles=(0.0, 100.0),
            least_usable=1.0,
        )
        for k in (0, 2, 4)
    )
    told = [
        f"{path.removeprefix('surface.')} {middle} ({low} to {high})"
        for path, ends in heights.items()
        for low, middle, high in [[format_quantity(end, "um", 3) for end in ends]]
    ]
    return {
        "states": 2,
        **both,
        "parts": {"contact_law": law, "rms_height": roughness},
        "contacts": _asperity_ends(result, names),
        **({} if run_in is None else {"run_in": _state(trees.map(lambda leaf: leaf[6], result))}),
        **({} if form is None else {"form_decay_length_m": form}),
        "surfaces": {path: {f"{key}_m": ends.tolist()} for path, ends in shown.items()},
        "title": "Interval of the contact law, and of the rms of the heights",
        "words": f"Of the assembled stiffness {_ends_in_words(law)} by the error of the law alone, "
        f"{_ends_in_words(roughness)} by that of the heights alone. The rms of the heights: {', '.join(told)}. "
        f"{law_of_case.error} All other values are those of the file.",
    }


def _asperity_ends(result: JointResult, names: tuple[str, ...]) -> Document:
    """Ends of K_n and K_t of the asperities of each contact [N/m], by both errors and by each alone."""
    stiffness = {
        "normal": np.asarray(result.contacts.normal_stiffness),
        "tangential": np.asarray(result.contacts.tangential_stiffness),
    }
    return {
        name: {
            f"asperity_{direction}_stiffness_N_per_m": {
                part: sorted(float(end) for end in values[k : k + 2, number])
                for part, k in (("both", 0), ("contact_law", 2), ("rms_height", 4))
            }
            for direction, values in stiffness.items()
        }
        for number, name in enumerate(names)
    }


def _state(result: JointResult) -> Document:
    """Stiffness at every level of the model at the output, and drift, of one surface; None where there is none."""

    def number(value: Any) -> float | None:
        usable = bool(result.solved) and bool(result.contact_law_holds) and bool(np.isfinite(value))
        return float(value) if usable else None

    return {
        "published_Nm_per_rad": number(result.published.output),
        "series_with_bulk_Nm_per_rad": number(result.series_with_bulk.output),
        "assembly_Nm_per_rad": number(result.assembly.stiffness.output),
        "drift_rad_per_output_turn": number(result.rolling.drift_per_output_turn),
    }


def _ends_in_words(interval: Document) -> str:
    low, high = (interval["assembly"][f"{end}_Nm_per_rad"] for end in ("low", "high"))
    if low is None:
        return "no value"
    return " to ".join(f"{end:.4g}" if end < 9999.5 else f"{end:.0f}" for end in (low, high)) + " N·m/rad"


def _words(interval: Document) -> str:
    """The ranges of D and Ra over which an interval is taken."""
    told = []
    for path, entry in interval["surfaces"].items():
        low, high = entry["fractal_dimension"]
        ranges = [
            " to ".join(format_quantity(end, "µm", 3) for end in entry[f"{key}_m"])
            for key in (_AVERAGE, _PARTNER)
            if f"{key}_m" in entry
        ]
        bodies = "Ra of a body from " if len(ranges) == 1 else "Ra of both bodies from "
        finish = f" ({entry['finish']})" if entry["finish"] else ""
        told.append(
            f"{path}{finish}: D from {low:.4g} to {high:.4g}, {bodies}{' and '.join(ranges)} at the cut-off "
            f"{format_quantity(entry['cut_off_m'], 'mm')}."
        )
    lost = interval["unsolved"] + interval["all_plastic"]
    if lost:
        told.append(f"{lost} of {interval['states']} states have no solution or no stiffness: no interval.")
    return " ".join([*told, "All other values are those of the middle."])


def _half_width(average: Quantity, dimension: np.ndarray) -> Any:
    """Half-width of Ra [m]: its tolerance, or the scatter of one evaluation length for each D."""
    if average.tolerance > 0.0:
        return average.tolerance
    scatter = [scatter_of_average(fractal_dimension=d, cut_offs=CUT_OFFS_EVALUATED) for d in dimension]
    return average.value * _NORMAL_95 * np.array(scatter)


def with_measured_surface(case: Case, measurement: SurfaceMeasurement) -> Case:
    """The joint file with the measured D, G and gamma at every contact.

    An ``InputError`` is raised if they are outside what a joint file allows.
    """
    entry = {
        "fractal_dimension": float(measurement.fractal_dimension),
        "fractal_roughness": f"{float(measurement.fractal_roughness)!r} m",
        "frequency_ratio": float(measurement.frequency_ratio),
    }
    return case.model_copy(update={"surface": SurfaceEntry.model_validate(entry)}).with_text("")

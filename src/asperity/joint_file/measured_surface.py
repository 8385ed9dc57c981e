"""A joint file with a measured surface: D and G, or the rms of the heights that each of its contacts feels."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from asperity.errors import InputError
from asperity.joint.description import Joint
from asperity.joint.measured_surface import stiffness_interval
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.drawn_surface import Ends, interval_of_heights, with_measured_surface
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import contacts_of
from asperity.joint_file.section_build import entries
from asperity.joint_file.si_tables import si_values
from asperity.materials import pair
from asperity.surface.height_spectrum import HeightSpectrum
from asperity.surface.measured_roughness import MeasuredRoughness, roughness_document
from asperity.units import format_quantity

#: The rms of the heights changes the width of the contacts by less than this share of it changes: the search ends.
_SETTLED = 1e-3
_MOST_PASSES = 6
_NORMAL_95 = 1.959963984540054


class MeasuredCase(NamedTuple):
    """A joint file with a measured surface.

    Parameters
    ----------
    case : Case
        The joint file, its surfaces in terms of its contact law.
    measured : MeasuredRoughness
        What was measured.
    assumed : tuple of str
        What was taken of the measurement, one sentence each.
    heights : dict of str to tuple, or None
        Path of a surface → lower end, middle and upper end of the rms of its heights [m], 95 % of measurements; None
        where D and G went in.
    ratios : dict of str to tuple, or None
        Path of a surface → decay length over these heights by boundary elements [-]: lower end, capped at the hardness;
        elastic; and upper end of the latter; None by another law.
    """

    case: Case
    measured: MeasuredRoughness
    assumed: tuple[str, ...]
    heights: Ends | None
    ratios: Ends | None = None

    def document(self, joint: Joint) -> dict[str, Any]:
        """What the measurement adds to the document of the solved joint."""
        return {
            "measured_surface": roughness_document(self.measured),
            "stiffness_interval": self.interval(joint),
        }

    def interval(self, joint: Joint) -> dict[str, Any]:
        """Intervals of stiffness and drift: from the law and the heights, or from the scatter of D and G."""
        if self.heights is not None:
            return interval_of_heights(self.case, self.heights, self.ratios)
        assert self.measured.fractal is not None
        return stiffness_interval(joint, self.measured.fractal)


class _Felt(NamedTuple):
    """What a contact feels of a measured surface."""

    rms_height: float
    deviation: float  #: standard deviation of its logarithm
    width: float
    axial: tuple[float, ...]  #: longest waves along the axis, for each body
    longest: float  #: share of the mean square in waves longer than half of the longest one
    squares: tuple[float, ...]  #: mean square of the heights of each body


class _Solved(NamedTuple):
    """A joint and its contacts, shape (contacts,)."""

    joint: Joint
    widths: Any  #: [m]
    peaks: Any  #: Hertzian pressures [Pa]


class _Pressed(NamedTuple):
    """What boundary elements tell of a contact."""

    pressure: float  #: mean pressure [Pa]
    ratios: tuple[
        float, float, float
    ]  #: decay length over the rms of the heights: capped, elastic, upper end
    outside: bool  #: whether the boundary elements do not have the pressure
    hardness: float  #: of the softer body [Pa]
    taken: float  #: hardness of the capped boundary elements on these bodies [Pa]


def case_with_surface(case: Case, measured: MeasuredRoughness) -> MeasuredCase:
    """The joint file with its surfaces replaced by a measured one, at every contact.

    Parameters
    ----------
    case : Case
        A joint file.
    measured : MeasuredRoughness
        What was measured: the roughness of both bodies together.

    Returns
    -------
    MeasuredCase
        With ``model.contact_law = "zou_2025"`` the measured D, G and gamma. Otherwise, by the exponential law, the rms
        of the heights that each contact feels: of all waves but those longer than its Hertzian width in the rolling
        direction and, along the rollers' axis, longer than its contact line or the cut-off of ISO 4288. With
        ``"measured"`` the decay length, which is not 0.48 of these heights but what boundary elements on the map
        have at the mean pressure of the contact.

    Raises
    ------
    InputError
        If the measurement does not have what the law needs, a profile states no lay, or the joint cannot be solved.
    """
    law = case.model.contact_law
    if law == "measured":
        _refuse_without_elements(measured)
    if law == "zou_2025" or not measured.spectra:
        if measured.fractal is None or law == "exponential":
            raise InputError(_lacks(measured, law))
        old = "measured surface: a document of an earlier release, without a spectrum; its D and G go in"
        return MeasuredCase(
            with_measured_surface(case, measured.fractal), measured, () if measured.spectra else (old,), None
        )
    for spectrum in measured.spectra:
        if not spectrum.is_map and spectrum.lay is None:
            raise InputError(_without_lay(spectrum, measured))
    by_heights = case if law != "measured" else _by_law(case, "exponential")
    felt, solved = _settled(by_heights, measured.spectra)
    heights = {
        f"surface.{name}": (
            contact.rms_height * math.exp(-_NORMAL_95 * contact.deviation),
            contact.rms_height,
            contact.rms_height * math.exp(_NORMAL_95 * contact.deviation),
        )
        for name, contact in felt.items()
    }
    told = tuple(_assumed(measured, felt))
    if law != "measured":
        return MeasuredCase(_with_heights(case, felt), measured, told, heights)
    pressed = _pressed(measured.spectra, felt, solved)
    lengths = {
        name: {"decay_length": f"{pressed[name].ratios[1] * contact.rms_height!r} m"}
        for name, contact in felt.items()
    }
    return MeasuredCase(
        _with_surfaces(case, lengths),
        measured,
        (*told, *_assumed_of_elements(felt, pressed)),
        heights,
        {f"surface.{name}": contact.ratios for name, contact in pressed.items()},
    )


def _refuse_without_elements(measured: MeasuredRoughness) -> None:
    """Refuse surfaces that were not pressed by boundary elements."""
    for spectrum in measured.spectra:
        if not spectrum.is_map:
            raise InputError(
                f'{spectrum.source}: a profile; model.contact_law = "measured" needs a map of the surface. Leave '
                "contact_law out: the exponential law takes the spectrum of the profile"
            )
    if not measured.spectra or any(spectrum.pressed is None for spectrum in measured.spectra):
        raise InputError(
            f'{measured.source}: a measurement without boundary elements, which model.contact_law = "measured" takes: '
            'measure the map again with a hardness, such as "7 GPa", that of the softer body'
        )


def _by_law(case: Case, law: Any) -> Case:
    return case.model_copy(update={"model": case.model.model_copy(update={"contact_law": law})})


def _pressed(
    spectra: tuple[HeightSpectrum, ...], felt: dict[str, _Felt], solved: _Solved
) -> dict[str, _Pressed]:
    """What boundary elements on the maps tell of every contact at its mean pressure, where it is widest."""
    made, joint = {}, solved.joint
    bodies = {body.name: material for body, material in zip(joint.drive.bodies, joint.materials, strict=True)}
    for contact, (name, one), peak in zip(joint.drive.contacts, felt.items(), solved.peaks, strict=True):
        for spectrum in spectra:
            if one.width > spectrum.rolling_length:
                raise InputError(
                    f"{spectrum.source}: {format_quantity(spectrum.rolling_length, 'mm', 3)} in the rolling "
                    f"direction, less than the contact {name} is wide, {format_quantity(one.width, 'mm', 3)}: "
                    'measure a larger map, or leave model.contact_law = "measured" out'
                )
        moduli = pair(bodies[contact.first], bodies[contact.second])
        modulus = float(moduli.contact_modulus)
        pressure = 0.25 * math.pi * float(peak)
        (elastic, wide), (capped, deep) = (
            _decay_ratio(spectra, one.squares, pressure / modulus, capped=capped) for capped in (False, True)
        )
        ends = [
            spectrum.pressed.range(capped=capped)
            for spectrum in spectra
            if spectrum.pressed is not None
            for capped in (False, True)
        ]
        made[name] = _Pressed(
            pressure,
            (capped * math.exp(-deep), elastic, elastic * math.exp(wide)),
            not all(low <= pressure / modulus <= high for low, high in ends),
            float(moduli.hardness),
            min(spectrum.pressed.hardness * modulus for spectrum in spectra if spectrum.pressed),
        )
    return made


def _decay_ratio(
    spectra: tuple[HeightSpectrum, ...], squares: tuple[float, ...], pressure: float, *, capped: bool
) -> tuple[float, float]:
    """Decay length over the rms of the heights, and the half-width of its logarithm; squares of bodies add."""
    parts, errors = [], []
    for spectrum, square in zip(spectra, squares, strict=True):
        assert spectrum.pressed is not None
        ratio, error = spectrum.pressed.decay_ratio(pressure=pressure, capped=capped)
        parts.append(ratio**2 * square)
        errors.append(parts[-1] * error)
    return math.sqrt(sum(parts) / sum(squares)), math.hypot(*errors) / sum(parts)


def _assumed_of_elements(felt: dict[str, _Felt], pressed: dict[str, _Pressed]) -> list[str]:
    """What was taken of boundary elements."""
    parts = [
        f"{name} {format_quantity(one.ratios[1] * felt[name].rms_height, 'um', 3)} ({one.ratios[1]:.3f} of the "
        f"heights, at {format_quantity(one.pressure, 'MPa', 3)})"
        for name, one in pressed.items()
    ]
    told = [
        "contact law measured: the decay length over the rms of the heights is that of elastic boundary elements on "
        "patches of the map under the mean pressure of each contact, at the torque of the file; it stays at other "
        f"torques: {'; '.join(parts)}"
    ]
    outside = [name for name, one in pressed.items() if one.outside]
    if outside:
        told.append(
            f"contact law measured: the pressure of {', '.join(outside)} is outside of what boundary elements have "
            "for this map; the decay length is that of the nearest pressure"
        )
    other = [name for name, one in pressed.items() if abs(one.taken - one.hardness) > 0.1 * one.hardness]
    if other:
        hardest = "; ".join(f"{name} {format_quantity(pressed[name].hardness, 'GPa', 3)}" for name in other)
        told.append(
            "contact law measured: the stiff end of the interval is that of boundary elements with the hardness "
            f"{format_quantity(pressed[other[0]].taken, 'GPa', 3)} of the measurement, while the softer body has: "
            f"{hardest}"
        )
    return told


def _lacks(measured: MeasuredRoughness, law: str | None) -> str:
    """Why a measurement does not serve a law."""
    if measured.spectra:
        return (
            f'model.contact_law = "zou_2025" needs D and G, which {measured.source} does not have '
            f"({measured.no_power_law}); leave contact_law out: the exponential law takes the measured spectrum"
        )
    if law == "exponential":
        return (
            f'{measured.source}: a document without a spectrum; model.contact_law = "exponential" needs one: measure '
            "the surface again with this release, in 16 points or more"
        )
    return f"{measured.source}: neither a power law nor a spectrum; measure it in 16 points or more"


def _without_lay(spectrum: HeightSpectrum, measured: MeasuredRoughness) -> str:
    """What to do about a profile whose lay is not known."""
    remedy = (
        ""
        if measured.fractal is None
        else '; or state model.contact_law = "zou_2025", which takes the measured D and G whatever the lay'
    )
    return (
        f"{spectrum.source}: a profile tells nothing of the waves along its grooves: measure it again with --lay: "
        "rolling (grooves in the rolling direction, measured along the rollers' axis), axis (grooves along the axis, "
        f"measured in the rolling direction) or isotropic (no grooves){remedy}"
    )


def _settled(case: Case, spectra: tuple[HeightSpectrum, ...]) -> tuple[dict[str, _Felt], _Solved]:
    """What each contact feels at the width that it has in the joint with these surfaces, and that joint."""
    names = contacts_of(si_values(case))
    lengths = entries(si_values(case)["drive"]["contact_length"], names)
    lengths = lengths * len(names) if len(lengths) == 1 else lengths

    def at(widths: Any) -> dict[str, _Felt]:
        return {
            name: _felt(spectra, width=float(width), length=float(length))
            for name, width, length in zip(names, widths, lengths, strict=True)
        }

    felt = at([math.inf] * len(names))
    settles = not any(spectrum.needs_width for spectrum in spectra)
    for _ in range(_MOST_PASSES):
        solved = _solved(_with_heights(case, felt))
        before, felt = felt, at(solved.widths)
        if settles or all(
            abs(felt[name].rms_height - before[name].rms_height) <= _SETTLED * felt[name].rms_height
            for name in names
        ):
            return felt, solved
    raise InputError(
        "the heights that the contacts feel and the widths of the contacts do not settle: state surface.rms_height"
    )


def _solved(case: Case) -> _Solved:
    """Hertzian widths and pressures of the contacts of a joint, crowned ones where they are widest."""
    joint = joint_from_case(case)
    diagnostics = solve_joint(joint).result.diagnostics
    return _Solved(
        joint, 2.0 * np.asarray(diagnostics.hertz_half_width), np.asarray(diagnostics.hertz_pressure)
    )


def _with_heights(case: Case, felt: dict[str, _Felt]) -> Case:
    return _with_surfaces(
        case, {name: {"rms_height": f"{contact.rms_height!r} m"} for name, contact in felt.items()}
    )


def _with_surfaces(case: Case, lengths: dict[str, dict[str, str]]) -> Case:
    surface = {name: SurfaceEntry.model_validate(entry) for name, entry in lengths.items()}
    return case.model_copy(update={"surface": surface}).with_text("")


def _felt(spectra: tuple[HeightSpectrum, ...], *, width: float, length: float) -> _Felt:
    """The waves of all bodies that a contact of a width and a length feels [m]."""
    rolling, axial = 1.0 / width if width > 0.0 else math.inf, []
    square = variance = long = 0.0
    squares = []
    for spectrum in spectra:
        limit = min(length, spectrum.cut_off())
        one, deviation = spectrum.felt(rolling=rolling, axial=1.0 / limit)
        longest = min(limit, spectrum.longest_wave)
        short, _ = spectrum.felt(rolling=max(rolling, 2.0 / longest), axial=2.0 / longest)
        square, variance, long = square + one, variance + deviation**2, long + one - short
        axial.append(limit)
        squares.append(one)
    if not square > 0.0:
        sources = " + ".join(spectrum.source for spectrum in spectra)
        raise InputError(
            f"{sources}: all heights are equal, there is no roughness of which a contact law knows"
        )
    return _Felt(
        math.sqrt(square),
        0.5 * math.sqrt(variance) / square,
        width,
        tuple(axial),
        long / square,
        tuple(squares),
    )


def _assumed(measured: MeasuredRoughness, felt: dict[str, _Felt]) -> list[str]:
    """What was taken of a measurement."""
    power = "" if measured.fractal is not None else f"; {measured.no_power_law}"
    told = [f"measured surface {measured.source}: the joint uses the measured spectrum{power}"]
    parts = []
    for name, contact in felt.items():
        limits = " and ".join(format_quantity(limit, "mm", 3) for limit in contact.axial)
        height, width = format_quantity(contact.rms_height, "um", 3), format_quantity(contact.width, "mm", 3)
        parts.append(f"{name} {height} (2b {width}, along the axis {limits})")
    told.append(
        "measured surface: the rms of the heights of all waves but those that are longer than the Hertzian width 2b of "
        "the contact, under the torque of the file, in the rolling direction and, along the axis, longer than its "
        f"contact line or than the cut-off of ISO 4288 for the Ra of the surface: {'; '.join(parts)}"
    )
    for number, spectrum in enumerate(measured.spectra):
        if spectrum.lay is not None:
            told.append(f"{spectrum.source}: a profile across its lay, which is stated as {spectrum.lay}")
        if any(spectrum.longest_wave < contact.axial[number] for contact in felt.values()):
            size = format_quantity(spectrum.longest_wave, "mm", 3)
            told.append(
                f"{spectrum.source}: nothing is known of waves longer than {size}, its size; if there are any that "
                "count, the contacts are softer"
            )
    share = max(contact.longest for contact in felt.values())
    if share > 0.5:
        told.append(
            f"measured surface: {100.0 * share:.0f} % of the mean square of the heights lie in the longest octave of "
            "waves that counts: there is no roll-off, and the result depends on where the waves are cut off"
        )
    return told

"""What the contacts of a joint feel of a measured surface: the rms of the heights, at the width that each has."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from asperity.contact.felt_contacts import Felt, FeltContacts
from asperity.errors import InputError
from asperity.joint.description import Joint
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import contacts_of
from asperity.joint_file.section_build import entries
from asperity.joint_file.si_tables import Values, si_values
from asperity.materials import ContactPair, pair
from asperity.surface.height_spectrum import HeightSpectrum, lowest_frequency
from asperity.surface.lay import DIRECTIONS, felt_rolling_share
from asperity.surface.measured_roughness import MeasuredRoughness
from asperity.units import format_quantity

Heights = NDArray[np.float64]
#: Key of a surface → its numbers at all contacts, shape (contacts, points).
Numbers = Mapping[str, Heights]
#: Keys of what contacts feel of a measured surface.
HEIGHT, SHARE = "rms_height", "rolling_share"

#: Heights are settled that change by less than this share with the widths that they make.
_SETTLED = 1e-9
_MOST_PASSES = 12


def felt_contacts(case: Case, spectra: tuple[HeightSpectrum, ...]) -> FeltContacts:
    """What each contact feels at the width that it has in the joint with these surfaces."""
    names, lengths = contacts_of(si_values(case)), contact_lengths(si_values(case))
    solved: list[tuple[Joint, Any]] = []

    def widths_of(numbers: Numbers) -> Heights:
        joint = joint_from_case(
            with_numbers_of(
                case, {key: dict(zip(names, felt[:, 0], strict=True)) for key, felt in numbers.items()}
            )
        )
        solved.append((joint, solve_joint(joint).result.diagnostics))
        return 2.0 * np.asarray(solved[-1][1].hertz_half_width)[:, None]

    _, settled = settled_heights(spectra, lengths, widths_of)
    if not settled.all():
        raise InputError(
            "the heights that the contacts feel and the widths of the contacts do not settle: state surface.rms_height"
        )
    joint, diagnostics = solved[-1]
    felt = felt_by(spectra, names, 2.0 * np.asarray(diagnostics.hertz_half_width), lengths[:, 0])
    return FeltContacts(felt, 0.25 * math.pi * np.asarray(diagnostics.hertz_pressure), moduli_of(joint))


def settled_heights(
    spectra: tuple[HeightSpectrum, ...], lengths: Heights, widths_of: Callable[[Numbers], Heights]
) -> tuple[Numbers, NDArray[np.bool_]]:
    """What each contact feels at the width which it has with that, and where it settles: :func:`felt_numbers`.

    ``lengths`` of the contact lines and the widths that numbers make, shape (contacts, points) [m]; widths are nan
    where a joint has no solution: its numbers stay.
    """
    numbers = felt_numbers(spectra, np.full(lengths.shape, math.inf), lengths)
    settled = np.zeros(lengths.shape[1], dtype=bool)
    for _ in range(_MOST_PASSES):
        widths = widths_of(numbers)
        stay = settled | ~np.all(np.isfinite(widths) & (widths > 0.0), axis=0)
        before, found = numbers, felt_numbers(spectra, np.where(stay, 1.0, widths), lengths)
        numbers = {key: np.where(stay, before[key], felt) for key, felt in found.items()}
        close = [np.abs(felt - before[key]) <= _SETTLED * felt for key, felt in numbers.items()]
        settled |= np.all(close, axis=(0, 1))
        if settled.all():
            break
    return numbers, settled


def contact_lengths(values: Values) -> Heights:
    """Lengths of the contact lines of tables in SI units, shape (contacts, points) [m]."""
    names = contacts_of(values)
    lengths = entries(values["drive"]["contact_length"], names)
    return np.stack(np.broadcast_arrays(*map(np.atleast_1d, lengths * (len(names) // len(lengths)))))


def moduli_of(joint: Joint) -> tuple[ContactPair, ...]:
    """Moduli and hardness of the two bodies of each contact."""
    bodies = {body.name: material for body, material in zip(joint.drive.bodies, joint.materials, strict=True)}
    return tuple(pair(bodies[contact.first], bodies[contact.second]) for contact in joint.drive.contacts)


def with_numbers_of(case: Case, numbers: Mapping[str, Mapping[str, float]]) -> Case:
    """The joint file with numbers of the surface of each contact: key → contact → number in SI units."""
    units = {key: "" if key == SHARE else " m" for key in numbers}
    names = next(iter(numbers.values()))
    try:
        surface = {
            name: SurfaceEntry.model_validate(
                {key: f"{float(each[name])!r}{units[key]}" for key, each in numbers.items()}
            )
            for name in names
        }
    except ValidationError as error:
        (problem, *_) = error.errors()
        said = f"{problem['loc'][0]}: {problem['msg'].removeprefix('Value error, ')}"
        raise InputError(
            f"the measured surface makes {said}; check the units of the measured heights"
        ) from None
    return case.model_copy(update={"surface": surface}).with_text("")


def felt_at(spectra: tuple[HeightSpectrum, ...], widths: Heights, lengths: Heights) -> Heights:
    """The rms of the heights that contacts of these widths and lengths feel [m]."""
    squares = [
        spectrum.squares(rolling=1.0 / widths, axial=1.0 / np.minimum(lengths, spectrum.cut_off()))
        for spectrum in spectra
    ]
    heights = np.sqrt(np.sum(squares, axis=0))
    if not np.all(heights > 0.0):
        sources = " + ".join(spectrum.source for spectrum in spectra)
        raise InputError(
            f"{sources}: all heights are equal, there is no roughness of which a contact law knows"
        )
    return heights


def has_lay(spectra: tuple[HeightSpectrum, ...]) -> bool:
    """Whether something is known of the grooves: of every map, and of profiles whose lay is a direction."""
    return any(spectrum.is_map or spectrum.lay in DIRECTIONS for spectrum in spectra)


def felt_numbers(spectra: tuple[HeightSpectrum, ...], widths: Heights, lengths: Heights) -> Numbers:
    """The rms of the heights [m], and the share of the waves in the rolling direction where a lay is known."""
    numbers = {HEIGHT: felt_at(spectra, widths, lengths)}
    if has_lay(spectra):
        numbers[SHARE] = felt_rolling_share(
            spectra,
            rolling=(1.0 / widths,) * len(spectra),
            axial=tuple(1.0 / np.minimum(lengths, spectrum.cut_off()) for spectrum in spectra),
        )
    return numbers


def felt_by(
    spectra: tuple[HeightSpectrum, ...], names: tuple[str, ...], widths: Heights, lengths: Heights
) -> dict[str, Felt]:
    """What contacts of these names, widths and lengths feel."""
    return {
        name: _felt(spectra, width=float(width), length=float(length))
        for name, width, length in zip(names, widths, lengths, strict=True)
    }


def _felt(spectra: tuple[HeightSpectrum, ...], *, width: float, length: float) -> Felt:
    """The waves of all bodies that a contact of a width and a length feels [m]."""
    rolling, axial = 1.0 / width, []
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
    deviation = 0.5 * math.sqrt(variance) / square
    limits = tuple(1.0 / limit for limit in axial)
    share = None
    if has_lay(spectra):
        limited = {"rolling": (rolling,) * len(spectra), "axial": limits}
        share = float(felt_rolling_share(spectra, **limited))
    steep = 0.0
    for spectrum, limit in zip(spectra, limits, strict=True):
        wavenumber, one = spectrum.waves(rolling=rolling, axial=limit)
        steep += float(np.sum(wavenumber**2 * one))
    return Felt(
        math.sqrt(square),
        deviation,
        width,
        tuple(axial),
        long / square,
        tuple(squares),
        share,
        math.sqrt(steep),
    )


def assumed_heights(measured: MeasuredRoughness, felt: dict[str, Felt]) -> list[str]:
    """What was taken of a measurement."""
    power = "" if measured.fractal is not None else f"; {measured.no_power_law}"
    told = [f"measured surface {measured.source}: the joint uses the measured spectrum{power}"]
    parts = []
    for name, contact in felt.items():
        limits = " and ".join(format_quantity(limit, "mm", 3) for limit in contact.axial)
        height, width = format_quantity(contact.rms_height, "um", 3), format_quantity(contact.width, "mm", 3)
        parts.append(f"{name} {height} (2b {width}, along the axis {limits})")
    told.append(
        "measured surface: the rms of the heights of both bodies together, of all waves but those that are longer than "
        "the Hertzian width 2b of the contact, under the torque of the file, in the rolling direction and, along the "
        "axis, longer than its contact line or than the cut-off of ISO 4288 for the Ra of a body: "
        f"{'; '.join(parts)}"
    )
    shares = {name: one.rolling_share for name, one in felt.items() if one.rolling_share is not None}
    if shares:
        told.append(
            "measured surface: the share of these waves that runs in the rolling direction, half of a surface without "
            f"grooves: {', '.join(f'{name} {share:.3f}' for name, share in shares.items())}"
        )
    for number, spectrum in enumerate(measured.spectra):
        if spectrum.lay is not None:
            told.append(f"{spectrum.source}: a profile across its lay, which is stated as {spectrum.lay}")
        for along, edges, sizes in (
            ("in the rolling direction", spectrum.rolling_edges, [one.width for one in felt.values()]),
            ("along the axis", spectrum.axial_edges, [one.axial[number] for one in felt.values()]),
        ):
            if max(sizes) * lowest_frequency(edges) > 1.0:
                size = format_quantity(1.0 / lowest_frequency(edges), "mm", 3)
                told.append(
                    f"{spectrum.source}: nothing is known of waves longer than {size} {along}, two thirds of its size, "
                    f"while contacts feel those up to {format_quantity(max(sizes), 'mm', 3)}; if there are any that "
                    "count, the contacts are softer"
                )
    share = max(contact.longest for contact in felt.values())
    if share > 0.5:
        told.append(
            f"measured surface: {100.0 * share:.0f} % of the mean square of the heights lie in the longest octave of "
            "waves that counts: there is no roll-off, and the result depends on where the waves are cut off"
        )
    return told

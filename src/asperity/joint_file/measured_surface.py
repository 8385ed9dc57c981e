"""A joint file with a measured surface: D and G, or the rms of the heights that each of its contacts feels."""

from __future__ import annotations

import json
import math
from contextlib import suppress
from typing import NamedTuple

from asperity.contact.felt_contacts import FeltContacts, form_lengths
from asperity.contact.laws.law import ContactLaw
from asperity.contact.laws.registry import LAWS, law_for
from asperity.engine.arrays import xp
from asperity.errors import AsperityError, InputError
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.joint.measured_surface import stiffness_interval
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.contact_laws import laws_side_by_side, with_law
from asperity.joint_file.decay_ratios import ratios_of
from asperity.joint_file.drawn_surface import Ends, interval_of_heights, with_measured_surface
from asperity.joint_file.felt_heights import (
    HEIGHT,
    SHARE,
    assumed_heights,
    felt_contacts,
    with_numbers_of,
)
from asperity.joint_file.model import Case
from asperity.joint_file.run_in import run_in_bound, run_in_document
from asperity.joint_file.section_build import surface_of
from asperity.surface.height_spectrum import HeightSpectrum
from asperity.surface.measured_roughness import MeasuredRoughness, roughness_document
from asperity.types import Document

_NORMAL_95 = 1.959963984540054


class MeasuredSurface(NamedTuple):
    """The measurement from which the surfaces of a joint file are, in terms of its contact law.

    ``measured``: as it was measured, of one body or of the pair; everything else is of the pair. ``assumed``: what was
    taken of it, one sentence each. ``heights``: path of a surface → lower end, middle and upper end of the rms of its
    heights [m], 95 % of measurements; ``ratios``, the same of the decay length over these heights by the contact law
    [-]; both, what the ``contacts`` feel, and the decay length of their ``form`` by
    :func:`asperity.contact.felt_contacts.form_lengths` [m], are None
    where D and G went in. ``files`` that the joint file names.
    """

    measured: MeasuredRoughness
    assumed: tuple[str, ...]
    heights: Ends | None = None
    ratios: Ends | None = None
    contacts: FeltContacts | None = None
    form: dict[str, float] | None = None
    files: tuple[str, ...] = ()

    @property
    def pair(self) -> MeasuredRoughness:
        """The surface of both bodies together."""
        return self.measured.pair

    @property
    def text(self) -> str:
        """The document of the measurement."""
        return json.dumps(roughness_document(self.measured))

    def document(self, case: Case, joint: Joint) -> Document:
        """What the measurement adds to the document of the solved joint."""
        return {
            "measured_surface": roughness_document(self.measured),
            "stiffness_interval": self.interval(case, joint),
        }

    def laws(self, case: Case, joint: Joint, result: JointResult) -> list[Document]:
        """The solved joint by every law that the measurement serves, as :func:`laws_side_by_side`."""
        used, contacts = case.contact_law(), self.contacts
        surfaces = {used: joint.surfaces}
        if self.heights is None:
            with suppress(AsperityError):  # the profile may have no lay
                by_heights = with_law(case, law_for("measurement").name)
                measured = case_with_surface(by_heights, self.measured).measured
                contacts = measured.contacts if measured else None
        for law in LAWS.values():
            if law.name == used:
                continue
            with suppress(InputError):  # a law that the measurement does not serve
                if law.from_measurement == "fractal" and self.pair.fractal is not None:
                    fractal = with_law(with_measured_surface(case, self.pair.fractal), law.name)
                    surfaces[law.name] = joint_from_case(fractal).surfaces
                elif law.from_measurement in ("heights", "decay_length") and contacts is not None:
                    surfaces[law.name] = self._by_length(law, contacts, case)
        return laws_side_by_side(joint, result, used=used, surfaces=surfaces)

    def _by_length(self, law: type[ContactLaw], contacts: FeltContacts, case: Case) -> tuple[ContactLaw, ...]:
        """The surfaces of all contacts by a law of the heights that they feel, or of their decay length."""
        ratios, _ = ratios_of(law, self.pair, contacts)
        surfaces = []
        for name, one in contacts.felt.items():
            _, ratio, _ = ratios[f"surface.{name}"]
            entry = {
                "rms_height": xp.asarray(one.rms_height),
                "decay_length": xp.asarray(ratio * one.rms_height),
                **({} if one.rolling_share is None else {SHARE: xp.asarray(one.rolling_share)}),
            }
            surfaces.append(surface_of(entry, asperity_base=case.model.asperity_base, contact_law=law.name))
        return tuple(surfaces)

    def interval(self, case: Case, joint: Joint) -> Document:
        """Intervals of stiffness and drift: from the law and the heights, or from the scatter of D and G."""
        if self.heights is not None and self.ratios is not None:
            return self._interval_with_run_in(case)
        assert self.pair.fractal is not None
        return stiffness_interval(joint, self.pair.fractal)

    def _interval_with_run_in(self, case: Case) -> Document:
        """The interval of the heights, and the joint after running in where that is known of every contact."""
        assert self.heights is not None
        assert self.ratios is not None
        assert self.contacts is not None
        bound = run_in_bound(self.pair.spectra, self.contacts)
        factors = bound.factors if bound.refused == "" else None
        interval = interval_of_heights(case, self.heights, self.ratios, self.form, factors)
        found = interval.pop("run_in", {})
        return interval | {"run_in": run_in_document(bound, found)}


def case_with_surface(case: Case, measured: MeasuredRoughness, files: tuple[str, ...] = ()) -> Case:
    """The joint file with its surfaces replaced by a measured one, at every contact.

    With ``model.contact_law = "zou_2025"`` the measured D, G and gamma go in. Otherwise, by the exponential law, the
    rms of the heights that each contact feels: of all waves but those longer than its Hertzian width in the rolling
    direction and, along the rollers' axis, longer than its contact line or the cut-off of ISO 4288. With ``"measured"``
    or ``"persson_2007"`` the decay length, which is not 0.48 of these heights but what boundary elements on the map, or
    Persson's theory of these waves, have at the mean pressure of the contact. ``measured`` is the surface of one body,
    which both then have, or of the pair; ``files`` are those that the joint file is to name.

    An ``InputError`` is raised if the measurement does not have what the law needs, a profile states no lay, or the
    joint cannot be solved.
    """
    stated, pair = case.model.contact_law, measured.pair
    law = law_for("measurement") if stated is None else LAWS[stated]
    law.refuse(pair)
    by_fractal = law.from_measurement == "fractal"
    if by_fractal or not pair.spectra:
        if pair.fractal is None or not (by_fractal or stated is None):
            raise InputError(_lacks(pair, stated))
        old = "measured surface: a document of an earlier release, without a spectrum; its D and G go in"
        surface = MeasuredSurface(measured, (measured.words, *(() if pair.spectra else (old,))), files=files)
        return with_measured_surface(case, pair.fractal).with_measured(surface)
    for spectrum in pair.spectra:
        if not spectrum.is_map and spectrum.lay is None:
            raise InputError(_without_lay(spectrum, pair))
    by_length = law.from_measurement == "decay_length"
    by_heights = with_law(case, law_for("measurement").name) if by_length else case
    contacts = felt_contacts(by_heights, pair.spectra)
    ends = {
        name: (contact.rms_height, math.exp(_NORMAL_95 * contact.deviation))
        for name, contact in contacts.felt.items()
    }
    heights = {f"surface.{name}": (rms / factor, rms, rms * factor) for name, (rms, factor) in ends.items()}
    ratios, assumed = ratios_of(law, pair, contacts)
    form = form_lengths(pair, contacts)
    heights_told = assumed_heights(pair, contacts.felt)
    told = (measured.words, *heights_told, *assumed, *_form_assumed(contacts, ratios, form))
    surface = MeasuredSurface(measured, told, heights, ratios, contacts, form, files)
    numbers = {
        "decay_length" if by_length else HEIGHT: {
            name: rms * (ratios[f"surface.{name}"][1] if by_length else 1.0)
            for name, (rms, _) in ends.items()
        }
    }
    shares = {name: one.rolling_share for name, one in contacts.felt.items() if one.rolling_share is not None}
    if shares:
        numbers[SHARE] = shares
    return with_numbers_of(case, numbers).with_measured(surface)


def _form_assumed(contacts: FeltContacts, ratios: Ends, form: dict[str, float]) -> list[str]:
    """The waves along the axis that make a contact softer than the law's own error does, if there are any."""
    softer = [
        f"{1.0 + form[name] / (ratio * one.rms_height):.3g} times at {name}"
        for (name, one), (_, ratio, most) in zip(contacts.felt.items(), ratios.values(), strict=True)
        if form[name] > (most - ratio) * one.rms_height
    ]
    told = (
        "form along the axis: waves that are too long to count as roughness, and deeper than the line load closes, so "
        "that the contact rests on a part of its line: the law does not hold them, the soft end of the interval does, "
        f"by a decay length up to {', '.join(softer)}; measure without the form of the roller (a polynomial, or a "
        "shorter section) and state it as crown radius"
    )
    return [told] if softer else []


def _lacks(measured: MeasuredRoughness, law: str | None) -> str:
    """Why a measurement does not serve a law."""
    if measured.spectra:
        return (
            f'model.contact_law = "{law}" needs D and G, which {measured.source} does not have '
            f"({measured.no_power_law}); leave contact_law out: the exponential law takes the measured spectrum"
        )
    if law is not None and LAWS[law].from_measurement != "fractal":
        return (
            f'{measured.source}: a document without a spectrum; model.contact_law = "{law}" needs one: measure '
            "the surface again with this release, in 16 points or more"
        )
    return f"{measured.source}: neither a power law nor a spectrum; measure it in 16 points or more"


def _without_lay(spectrum: HeightSpectrum, measured: MeasuredRoughness) -> str:
    """What to do about a profile whose lay is not known."""
    law = law_for("fractal_roughness").name
    remedy = f'; or state model.contact_law = "{law}", which takes the measured D and G whatever the lay'
    if measured.fractal is None:
        remedy = ""
    return (
        f"{spectrum.source}: a profile tells nothing of the waves along its grooves: measure it again with --lay: "
        "rolling (grooves in the rolling direction, measured along the rollers' axis), axis (grooves along the axis, "
        f"measured in the rolling direction) or isotropic (no grooves){remedy}"
    )

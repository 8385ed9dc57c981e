"""Decay length over the heights of every contact on a measured surface, by the contact law of a joint file."""

from __future__ import annotations

from asperity.contact.felt_contacts import FeltContacts
from asperity.contact.laws.law import ContactLaw
from asperity.errors import InputError
from asperity.joint_file import limits
from asperity.joint_file.drawn_surface import Ends
from asperity.surface.measured_roughness import MeasuredRoughness
from asperity.units import format_quantity


def ratios_of(
    law: type[ContactLaw], measured: MeasuredRoughness, contacts: FeltContacts
) -> tuple[Ends, list[str]]:
    """Decay length over the rms of the heights of every contact by a law, and what was taken, one sentence each.

    Path of a surface → lower end, itself and upper end [-]. An ``InputError`` is raised where the measurement does not
    serve the law, or a contact has no gaps.
    """
    found = law.decay_ratios(measured, contacts, format_quantity)
    for name, state in found.states.items():
        _, ratio, _ = found.ratios[name]
        if not ratio * contacts.felt[name].rms_height > 1e-6 * limits.DECAY_LENGTH.lower:
            raise InputError(
                f"{measured.source}: {state}: in complete contact an interface has no stiffness that counts; leave "
                "contact_law out, the exponential law is its soft bound"
            )
    return {f"surface.{name}": ends for name, ends in found.ratios.items()}, list(found.told)

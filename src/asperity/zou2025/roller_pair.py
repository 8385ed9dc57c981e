"""One pair of rollers on its own: the subject of the paper's section 5.1 and Fig. 4."""

from __future__ import annotations

from asperity.contact.fractal import FractalContact
from asperity.contact.roller_pairs import contact_factors, rough_contacts
from asperity.types import Real
from asperity.zou2025.preset import TABLE_1, table_1_pair


def pair_contact(**varied: Real) -> FractalContact:
    """Spots and stiffnesses of the roller pair of Table 1.

    Parameters
    ----------
    **varied : Real
        What a case varies, as for :func:`asperity.zou2025.preset.table_1_pair`. SI units.

    Returns
    -------
    FractalContact
        In the broadcast shape of the numbers.

    References
    ----------
    Zou et al. 2025, equations (10)–(24).
    """
    pairs = table_1_pair(**varied)
    values: dict[str, Real] = {**TABLE_1, **varied}
    return rough_contacts(
        pairs=pairs,
        contact_factor=contact_factors(pairs=pairs, model="printed", normal_force=values["normal_force"]),
        normal_force=values["normal_force"],
        tangential_force=values["tangential_force"],
    )

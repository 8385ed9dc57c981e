"""Messages with numbers by hand."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.refusal import refuse_short_contacts


def test_short_crowned_contacts_are_named_as_their_drive_names_them():
    """0.3 mm of half-width: 0.6 mm wide, and 1.5 times as long."""
    diagnostics = SimpleNamespace(
        slices_hold=np.array([True, False]),
        hertz_half_width=np.array([0.1e-3, 0.3e-3]),
        loaded_length_over_width=np.array([20.0, 1.5]),
    )
    result = SimpleNamespace(contact_names=("sp", "pr"), diagnostics=diagnostics)
    with pytest.raises(InputError, match=r"touch at pr over a length of 0\.9 mm and a width of 0\.6 mm"):
        refuse_short_contacts(result)
    diagnostics.slices_hold = None  # cylinders
    refuse_short_contacts(result)

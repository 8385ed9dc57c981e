"""Numbers for one or all contacts."""

import numpy as np

from asperity.joint.fit import per_contact
from asperity.materials import Material

SUN, RING = (Material(modulus, 0.3, 7800.0, 4e8, 1.2e9) for modulus in (200e9, 100e9))


def test_one_or_five_things_are_stacked():
    np.testing.assert_array_equal(per_contact((2.0,)), [2.0])
    np.testing.assert_array_equal(per_contact((1.0, 2.0, 3.0, 4.0, 5.0)), [1.0, 2.0, 3.0, 4.0, 5.0])
    assert per_contact((np.ones(3), 2.0)).shape == (2, 3)
    assert per_contact((SUN, RING)).youngs_modulus.tolist() == [200e9, 100e9]

"""A smooth line contact by boundary elements that rolls under a constant force."""

import numpy as np

from asperity.bem import ElasticPair, FreeHalfSpace, transient_rolling


def rolling_strip(cells, steps):
    """Shift over the creepage at gross slip, half-width 1: of a slip ratio, at rest and after each of the steps rolled.

    So many ``cells`` across the contact, a step of one of them each; further steps up to ``steps`` stand still.
    """
    pixel = 2.0 / cells
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)
    strip = FreeHalfSpace(pair, shape=(cells + 2,), pixel_size=(pixel,), reference_distance=10.0)
    edge = np.linspace(-1.0, 1.0, cells + 1)
    pressure = np.pad(np.diff(0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))) / pixel, 1)

    def shift(slip_ratio, rolled, layer=0.0):
        padded = np.zeros(steps, dtype=int)
        padded[: len(rolled)] = rolled
        found = transient_rolling(
            strip,
            pressure,
            friction_coefficient=1.0,
            axis=0,
            rolled_pixels=np.r_[0, padded],
            layer_compliance=layer,
            tangential_force=np.full(steps + 1, slip_ratio * pressure.sum() * pixel),
        )
        return np.asarray(found.shear.displacement)[: len(rolled) + 1]

    return shift

"""What asperities change in a rolling line contact: the table of asperity.contact.creep_layer.

Run it: ``python examples/rolling_layer.py`` (a quarter of an hour). It computes every entry by boundary elements,
prints the table and by how much it differs from the one in use.
"""

import numpy as np

from asperity.bem.rough_rolling import RoughPressure, rough_pressure, rough_rolling
from asperity.contact import creep_layer
from asperity.precision import use_double_precision


def strips(layer_ratio: float) -> int:
    """How many strips resolve the edges of the contact, whose width is that of s^(2/3)."""
    return 900 if layer_ratio < 0.0045 else 600 if layer_ratio < 0.015 else 300


def creepage_factors(
    contact: RoughPressure, *, stiffness_ratio: float, slip_ratios: np.ndarray
) -> np.ndarray:
    """Creepages over Carter's under growing forces."""
    factors, state = [], None
    for q in slip_ratios:
        state = rough_rolling(contact, stiffness_ratio=stiffness_ratio, slip_ratio=float(q), start=state)
        factors.append(state.creepage / (1.0 - np.sqrt(1.0 - q)))
    return np.array(factors)


def table() -> tuple[np.ndarray, np.ndarray]:
    """Scaled factors at every node, and scaled peaks of the pressure at the layer ratios."""
    ratios, slips, stiffnesses = creep_layer.table_nodes(creep_layer._TABLE.shape)
    factors, peaks = np.zeros(creep_layer._TABLE.shape), np.zeros(ratios.size)
    for i, s in enumerate(ratios):
        contact = rough_pressure(layer_ratio=float(s), strips=strips(s))
        peaks[i] = contact.pressure.max() * np.sqrt(1.0 + 8.0 * s / np.pi)
        for k, kappa in enumerate(stiffnesses):
            found = creepage_factors(contact, stiffness_ratio=float(kappa), slip_ratios=slips[::-1])
            factors[i, :, k] = (found[::-1] - 1.0) * np.sqrt(1.0 + s) / s
    return factors, peaks


def main() -> dict[str, float]:
    use_double_precision()
    factors, peaks = table()
    print("_TABLE = np.array([")
    for k in range(factors.shape[2]):
        print("    [")
        for row in factors[:, :, k]:
            print("        [" + ", ".join(f"{value:.5g}" for value in row) + "],")
        print("    ],")
    print("]).transpose(1, 2, 0)")
    print("_PEAKS = np.array([" + ", ".join(f"{value:.6g}" for value in peaks) + "])")
    return {
        "largest difference from the table in use": float(np.max(np.abs(factors - creep_layer._TABLE))),
        "largest difference of the peaks": float(np.max(np.abs(peaks - creep_layer._PEAKS))),
    }


if __name__ == "__main__":
    print(main())

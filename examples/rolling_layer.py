"""What a thin elastic layer adds to the creepage of a rolling line contact: the table of asperity.contact.creep_layer.

Run it: ``python examples/rolling_layer.py``. It computes every entry by boundary elements, prints the table and by how
much it differs from the one in use.
"""

import numpy as np

from asperity.bem import ElasticPair, FreeHalfSpace, steady_rolling
from asperity.contact import creep_layer
from asperity.precision import use_compilation_cache, use_double_precision

#: Grids for the extrapolation to infinitely fine pixels: cells across the contact.
CELLS = (400, 800)


def elliptic_pressure(cells: int) -> np.ndarray:
    """Means of the ellipse with peak 1 and half-width 1 over the cells."""
    edge = np.linspace(-1.0, 1.0, cells + 1)
    integral = 0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))
    return np.diff(integral) * cells / 2.0


def creepage(*, cells: int, layer_ratio: float, slip_ratio: float, with_pressure: bool) -> float:
    """Steady creepage over that of gross slip: half-width, contact modulus / 2 and peak of the friction limit are 1."""
    pixel = 2.0 / cells
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)
    strip = FreeHalfSpace(pair, shape=(cells,), pixel_size=(pixel,), reference_distance=1.0)
    pressure = elliptic_pressure(cells)
    layer = layer_ratio * (0.25 * np.pi / pressure if with_pressure else np.ones(cells))
    found = steady_rolling(
        strip,
        pressure,
        friction_coefficient=1.0,
        layer_compliance=layer,
        longitudinal_force=slip_ratio * pixel * pressure.sum(),
        lateral_creepage=0.0,
    )
    return float(found.creepage[0])


def creepage_factor(
    *, layer_ratio: float, slip_ratio: float, with_pressure: bool, cells: tuple[int, int] = CELLS
) -> float:
    """Creepage over Carter's, extrapolated from two grids."""
    coarse, fine = (
        creepage(cells=n, layer_ratio=layer_ratio, slip_ratio=slip_ratio, with_pressure=with_pressure)
        for n in cells
    )
    extrapolated = fine + (fine - coarse) * cells[0] / (cells[1] - cells[0])
    return extrapolated / (1.0 - np.sqrt(1.0 - slip_ratio))


def table(shape: tuple[int, int], *, with_pressure: bool) -> np.ndarray:
    """The factor at every node."""
    ratios, slips = creep_layer.table_nodes(shape)
    return np.array(
        [
            [creepage_factor(layer_ratio=c, slip_ratio=q, with_pressure=with_pressure) for q in slips]
            for c in ratios
        ]
    )


def main() -> dict[str, float]:
    use_double_precision()
    use_compilation_cache()
    differences = {}
    in_use = {"uniform": creep_layer._UNIFORM_LAYER, "pressure": creep_layer._PRESSURE_LAYER}
    for name, old in in_use.items():
        new = table(old.shape, with_pressure=name == "pressure")
        print(f"_{name.upper()}_LAYER = np.array([")
        for row in new:
            print("    [" + ", ".join(f"{value:.6g}" for value in row) + "],")
        differences[name] = float(np.max(np.abs(new / old - 1.0)))
        print(f"])  # largest relative difference from the table in use: {differences[name]:.1e}")
    return differences


if __name__ == "__main__":
    main()

"""Two like steel rollers pressed together, and springs with their compliance."""

import math

import numpy as np

from asperity.drive.normal_springs import NormalSprings


def johnson(force):
    """Approach [m] of rollers of R = 4 and 13.5 mm, B = 5 mm: Johnson 1985, equation (5.57), both bodies."""
    modulus, nu, length, radii = 206e9, 0.3, 5e-3, (4e-3, 13.5e-3)
    contact = modulus / (2.0 * (1.0 - nu**2))
    effective = radii[0] * radii[1] / (radii[0] + radii[1])
    width = math.sqrt(4.0 * force * effective / (math.pi * length * contact))
    scale = force / length * (1.0 - nu**2) / (math.pi * modulus)
    return scale * sum(2.0 * math.log(4.0 * radius / width) - 1.0 for radius in radii)


def springs_at(force):
    """The approach over the force, and its slope by differences."""
    step = 1e-4 * force
    incremental = (johnson(force + step) - johnson(force - step)) / (2.0 * step)
    return NormalSprings(np.array(johnson(force) / force), np.array(incremental))

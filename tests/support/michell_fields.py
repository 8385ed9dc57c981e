"""Annuli of steel on their supports, and every mode of one by a dense solution with Michell's fields."""

import math

import numpy as np

from asperity.body.shapes import Annulus

E, NU = 206e9, 0.3
G = E / (2.0 * (1.0 + NU))
SUPPORTS = [(0.0, 0.0), (math.inf, math.inf), (3e12, 3e12), (math.inf, 0.0), (1e13, 2e12)]


def annulus(support, rim, inner=1.0, outer=1.4, state="plane_strain"):
    return Annulus(inner, outer, 1.0, E, NU, *support, rim, state)


def fields(n, r, kappa):
    """2G u_r, 2G u_theta, sigma_r, tau of Airy's r^(n+2), r^(2-n), r^n, r^-n times cos n theta (Barber, table 9.1)."""
    columns = [
        [
            (kappa - n - 1) * r ** (n + 1),
            (kappa + n + 1) * r ** (n + 1),
            -(n + 1) * (n - 2) * r**n,
            n * (n + 1) * r**n,
        ],
        [
            (kappa + n - 1) * r ** (1 - n),
            -(kappa - n + 1) * r ** (1 - n),
            -(n + 2) * (n - 1) * r**-n,
            -n * (n - 1) * r**-n,
        ],
        [-n * r ** (n - 1), n * r ** (n - 1), -n * (n - 1) * r ** (n - 2), n * (n - 1) * r ** (n - 2)],
        [n * r ** (-n - 1), n * r ** (-n - 1), -n * (n + 1) * r ** (-n - 2), -n * (n + 1) * r ** (-n - 2)],
    ]
    if (
        n == 1
    ):  # one more for a resultant force: (kappa+1) r theta sin - (kappa-1) r ln r cos; r^1 is a translation
        columns[1] = [
            -1 + 2 * kappa * math.log(r),
            -1 - 2 * kappa * math.log(r),
            (kappa + 3) / r,
            -(kappa - 1) / r,
        ]
        columns[2] = [1.0, -1.0, 0.0, 0.0]
    return np.array(columns).T


def dense(n, support, rim, inner, outer, kappa):
    """Displacements 4G u/R on the loaded rim under unit tractions there, as a 2x2 matrix."""
    loaded, other = (outer, inner) if rim == "outer" else (inner, outer)
    side = 1.0 if rim == "outer" else -1.0
    here, there = fields(n, loaded, kappa), fields(n, other, kappa)
    rows = [side * here[2], side * here[3]]
    for k, stiffness in enumerate(support):
        if math.isinf(stiffness):
            rows.append(there[k])
        else:
            rows.append(-side * there[2 + k] + stiffness / (2.0 * G) * there[k])
    right = np.zeros((4, 2))
    right[:2] = np.eye(2)
    return here[:2] @ np.linalg.solve(np.array(rows), right) * 2.0 / loaded

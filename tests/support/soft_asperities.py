"""Asperities so soft that the bodies are rigid."""

import numpy as np


def soft_slip_ratio(k):
    """Rigid bodies: springs that touch at X, in numbers of X exp(-X^2/2), creep k (X - x) up to (X^2 - x^2)/2."""
    X = np.linspace(0.0, 12.0, 40001)
    meets = np.where(k < X, 2.0 * k - X, X)
    sticks = np.where(k < X, 2.0 * k * (X - k) ** 2, 0.0)
    slips = 0.5 * X**2 * (meets + X) - (meets**3 + X**3) / 6.0
    number = X * np.exp(-0.5 * X**2)
    return np.trapezoid(number * (sticks + slips), X) / np.trapezoid(number * X**3 * 2.0 / 3.0, X)

"""Sensitivities and the effect of tolerances."""

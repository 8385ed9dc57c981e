"""A library of materials of a user's own."""

BRONZE = """
[bronze]
description = "a bronze"
reference = "own tests"
youngs_modulus = "110 GPa"
poisson_ratio = 0.34
density = "8800 kg/m^3"
yield_strength = "200 MPa"
hardness_factor = 2.8
"""

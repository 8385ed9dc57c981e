"""Two engines for one formula code: NumPy for one joint, JAX for many, for derivatives and for GPUs.

Which one computes follows from the numbers that come in. A formula is written once, with :mod:`asperity.engine.arrays`
and :mod:`asperity.engine.control`; it never asks.
"""

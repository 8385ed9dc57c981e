"""Joint files: TOML with units as text, checked, and turned into a :class:`asperity.joint.Joint`.

This package is the only place where the units of a joint file are converted. The way is file → text with units
(:mod:`~asperity.case.model`) → nested tables of SI numbers (:mod:`~asperity.case.values`) → joint
(:mod:`~asperity.case.build`); sweeps and gradients enter at the second step with arrays.
"""

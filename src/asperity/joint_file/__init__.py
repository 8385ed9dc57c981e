"""Joint files: TOML with units as text, checked, and turned into a :class:`asperity.joint.description.Joint`.

This package is the only place where the units of a joint file are converted. The way is file → text with units
(:mod:`~asperity.joint_file.sections`) → nested tables of SI numbers (:mod:`~asperity.joint_file.si_tables`) → joint
(:mod:`~asperity.joint_file.build`); sweeps and gradients enter at the second step with arrays.
"""

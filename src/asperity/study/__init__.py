"""Studies of a joint: its numbers varied, toleranced, optimised, or fitted to a measurement.

Four rooms share one batch evaluator: :mod:`~asperity.study.sweep`, :mod:`~asperity.study.tolerances`,
:mod:`~asperity.study.design` and :mod:`~asperity.study.calibration`.
"""

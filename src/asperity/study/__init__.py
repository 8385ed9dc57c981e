"""What a designer does all day: vary, compare, weigh tolerances, optimise, calibrate. SI units, reasons, no holes.

:mod:`~asperity.study.sweep` evaluates a joint on a grid, in memory or streamed to disk;
:mod:`~asperity.study.sensitivity` differentiates it; :mod:`~asperity.study.uncertainty` carries tolerances through
it; :mod:`~asperity.study.design` chooses a joint under constraints; :mod:`~asperity.study.calibrate` fits one to a
measurement.
"""

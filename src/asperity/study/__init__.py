"""What a designer does all day: vary, compare, weigh tolerances. xarray out, SI units, reasons instead of holes.

:mod:`~asperity.study.sweep` evaluates a joint on a grid, in memory or streamed to disk;
:mod:`~asperity.study.sensitivity` differentiates it; :mod:`~asperity.study.uncertainty` carries tolerances through it.
"""

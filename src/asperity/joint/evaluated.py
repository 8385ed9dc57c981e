"""The chain of one joint, by two programs that compile beside each other."""

from __future__ import annotations

from collections.abc import Callable

import jax
import numpy as np

from asperity.compilation import Program, compile_fast
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult, rolling_joint, standing_joint
from asperity.joint.rolling import RollingResult


def chain_programs(joint: Joint) -> tuple[Program, Program, JointResult]:
    """Programs of the joint at rest and of the joint that turns.

    Parameters
    ----------
    joint : Joint
        One joint of NumPy numbers.

    Returns
    -------
    Program, Program, JointResult
        The programs, which compile meanwhile, and the shapes of what comes out of both.
    """
    first = compile_fast(standing_joint, joint)
    second = compile_fast(rolling_joint, joint, *first.results)
    return first, second, JointResult(**vars(first.results[0]), rolling=second.results)


def evaluated(joint: Joint) -> JointResult:
    """What :func:`asperity.joint.evaluation.evaluate` says about one joint.

    Parameters
    ----------
    joint : Joint
        One joint of NumPy numbers.

    Returns
    -------
    JointResult
        With leaves as NumPy arrays.
    """
    first, second, _ = chain_programs(joint)
    half = first(joint)
    found = JointResult(**vars(half[0]), rolling=second(joint, *half))
    result: JointResult = jax.tree.map(np.asarray, found)
    return result


def rolling_of(joint: Joint) -> Callable[[Joint], RollingResult]:
    """The joint that turns, for many calls.

    Parameters
    ----------
    joint : Joint
        One joint of NumPy numbers.

    Returns
    -------
    callable
        Joint like this one with other numbers → its creep, drift, axial forces, losses and life.
    """
    first, second, _ = chain_programs(joint)

    def rolling(there: Joint) -> RollingResult:
        found: RollingResult = second(there, *first(there))
        return found

    return rolling

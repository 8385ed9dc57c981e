"""The errors that asperity raises on purpose.

Each carries one complete sentence for the user: the offending value, the allowed range, what to do. The
command line prints that sentence and exits with :attr:`AsperityError.exit_code`; nothing else is printed.
"""


class AsperityError(Exception):
    """Base of every error that asperity raises on purpose."""

    exit_code = 1


class InputError(AsperityError, ValueError):
    """The input is wrong: a value, a unit, a key, a file. Exit code 2."""

    exit_code = 2


class NoSolutionError(AsperityError, RuntimeError):
    """The input is well formed but has no solution, or the solver did not converge. Exit code 3."""

    exit_code = 3


class PrecisionError(AsperityError, RuntimeError):
    """JAX runs in single precision, which the contact law cannot tolerate. Exit code 2."""

    exit_code = 2


class MissingExtraError(AsperityError, ImportError):
    """An optional dependency is needed for this operation and is not installed. Exit code 2."""

    exit_code = 2

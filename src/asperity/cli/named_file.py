"""What a command finds impossible about the joint of a file names the file, like what it finds wrong in its text."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from asperity.errors import InputError, NoSolutionError


@contextmanager
def about(file: str, *others: str | None) -> Iterator[None]:
    """While the joint of a file is solved: refusals begin with the name of the file.

    Parameters
    ----------
    file : str
        The joint file.
    *others : str or None
        Further files of the command: a refusal that begins with the name of one of them is about that file.

    Yields
    ------
    None

    Raises
    ------
    InputError, NoSolutionError
        As they are raised within, after the name.
    """
    try:
        yield
    except (InputError, NoSolutionError) as error:
        if any(str(error).startswith((f"{name}: ", f"{name}, ")) for name in (file, *others)):
            raise
        raise type(error)(f"{file}: {error}", options=error.options) from None

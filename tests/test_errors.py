"""Exit codes and Python's own families of the errors, as documented."""

import pytest

from asperity.errors import (
    AsperityError,
    InputError,
    MissingExtraError,
    NoSolutionError,
    PrecisionError,
)


@pytest.mark.parametrize(
    ("kind", "code", "family"),
    [
        (AsperityError, 1, Exception),
        (InputError, 2, ValueError),
        (NoSolutionError, 3, RuntimeError),
        (PrecisionError, 2, RuntimeError),
        (MissingExtraError, 2, ImportError),
    ],
)
def test_who_catches_the_family_catches_the_error(kind, code, family):
    assert issubclass(kind, AsperityError)
    assert kind.exit_code == code
    with pytest.raises(family, match="what to do"):
        raise kind("what to do")

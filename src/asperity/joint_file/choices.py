"""The words that a joint file chooses among: variants of the model, finishes, and materials of its bodies."""

from __future__ import annotations

import functools
from collections.abc import Iterable
from typing import Any, Literal, get_args, get_origin

from asperity.joint_file.case_types import DefaultCase
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import HOUSING
from asperity.joint_file.section import is_list, models_of
from asperity.library import read_finishes

#: The key of the finish of all surfaces.
FINISH = "surface.finish"


def _words(annotation: Any) -> tuple[str, ...]:
    """The words that an annotation allows."""
    if get_origin(annotation) is Literal:
        return get_args(annotation)
    return tuple(word for part in get_args(annotation) for word in _words(part))


def choices_of(model: type[Case], bodies: Iterable[str]) -> dict[str, tuple[str, ...]]:
    """The choices that a joint file offers."""
    return {
        **{f"bodies.{name}": () for name in (*bodies, HOUSING)},
        FINISH: tuple(read_finishes()),
        **_words_of_sections(model),
    }


@functools.cache
def _words_of_sections(model: type[Case]) -> dict[str, tuple[str, ...]]:
    return {
        f"{section}.{name}": _words(field.annotation)
        for section, above in model.model_fields.items()
        if not is_list(above.annotation)
        for below in models_of(above.annotation)
        for name, field in below.model_fields.items()
        if not models_of(field.annotation) and _words(field.annotation)
    }


#: The choices of a joint file without a type.
CHOICES = choices_of(DefaultCase, DefaultCase.drive_type.material_keys)


def choices_of_case(case: Case) -> dict[str, tuple[str, ...]]:
    """The choices of one joint file, as :func:`choices_of`."""
    return choices_of(type(case), case.bodies)

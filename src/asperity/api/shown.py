"""Tables and figures as a terminal and a notebook show them."""

from __future__ import annotations

import functools
import io
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from types import ModuleType
from typing import TYPE_CHECKING, Any

from asperity.extras import optional_module
from asperity.views.blocks import Block
from asperity.views.html import notebook_html
from asperity.views.terminal import plain_text

if TYPE_CHECKING:
    import numpy as np
    import pandas
    from matplotlib.figure import Figure


class Shown(ABC):
    """Something that a terminal shows as text, and a notebook as HTML."""

    @abstractmethod
    def blocks(self) -> Sequence[Block]:
        """What there is to read, in its order."""

    def __repr__(self) -> str:
        return plain_text(self.blocks())

    def _repr_html_(self) -> str:
        return notebook_html(self.blocks())


def displayed(figure: Figure) -> Figure:
    """The same figure, which a notebook shows by itself although it is made without pyplot."""
    shows: Any = figure
    shows._repr_png_ = functools.partial(_png, figure)
    return figure


def _png(figure: Figure) -> bytes:
    target = io.BytesIO()
    figure.savefig(target, format="png", dpi=100)
    return target.getvalue()


def frame(
    columns: Mapping[str, Sequence[object] | np.ndarray],
    *,
    index: Sequence[object] | None = None,
    index_name: str = "",
) -> pandas.DataFrame:
    """A pandas data frame of columns by title, with named rows; a ``MissingExtraError`` if pandas is not installed."""
    made = installed_pandas().DataFrame(columns, index=index)
    if index_name:
        made.index.name = index_name
    return made


def installed_pandas() -> ModuleType:
    """The package pandas, or a ``MissingExtraError`` if it is not installed."""
    return optional_module("pandas", extra="study", needs="data frames need")

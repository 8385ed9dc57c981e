"""A design in a script: the designed joint, how it stands to its limits, a picture."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from asperity.api.joint import DescribedJoint
from asperity.api.named_quantity import NamedQuantity, columns_of
from asperity.api.shown import Shown, displayed, frame
from asperity.errors import NoSolutionError
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import key_at
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.results import known_result
from asperity.study.design.design import design as search
from asperity.study.design.design_file import read_design
from asperity.study.design.design_plot import design_figure
from asperity.study.design.design_result import DesignResult, shortcoming
from asperity.study.design.pareto import pareto_front, require_pymoo
from asperity.study.parameters import long_name
from asperity.views.blocks import Block
from asperity.views.design import design as designed
from asperity.views.design import design_warnings

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.figure import Figure


def design(
    path: str | Path, *, population: int = 100, generations: int = 150
) -> DesignedJoint | xarray.Dataset:
    """The best joint within limits, or a Pareto front, as a design file asks.

    Parameters
    ----------
    path : str or Path
        A TOML file that names joint file, free numbers with bounds, objectives and limits.
    population, generations : int, optional
        Designs of a generation, and number of generations, of a Pareto front.

    Returns
    -------
    DesignedJoint or xarray.Dataset
        The best joint for one objective. For two or three a dataset of the front in SI units, with units in its
        attributes; it needs the extra ``study``.

    Raises
    ------
    InputError
        If the file cannot be read or makes no sense.
    NoSolutionError
        If no design meets all limits, with those that conflict and by how much; or if no search converged.
    """
    use_double_precision()
    use_compilation_cache()
    problem = read_design(path)
    if len(problem.objectives) > 1:
        require_pymoo()
        return pareto_front(problem, population=population, generations=generations)
    result = search(problem)
    if shortcoming(result):
        raise NoSolutionError(shortcoming(result))
    return DesignedJoint(result, source=f"design of {path}")


class DesignedJoint(Shown):
    """The outcome of a design: ``found["load.preload"]`` is a free number with its unit.

    Parameters
    ----------
    result : DesignResult
        All of it in SI units.
    source : str
        What the designed joint is called in titles and messages.
    """

    def __init__(self, result: DesignResult, *, source: str) -> None:
        self.result = result
        #: The designed joint, ready to be solved or saved.
        self.joint = DescribedJoint(parse_case(result.joint_text, source=source), source)

    def __getitem__(self, path: str) -> NamedQuantity:
        """One free number."""
        known_result(path, among=tuple(self.result.point), what="free number of the design")
        key = key_at(path)
        return NamedQuantity(path, long_name(path), self.result.point[path], key.dimension, key.unit)

    def keys(self) -> list[str]:
        """Dotted paths of the free numbers."""
        return list(self.result.point)

    def to_frame(self) -> pandas.DataFrame:
        """The free numbers as a pandas data frame: value, unit, SI value, SI unit, bound on which it lies."""
        numbers = [self[path] for path in self.keys()]
        return frame(
            {
                **columns_of(numbers),
                "at_bound": [self.result.at_bound.get(quantity.name, "") for quantity in numbers],
            },
            index=self.keys(),
            index_name="number",
        )

    def plot(self) -> Figure:
        """Draw the objective along each free number, with the range that meets all limits.

        A notebook shows the figure; elsewhere call its ``savefig``.
        """
        return displayed(design_figure(self.result))

    def blocks(self) -> list[Block]:
        """What ``asperity design`` prints."""
        return [*designed(self.result), *design_warnings(self.result)]

"""The oil in the contacts of a joint in a script: film, asperities and traction over speed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import Shown, displayed, frame
from asperity.joint_file.film import POINTS, joint_film
from asperity.results.film_document import FilmOverSpeed, film_columns, film_document
from asperity.show.film_figure import film_figure
from asperity.show.style import plain_title
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.views.blocks import Block, Heading
from asperity.views.film import film as film_shown

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure


def film(
    joint: DescribedJoint,
    *,
    temperatures: Sequence[str | NamedQuantity] = (),
    start: str | NamedQuantity | None = None,
    stop: str | NamedQuantity | None = None,
    points: int = POINTS,
    report: Callable[[int, int], None] | None = None,
) -> JointFilm:
    """Oil in the contacts of a joint over the speed of its input: films, asperities, traction and creep.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`; its file names an oil whose traction is known.
    temperatures : sequence of str or NamedQuantity, optional
        Of the oil, at most six, such as ``("20 degC", "80 degC")``; by default that of the file. Fits and preload stay
        those of the file.
    start, stop : str or NamedQuantity, optional
        Lowest and highest speed of the input, such as ``"1 rpm"``; by default a thousandth of the speed of the file,
        and twice that speed.
    points : int, optional
        Number of speeds, evenly over their logarithm; that of the file comes in addition.
    report : callable, optional
        Takes the number of temperatures done, and of all.

    Returns
    -------
    JointFilm
        Numbers of every contact over speed, and those at the speed and torque of the file.

    Raises
    ------
    InputError
        If the file names no oil whose traction is known, an end or a temperature has no unit or is out of range, the
        speeds do not rise, there are fewer than 2 points, or the bodies do not fit.
    NoSolutionError
        If the joint rolls at none of the speeds.
    """
    require_joint(joint)
    ends = {
        name: None
        if end is None
        else si_number(end, Dimension.ANGULAR_VELOCITY, name=f"{name} of the speeds")
        for name, end in (("start", start), ("stop", stop))
    }
    given = [temperatures] if isinstance(temperatures, str | NamedQuantity) else temperatures
    oil = [si_number(each, Dimension.TEMPERATURE, name="temperature of the oil") for each in given]
    return JointFilm(joint, joint_film(joint.case, temperatures=oil, points=points, report=report, **ends))


class JointFilm(Shown):
    """The oil in the contacts of a joint over speed: what ``asperity film`` prints and draws.

    Parameters
    ----------
    joint : DescribedJoint
        The joint.
    film : FilmOverSpeed
        Numbers over speed, as arrays in SI units.
    """

    def __init__(self, joint: DescribedJoint, film: FilmOverSpeed) -> None:
        self.joint, self.film = joint, film
        self.document: Document = film_document(film)

    def to_frame(self) -> pandas.DataFrame:
        """Every number over temperatures and speeds as a pandas data frame, units in the column names."""
        return frame(film_columns(self.film))

    def plot(self) -> Figure:
        """Draw traction capacity and share of the asperities over speed.

        A notebook shows the figure; elsewhere call its ``savefig``.
        """
        return displayed(film_figure(self.film, title=plain_title(self.joint.source)))

    def blocks(self) -> list[Block]:
        """What ``asperity film`` prints."""
        return [Heading(self.joint.source), *film_shown(self.document)]

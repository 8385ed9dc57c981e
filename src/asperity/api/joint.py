"""A joint file in a script: its numbers with units, changed copies of it, and its solution."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from asperity.api.named_quantity import NamedQuantity, columns_of, si_number
from asperity.api.shown import Shown, frame
from asperity.api.solution import JointSolution
from asperity.errors import InputError, quoted
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.choices import choices_of_case
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.si_tables import AnyCase, check_values, key_at, numeric_keys
from asperity.joint_file.solved_document import solved_case
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.study.parameters import long_name
from asperity.units import from_si
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import quantity
from asperity.writing import write_text

if TYPE_CHECKING:
    import pandas

    from asperity.api.solution import JointSolution
    from asperity.surface.measured_roughness import MeasuredRoughness

#: Keys of the file that its one-line summary names.
_SUMMARY = ("load.preload", "load.interference", "load.output_torque", "load.sun_speed")


def load(path: str | Path) -> DescribedJoint:
    """Read a joint file.

    Parameters
    ----------
    path : str or Path
        A TOML file, as ``asperity init`` writes one.

    Returns
    -------
    DescribedJoint
        The joint, ready to be changed and solved.

    Raises
    ------
    InputError
        If the file cannot be read or says something that is not allowed.
    NoSolutionError
        If the file names a measured surface, and the joint with it has no balance.

    Notes
    -----
    Switches JAX to double precision for this process, as every function of this room does.
    """
    use_double_precision()
    use_compilation_cache()
    return DescribedJoint(read_case(path), str(path))


@dataclass(frozen=True, repr=False)
class DescribedJoint(Shown):
    """A joint as its file describes it; a change makes a new one.

    Parameters
    ----------
    case : Case
        The checked content of the joint file.
    source : str
        Where it comes from, for titles and messages.
    """

    case: AnyCase
    source: str

    @property
    def numbers(self) -> dict[str, NamedQuantity]:
        """Every number that the file states: dotted path → quantity."""
        return {
            path: NamedQuantity(path, long_name(path), entry.value, entry.key.dimension, entry.key.unit)
            for path, entry in numeric_keys(self.case).items()
        }

    def __getitem__(self, path: str) -> NamedQuantity:
        """One number of the file, such as ``load.preload``."""
        numbers = self.numbers
        if path not in numbers:
            key_at(path, self.case.type)  # raises if no joint file has such a number
            raise InputError(f"{self.source} does not state '{path}'; it states {', '.join(numbers)}")
        return numbers[path]

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.numbers)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """What the file leaves out and what is assumed instead, one sentence each."""
        return assumptions(self.case, joint_from_case(self.case))

    def with_values(self, changes: Mapping[str, str | float | NamedQuantity]) -> DescribedJoint:
        """The same joint with other numbers, choices or materials.

        Parameters
        ----------
        changes : mapping
            Dotted path → text with its unit, such as ``{"load.preload": "1200 N"}``, or a :class:`NamedQuantity` of
            another joint or result. A bare number is accepted only where the quantity is dimensionless. A tolerance of
            the file stays. Choices and materials are words, ``{"model.traction_split": "springs", "bodies.sun":
            "440C"}``.

        Returns
        -------
        DescribedJoint
            A new joint.

        Raises
        ------
        InputError
            If there is no such number or word, a unit is missing or wrong, or a number is outside its range.
        """
        from asperity.joint_file.edited_text import joint_file_text

        if not isinstance(changes, Mapping):
            raise InputError(f"expected changes such as {{'load.preload': '1200 N'}}, got {quoted(changes)}")
        kind, choices = self.case.type, choices_of_case(self.case)
        words: dict[str, str] = {}
        for path, word in changes.items():
            if path not in choices:
                continue
            if not isinstance(word, str) or not word:
                raise InputError(f"{path}: expected a word, got {quoted(word)}")
            words[path] = word
        numbers = {
            path: si_number(given, key_at(path, kind).dimension, name=path)
            for path, given in changes.items()
            if path not in words
        }
        check_values(numbers)
        changed = self.edited(joint_file_text(self.case, numbers, comment="", words=words))
        if self.case.measured is not None and not self.case.measured.files:  # which the text cannot name
            changed = changed.with_surface(self.case.measured.measured)
        for path, value in numbers.items() if words else ():  # without words the text is compared as a whole
            if path not in changed.numbers or not math.isclose(changed[path].si, value, rel_tol=1e-12):
                raise InputError(
                    f"{path}: cannot be written into the text of {self.source}; change words and numbers in two steps"
                )
        return changed

    def with_surface(
        self, measurement: MeasuredRoughness, *, measurement_of: str | None = None
    ) -> DescribedJoint:
        """The same joint with a measured surface at every contact, in terms of its contact law.

        Parameters
        ----------
        measurement : MeasuredRoughness
            The ``measurement`` of what :func:`asperity.api.surface.measure_surface` returns.
        measurement_of : {"body", "pair"}, optional
            What it is of: one body, as both bodies of a contact then are, or both together. What the measurement says
            if not given; a file is of one body.

        Returns
        -------
        DescribedJoint
            A new joint.

        Raises
        ------
        InputError
            If the measurement lacks what the law needs, a profile its lay, or the joint cannot be solved.
        """
        from asperity.joint_file.measured_surface import case_with_surface
        from asperity.surface.measured_roughness import measurement_of as stated_to_be

        measured = stated_to_be(measurement, measurement_of)
        return DescribedJoint(case_with_surface(self.case, measured), self.source)

    def edited(self, text: str) -> DescribedJoint:
        """The joint of another text, TOML, of its file."""
        return DescribedJoint(parse_case(text, source=self.source), self.source)

    def save(self, path: str | Path) -> None:
        """Write the joint as a joint file.

        Parameters
        ----------
        path : str or Path
            Name of the file; an existing one is replaced.

        Raises
        ------
        InputError
            If it cannot be written.
        """
        from asperity.joint_file.edited_text import joint_file_text

        write_text(joint_file_text(self.case, {}, comment=""), str(path))

    def solve(self) -> JointSolution:
        """Forces, contacts, stiffness and limits of the joint.

        Returns
        -------
        JointSolution
            All results with names and units.

        Raises
        ------
        InputError
            If the rollers do not fit, or the output torque is beyond the standing torque capacity.
        NoSolutionError
            If the force balance does not close.
        """
        return JointSolution(self.case, solved_case(self.case), source=self.source, summary=self.summary)

    def to_frame(self) -> pandas.DataFrame:
        """The numbers of the file as a pandas data frame: value, unit, SI value, SI unit, tolerance (in the unit)."""
        stated, numbers = numeric_keys(self.case), self.numbers
        return frame(
            {
                **columns_of(numbers.values()),
                "tolerance": [from_si(stated[path].tolerance, q.unit) for path, q in numbers.items()],
            },
            index=list(numbers),
            index_name="number",
        )

    @property
    def summary(self) -> str:
        """The joint in one line."""
        stated = ", ".join(f"{self[path].label} {self[path]}" for path in _SUMMARY if path in self.numbers)
        sectors = self.case.drive_type.sectors
        count = None if sectors is None else self[f"drive.{sectors.key}"]
        return f"{self.source}: {stated if count is None else f'{count.si:g} {count.label}, {stated}'}"

    def blocks(self) -> list[Block]:
        """The joint in one line, and the numbers of its file."""
        rows = [(path, quantity(q.si, q.unit, 6)) for path, q in self.numbers.items()]
        return [Paragraph(self.summary), Table("Numbers of the joint file", ("number", "value"), rows)]


def require_joint(joint: object) -> None:
    """Raise an ``InputError`` unless this is a joint that was loaded."""
    if not isinstance(joint, DescribedJoint):
        raise InputError(f"expected a joint, got {quoted(joint)}; asperity.load('joint.toml') reads one")

"""The drawing of a drive: frame, view with dimensions, what the view does not say, and the forces on request."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from typing import NamedTuple

from asperity.drive.types import TYPES
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.joint_file.stated_parts import StatedPart, StatedParts
from asperity.show.arrangement import Arrangement, Room, arrange
from asperity.show.box import Box, around_all, box_of
from asperity.show.cutting_line import LETTER, cutting_marks, cutting_path, is_bent
from asperity.show.drive_notes import drive_lines, load_lines
from asperity.show.drive_sizes import Clearance, Size, drive_clearances, sizes
from asperity.show.drive_view import drive_view, write_contact_names
from asperity.show.free_bodies import free_bodies
from asperity.show.notes import SPACING
from asperity.show.paper import FORMATS, Paper
from asperity.show.placed_dimensions import Dimensions, place_dimensions, room_of_dimensions
from asperity.show.section_view import draw_section, drive_section
from asperity.show.sheet import TITLE_HEIGHT, Circle, Dimension, Item, Line, Point, Sheet, Text
from asperity.show.sheet_figure import text_width
from asperity.show.taken import Taken
from asperity.show.title_block import Title

_BEYOND_AXES = 4.0  # of a view, with its axes [mm on paper]
_LONG_LABEL = 45.0  # on a leader [mm on paper]
_ROOM_OF_FORCES = 150.0  # width of the bodies that are drawn apart [mm on paper]


class _Contents(NamedTuple):
    """What a sheet has to show: the joint, its sizes and clearances, and what is stated of it."""

    joint: Joint
    sizes: list[Size]
    clearances: list[Clearance]
    interference: float | None
    stated: StatedParts | None
    loads: tuple[str, ...]
    forces: tuple[Item, ...]
    section: bool

    @property
    def bodies(self) -> tuple[StatedPart, ...] | None:
        """What is stated of the bodies; None where nothing is."""
        return None if self.stated is None else self.stated.bodies

    @property
    def is_plain(self) -> bool:
        """Whether the view stands alone, as a page of a report."""
        return not self.section and not self.forces

    @property
    def letters(self) -> str:
        """Letters for clearances; the section has the first one."""
        return "BCD" if self.section else "ABC"

    def lines(self, listed: frozenset[int], letters: dict[int, str]) -> list[str]:
        """The notes, with the sizes that are listed."""
        notes = drive_lines(
            self.joint, self.sizes, self.clearances, listed, letters, self.interference, self.stated
        )
        return [*self.loads, *([""] if self.loads else []), *notes]


def drive_sheet(
    joint: Joint,
    *,
    name: str,
    result: JointResult | None = None,
    loaded: Joint | None = None,
    interference: float | None = None,
    stated: StatedParts | None = None,
    title: Title | None = None,
    section: bool = False,
) -> Sheet:
    """Draw a drive to scale.

    ``joint``: one joint whose drive can exist; ``name``: what the drawing is called, for example the name of its file;
    ``result``, if the forces on the bodies are to be drawn too, and ``loaded``, whose forces these are where the
    sectors differ, every sector by itself. ``interference`` with which the drive is made where the joint states a force
    [m], None where it is not known; ``stated``: tolerances, materials, crowns and surfaces of its parts, without them
    the drawing shows sizes alone; ``title``: what the title block says, dashes if None; ``section``: whether the sheet
    has a section along the axis, unless it has forces.

    The smallest sheet that the drawing fills, at the largest scale of ISO 5455 that fits on it; without section and
    forces A4 across if it can be. Tracks of a stepped roller are circles about one centre, although they lie in
    different planes. A size for which the view has no room is said beside it. Rings are drawn at the radii at which all
    contacts just touch. Raises :class:`asperity.errors.InputError` if no sheet can show the drive.
    """
    bodies = None if stated is None else stated.bodies
    loads, forces = tuple[str, ...](), tuple[Item, ...]()
    if result is not None:
        of = loaded or joint
        loads = tuple(load_lines(of, result.forces))
        forces = tuple(free_bodies(of, result, middle=(0.0, 0.0), room=_ROOM_OF_FORCES, scale=1.0))
    contents = _Contents(
        joint,
        sizes(joint, 1.0, interference, bodies),
        drive_clearances(joint),
        interference,
        stated,
        loads,
        forces,
        section,
    )
    view, placed, names, arranged = _view(contents)
    if section and forces:  # both, unless the sheet is smaller without the section
        without = contents._replace(section=False)
        other = _view(without)
        if other[3].paper.width < arranged.paper.width:
            contents, (view, placed, names, arranged) = without, other
    paper, scale = arranged.paper, arranged.paper.scale
    notes = arranged.note_items()
    front = [*view, *placed.items, *names]
    groups: list[list[Item]] = [front]
    measured = list(placed.measured)
    if contents.section:
        cut, lengths = _section_items(contents, scale, paper.at(*arranged.origins[0])[0])
        groups.append(cut)
        measured += lengths
    if forces:
        groups.append(_on_paper(forces, paper, arranged.origins[-1]))
    groups.append(notes)
    items = [item for group in groups for item in group]
    items += paper.block(_kind(joint), name, title or Title())
    return Sheet(
        paper.width,
        paper.height,
        scale,
        paper.middle,
        tuple(items),
        tuple(measured),
        (*(paper.boxed(group) for group in groups if group), paper.title_box),
    )


def _view(contents: _Contents) -> tuple[list[Item], Dimensions, list[Item], Arrangement]:
    """The view with its dimensions and the names of its contacts, and the sheet that has room for it.

    What finds no room in the view is listed, and the list needs room itself.
    """
    joint, letters, front = contents.joint, contents.letters, int(contents.section)
    said = dict(enumerate(letters))
    outlined = _extent(drive_view(joint, 1.0))
    arranged, listed = max(
        ((_arranged(contents, listed, said), listed) for listed in _first_listed(contents)),
        key=lambda each: each[0].paper.scale,
    )
    for _ in range(2 * (len(contents.sizes) + len(contents.clearances)) + 2):
        scale = arranged.paper.scale
        marks = cutting_marks(joint, scale) if contents.section else []
        view = [*drive_view(joint, scale), *marks]
        room = arranged.paper.box(arranged.boxes[front])
        taken = Taken(scale, room)
        taken.add_areas(marks)
        names = write_contact_names(joint, view, taken)
        placed = place_dimensions(
            sizes(joint, scale, contents.interference, contents.bodies),
            contents.clearances,
            [item for item in view if isinstance(item, Circle) and item.style == "outline"],
            view=around_all([outlined, *(box_of(mark, scale) for mark in marks)])._replace(
                left=outlined.left, right=outlined.right
            ),
            paper=room,
            taken=taken,
            listed=listed,
            letters=letters,
        )
        if not placed.unplaced and placed.letters == said:
            break
        listed, said = listed | placed.unplaced, placed.letters
        arranged = _arranged(contents, listed, said)
    return view, placed, names, arranged


def _first_listed(contents: _Contents) -> list[frozenset[int]]:
    """Sizes that may be listed from the start: those without a place; of a page of a report long ones too."""
    nowhere = frozenset(number for number, size in enumerate(contents.sizes) if not size.places)
    if not contents.is_plain:
        return [nowhere]
    long = (number for number, size in enumerate(contents.sizes) if text_width(size.label) > _LONG_LABEL)
    return [nowhere, nowhere | frozenset(long)]


def _arranged(contents: _Contents, listed: frozenset[int], said: dict[int, str]) -> Arrangement:
    """The sheet for a drive with what is listed and the letters of its clearances."""
    outlined = _extent(drive_view(contents.joint, 1.0))
    return arrange(
        functools.cache(functools.partial(_rooms, contents, listed)),
        contents.lines(listed, said),
        origin=int(contents.section),
        what="the drive",
        size=max(outlined.width, outlined.height),
        formats=FORMATS[1:] if contents.is_plain else FORMATS,
        filled=not contents.is_plain,
    )


def _rooms(contents: _Contents, listed: frozenset[int], scale: float) -> list[Room]:
    """The rooms of section, view and forces at a scale."""
    joint = contents.joint
    marks = cutting_marks(joint, scale) if contents.section else []
    outlined = _extent(drive_view(joint, 1.0))
    around = _on_room([outlined, *(box_of(mark, scale) for mark in marks)], scale)
    left, right, below = room_of_dimensions(
        contents.sizes, contents.clearances, listed, right=outlined.right, scale=scale
    )
    rooms = [
        Room(
            Box(
                min(around.left, scale * outlined.left - max(left, _BEYOND_AXES)),
                max(around.right, scale * outlined.right + max(right, _BEYOND_AXES)),
                min(around.low - below, scale * outlined.low - _BEYOND_AXES),
                max(around.high, scale * outlined.high + _BEYOND_AXES),
            ),
            (scale * outlined.width, scale * outlined.height),
        )
    ]
    if contents.section:
        cut, _ = _section_items(contents, scale, 0.0)
        along = drive_section(joint, scale)
        size = scale * along.width, scale * (along.height + along.depth)
        rooms.insert(0, Room(_on_room([box_of(item, scale) for item in cut], scale), size))
    if contents.forces:
        box = around_all(box_of(item, 1.0) for item in contents.forces)
        rooms.append(Room(box, level=False))
    return rooms


def _on_room(boxes: Sequence[Box], scale: float) -> Box:
    """The box around boxes, on paper [mm]."""
    return Box(*(scale * edge for edge in around_all(boxes)))


def _extent(view: Sequence[Item]) -> Box:
    """The box around the outlines of a view."""
    return around_all(
        box_of(item, 1.0)
        for item in view
        if not isinstance(item, Text) and item.style in ("outline", "break")
    )


def _section_items(contents: _Contents, scale: float, x: float) -> tuple[list[Item], list[Dimension]]:
    """The section that begins at a place along the axis [mm], with its name and lengths."""
    lengths = None if contents.stated is None else contents.stated.lengths
    along = drive_section(contents.joint, scale, lengths)
    items, measured = draw_section(along, x, low=-along.depth - 2.0 / scale, scale=scale)
    caption = f"{LETTER}–{LETTER}" + (" developed" if is_bent(cutting_path(contents.joint)) else "")
    middle, above = x + 0.5 * along.width, along.height + 3.0 / scale
    items.append(Text((middle, above), caption, "center", TITLE_HEIGHT))
    return [*items, *(item for dimension in measured for item in dimension.items)], measured


def _on_paper(items: Sequence[Item], paper: Paper, origin: Point) -> list[Item]:
    """What is drawn in mm of paper about an origin on it, in true size."""

    def at(point: Point) -> Point:
        return paper.at(origin[0] + point[0], origin[1] + point[1])

    moved: list[Item] = []
    for item in items:
        if isinstance(item, Circle):
            moved.append(Circle(at(item.centre), item.radius / paper.scale, item.style))
        elif isinstance(item, Line):
            moved.append(Line(tuple(map(at, item.points)), item.style, item.arrows))
        else:
            moved.append(Text(at(item.at), item.text, item.align, item.height))
    return moved


def forces_sheet(joint: Joint, result: JointResult) -> Sheet:
    """The forces on the bodies of one sector, or of all that differ, as a picture of its own."""
    items = free_bodies(joint, result, middle=(0.0, 5.0), room=166.0, scale=1.0)
    box = around_all(box_of(item, 1.0) for item in items)
    wider = max(0.0, -84.0 - box.left)
    higher = max(0.0, box.height - 108.0)
    for row, line in enumerate(load_lines(joint, result.forces)):
        items.append(Text((-82.0, -56.0 - 0.5 * higher - SPACING * row), line))
    return Sheet(170.0 + wider, 140.0 + higher, 1.0, (85.0 + wider, 68.0 + 0.5 * higher), tuple(items))


def _kind(joint: Joint) -> str:
    words = TYPES[joint.type].words
    return f"{words[0].upper()}{words[1:]} traction drive"

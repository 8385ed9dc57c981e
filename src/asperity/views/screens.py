"""What a command, a notebook and the page show of a solved joint, in its order."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.results.margins import margins
from asperity.views.blocks import Block, BlockDocument, Figures, Heading, block_documents
from asperity.views.branches import branches
from asperity.views.headline import headline
from asperity.views.heat import heat
from asperity.views.joint import (
    assumed,
    contact_forces,
    contacts,
    drive,
    key_figures,
    load,
    surfaces,
    verdict,
)
from asperity.views.limits import margins as margins_shown
from asperity.views.limits import warnings
from asperity.views.numbers import words
from asperity.views.rolling import films, rolling
from asperity.views.solved_view import SolvedView
from asperity.views.stiffness import budget, stiffness


def opening(view: SolvedView, source: str) -> Iterator[Block]:
    """Name of the joint, its load, its verdict, and the numbers that are asked for first."""
    kind = view.document["input"].get("type")
    yield Heading(source if kind is None else f"{source}: {words(kind)} drive")
    yield load(view)
    yield verdict(view.document)
    yield Figures(key_figures(view))


def joint_screen(view: SolvedView, source: str, *, in_full: bool = True) -> Iterator[Block]:
    """The joint that stands under its torque; in brief without shares, springs and the drive."""
    yield from opening(view, source)
    yield from stiffness(view, in_full=in_full)
    if in_full:
        yield from budget(view.document)
        yield from contacts(view)
        yield drive(view)
        yield from surfaces(view.document)
    else:
        yield from contact_forces(view)
    yield from closing(view)


def rolling_screen(view: SolvedView, source: str) -> Iterator[Block]:
    """The joint that turns."""
    yield from opening(view, source)
    yield from rolling(view)
    yield from closing(view)


def closing(view: SolvedView) -> Iterator[Block]:
    """What its branches do, and the limits that it crosses."""
    if "branches" in view.document:
        yield from branches(view.document["branches"])
    yield warnings(view.document)


def page_views(view: SolvedView) -> dict[str, list[BlockDocument]]:
    """The blocks of each panel of the page, by the name of the panel."""
    document = view.document
    unequal = list(branches(document["branches"])) if "branches" in document else []
    panels: dict[str, list[Block]] = {
        "headline": [Figures(headline(document))],
        "cards": [Figures(key_figures(view))],
        "levels": list(stiffness(view)),
        "budget": list(budget(document)),
        "numbers": [drive(view)],
        "margins": list(margins_shown(margins(view.solved))),
        "warnings": [warnings(document)],
        "contacts": [
            *contacts(view),
            *view.contact_table("rolling", "Contacts in rolling"),
            *films(document),
            *view.contact_table("film", "Oil film and asperities"),
            *surfaces(document),
            *unequal,
        ],
        "heat": list(heat(document)),
        "assumptions": [assumed(document)],
    }
    return {name: block_documents(blocks) for name, blocks in panels.items()}

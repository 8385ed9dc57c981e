"""The joint that turns: drift beside stiffness, losses, contacts, films, thrust and life."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.results.film_bands import BANDS, surface_rows
from asperity.rolling.document import rating_life_name
from asperity.types import Document
from asperity.views.blocks import Block, Bullets, Figure, Paragraph, Table
from asperity.views.heat import heat
from asperity.views.joint import input_member
from asperity.views.numbers import number, percent, quantity, sentence, words
from asperity.views.position import position_rows
from asperity.views.solved_view import SolvedView

_CAUSES = ("creep", "skew", "hysteresis", "oil")


def rolling(view: SolvedView) -> Iterator[Block]:
    """Drift, losses, contacts, thrust and life, and why numbers are absent."""
    document = view.document
    turning = document["rolling"]
    yield Table(
        "Position of the output: drift beside stiffness",
        ("quantity", "value", "what it is"),
        [(label, quantity(value, unit), meaning) for label, value, unit, meaning in position_rows(document)],
        words=(0, 2),
    )
    if turning["losses_W"]["total"] is not None:
        yield _losses(turning, has_bearings="bearings" in document["input"])
    if turning["unknown_because"]:
        yield Bullets([sentence(reason) for reason in turning["unknown_because"]])
    yield from view.contact_table("rolling", "Contacts in rolling")
    yield from _sliding(document)
    yield from films(document)
    yield from view.contact_table("film", "Oil film and asperities")
    yield from heat(document)
    yield from _thrust(document)
    yield from _life(view)


def _losses(turning: Document, *, has_bearings: bool) -> Table:
    """Losses by contact and cause; a dash for what the file leaves out."""
    rows = [
        (
            words(name),
            *(number(contact["losses_W"][cause]) for cause in _CAUSES),
            number(contact["losses_W"]["total"]),
        )
        for name, contact in turning["contacts"].items()
    ]
    sums = turning["losses_W"]
    rows.append(
        ("bearings and pins", *("" for _ in _CAUSES), number(sums["bearings"] if has_bearings else None))
    )
    rows.append(("all", *(number(sums[cause]) for cause in _CAUSES), number(sums["total"])))
    title = (
        f"Losses; efficiency {percent(turning['efficiency'])}, power in {quantity(turning['input_power_W'], 'W')}, out "
        f"{quantity(turning['output_power_W'], 'W')}"
    )
    return Table(title, ("losses of", *(f"{cause}\nW" for cause in _CAUSES), "sum\nW"), rows)


def _sliding(document: Document) -> Iterator[Paragraph]:
    """Contacts that slip as a whole because skew uses a part of their friction."""
    friction = {
        entry["contact"]: entry["value"]
        for entry in document["diagnostics"]
        if entry["name"] == "friction_coefficient"
    }
    sliding = [
        words(name)
        for name, contact in document["rolling"]["contacts"].items()
        if contact["capacity_loss"] is not None
        and abs(contact["traction_coefficient"] or 0.0) > friction[name] * (1.0 - contact["capacity_loss"])
    ]
    if sliding:
        yield Paragraph(
            f"{', '.join(sliding)}: slips as a whole, because skew uses part of the friction; the rest of the traction "
            "takes the large creepage above."
        )


def films(document: Document) -> Iterator[Block]:
    """Flash temperature and oil film, where the file has the numbers for one of them."""
    contacts = document["rolling"]["contacts"]
    factors = {name: contact["life_factor"] for name, contact in contacts.items()}
    stated = "life" in document["input"]
    rows = [
        (
            words(name),
            *(number(value) for value in numbers),
            band or "–",
            *([number(factors[name])] if stated else []),
        )
        for name, *numbers, band in surface_rows(contacts)
    ]
    head = ["contact", "flash temperature\nK", "smallest oil film\nµm", "film ratio λ\n-", "lubrication"]
    if rows:
        factor = ["film factor\nof the life"] if stated else []
        yield Table("Surfaces in rolling", (*head, *factor), rows, words=(0, 4))
    if any(band for *_, band in surface_rows(contacts)):
        yield Paragraph(BANDS)


def smallest_film(document: Document) -> list[Figure]:
    """The smallest film ratio of the contacts and who carries the load there; none where no film is known."""
    known = [row for row in surface_rows(document["rolling"]["contacts"]) if row[3] is not None]
    if not known:
        return []
    name, _, _, ratio, band = min(known, key=lambda row: float(row[3] or 0.0))
    return [
        Figure("Film ratio λ, smallest", number(ratio), "", f"{band} lubrication, at {words(name)}", ratio)
    ]


def _thrust(document: Document) -> Iterator[Block]:
    turning = document["rolling"]
    axial = {name: contact["axial_force_N"] for name, contact in turning["contacts"].items()}
    skewed = (document["input"].get("rolling") or {}).get("skew")
    if not any(axial.values()) and not (skewed and None in axial.values()):
        yield Paragraph("Axial thrust: none, the axes are parallel.")
        return
    for title, forces in (
        ("Axial force of each contact on its driven body", axial),
        ("Axial thrust on each body", turning["axial_thrust_N"]),
    ):
        yield Table(
            title,
            ("part", "axial force\nN"),
            [(words(name), number(force)) for name, force in forces.items()],
        )


def _life(view: SolvedView) -> Iterator[Block]:
    document = view.document
    on_axis = {body.name for body in view.solved.joint.drive.bodies if body.on_axis}
    turning, loads = document["rolling"], document["input"].get("duty", {})
    rows = [("the drive", number(turning["life_hours"]), number(turning["life_output_turns"]))]
    for name, hours in turning["body_life_hours"].items():
        alone = document["of_own_branches"] or name in on_axis
        one = "" if alone else "one "
        rows.append((one + words(name), number(hours), number(turning["body_life_output_turns"][name])))
    if loads:
        duty = number(turning["duty_life_hours"]), number(turning["duty_life_output_turns"])
        rows.append(("the drive under the duty", *duty))
    title = rating_life_name(float(turning["reliability"]), with_film="life" in document["input"])
    yield Table(title, ("life of", "life\nh", "life\noutput turns"), rows)
    required = [
        _required(entry) for entry in document["diagnostics"] if entry["name"].startswith("required_")
    ]
    if required:
        yield Bullets(required)
    if turning["no_life_because"]:
        yield Paragraph(sentence(turning["no_life_because"]))
    if loads:
        yield _duty(document, loads)


def _required(entry: Document) -> str:
    """Whether the drive or a bearing lives as long as required."""
    verdict = ": met" if entry["ok"] else ": NOT met" if entry["known"] else f"; {entry['meaning']}"
    where = f", {words(entry['contact'])}" if entry["contact"] else ""
    return f"{entry['label']}{where} {entry['shown']}, required {entry['limit_shown']}{verdict}"


def _duty(document: Document, loads: Document) -> Table:
    head = (
        "load",
        "output torque",
        input_member(document),
        "share\nof time",
        "share\nof damage",
        "life under this\nload alone, h",
    )
    rows = []
    for name, load in loads.items():
        of_load = document["rolling"]["duty"][name]
        rows.append(
            (
                name,
                quantity(load["output_torque"], "N*m"),
                quantity(load["sun_speed"], "rpm"),
                percent(load["share"]),
                percent(of_load["damage_share"]),
                number(of_load["life_hours"]),
            )
        )
    return Table("Duty, damage summed by Miner's rule", head, rows)

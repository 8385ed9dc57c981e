"""The joint that stands under its torque: its load, verdict, stiffness, contacts, sizes and assumptions."""

from __future__ import annotations

import math

from asperity.joint.pin_bound import bounded
from asperity.joint.temperature_limits import limit_words
from asperity.joint.torque_limits import first_slip_words, standing_words
from asperity.joint_file.part_names import drive_type_of
from asperity.types import Document
from asperity.views.blocks import Block, Bullets, Figure, Heading, Paragraph, Table
from asperity.views.heat import temperature_figure
from asperity.views.numbers import number, number_in, percent, quantity, unit_words, words
from asperity.views.solved_view import SolvedView

Rows = list[tuple[str, str]]


def input_member(document: Document) -> str:
    """Name of the member that drives, in words, such as "sun"."""
    return words(document["geometry"]["input"])


def verdict_words(verdict: Document) -> str:
    """The verdict of a document in sentences, and of the requirements that are met the one with the tightest margin."""
    nearest = verdict["nearest"]
    tightest = "" if nearest is None else f" Tightest margin: {nearest['words']}."
    return f"{verdict['title']}: {verdict['words']}{tightest}"


def load(view: SolvedView) -> Paragraph:
    """For which load the numbers hold: speed, preload, torque, temperature, cam."""
    document = view.document
    preload, sectors = document["preload"], drive_type_of(document["input"]).sectors
    size = "" if sectors is None else f"{sectors.words_of(number(document['geometry']['sectors']))}, "
    parts = [
        f"{size}{input_member(document)} at {quantity(document['input_speed_rad_per_s'], 'rpm')}",
        f"preload {quantity(preload['force_N'], 'N')}"
        + (f" ({approach} {_short(preload['interference_m'])})" if (approach := _approach(document)) else ""),
        f"output torque {quantity(document['input']['load']['output_torque'], 'N*m')}",
    ]
    return Paragraph(
        "; ".join([", ".join(parts), *_temperatures(preload), *_loading_cam(preload)]), strong=True
    )


def _approach(document: Document) -> str:
    """What the length is called that makes the preload; empty where none does."""
    return drive_type_of(document["input"]).approach(document["input"]["drive"])


def _short(size: float | None) -> str:
    """A length in micrometres, above one millimetre in millimetres."""
    return quantity(size, "mm" if size is not None and size >= 1e-3 else "um")


def _temperatures(preload: Document) -> list[str]:
    """Working temperature of a joint with its preload at the assembly, and where it would get loose."""
    assembled, limits = preload["at_assembly"], limit_words(preload["temperature_limits"])
    if assembled is None:
        return limits
    return [
        f"at {quantity(assembled['working_temperature_degC'], 'degC')}, assembled at "
        f"{quantity(assembled['temperature_degC'], 'degC')} with {quantity(assembled['force_N'], 'N')} "
        f"({_short(assembled['interference_m'])})",
        *limits,
    ]


def _loading_cam(preload: Document) -> list[str]:
    """What a loading cam does."""
    cam = preload["loading_cam"]
    if cam is None:
        return []
    return [
        f"loading cam: {quantity(cam['least_preload_N'], 'N')} plus "
        f"{quantity(cam['force_per_torque_N_per_Nm'], 'N/Nm')}, angle {quantity(cam['angle_rad'], 'arcmin')} at the "
        "output"
    ]


def verdict(document: Document) -> Paragraph:
    """Whether the joint works, and what limits it."""
    said = document["verdict"]
    passed = None if None in (said["works"], said["holds"]) else said["works"] and said["holds"]
    return Paragraph(verdict_words(said), strong=True, passed=passed)


def key_figures(view: SolvedView) -> list[Figure]:
    """Stiffness, drift, capacity, efficiency, life, size and ratio of a joint."""
    document = view.document
    rolling, geometry = document["rolling"], document["geometry"]
    why_not = "; ".join(_clause(reason) for reason in rolling["unknown_because"])
    lives = [
        f"{number(rolling['life_output_turns'])} output turns",
        f"{number(100.0 * rolling['reliability'])} % reliability",
    ]
    return [
        _stiffness_figure(document),
        Figure(
            "Drift per output turn",
            number_in(document["drift_rad_per_output_turn"], "arcmin"),
            "arcmin",
            why_not
            if document["drift_rad_per_output_turn"] is None
            else f"{percent(document['speed_loss'])} of the speed: creep, which does not come back",
            document["drift_rad_per_output_turn"],
        ),
        _capacity_figure(document),
        Figure(
            "Efficiency",
            number(document["efficiency"], 100.0),
            "%",
            why_not
            if document["efficiency"] is None
            else f"loss {quantity(document['losses_W']['total'], 'W')}",
            document["efficiency"],
        ),
        Figure(
            "Life",
            number(document["life_hours"]),
            "h",
            (rolling["no_life_because"] or "").partition(", and ")[0].partition(";")[0]
            or (why_not if rolling["life_output_turns"] is None else ", ".join(lives)),
            None if document["life_hours"] is None else 3600.0 * document["life_hours"],
        ),
        *temperature_figure(document),
        Figure("Mass", number(document["mass_kg"]), "kg", "of the rolling parts", document["mass_kg"]),
        Figure(
            "Outside diameter",
            number_in(document["envelope_diameter_m"], "mm"),
            "mm",
            "of the largest body",
            document["envelope_diameter_m"],
        ),
        Figure(
            "Speed ratio",
            number(geometry["speed_ratio"]),
            "",
            f"{words(geometry['input'])} over {words(geometry['output'])}, {words(geometry['grounded'])} grounded",
            geometry["speed_ratio"],
        ),
    ]


def _stiffness_figure(document: Document) -> Figure:
    stiffness = document["torsional_stiffness"]["assembly"]
    said = bounded("assembled", document["stiffness_bound"])
    return Figure(
        "Stiffness at the output",
        number(stiffness["output_Nm_per_arcmin"]),
        "N·m/arcmin",
        document["stiffness_unknown_because"] or f"{number(stiffness['output_Nm_per_rad'])} N·m/rad, {said}",
        stiffness["output_Nm_per_rad"],
    )


def _capacity_figure(document: Document) -> Figure:
    """The torque capacity in the direction of the torque, what limits it, and where the joint that stands slips."""
    capacity, standing = (
        in_its_direction(document, document["torque_capacity"]),
        in_its_direction(document, document["standing_torque_capacity"]),
    )
    torque = capacity["output_torque_Nm"]
    same = torque is not None and torque == standing["output_torque_Nm"]
    parts = [capacity["meaning"], "" if same else standing_words(standing)]
    return Figure("Torque capacity", number(torque), "N·m", "; ".join(filter(None, parts)), torque)


def in_its_direction(document: Document, both: Document) -> Document:
    """The one of both capacities of a document that is in the direction of its output torque."""
    reverse: Document = both["reverse"]
    return reverse if document["standing"]["forces"]["output_torque_Nm"] < 0.0 else both


def contacts(view: SolvedView) -> list[Table]:
    """Forces, pressures and stiffness of the contacts that stand under the torque."""
    return [
        *contact_forces(view),
        *view.contact_table("crowns", "Crowned contacts"),
        *view.contact_table("stiffness", "Contact stiffness"),
    ]


def contact_forces(view: SolvedView) -> list[Table]:
    """Forces and pressures of the contacts that stand under the torque."""
    return view.contact_table("forces", "Contact forces at standstill, under the torque")


def drive(view: SolvedView) -> Table:
    """Members, torques, capacities, strength and masses of a drive."""
    document = view.document
    forces, rolling = document["standing"]["forces"], document["rolling"]
    rows = [
        *_members(document),
        ("torque at the output", quantity(forces["output_torque_Nm"], "N*m")),
        # the balance of forces knows no losses of rolling contacts; a motor has to overcome them too
        ("torque at the input, without losses in rolling", quantity(forces["input_torque_Nm"], "N*m")),
        ("torque at the input in rolling, all losses counted", quantity(rolling["input_torque_Nm"], "N*m")),
        ("torque capacity", capacity_text(document["torque_capacity"])),
        ("torque capacity, standing", capacity_text(document["standing_torque_capacity"])),
        *(("first slip, standing", text) for text in first_slip_words(document["standing_torque_capacity"])),
        ("torque capacity, rolling", capacity_text(document["rolling"]["torque_capacity"])),
        *_pins(forces),
        *_strength(document),
        *((f"mass, {words(name)}", quantity(mass, "g")) for name, mass in forces["body_mass_kg"].items()),
        *_clearance(document["geometry"]),
    ]
    if view.made_interference is not None:
        cold = ", at the assembly temperature" if document["input"].get("temperature") else ""
        rows.append((f"{_approach(document)} to be made{cold}", _short(view.made_interference)))
    return Table("Drive", ("quantity", "value"), rows, words=(0, 1))


def _members(document: Document) -> Rows:
    geometry = document["geometry"]
    roles = ", ".join(f"{words(geometry[role])} {said}" for role, said in _ROLES.items())
    rows = [
        ("members", roles),
        ("speed of the output", quantity(document["standing"]["forces"]["output_speed_rad_per_s"], "rpm")),
    ]
    rows += [(label, quantity(geometry[key], "deg")) for key, label in _ANGLES.items() if key in geometry]
    return rows


_ROLES = {"input": "in", "output": "out", "grounded": "grounded"}
_ANGLES = {
    "alpha_rad": "angle alpha between planet and loading roller",
    "theta_rad": "direction theta from planet to loading roller",
    "wedge_angle_rad": "wedge angle beta",
}


def _pins(forces: Document) -> Rows:
    return [
        (
            f"force on the pin, {words(name)}",
            f"radial {quantity(force['radial'], 'N')}, tangential {quantity(force['tangential'], 'N')}, standing",
        )
        for name, force in forces["pin_N"].items()
    ]


def _strength(document: Document) -> Rows:
    """Lives of rated bearings, and safeties of the bodies that bend."""
    lives = [
        (f"bearing life L10, {words(bearing['bearing'])}", _hours(bearing["life_hours"]))
        for bearing in document["bearings"]
    ]
    safeties = [
        (
            f"rim of the {words(name)}",
            f"yield safety {number(rim['yield_safety'])}"
            + ("" if rim["fatigue_safety"] is None else f", fatigue safety {number(rim['fatigue_safety'])}"),
        )
        for name, rim in document["rims"].items()
    ]
    return [*lives, *safeties]


def _hours(hours: float | None) -> str:
    """A time in hours with its unit, a dash where there is none."""
    return number(hours) if hours is None else f"{number(hours)} h"


def _clearance(geometry: Document) -> Rows:
    gaps = [entry for entry in geometry["clearances"] if entry["gap_m"] is not None]
    if not gaps:
        return []
    gap = min(gaps, key=lambda entry: entry["gap_m"])
    return [("smallest clearance", f"{quantity(gap['gap_m'], 'mm')}, {words(gap['name'])}")]


def capacity_text(capacity: Document) -> str:
    """Torque capacity of both directions in words."""

    def one(entry: Document) -> str:
        torque = entry["output_torque_Nm"]
        return str(entry["meaning"]) if torque is None else f"{quantity(torque, 'N*m')}: {entry['meaning']}"

    reverse = capacity["reverse"]
    both = [entry["output_torque_Nm"] for entry in (capacity, reverse)]
    if both[0] == both[1] or (None not in both and math.isclose(*both, rel_tol=1e-9)):
        return f"{one(capacity)} (both directions)"
    return f"{one(capacity)}; reverse {one(reverse)}"


#: How the assumptions begin that are those of every joint.
OF_EVERY_JOINT = ("standing: ", "torque capacity, standing: ", "every track ", "rolling: steady", "life: ")


def assumptions(document: Document, *, brief: str = "") -> list[Block]:
    """The assumptions below a heading, which says how to see more where ``brief`` has it."""
    return [
        Heading(f"Assumptions ({brief})" if brief else "Assumptions"),
        assumed(document, in_full=not brief),
    ]


def assumed(document: Document, *, in_full: bool = True) -> Bullets:
    """What is assumed: in full, or by name what the file leaves out, and in a clause what is not so in every joint."""
    told = document["assumptions"]
    left_out = [] if in_full else [text for text in told if text.startswith("no ")]
    names = ", ".join(text.partition(":")[0].removeprefix("no ") for text in left_out)
    first = [f"not in the file: {names}"] if names else []
    if in_full:
        return Bullets([*first, *told])
    rest = [text for text in told if not (text in left_out or text.startswith(OF_EVERY_JOINT))]
    return Bullets([*first, *(_clause(text) for text in rest)])


def _clause(text: str) -> str:
    """What is said up to the first semicolon or full stop."""
    return text.partition(";")[0].partition(". ")[0]


def surfaces(document: Document) -> list[Table]:
    """The Ra that belongs to the D and G of every fractal surface."""
    rows = [
        (
            "all"
            if len(entry["contacts"]) == len(document["standing"]["contacts"])
            else ", ".join(entry["contacts"]),
            number(entry["fractal_dimension"]),
            number_in(entry["fractal_roughness_m"], "mm"),
            number_in(entry["cut_off_m"], "mm"),
            number_in(entry["roughness_average_m"], "um"),
            " to ".join(number_in(entry[f"roughness_average_{end}_m"], "um") for end in ("low", "high")),
        )
        for entry in document["surfaces"]
    ]
    micrometre = unit_words("um")
    head = ("contacts", "D\n-", "G\nmm", "cut-off\nmm", f"Ra\n{micrometre}", f"95 % measured\n{micrometre}")
    title = "Ra to which D and G correspond, on each of two like bodies, measured over five cut-offs"
    return [Table(title, head, rows)] if rows else []

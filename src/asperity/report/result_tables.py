"""The results of a joint and its surfaces as tables of a report, from its document."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from asperity.joint.pin_bound import bounded
from asperity.joint.temperature_limits import limit_words
from asperity.joint.torque_limits import first_slip_words
from asperity.report.content import Block, Paragraph, Table, number, percent, quantity
from asperity.results.document import (
    INTERVAL_HEADS,
    LAW_HEADS,
    NO_SHARE,
    budget_words,
    has_elastic_bodies,
    input_member,
    interval_rows,
    law_range_words,
    law_rows,
    level_words,
    stiffness_rows,
)
from asperity.results.windup_document import stages_title

Document = dict[str, Any]


def summary(document: Document) -> Table:
    """The numbers that are asked for first."""
    load = document["input"]["load"]
    stiffness = document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    rows = [
        _branches(document),
        ("output torque", quantity(load["output_torque"], "N*m")),
        (f"speed of the {input_member(document)}", quantity(document["input_speed_rad_per_s"], "rpm")),
        (
            f"preload, contact {next(iter(document['standing']['contacts']))}",
            quantity(document["preload"]["force_N"], "N"),
        ),
        ("interference giving this preload", quantity(document["preload"]["interference_m"], "um")),
        *_at_assembly(document),
        *_loading_cam(document),
        (
            bounded("torsional stiffness at the output, assembled", document["stiffness_bound"]),
            quantity(stiffness, "N*m/arcmin"),
        ),
        (
            "drift per output turn",
            quantity(document["drift_rad_per_output_turn"], "arcmin"),
        ),
        ("torque capacity", _capacity(document["torque_capacity"])),
        ("torque capacity, negative torques", _capacity(document["torque_capacity"]["reverse"])),
        ("standing torque capacity", _capacity(document["standing_torque_capacity"])),
        (
            "standing torque capacity, negative torques",
            _capacity(document["standing_torque_capacity"]["reverse"]),
        ),
        *(
            ("first slip, standing", words)
            for words in first_slip_words(document["standing_torque_capacity"])
        ),
        ("efficiency", percent(document["efficiency"])),
        ("rating life in hours", number(document["life_hours"])),
        ("rating life in turns of the output", number(document["rolling"]["life_output_turns"])),
    ]
    return Table("Summary", ("quantity", "value"), rows, words=(0, 1))


def _branches(document: Document) -> tuple[str, str]:
    """Name of the branches in this drive, and their number."""
    stated = document["input"]["drive"]
    for name in ("planets", "sectors"):
        if name in stated:
            return name, number(stated[name])
    return "rollers in each row", number(document["geometry"]["sectors"])


def _at_assembly(document: Document) -> list[tuple[str, str]]:
    """Temperatures of a joint whose preload or seats change with them."""
    assembled = document["preload"]["at_assembly"]
    limits = [
        ("limit of temperature", words) for words in limit_words(document["preload"]["temperature_limits"])
    ]
    if assembled is None:
        return limits
    return [
        ("working temperature", quantity(assembled["working_temperature_degC"], "degC")),
        ("temperature at the assembly", quantity(assembled["temperature_degC"], "degC")),
        ("preload at the assembly", quantity(assembled["force_N"], "N")),
        ("interference at the assembly", quantity(assembled["interference_m"], "um")),
        *limits,
    ]


def _loading_cam(document: Document) -> list[tuple[str, str]]:
    """Numbers of a loading cam."""
    cam = document["preload"]["loading_cam"]
    if cam is None:
        return []
    return [
        ("preload without torque", quantity(cam["least_preload_N"], "N")),
        ("loading cam, force per torque", quantity(cam["force_per_torque_N_per_Nm"], "N/Nm")),
        ("angle of the loading cam at the output", quantity(cam["angle_rad"], "arcmin")),
    ]


def _capacity(entry: Document) -> str:
    torque = entry["output_torque_Nm"]
    return entry["meaning"] if torque is None else f"{quantity(torque, 'N*m')}: {entry['meaning']}"


def stiffness(document: Document) -> Iterator[Block]:
    """Stiffness on every level, and the budget of the compliance."""
    keys = ("input_Nm_per_rad", "output_Nm_per_rad", "output_Nm_per_arcmin")
    yield Table(
        "Torsional stiffness",
        ("level of the model", f"{input_member(document)}\nN·m/rad", "output\nN·m/rad", "output\nN·m/arcmin"),
        [(words, *(number(level[key]) for key in keys)) for words, level in stiffness_rows(document)],
    )
    if document["stiffness_unknown_because"]:
        yield Paragraph(f"No value: {document['stiffness_unknown_because']}.")
    if "pin_clearance_interval" in document:
        yield Paragraph(f"{document['pin_clearance_interval']['words']}.")
    if words := law_range_words(document):
        yield Paragraph(f"{words[0].upper()}{words[1:]}.")
    if laws := law_rows(document, number):
        yield Table("Contact laws side by side", LAW_HEADS, laws, words=(0, 4))
    shares = []
    for name, share in document["stiffness_budget"].items():
        words = name.removesuffix("_share").replace("_", " ")
        parts = share if isinstance(share, dict) else {"": share}
        shares += [
            (f"{place} {words}".strip(), value)
            for place, value in parts.items()
            if value and abs(value) > NO_SHARE
        ]
    shares.sort(key=lambda entry: -entry[1])
    if not shares:
        return
    yield Table(
        "Stiffness budget: shares of the compliance of the assembled joint",
        ("spring", "share %"),
        [(words, number(value, 100.0)) for words, value in shares],
    )
    note = budget_words((share for _, share in shares), elastic_bodies=has_elastic_bodies(document))
    if note:
        yield Paragraph(f"{note[0].upper()}{note[1:]}.")


def contacts(document: Document) -> Iterator[Block]:
    """Forces, pressures and stiffness of the contacts."""
    forces = document["standing"]["forces"]
    slip = {row["contact"]: row["value"] for row in document["diagnostics"] if row["name"] == "slip_ratio"}
    yield Table(
        "Contact forces at standstill, under the torque",
        (
            "contact",
            "normal\nN",
            "tangential\nN",
            "slip\nT/(mu N)",
            "Hertz width\nmm",
            "Hertz pressure\nMPa",
            "real area\nmm²",
        ),
        [
            (
                name,
                number(forces["normal_N"][name]),
                number(forces["tangential_N"][name]),
                number(slip.get(name)),
                number(contact["hertz_half_width_m"], 2e3),
                number(contact["hertz_pressure_Pa"], 1e-6),
                number(contact["real_contact_area_m2"], 1e6),
            )
            for name, contact in document["standing"]["contacts"].items()
        ],
    )
    if any(row.get("loaded_length_share") is not None for row in document["standing"]["contacts"].values()):
        yield _crowns(document["standing"]["contacts"])
    kinds = ("asperity_tangential", "bulk_tangential", "asperity_normal", "bulk_normal")
    yield Table(
        "Contact stiffness, N/µm",
        (
            "contact",
            "tangential,\nasperities",
            "tangential,\nbodies",
            "normal,\nasperities",
            "normal,\nbodies",
        ),
        [
            (name, *(number(contact[f"{kind}_stiffness_N_per_m"], 1e-6) for kind in kinds))
            for name, contact in document["standing"]["contacts"].items()
        ],
    )


def _crowns(crowned: Document) -> Table:
    """How the load of crowned contacts spreads along their lines."""
    return Table(
        "Crowned contacts",
        ("contact", "loaded length\n%", "peak over mean load", "end over mean load"),
        [
            (
                name,
                number(contact["loaded_length_share"], 100.0),
                number(contact["peak_line_load_ratio"]),
                number(contact["end_line_load_ratio"]),
            )
            for name, contact in crowned.items()
        ],
    )


def drive(document: Document) -> Iterator[Block]:
    """Ratio, torques and masses of a drive, a table."""
    geometry, forces = document["geometry"], document["standing"]["forces"]

    def words(name: str) -> str:
        return name.replace("_", " ")

    rows = [
        *((f"{role} member", words(geometry[role])) for role in ("input", "output", "grounded")),
        ("speed ratio, input over output", number(geometry["speed_ratio"])),
        ("speed of the output", quantity(abs(forces["output_speed_rad_per_s"]), "rpm")),
        # the balance of forces knows no losses of rolling contacts; a motor has to overcome them too
        ("torque at the input, without losses in rolling", quantity(forces["input_torque_Nm"], "N*m")),
        (
            "torque at the input in rolling, all losses counted",
            quantity(document["rolling"]["input_torque_Nm"], "N*m"),
        ),
        ("torque at the output", quantity(forces["output_torque_Nm"], "N*m")),
        *_wedge(geometry),
        *((f"mass of {words(name)}", quantity(mass, "g")) for name, mass in forces["body_mass_kg"].items()),
        *(
            (f"clearance, {words(gap['name'])}", quantity(gap["gap_m"], "mm"))
            for gap in geometry["clearances"]
            if gap["gap_m"] is not None
        ),
    ]
    yield Table("Drive", ("quantity", "value"), rows)


def _wedge(geometry: Document) -> list[tuple[str, str]]:
    """Angles of the wedges of a drive that has them."""
    labels = {
        "alpha_rad": "angle alpha between planet and loading roller",
        "theta_rad": "direction theta from planet to loading roller",
        "wedge_angle_rad": "wedge angle beta",
    }
    return [(label, quantity(geometry[key], "deg")) for key, label in labels.items() if key in geometry]


def windup(curves: Document) -> Iterator[Block]:
    """The figures of a wind-up, tables."""
    yield Paragraph(
        "At the output with the input locked, assembled stiffness, up to the output torque of the file."
    )
    rows = [
        ("largest torque of the curve", quantity(curves["largest_torque_Nm"], "N*m")),
        ("angle at plus the largest torque", quantity(curves["windup_rad"], "arcmin")),
        ("angle at minus the largest torque", quantity(-curves["reverse_windup_rad"], "arcmin")),
        ("hysteresis, width of the loop at zero torque", quantity(curves["hysteresis_rad"], "arcmin")),
        ("lost motion, between ±3 % of the torque", quantity(curves["lost_motion_rad"], "arcmin")),
        ("energy lost per cycle", f"{number(curves['dissipated_energy_J'])} J"),
    ]
    yield Table("Wind-up", ("quantity", "value"), rows)
    yield Table(
        stages_title(curves),
        ("stage", "from\nN·m", "to\nN·m", "N·m/rad", "negative torques\nN·m/rad"),
        [
            (
                stage["name"],
                number(stage["from_Nm"]),
                number(stage["to_Nm"]),
                number(stage["stiffness_Nm_per_rad"]),
                number(stage["reverse_stiffness_Nm_per_rad"]),
            )
            for stage in curves["stages"]
        ],
    )


def interval(document: Document) -> Iterator[Block]:
    """Interval of stiffness and drift over what is open of the surfaces, drawn or measured."""
    interval, ends = document.get("stiffness_interval"), ("low", "high")
    if interval is None:
        return
    yield Table(
        interval["title"],
        ("level of the model", "output from\nN·m/rad", "output to\nN·m/rad"),
        [
            (words, *(number(interval[level][f"{end}_Nm_per_rad"]) for end in ends))
            for level, words in level_words(document)
        ],
    )
    low, high = (quantity(interval["drift"][f"{end}_rad_per_output_turn"], "arcmin") for end in ends)
    yield Paragraph(f"Drift from {low} to {high} per output turn.")
    if rows := interval_rows(interval):
        yield Table("Asperities of the contacts in this interval", INTERVAL_HEADS, rows)
    yield Paragraph(interval["words"])


def averages(document: Document) -> Iterator[Table]:
    """The Ra that belongs to the D and G of every fractal surface."""
    rows = []
    for entry in document["surfaces"]:
        low, high = (number(entry[f"roughness_average_{end}_m"], 1e6) for end in ("low", "high"))
        rows.append(
            (
                "all"
                if len(entry["contacts"]) == len(document["standing"]["contacts"])
                else ", ".join(entry["contacts"]),
                number(entry["fractal_dimension"]),
                number(entry["fractal_roughness_m"], 1e3),
                number(entry["cut_off_m"], 1e3),
                number(entry["roughness_average_m"], 1e6),
                f"{low} to {high}",
            )
        )
    if rows:
        yield Table(
            "Ra to which D and G correspond, on each of two like bodies; 95 % of measurements over five cut-offs lie "
            "in the range",
            ("contacts", "D\n-", "G\nmm", "cut-off\nmm", "Ra\nµm", "measured Ra\nµm"),
            rows,
        )

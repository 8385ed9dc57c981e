"""``asperity crown``: which crown takes up a tilt of the rollers."""

from __future__ import annotations

from typing import Any

import click

from asperity.cli.terminal import about, json_option, prepare_computation, print_json, read_option

_NOTES = (
    "Drops are those of both bodies together; crowns of both add as 1/R. A crown on a roller acts in all its contacts: "
    "take the smallest radius. Pressures are those of slices: where an end carries load, its sharp edge has more, up "
    "to 2.6 times as much, which is why the recommended drops z leave the ends free. The logarithmic profile drops by "
    "A ln(1/(1 - (1 - exp(-z/A))(2y/B)^2)) at y from the middle of its length B.",
    "The tilt is the angle between the axes in the plane through both, by which a line opens at one end; rolling.skew "
    "is the angle across it, which moves rollers along their axes and loads no end.",
)


@click.command()
@click.argument("file", type=click.Path())
@click.option("--tilt", required=True, metavar="ANGLE", help="Angle between the axes, e.g. '0.5 mrad'.")
@json_option()
def crown(file: str, tilt: str, as_json: bool) -> None:
    """The crown radius and the logarithmic profile of every contact in FILE for a misalignment.

    Of the profiles that leave both ends of a tilted contact free, the one with the lowest peak pressure, under its
    largest normal force; with half and twice the drop at the ends for comparison, and as FILE crowns it.
    """
    from asperity.joint_file.reader import read_case
    from asperity.unit_table import Dimension

    angle = read_option("tilt", tilt, Dimension.ANGLE)
    case = read_case(file)
    prepare_computation()
    from asperity.joint_file.solved_document import solved_case
    from asperity.results.crown_document import crown_document

    with about(file):
        document = crown_document(solved_case(case), angle)
    if as_json:
        print_json(document)
    else:
        _show(document)


#: Columns of the tables: what is shown, and in how many of these units a metre, a pascal or a share is.
_COLUMNS = {
    "drop at ends\num": ("end_drop_m", 1e6),
    "radius\nmm": ("crown_radius_m", 1e3),
    "A\num": ("coefficient_m", 1e6),
    "peak pressure\nMPa": ("peak_pressure_Pa", 1e-6),
    "end over mean\n-": ("end_over_mean", 1.0),
}
_SHARES = {None: "", 0.5: ", half", 1.0: ", recommended", 2.0: ", double"}


def _show(document: dict[str, Any]) -> None:
    from asperity.cli.document_text import in_unit, print_wrapped, scaled
    from asperity.cli.terminal import console, show_table

    target, tilt = console(), in_unit(document["tilt_rad"], "mrad")
    for name, contact in document["contacts"].items():
        if not contact["profiles"]:
            print_wrapped(target, f"{name}: carries no force", indent=2)
            continue
        rows = (
            (
                entry["profile"].replace("_", " ") + _SHARES[entry["share_of_recommended"]],
                *(scaled(entry[key], factor) for key, factor in _COLUMNS.values()),
            )
            for entry in contact["profiles"]
        )
        force, length = in_unit(contact["normal_force_N"], "N"), in_unit(contact["contact_length_m"], "mm")
        show_table(target, f"{name}: {force} on {length}, tilt {tilt}", ("profile", *_COLUMNS), rows)
    for note in _NOTES:
        print_wrapped(target, note, indent=2)

"""``asperity joint``: from a joint file to its stiffness."""

from __future__ import annotations

import click


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--json", "as_json", is_flag=True, help="Print one JSON document in SI units instead of tables."
)
def joint(file: str, as_json: bool) -> None:
    """Forces, contacts, torsional stiffness and warnings of the joint described in FILE.

    FILE is a TOML file; 'asperity init' writes one with comments.
    """
    from asperity.case.reader import read_case

    case = read_case(file)
    from asperity.precision import use_compilation_cache, use_double_precision

    use_double_precision()
    use_compilation_cache()
    from asperity.case.build import joint_from_case
    from asperity.examination import examine
    from asperity.joint_document import joint_document

    document = joint_document(case=case, examination=examine(joint_from_case(case)))
    if as_json:
        import json

        click.echo(json.dumps(document, indent=2, allow_nan=False))
        return
    from asperity.cli.joint_table import show_joint
    from asperity.cli.terminal import console

    show_joint(console(), document, source=file)

"""``asperity schema``: the JSON schema of joint files, for editors."""

from __future__ import annotations

import click

#: Types of drives, the paper's first.
TYPES = ("zou2025", "planetary", "multiroller", "stepped_planet", "planar")


@click.command()
@click.option(
    "--type",
    "kind",
    type=click.Choice(TYPES),
    default=TYPES[0],
    show_default=True,
    help="Type of the drive.",
)
def schema(kind: str) -> None:
    """Print the JSON schema of joint files, which lets editors check and complete them.

    Save it next to the joint file and refer to it in the first line of that file: '#:schema ./joint.schema.json'.
    """
    import json

    from asperity.joint_file.schema import joint_schema

    click.echo(json.dumps(joint_schema(kind), indent=2))

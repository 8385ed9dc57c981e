"""``asperity schema``: the JSON schema of joint files, for editors."""

from __future__ import annotations

import click


@click.command()
def schema() -> None:
    """Print the JSON schema of joint files, with which editors check and complete them.

    Save it beside the joint file and name it in the file's first line: '#:schema ./joint.schema.json'.
    """
    import json

    from asperity.joint_file.schema import joint_schema

    click.echo(json.dumps(joint_schema(), indent=2))

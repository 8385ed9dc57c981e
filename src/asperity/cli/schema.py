"""``asperity schema``: the JSON schema of joint files, for editors."""

from __future__ import annotations

import click


@click.command()
def schema() -> None:
    """Print the JSON schema of joint files, which lets editors check and complete them.

    Save it next to the joint file and refer to it in the first line of that file: '#:schema ./joint.schema.json'.
    """
    import json

    from asperity.joint_file.schema import joint_schema

    click.echo(json.dumps(joint_schema(), indent=2))

"""``asperity export``: a joint as other programs read it."""

from __future__ import annotations

import click

from asperity.cli.run_by_name import run_by_name

#: Names of the targets; asperity.export.targets has their writers.
TARGETS = ("table", "mujoco", "fmu", "modelica")
LEVELS = ("assembly", "series_with_bulk", "published")


@click.command()
@click.argument("file", type=click.Path())
@click.option("--to", required=True, type=click.Choice(TARGETS), help="Program the file is for.")
@click.option(
    "--out",
    required=True,
    type=click.Path(dir_okay=False),
    help="Write to this file: table .csv or .mat (MATLAB), mujoco .xml, fmu .fmu, modelica .mo.",
)
@click.option(
    "--torque",
    help="Largest output torque of the export, with its unit, e.g. '10 N*m'; default: the file's output torque. "
    "Both directions are exported, so the sign does not matter.",
)
@click.option(
    "--level",
    type=click.Choice(LEVELS),
    default="assembly",
    show_default=True,
    help="Level of the stiffness that makes the wind-up.",
)
@run_by_name
def export() -> None:
    """Write the joint described in FILE for other programs: stiffness, hysteresis, play and drift.

    table: stiffness at three levels, wind-up, hysteresis loop and drift per output turn over the torque.

    mujoco: a model with motor and output, joined by a spring with the hysteresis of the wind-up (MuJoCo 4.0 or later).

    fmu: a co-simulation unit of FMI 2.0 in C source, with hysteresis, play, and drift while it turns. 'fmpy compile'
    adds the binary that most programs need.

    modelica: a package with a spring that has hysteresis and drift, alone and between two rotational flanges.

    Every file states the stiffness and the drift, which are two regimes: the wind-up of a joint that stands comes back,
    the drift of a joint that turns does not.
    """

"""Answers of the page as models, for their description in OpenAPI."""
# ruff: noqa: N815  # keys end in their units, as in documents

from __future__ import annotations

from typing import Literal, get_args

from pydantic import BaseModel, ConfigDict, Field

from asperity.types import Document
from asperity.views import blocks

Number = float | None

#: What can be downloaded of a joint, and its type: joint file, JSON document, report.
DOWNLOADS = {
    "toml": "application/toml",
    "json": "application/json",
    "html": "text/html; charset=utf-8",
    "pdf": "application/pdf",
}


class _Described(BaseModel):
    """An answer, whose model is made when it is asked for."""

    model_config = ConfigDict(defer_build=True)


class Error(_Described):
    """Why there is no other answer."""

    error: str = Field(description="The message of the command line.")
    kind: Literal["input", "no_solution", "busy", "refused", "failed"]
    keys: dict[str, str] = Field(
        description="Dotted path of a key of the joint file → what is wrong with it."
    )


class Value(_Described):
    """A number of a joint file."""

    value: float = Field(description="In the unit of the key's range.")
    si: float
    tolerance: float = Field(description="In SI; 0 where the file states none.")


class EnteredValue(Value):
    """A number of a joint file that no study varies."""

    text: str = Field(description="As the file has it.")


class Sections(_Described):
    """A list of sections of a joint file."""

    meaning: str
    keys: list[str] = Field(description="Of the numbers of each section, in their order.")
    words: dict[str, list[str]] = Field(description="Key of each section that is a word → words that fit.")
    one_for_each: str | None = Field(
        description="Dotted path of the number of sections that the list has to have; null for any number."
    )
    most: int = Field(description="Largest number of sections.")
    of_file: list[dict[str, str]] = Field(
        description="What each section of the file says, without the changes."
    )


class Stated(_Described):
    """What a joint file states."""

    name: str
    numbers: dict[str, Value] = Field(description="By dotted path.")
    entered: dict[str, EnteredValue] = Field(
        description="By dotted path: numbers that no study varies, an Rz and the shares of a duty."
    )
    lists: dict[str, Sections] = Field(description="By name: the sections [[duty]], [[branch]] and [[form]].")
    choices: dict[str, str]
    form: Document | None = Field(
        description="Groups of numbers and choices of another drive than the paper's; null for the paper's."
    )


class File(Stated):
    """A joint file that was opened."""

    toml: str = Field(description="Its text.")


class Block(_Described):
    """A part of what is shown, with the fields of its kind."""

    model_config = ConfigDict(extra="allow")

    kind: str = Field(json_schema_extra={"enum": [kind.__name__.lower() for kind in get_args(blocks.Block)]})


class Figure(_Described):
    """One number by which a joint is judged."""

    name: str
    shown: str = Field(description="As text, without its unit.")
    unit: str
    detail: str = Field(description="A few words on it.")
    si: Number


class Figures(_Described):
    """Key figures of a joint, without its torque capacity."""

    figures: list[Figure] = Field(description="Empty where the joint has no state under its torque.")


class CreepCurve(_Described):
    """Traction T/N over creepage, up to gross slip."""

    traction: list[Number]
    creepage: list[Number]


class Curves(_Described):
    """Results over the output torque."""

    torque_Nm: list[Number]
    published_Nm_per_rad: list[Number]
    series_with_bulk_Nm_per_rad: list[Number]
    assembly_Nm_per_rad: list[Number]
    drift_rad_per_output_turn: list[Number]
    efficiency: list[Number]
    total_loss_W: list[Number]
    life_hours: list[Number]
    life_output_turns: list[Number]
    largest_slip_ratio: list[Number]


class Windup(_Described):
    """The loop at the torque of the joint."""

    unknown_because: None
    hysteresis_rad: float
    lost_motion_rad: float
    dissipated_energy_J: float
    torque_Nm: list[Number]
    incremental_stiffness_Nm_per_rad: list[Number]
    loading_angle_rad: list[Number]
    unloading_angle_rad: list[Number]
    reloading_angle_rad: list[Number]


class NoWindup(_Described):
    """Why there is no wind-up."""

    unknown_because: str


class Answer(Stated):
    """A solved joint."""

    id: str = Field(description="For downloads.")
    document: Document = Field(description="As 'asperity joint FILE --json' prints it.")
    drawing: Document = Field(description="Circles and contact forces of the drive.")
    views: dict[str, list[Block]] = Field(description="What each panel of the page shows, by its name.")
    creep: dict[str, CreepCurve] = Field(description="By contact.")
    curves: Curves
    windup: Windup | NoWindup


class ResultOfChart(_Described):
    """A number that charts of a joint can show."""

    name: str
    label: str
    unit: str
    group: str
    design: dict[str, str] | None = Field(
        description="Name and label of the result for goals of designs; null if none."
    )


class Curve(_Described):
    """One curve of a chart."""

    value: Number = Field(description="Of the number that differs from curve to curve.")
    value_shown: str
    y: list[Number]
    y_shown: list[Number]
    status: list[int]


class Point(_Described):
    """The joint itself in a chart."""

    x: Number
    x_shown: Number
    y: Number
    y_shown: Number
    status: int = Field(description="0 is solved; the reasons say what others mean.")


class Chart(_Described):
    """Curves in SI units, and in those of displays."""

    over: str
    unit: str
    result: str
    result_label: str
    result_unit: str
    family: str | None
    x: list[Number]
    x_shown: list[Number]
    curves: list[Curve]
    joint: Point | None
    reasons: dict[str, str] = Field(description="What the statuses other than 0, which is solved, mean.")


class Comparison(_Described):
    """Sentences and tables."""

    parts: list[Block]
    all_parts: list[Block] = Field(description="With every result that differs.")
    document: Document


class Opened(_Described):
    """What an opened file is; its further entries are those of /api/file, the design, or those of /api/measure."""

    kind: Literal["joint", "design", "measurement"]


class Measurement(_Described):
    """A measured surface."""

    document: Document
    surface: Document | None = Field(
        description="For 'surfaces' of a request; null without spectrum and power law."
    )


class Job(_Described):
    """A job."""

    id: str
    kind: Literal["window", "film", "wear", "accuracy", "sensitivity", "uncertainty", "design"]
    name: str = Field(description="Name of the joint.")
    state: Literal["waiting", "running", "done", "failed", "stopped"]
    done: int
    total: int = Field(description="0 as long as it is not known.")
    seconds: float = Field(description="Since it began to run.")
    message: str = Field(description="Why it failed.")


class JobWithResult(Job):
    """A job, and what came out."""

    result: Document | None = Field(
        description="As the command of the same name prints it in JSON, with the blocks to be shown in 'views', and "
        "of an accuracy one turn of the output in 'over_turn'."
    )

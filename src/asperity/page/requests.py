"""Bodies of requests to the page as models: they check what arrives, describe it in OpenAPI, and say what is wrong."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self, TypeVar, Union

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator
from pydantic_core import ErrorDetails

from asperity.errors import InputError, quoted
from asperity.page.list_changes import ONE_PER_BRANCH
from asperity.surface.height_spectrum import Lay
from asperity.surface.measurement_of import MeasurementOf
from asperity.types import Document

Schema = Document

MOST_CHANGES = 600
LONGEST_VALUE = 200
LONGEST_NAME = 120
#: Points and curves of a chart, samples of an uncertainty.
MOST_POINTS, MOST_CURVES = 201, 5
FEWEST_SAMPLES, MOST_SAMPLES = 100, 1_000_000

Text = Annotated[str, Field(min_length=1, max_length=LONGEST_VALUE)]
_Path = Annotated[str, Field(max_length=LONGEST_VALUE)]
_Value = Annotated[str, Field(max_length=LONGEST_VALUE)] | int | float
_NotStated = Annotated[str, Field(max_length=40, description="Where the file does not say it.")]


class Body(BaseModel):
    """What a request says: of exactly these types, without further entries."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, defer_build=True)


class Request(Body):
    """A joint: the text of a joint file or its tables, with changes and measured surfaces."""

    model_config = ConfigDict(json_schema_extra={"oneOf": [{"required": ["toml"]}, {"required": ["joint"]}]})

    toml: str = Field("", description="The text of a joint file.")
    joint: Document = Field({}, description="The tables of a joint file; /api/schema is their schema.")
    changes: dict[_Path, _Value] = Field(
        {},
        max_length=MOST_CHANGES,
        description="Dotted path → value with its unit, or one of the words of a choice; empty to leave a key out. "
        "Name of a list → its sections as their places in the file, '1 3 0' with 0 for a new one, empty for none; for "
        f"'branch' also '{ONE_PER_BRANCH}', one for each branch of the drive: changes of sections beyond them wait. "
        "Sections are counted from 1 in the new arrangement.",
        examples=[
            {"load.output_torque": "6000 N*mm", "model.closure": "constant_pin_force"},
            {"branch": ONE_PER_BRANCH, "branch.2.planet_deviation": "2 um", "duty": "2"},
        ],
    )
    surfaces: list[Document] = Field(
        [],
        max_length=2,
        description="Documents of 'asperity surface measure --json' in place of the surfaces of the file: one, that of "
        "both bodies alike or, by its measurement_of, of the pair; or one of each.",
    )
    name: str = Field(
        "joint.toml",
        min_length=1,
        max_length=LONGEST_NAME,
        description="What messages and downloads call the joint.",
    )

    @model_validator(mode="after")
    def _in_one_way(self) -> Self:
        if bool(self.toml.strip()) == bool(self.joint):
            raise ValueError(
                "give the joint either as 'toml', the text of a joint file, or as 'joint', its tables"
            )
        return self


class Family(Body):
    """Another number of the joint file, a curve for each of its values."""

    over: Text
    values: list[Text] = Field(min_length=1, max_length=MOST_CURVES)


class AskedChart(Body):
    """Curves of a result over a number of the joint file."""

    model_config = ConfigDict(
        json_schema_extra={
            "examples": [
                {
                    "over": "load.preload",
                    "from": "200 N",
                    "to": "2 kN",
                    "result": "assembly_stiffness_output",
                }
            ]
        }
    )

    over: Text = Field(description="Dotted path of a number that the joint file states.")
    start: Text = Field(alias="from", description="With its unit.")
    stop: Text = Field(alias="to", description="With its unit.")
    points: int = Field(41, ge=2, le=MOST_POINTS)
    scale: Literal["linear", "log"] = Field(
        "linear", description="Even steps of the number or of its logarithm."
    )
    result: Text = Field(description="A name of /api/results: one result, with its row: slip_ratio_sp.")
    family: Family | None = None


class ChartRequest(Request):
    """A joint, and the chart that is wanted of it."""

    chart: AskedChart


class CompareRequest(Body):
    """Two joints."""

    one: Request
    other: Request


class WindowJob(Body):
    """The torques that the joint may pass over its temperature or its preload."""

    kind: Literal["window"]
    over: Literal["temperature", "preload"] | None = Field(
        None, description="null: temperature where the preload or a seat depends on it."
    )


class FilmJob(Body):
    """The oil in the contacts over the speed of the input."""

    kind: Literal["film"]


class WearJob(Body):
    """Wear over the years: when the first contact slides, and what is left until then."""

    kind: Literal["wear"]


class AccuracyJob(Body):
    """Transmission error over a turn of the output, of a joint that states form errors."""

    kind: Literal["accuracy"]
    reverse: bool = Field(False, description="The other direction of rotation, too.")


class SensitivityJob(Body):
    """The influence of every number of the joint file."""

    kind: Literal["sensitivity"]


class UncertaintyJob(Body):
    """Intervals of the results from tolerances."""

    kind: Literal["uncertainty"]
    samples: int = Field(1000, ge=FEWEST_SAMPLES, le=MOST_SAMPLES)
    seed: int = Field(0, ge=0, le=2**31)
    distribution: str = Field("", max_length=80, examples=["uniform", "normal 2 sigma"])


class DesignJob(Body):
    """The best joint within limits."""

    kind: Literal["design"]
    design: str = Field(description="Text of a design file; its joint is that of the request.")
    file: str = Field("design.toml", description="Name of the design file, for messages.")


AskedJob = Union[  # noqa: UP007  # pydantic names its members
    WindowJob, FilmJob, WearJob, AccuracyJob, SensitivityJob, UncertaintyJob, DesignJob
]


class JobRequest(Request):
    """A joint, and the job that is wanted of it."""

    job: AskedJob = Field(discriminator="kind")


class MeasurementQuery(Body):
    """What an address may say of a measured surface."""

    position_unit: _NotStated = ""
    height_unit: _NotStated = ""
    spacing: _NotStated = ""
    decimal: _NotStated = ""
    column: _NotStated = ""
    no_data: _NotStated = ""
    lay: Lay | None = Field(None, description="Grooves of a profile, which it crosses; a joint needs it.")
    direction: Literal["x", "y"] | None = Field(
        None, description="In which the contact rolls over a map; x if absent."
    )
    missing: Literal["refuse", "longest", "interpolate"] | None = Field(
        None, description="What happens with missing points."
    )
    measurement_of: MeasurementOf | None = Field(
        None,
        description="Of what it is: body, as both bodies of a contact then are, or pair, of both together.",
    )


_Body = TypeVar("_Body", bound=Body)


def checked(model: type[_Body], body: object) -> _Body:
    """A body as its model has it; an ``InputError`` with what is needed and what came, about the first mistake."""
    try:
        return model.model_validate(body)
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
    raise InputError(_sentence(first, model.model_json_schema()))


def _sentence(error: ErrorDetails, schema: Schema) -> str:
    """One mistake as 'entry: what is needed, what came'."""
    kind, value = error["type"], error["input"]
    if kind == "value_error":  # a sentence of a model of ours
        return ": ".join([*map(str, error["loc"]), str(error["ctx"]["error"])])
    if kind == "extra_forbidden":
        *above, name = error["loc"]
        path, there = _place(tuple(above), schema)
        where = f"{path}: " if path else ""
        return f"{where}unknown entry {quoted(name)}; known are {', '.join(there['properties'])}"
    if kind in ("union_tag_invalid", "union_tag_not_found"):
        path, there = _place(error["loc"], schema)
        tag = there["discriminator"]["propertyName"]
        stated, words = value.get(tag), ", ".join(there["discriminator"]["mapping"])
        return f"{path}.{tag}: {quoted(stated)} is not one of {words}"
    path, there = _place(error["loc"], schema)
    if kind == "literal_error":
        return f"{path}: {quoted(value)} is not one of {', '.join(_words(there))}"
    got = "it is missing" if kind == "missing" else f"got {_got(kind, value)}"
    return f"{path or 'the body'}: {_needed(there, schema)} is needed, {got}"


def _got(kind: str, value: Any) -> str:
    """What came: of what is too long only how long it is."""
    if kind == "string_too_long":
        return f"{len(value)} characters"
    return f"{len(value)} entries" if kind in ("too_long", "too_short") else quoted(value)


def _place(location: tuple[str | int, ...], schema: Schema) -> tuple[str, Schema]:
    """Dotted path of a place in a body, as messages call it, and the schema there.

    Changes are called by their own paths, which are those of the joint file; entries of a list are counted from 1.
    """
    path: list[str] = []
    above = there = schema
    for part in location:
        if part == "[key]":
            there = {"type": "string", **above["propertyNames"]}
            path[-1] = quoted(path[-1])
            continue
        for option in [_resolved(each, schema) for each in there.get("anyOf", [there])]:
            below = option.get("discriminator", {}).get("mapping", {}).get(part)
            if below is not None:
                there = _resolved({"$ref": below}, schema)
                break
            below = option.get("properties", {}).get(part) or (
                option.get("items") if isinstance(part, int) else option.get("additionalProperties")
            )
            if isinstance(below, Mapping):
                above, there = option, _resolved(dict(below), schema)
                path.append(str(part + 1 if isinstance(part, int) else part))
                break
    return ".".join(path[1:] if path[:1] == ["changes"] and len(path) > 1 else path), there


def _resolved(schema: Schema, root: Schema) -> Schema:
    """A schema, or that to which it refers."""
    name = schema.get("$ref", "").rpartition("/")[2]
    return root["$defs"][name] if name else schema


def _words(schema: Schema) -> list[str]:
    """Words of a choice."""
    return [
        str(word)
        for each in schema.get("anyOf", [schema])
        for word in each.get("enum", [each["const"]] if "const" in each else [])
    ]


def _needed(schema: Schema, root: Schema) -> str:
    """What a schema asks for, in words."""
    schema = _resolved(schema, root)
    if "anyOf" in schema:
        kinds = [each for each in schema["anyOf"] if each.get("type") not in ("null", "integer")]
        return " or ".join(_needed(each, root) for each in kinds)
    if words := _words(schema):
        return f"one of {', '.join(words)}"
    match schema.get("type", "object"):
        case "string":
            return f"text{_between(schema, 'Length', ' of', ' characters')}"
        case "integer":
            return f"a whole number{_between(schema, 'imum', '', '')}"
        case "number":
            return "a number"
        case "array":
            return f"a list{_between(schema, 'Items', ' of', ' entries')}"
    inside = schema.get("properties", {schema.get("discriminator", {}).get("propertyName"): None})
    of = f" with {', '.join(map(repr, inside))}" if any(inside) else ""
    return f"a JSON object{of}{_between(schema, 'Properties', ' of', ' entries')}"


def _between(schema: Schema, what: str, before: str, after: str) -> str:
    """The bounds of a schema in words; empty where it has none."""
    low, high = schema.get(f"min{what}"), schema.get(f"max{what}")
    if high is None:
        return ""
    said = f"at most {high}" if low is None else f"{low} to {high}"
    return f"{before} {said}{after}" if before else f" from {said}"

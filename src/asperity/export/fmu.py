"""A joint as an FMI 2.0 co-simulation unit (FMU) in C source: table, play, slip elements, drift while it turns."""

from __future__ import annotations

import hashlib
import html
import io
import re
import zipfile
from dataclasses import dataclass
from importlib.resources import files
from xml.sax.saxutils import escape, quoteattr

import numpy as np

import asperity
from asperity.errors import InputError
from asperity.export.content import MASING, ExportContent, heading
from asperity.standing.series_law import SeriesLaw, SlipElements, slip_elements

#: Elements in series that make the slip.
ELEMENTS = 24
#: Motor speed over which its friction changes sign [rad/s].
_FRICTION_SPEED = 0.1
_OLDEST_DATE = (1980, 1, 1, 0, 0, 0)  # of a ZIP file

_INPUTS = {
    "motor_angle": ("angle of the motor at the {}", "rad"),
    "output_angle": ("angle of the output, counted in its own sense", "rad"),
    "motor_speed": ("speed of the motor, for damping and friction", "rad/s"),
    "output_speed": ("speed of the output, for damping", "rad/s"),
}
_OUTPUTS = {
    "output_torque": ("torque on the load, positive where it drives a positive speed", "N.m"),
    "motor_torque": ("torque that the joint asks of the motor", "N.m"),
    "windup": ("angle between motor/reduction and output without the drift", "rad"),
    "drift": ("angle that the output has lost by creep since the start", "rad"),
    "out_of_range": ("1 where the torque is beyond the table", "1"),
}


@dataclass(frozen=True)
class _Variable:
    name: str
    causality: str
    description: str
    unit: str
    start: float | None


@dataclass(frozen=True)
class FmuParts:
    """What an FMU is made of.

    Its name, a name of C; ``modelDescription.xml``; ``joint_data.h``, sizes and start values. ``sentences`` are what
    its user should know.
    """

    identifier: str
    description: str
    data: str
    sentences: tuple[str, ...]


def fmu_parts(content: ExportContent) -> FmuParts:
    """Model description and data of a joint."""
    drifts = [np.asarray(drift) for drift in (content.curves.driving_drift, content.curves.braking_drift)]
    if not all(np.all(np.isfinite(drift)) for drift in drifts):
        torque = np.asarray(content.windup.torque)[~np.isfinite(drifts[0] + drifts[1])]
        raise InputError(
            f"the joint has no steady rolling at {np.min(np.abs(torque)):.4g} N*m"
            + (f" ({content.no_drift_because[0]})" if content.no_drift_because else "")
            + "; an FMU needs its drift at every torque: lower the largest torque, or export to a table",
            options=["torque"],
        )
    law = SeriesLaw(content.windup, content.play)
    slip = slip_elements(law, elements=ELEMENTS)
    variables = _variables(content, law, slip)
    numbers = [0.0 if variable.start is None else variable.start for variable in variables]
    points = np.asarray(content.windup.torque).size
    plain = (
        f"#define POINTS {points}\n#define ELEMENTS {slip.threshold.size}\n"
        f"#define START {', '.join(f'{number!r}' for number in numbers)}\n"
    )
    source = files("asperity.export").joinpath("fmu_source.c").read_text(encoding="utf-8")
    guid = hashlib.sha256((source + plain + "".join(map(str, variables))).encode()).hexdigest()[:32]
    comment = "\n".join(f" * {line.replace('*/', '* /')}" for line in heading(content, what="FMU"))
    data = f'/*\n{comment}\n */\n#define GUID "{guid}"\n{plain}'
    identifier = re.sub(r"\W", "_", content.name, flags=re.ASCII)
    identifier = identifier if re.match("[A-Za-z]", identifier) else f"joint_{identifier}"
    return FmuParts(
        identifier, _description(content, identifier, guid, variables), data, _sentences(content, slip)
    )


def fmu_file(content: ExportContent, parts: FmuParts) -> bytes:
    """The FMU: a ZIP file with description, source and a page of documentation."""
    source = files("asperity.export").joinpath("fmu_source.c").read_text(encoding="utf-8")
    lines = "".join(f"<p>{html.escape(line)}</p>\n" for line in heading(content, what="FMU"))
    texts = {
        "modelDescription.xml": parts.description,
        "sources/joint.c": source,
        "sources/joint_data.h": parts.data,
        "documentation/index.html": f'<!doctype html>\n<meta charset="utf-8">\n<title>Joint</title>\n{lines}',
    }
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in texts.items():
            entry = zipfile.ZipInfo(name, _OLDEST_DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, text.encode("utf-8"))
    return target.getvalue()


def _sentences(content: ExportContent, slip: SlipElements) -> tuple[str, ...]:
    said = "No slip, no hysteresis loop."
    if slip.threshold.size and float(content.windup.hysteresis) > 0.0:
        off = 100.0 * slip.error / float(content.windup.hysteresis)
        said = (
            f"{slip.threshold.size} slip elements in series follow the loop within {off:.2g} % of its width at zero "
            f"torque. {MASING}"
        )
    return (
        said,
        "Drift grows as the motor turns, at once as in steady rolling. In the joint it is half as large over the first "
        "contact width, and short swings to and fro hardly drift.",
        "It holds C source and no binary: 'fmpy compile FILE' (pip install fmpy, and a C compiler) adds that of your "
        "machine, which most programs need.",
    )


def _variables(content: ExportContent, law: SeriesLaw, slip: SlipElements) -> list[_Variable]:
    """All variables in the order of their value references, which is that of the enumeration in the source."""
    play = content.play
    torque = np.asarray(content.windup.torque)
    entry = content.ends[0]
    made = [
        _Variable(name, "input", words.format(entry), unit, 0.0) for name, (words, unit) in _INPUTS.items()
    ]
    made += [_Variable(name, "output", *said, None) for name, said in _OUTPUTS.items()]
    scalars: dict[str, tuple[str, str, float]] = {
        "reduction": ("turns of the motor in one turn of the output", "1", content.reduction),
        "stiffness_factor": ("factor of the stiffness at every torque", "1", 1.0),
        "slip_factor": ("factor of the slip; 0 for no hysteresis", "1", 1.0),
        "drift_factor": ("factor of the drift; 0 for a joint without creep", "1", 1.0),
        "damping": ("viscous damping beside the spring", "N.m.s/rad", 0.0),
        "friction": ("friction torque at the motor", "N.m", content.friction),
        "friction_speed": ("motor speed over which the friction changes sign", "rad/s", _FRICTION_SPEED),
        "play_angle": ("play from side to side", "rad", float(play.angle)),
        "take_up_torque": (
            "torque over which the play is taken up; 0 for at once",
            "N.m",
            float(play.take_up_torque),
        ),
    }
    made += [_Variable(name, "parameter", *said) for name, said in scalars.items()]
    columns = {
        "torque": ("torques of the table", "N.m", torque),
        "reversible_angle": ("wind-up without slip and play", "rad", law.reversible(torque)),
        "drift_driving": (
            "drift per output turn with the torque",
            "rad",
            np.asarray(content.curves.driving_drift),
        ),
        "drift_braking": (
            "drift per output turn against it",
            "rad",
            np.asarray(content.curves.braking_drift),
        ),
        "slip_threshold": ("torque at which a slip element moves", "N.m", slip.threshold),
        "slip_compliance": ("its angle per torque beyond", "rad/(N.m)", slip.compliance),
    }
    for name, (said, unit, values) in columns.items():
        made += [
            _Variable(f"{name}[{place}]", "parameter", said, unit, float(value))
            for place, value in enumerate(values, start=1)
        ]
    return made


def _description(content: ExportContent, identifier: str, guid: str, variables: list[_Variable]) -> str:
    """``modelDescription.xml``."""
    said = " | ".join(heading(content, what="FMU"))
    units = dict.fromkeys(variable.unit for variable in variables)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<fmiModelDescription fmiVersion="2.0" modelName={quoteattr(content.name)} guid="{guid}"',
        f'  generationTool="asperity {escape(asperity.__version__)}" variableNamingConvention="structured"',
        f"  description={quoteattr(said)}>",
        f'  <CoSimulation modelIdentifier="{identifier}" canHandleVariableCommunicationStepSize="true"',
        '    canGetAndSetFMUstate="true" canNotUseMemoryManagementFunctions="true">',
        '    <SourceFiles><File name="joint.c"/></SourceFiles>',
        "  </CoSimulation>",
        "  <UnitDefinitions>",
        *(f'    <Unit name="{unit}">{_BASE_UNITS[unit]}</Unit>' for unit in units),
        "  </UnitDefinitions>",
        '  <DefaultExperiment startTime="0" stepSize="0.001"/>',
        "  <ModelVariables>",
    ]
    for place, variable in enumerate(variables):
        fixed = "fixed" if variable.causality == "parameter" else "continuous"
        start = "" if variable.start is None else f' start="{variable.start!r}"'
        lines += [
            f'    <ScalarVariable name="{variable.name}" valueReference="{place}" causality="{variable.causality}"'
            f' variability="{fixed}" description={quoteattr(variable.description)}>'
            f'<Real unit="{variable.unit}"{start}/></ScalarVariable>'
        ]
    outputs = [place for place, variable in enumerate(variables, start=1) if variable.causality == "output"]
    unknowns = "".join(f'<Unknown index="{place}"/>' for place in outputs)
    lines += [
        "  </ModelVariables>",
        f"  <ModelStructure><Outputs>{unknowns}</Outputs>",
        f"  <InitialUnknowns>{unknowns}</InitialUnknowns></ModelStructure>",
        "</fmiModelDescription>",
    ]
    return "\n".join(lines) + "\n"


_BASE_UNITS = {
    "rad": '<BaseUnit rad="1"/>',
    "rad/s": '<BaseUnit rad="1" s="-1"/>',
    "N.m": '<BaseUnit kg="1" m="2" s="-2"/>',
    "1": "<BaseUnit/>",
    "N.m.s/rad": '<BaseUnit kg="1" m="2" s="-1" rad="-1"/>',
    "rad/(N.m)": '<BaseUnit kg="-1" m="-2" s="2" rad="1"/>',
}

"""Rows of the table of results that are judged: the limits of the joint and of its model, and safety factors."""

from __future__ import annotations

import functools

from asperity.contact.fractal import VERIFIED_FRACTAL_DIMENSIONS
from asperity.drive.layout.wedge import self_locking_ratio
from asperity.drive.state.state import STATE_TOLERANCE
from asperity.joint.description import contact_values
from asperity.results.result import Column, Limit, Result
from asperity.results.solved import ONLY_SPOTS, SolvedJoint, has_spots
from asperity.unit_table import Dimension

_ratio = functools.partial(Result, dimension=Dimension.DIMENSIONLESS, display_unit="1", group="diagnostics")
_contact_ratio = functools.partial(_ratio, axis="contact")
_spot_ratio = functools.partial(_contact_ratio, present=has_spots, only=ONLY_SPOTS)
_residual = functools.partial(
    Result,
    dimension=Dimension.DIMENSIONLESS,
    display_unit="1",
    group="residuals",
    needs="geometry",
    differentiable=False,
)
_UNSOLVED = functools.partial(
    Limit,
    "function",
    "the equations are solved",
    "the equations are not solved",
    "do not use these numbers; check radii, preload and torque",
    highest=STATE_TOLERANCE,
)
_TRUST_THE_ASSEMBLY = (
    "use the assembled stiffness; the published stiffness leaves out the bodies and is an upper bound"
)


def _fractal_dimensions(solved: SolvedJoint) -> list[object]:
    surfaces = solved.joint.surfaces
    per_contact = surfaces if len(surfaces) > 1 else surfaces * len(solved.result.contact_names)
    return [surface.number("fractal_dimension") for surface in per_contact]


ROWS = (
    _contact_ratio(
        "slip_ratio",
        "slip ratio T/(mu N)",
        value="result.diagnostics.slip_ratio",
        needs="balance",
        highest_limit=1.0,
        column=Column("forces", "slip T/(mu N)"),
        limit=Limit(
            "function",
            "the tangential force is below the friction limit",
            "the contact slips: it has no tangential stiffness",
            "raise the preload or the friction coefficient, or lower the torque",
            highest=1.0,
        ),
    ),
    _ratio(
        "self_locking_ratio",
        "self-locking ratio tan(beta/2)/mu",
        value=lambda solved: self_locking_ratio(
            solved.joint.drive, contact_values(solved.joint, solved.joint.friction_coefficients)
        ),
        needs="geometry",
        needs_wedges=True,
        limit=Limit(
            "state",
            "the wedge is self-locking",
            "the friction coefficient is below tan(beta/2): the wedge is not self-locking, and the carrier pins hold "
            "the loading rollers in it",
            "check that the pins can carry this force, or raise the friction coefficient, or make the wedge "
            "angle beta smaller: smaller loading rollers or planets, or a larger ring",
            highest=1.0,
            state="held by the pins",
        ),
    ),
    _contact_ratio(
        "normal_force_over_preload",
        "normal force over preload",
        value="result.diagnostics.normal_force_over_preload",
        positive=False,
        lowest_limit=0.0,
        note="each contact's normal force over its value without torque",
        limit=Limit(
            "function",
            "the contact is loaded",
            "the contact has lifted off",
            "raise the preload, or lower the torque or the speed",
            lowest=0.0,
        ),
    ),
    _contact_ratio(
        "pressure_over_first_yield",
        "Hertz pressure over first yield",
        value="result.diagnostics.pressure_over_first_yield",
        limit=Limit(
            "damage",
            "the bodies stay elastic under the contact",
            "the Hertz pressure exceeds first yield, 1.67 times the yield strength: the bodies yield",
            "choose a material of higher yield strength, longer contact lines or less preload",
            highest=1.0,
            beyond="beyond first yield",
        ),
    ),
    _spot_ratio(
        "critical_over_largest_spot",
        "critical over largest spot",
        value="result.diagnostics.critical_over_largest_spot",
        limit=Limit(
            "accuracy",
            "some contact spots are elastic",
            "every contact spot is plastic: the contact law has no stiffness",
            "check D, G and hardness; a smoother surface, a harder material or more preload makes spots elastic",
            highest=1.0,
        ),
    ),
    _spot_ratio(
        "fractal_dimension",
        "fractal dimension D",
        value=_fractal_dimensions,
        needs="geometry",
        limit=Limit(
            "accuracy",
            f"D is inside the verified range of the contact law, {' to '.join(map(str, VERIFIED_FRACTAL_DIMENSIONS))}",
            f"D is outside the verified range of the contact law, {' to '.join(map(str, VERIFIED_FRACTAL_DIMENSIONS))}",
            "check the measured D; the results are extrapolated",
            lowest=VERIFIED_FRACTAL_DIMENSIONS[0],
            highest=VERIFIED_FRACTAL_DIMENSIONS[1],
            inclusive=True,
        ),
    ),
    _spot_ratio(
        "real_area_over_hertz_area",
        "real area over Hertz area",
        value="result.diagnostics.real_area_over_hertz_area",
        limit=Limit(
            "model",
            "the real area of contact is part of the Hertz area 2bB",
            "the real area of contact exceeds the Hertz area 2bB: the contact law is used beyond its validity",
            _TRUST_THE_ASSEMBLY,
            highest=1.0,
        ),
    ),
    _spot_ratio(
        "largest_spot_over_hertz_area",
        "largest spot over Hertz area",
        value="result.diagnostics.largest_spot_over_hertz_area",
        limit=Limit(
            "model",
            "the largest contact spot is part of the Hertz area 2bB",
            "one contact spot exceeds the Hertz area 2bB: the contact law is used beyond its validity",
            _TRUST_THE_ASSEMBLY,
            highest=1.0,
        ),
    ),
    _contact_ratio(
        "asperity_over_bulk_stiffness",
        "asperity over bulk stiffness",
        value="result.diagnostics.asperity_over_bulk_stiffness",
        limit=Limit(
            "model",
            "the asperities are at least ten times softer than the bodies under them",
            "the bodies are not much stiffer than the asperities: the published stiffness leaves out the bodies and is "
            "only an upper bound",
            _TRUST_THE_ASSEMBLY,
            highest=0.1,
        ),
    ),
    _contact_ratio(
        "slip_safety",
        "safety factor against slip",
        value=lambda solved: 1.0 / solved.result.diagnostics.slip_ratio,
        needs="balance",
        lowest_limit=1.0,
        note="mu N/T",
        place="",
    ),
    _contact_ratio(
        "yield_safety",
        "safety factor against yield",
        value=lambda solved: 1.0 / solved.result.diagnostics.pressure_over_first_yield,
        note="first yield, 1.67 times the yield strength, over Hertz pressure",
        place="",
    ),
    _residual(
        "balance_residual",
        "residual of the force balance",
        value="result.forces.balance_residual",
        note="of the forces and torques on every body, relative to the largest force; equations (1) to (5) of the "
        "paper's drive",
        limit=_UNSOLVED(),
        place="standing.forces.balance_residual",
    ),
    _residual(
        "closure_residual",
        "residual of the closure",
        value="result.forces.closure_residual",
        note="of the lengths that the preload presses together, relative; equation (A3) of the paper's drive",
        limit=_UNSOLVED(),
        place="standing.forces.closure_residual",
    ),
)

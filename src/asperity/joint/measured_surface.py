"""A joint with measured surfaces: the measured D and G go in, an interval of the stiffness comes out."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from asperity.engine.arrays import xp
from asperity.errors import InputError
from asperity.joint.description import Joint
from asperity.joint.surface_interval import over_surfaces, result_ends
from asperity.surface.measured_roughness import (
    MeasuredRoughness,
    measurement_of,
    read_roughness,
    two_bodies,
)
from asperity.surface.measurement import CONFIDENCE, SurfaceMeasurement
from asperity.types import Document
from asperity.units import format_quantity

#: Draws of (D, ln G); the ends of a 95 % interval then scatter by about 3 % of its width.
DRAWS = 2000
_SEED = 20250617


def measured_surface(paths: tuple[str | Path, ...], of: str | None = None) -> MeasuredRoughness:
    """The surface of the contacts from one measurement, or from measurements of both bodies.

    ``paths``: one document of ``asperity surface measure --json``, or two for the two bodies, of which spectra and
    structure functions add. ``of``: whether the one is of a "body", as both then are, or of the "pair"; what the
    document says if None. Spectra come out, and D and G with their covariance where there is a power law. An
    ``InputError`` is raised if there are more than two files, one is no measurement, or ``of`` contradicts them, a
    ``NoSolutionError`` if two surfaces without spectra cannot be combined into one power law.
    """
    if len(paths) > 2:
        raise InputError(
            f"{len(paths)} measured surfaces were given; allowed are one, or one for each of two bodies"
        )
    measured = [read_roughness(path=path) for path in paths]
    if len(measured) == 1:
        return measurement_of(measured[0], of)
    if of is not None:
        raise InputError(
            "two measured surfaces are of one body each; leave out of what they are",
            options=["measurement-of"],
        )
    return two_bodies(*measured)


def stiffness_interval(joint: Joint, measurement: SurfaceMeasurement) -> Document:
    """Intervals of output stiffness and drift of one joint from the uncertainty of the measured D and G.

    The (D, ln G) of the measurement are drawn together from their normal law. As
    :func:`asperity.joint.surface_interval.result_ends`, the ends are the 2.5 % and 97.5 % points; besides ``draws``,
    ``outside`` (draws with D outside 1…2), ``unsolved``, ``all_plastic`` (draws in which the contact law has no
    stiffness), ``confidence``, ``title`` and ``words``. Such draws are left out; both ends are None where one draw in
    twenty has no stiffness. An ``InputError`` is raised if more than one draw in twenty has a D outside (1, 2): the
    measurement is too uncertain for an interval.
    """
    generator = np.random.default_rng(_SEED)
    centre = [float(measurement.fractal_dimension), np.log(float(measurement.fractal_roughness))]
    dimension, log_roughness = generator.multivariate_normal(
        centre, np.asarray(measurement.covariance), size=DRAWS, method="eigh"
    ).T
    inside = (dimension > 1.0) & (dimension < 2.0)
    if np.count_nonzero(~inside) > DRAWS / 20:
        raise InputError(
            f"{np.count_nonzero(~inside)} of {DRAWS} draws of the measured D = {centre[0]:.3f} lie outside 1 to 2: the "
            "measurement is too uncertain; measure more profiles"
        )
    surface = joint.surfaces[0].with_numbers(
        fractal_dimension=xp.asarray(dimension[inside]),
        fractal_roughness=xp.asarray(np.exp(log_roughness[inside])),
        frequency_ratio=xp.full(np.count_nonzero(inside), float(measurement.frequency_ratio)),
    )
    shape = np.shape(dimension[inside])
    result = over_surfaces(joint, (surface,), shape=shape)
    tail = 50.0 * (1.0 - CONFIDENCE)
    outside = int(np.count_nonzero(~inside))
    ends = result_ends(result, shape=shape, percentiles=(tail, 100.0 - tail), least_usable=0.95)
    words = (
        f"Of {DRAWS} draws of D and G, {outside} had a D outside 1 to 2, {ends['unsolved']} had no solution and "
        f"{ends['all_plastic']} had plastic spots only, where the contact law has no stiffness. These are left out; "
        "where they are one draw in twenty or more, there is no interval. "
    )
    return {
        "confidence": CONFIDENCE,
        "draws": DRAWS,
        "outside": outside,
        **ends,
        "title": f"95 % interval from the measured surface, D = {centre[0]:.3f}, G = "
        f"{format_quantity(float(measurement.fractal_roughness), 'mm', 4)}",
        "words": f"{words if outside or ends['unsolved'] or ends['all_plastic'] else ''}"
        "The interval leaves out the error of the contact law.",
    }

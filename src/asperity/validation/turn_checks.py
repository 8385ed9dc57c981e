"""A drive with form errors over a turn, against an independent program and by statics."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator

import numpy as np

from asperity.drive.layout.drive import Drive
from asperity.drive.layout.form import Lobes, lobes_of
from asperity.drive.layout.unfolding import unfolded
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.state.march import Wave, march
from asperity.drive.state.ripple import ripples
from asperity.drive.state.rolling_balance import RollingBalance, rolling_balance
from asperity.drive.state.smooth_laws import smooth_contact_laws
from asperity.drive.state.state import DriveLoad
from asperity.drive.state.states import state_at_rest
from asperity.drive.types.wedge import wedge_drive
from asperity.engine.arrays import xp
from asperity.engine.control import at_once
from asperity.types import Array
from asperity.validation.check import Check, compared

_MODEL = "Form errors over a turn of the wedge drive"
_PROGRAM = "independent program in the plane, Hertz and Carter: the paper's radii, 12.9043 µm, 5 N·m"
_GEOMETRY = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
_INTERFERENCE, _TORQUE, _MICROMETRE, _ARCSECONDS = 12.9043e-6, 5.0, 1e-6, 648000.0 / math.pi
#: Body, waves round it, and per µm of amplitude: normal and tangential force of the first sun contact [N].
_FORCES = (
    ("sun", 1, 78.09, 7.20),
    ("sun", 2, 77.89, 5.03),
    ("planet_1", 2, 128.2, 7.05),
    ("planet_1", 3, 65.26, 13.65),
    ("planet_1", 4, 49.31, 17.07),
    ("right_loading_roller_1", 1, 10.11, 1.97),
    ("right_loading_roller_1", 2, 84.94, 20.43),
    ("left_loading_roller_1", 2, 82.74, 19.84),
    ("ring", 1, 82.67, 3.51),
    ("ring", 2, 75.47, 5.27),
)
#: And those that the output has most of: transmission error [arcsec].
_ERRORS = (
    ("ring", 3, 22.234),
    ("ring", 6, 24.760),
    ("planet_1", 2, 5.216),
    ("planet_1", 3, 7.647),
    ("right_loading_roller_1", 2, 8.060),
    ("left_loading_roller_1", 2, 8.039),
)


def _rolling(drive: Drive, interference: Array) -> RollingBalance:
    """The drive, every sector by itself, in steady rolling under the torque."""
    laws = smooth_contact_laws(
        drive=drive,
        youngs_modulus=206e9,
        poisson_ratio=0.3,
        friction_coefficient=0.12,
        contact_length=5e-3,
        ring_wall_thickness=60e-3,
        reference_force=1000.0,
    )
    pattern = xp.array([1.0 if contact.internal else 0.0 for contact in drive.contacts])
    rest = state_at_rest(drive=drive, laws=laws, pattern=pattern, interference=interference)
    return rolling_balance(drive=drive, laws=laws, rest=rest, load=DriveLoad(xp.asarray(_TORQUE)))


def _lobes(drive: Drive, body: str, harmonic: int) -> Lobes:
    sides = [
        (contact.name, side)
        for contact in drive.contacts
        for side, name in (("first", contact.first), ("second", contact.second))
        if name == body
    ]
    return lobes_of(drive, sides, harmonic)


def turns() -> Iterator[Check]:
    """Forces and transmission error to first order, and in full over a turn of an eccentric sun."""
    drive = unfolded(wedge_drive(_GEOMETRY, planet_count=3.0), sectors=3)
    rolling = at_once(functools.partial(_rolling, drive), _INTERFERENCE)
    compare = functools.partial(compared, model=_MODEL, reference=_PROGRAM)
    found = ripples(rolling, [_lobes(drive, *row[:2]) for row in _FORCES])
    for name, column in (("normal", 2), ("tangential", 3)):
        yield compare(
            quantity=f"{name} force of a contact over the amplitude",
            unit="N/µm",
            expected=[row[column] for row in _FORCES],
            computed=np.abs(getattr(found, name)[:, 0]) * _MICROMETRE,
            tolerance=0.01,
        )
    swung = ripples(rolling, [_lobes(drive, *row[:2]) for row in _ERRORS]).error(drive.layout.output)
    yield compare(
        quantity="transmission error over the amplitude",
        unit="arcsec/µm",
        expected=[row[2] for row in _ERRORS],
        computed=np.abs(swung) * _MICROMETRE * _ARCSECONDS,
        tolerance=0.01,
    )
    hills = ripples(rolling, [_lobes(drive, "sun", 3)])
    moment = 3.0 * 3.0 * float(rolling.state.normal[0])
    yield compared(
        model=_MODEL,
        reference="balance of moments: m N rho' (1 + R_s/(R_o - R_s)) by hand",
        quantity="input torque by three waves of the sun over the amplitude",
        unit="mN·m/µm",
        expected=moment * (1.0 + 4.0 / 36.0) * 1e-3,
        computed=abs(hills.input_torque[0]) * 1e-3,
        tolerance=0.005,
    )
    yield _eccentric(rolling)


def _eccentric(rolling: RollingBalance) -> Check:
    """Largest and smallest force over a turn of a sun that is 5 µm eccentric, without a linear approximation."""
    drive = rolling.machine.drive
    wave = Wave(_lobes(drive, "sun", 1), 5.0 * _MICROMETRE, 0.0)
    speed = np.asarray(rolling.state.speed)
    turn = 2.0 * math.pi / abs(float(speed[wave.lobes.body] - speed[drive.layout.carrier]))
    with np.errstate(all="ignore"):
        found = march(rolling, [wave], ripples(rolling, [wave.lobes]), angle=1.2 * turn, steps=72)
    normal = found.normal[12:, 0]
    return compared(
        model=_MODEL,
        reference=_PROGRAM,
        quantity="smallest and largest normal force with a sun 5 µm eccentric",
        unit="N",
        expected=[619.7, 1399.1],
        computed=[normal.min(), normal.max()],
        tolerance=0.003,
    )

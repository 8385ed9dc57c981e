r"""What a bore adds to the compliance of a roller with two tracks of unlike radii.

Each track is an annulus of its own length in plane elasticity. Both share the bore and the circle of the smaller
radius :math:`R_s`, where they are joined through the face between them. Of a mode n, with the compliances
:math:`A` of the smaller track at its rim and :math:`P` of the larger one at that circle (s) and at its rim (l), the
displacements under the loads :math:`f` of both rims are

.. math::
    C = \begin{pmatrix} A & 0 \\ 0 & P_{ll} \end{pmatrix}
        - \begin{pmatrix} A \\ -P_{ls} \end{pmatrix} \big(\chi_s A + \chi_l P_{ss}\big)^{-1}
        \begin{pmatrix} A & -P_{sl} \end{pmatrix},
    \qquad \chi = x \coth x,\; x = \frac{L}{2\ell},\; \ell^2 = \frac gk,

with the mode's stiffness k per length and the stiffness g of the wall in shear along the axis. Short tracks move as one
plate of two thicknesses, :math:`\chi = 1`; long ones move each by itself.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from asperity.body.annulus_modes import Channels, Wall, channel_product, mode_field
from asperity.body.shapes import PlaneState, kolosov_constant
from asperity.engine.arrays import xp
from asperity.engine.control import traced_once
from asperity.engine.derivatives import without_slopes
from asperity.engine.module import Module, static
from asperity.materials import shear_modulus
from asperity.types import Array, Real

#: Bore over the diameter of the smaller track up to which the compliance is known.
WIDEST_BORE = 0.65
#: Modes n >= 2 that are summed; those left out are less than 1e-14 of the first at the widest bore.
_MODES = 48
#: Difference of the radii over the smaller one, below which both are one rim.
_ONE_RIM = 1e-5


class SteppedRoller(Module):
    """A roller with two tracks and one bore through both, SI units.

    Parameters
    ----------
    radii, lengths : tuple of Real
        Of the two tracks [m]. One of them lies in the middle, half of the other on either side of it.
    bore_radius : Real
        Radius of the bore [m].
    youngs_modulus : Real
        Young's modulus [Pa].
    poisson_ratio : Real
        Poisson's ratio [-].
    plane_state : {"plane_strain", "plane_stress"}
        Of each track.
    """

    radii: tuple[Real, Real]
    lengths: tuple[Real, Real]
    bore_radius: Real
    youngs_modulus: Real
    poisson_ratio: Real
    plane_state: PlaneState = static()


class _Tracks(NamedTuple):
    """The smaller and the larger track: radii, lengths, the bore's radius, and Kolosov's constant."""

    small: Real
    large: Real
    small_length: Real
    large_length: Real
    bore: Real
    kolosov: Real


class _Rims(NamedTuple):
    """Compliances of the smaller rim, of the larger one, and of the smaller under the larger, times 2G [1/m]."""

    small: Channels
    large: Channels
    small_by_large: Channels


@functools.partial(traced_once, fixed=("contact_tracks",))  # traced once for all uses
def bore_addition(
    *, roller: SteppedRoller, contact_angles: Array, contact_tracks: tuple[int, ...], sectors: Real
) -> Array:
    r"""Compliance between the contacts of a hollow stepped roller, less that of the same roller without a bore.

    .. math::
        \Delta C_{ij} = \frac1{2\pi}\,\Delta C_0 + \frac1\pi \sum_{n\ge1} \Delta C_n \cos n(\varphi_i - \varphi_j)

    Parameters
    ----------
    roller : SteppedRoller
        The roller.
    contact_angles : Array
        Polar angles of its contacts, counter-clockwise, shape (n,) [rad].
    contact_tracks : tuple of int
        The track of each contact, 0 or 1.
    sectors : Real
        Number of equal sectors that load the roller alike, 1 for a roller of one sector [-]; not differentiated.

    Returns
    -------
    Array
        Shape (2n, 2n), first radial, then tangential components, outward and counter-clockwise positive [m/N]; the
        contacts are points that load the whole length of their tracks. The loads of all contacts together balance.

    Notes
    -----
    With equal radii and loads even along both tracks this is the difference between an annulus and a disc. Against
    finite elements in space (radii in the ratios 1.2 to 3, either track in the middle, both 0.2 to 2 of the smaller
    radius long, Poisson's ratio 0.3, plane strain), with loads on one track balanced on the other or on itself, the
    compliance of these loads is too low by up to 2 % for a bore of 0.3 of the smaller diameter, 6 % for 0.5 and 18 %
    for 0.65; of what the bore adds, by up to 29, 31 and 35 %. Plane stress comes up to 9 % of the addition nearer.
    A bore of 0.8 would be 43 % off: wider ones than 0.65 are refused. The faces of thin walls warp, which is left out.

    References
    ----------
    Equation (E6) of :doc:`/equations`; V. Z. Vlasov and N. N. Leont'ev, Beams, Plates and Shells on Elastic
    Foundations, 1966, for one displacement along the axis.
    """
    tracks, first_is_small = _sorted_tracks(roller)
    solid = tracks._replace(bore=xp.zeros_like(xp.asarray(tracks.bore)))
    modulus = shear_modulus(youngs_modulus=roller.youngs_modulus, poisson_ratio=roller.poisson_ratio)
    at = np.array(contact_tracks)
    turn = contact_angles[:, None] - contact_angles[None]
    modes, copies = xp.arange(2.0, 2.0 + _MODES), without_slopes(xp.asarray(sectors, dtype=float))
    total = xp.zeros((4, at.size, at.size))
    for mode, rims in (
        (xp.zeros(1), (_uniform(tracks), _uniform(solid))),
        (xp.ones(1), (_first(tracks), _first(solid))),
        (
            modes,
            (_higher(modes, tracks, _annulus(modes, tracks)), _higher(modes, solid, _disc(modes, solid))),
        ),
    ):
        hollow_rims, solid_rims = (_by_track(rim, first_is_small)[:, at[:, None], at[None]] for rim in rims)
        change = xp.broadcast_to(hollow_rims - solid_rims, (4, at.size, at.size, mode.size))
        angle = mode * turn[..., None]
        waves = xp.stack([xp.cos(angle), -xp.sin(angle), xp.sin(angle), xp.cos(angle)])
        waves = xp.where(mode > 0.0, 1.0, 0.5) * xp.where(mode % copies == 0.0, copies, 0.0) * waves
        total = total + xp.sum(change * waves, axis=-1)
    rr, rt, tr, tt = total / (2.0 * math.pi * modulus)
    return xp.concatenate([xp.concatenate([rr, rt], axis=1), xp.concatenate([tr, tt], axis=1)])


def _sorted_tracks(roller: SteppedRoller) -> tuple[_Tracks, Array]:
    """The smaller and the larger track, and whether the first one is the smaller."""
    (one, two), (long_1, long_2) = roller.radii, roller.lengths
    first = xp.asarray(one) <= xp.asarray(two)
    kolosov = kolosov_constant(poisson_ratio=roller.poisson_ratio, plane_state=roller.plane_state)
    return _Tracks(
        xp.where(first, one, two),
        xp.where(first, two, one),
        xp.where(first, long_1, long_2),
        xp.where(first, long_2, long_1),
        roller.bore_radius,
        kolosov,
    ), first


def _by_track(rims: _Rims, first_is_small: Array) -> Array:
    """Compliances rr, rt, tr, tt between the first and the second track, shape (4, 2, 2, modes)."""

    def parts(channels: Channels) -> Array:
        pp, pm, mp, mm = channels
        return 0.5 * xp.stack(
            xp.broadcast_arrays(
                *map(
                    xp.atleast_1d,
                    (pp + pm + mp + mm, pp - pm + mp - mm, pp + pm - mp - mm, pp - pm - mp + mm),
                )
            )
        )

    small, large, mixed = parts(rims.small), parts(rims.large), parts(rims.small_by_large)
    turned = mixed[np.array([0, 2, 1, 3])]
    one = xp.stack([xp.stack([small, mixed], 1), xp.stack([turned, large], 1)], 1)
    two = xp.stack([xp.stack([large, turned], 1), xp.stack([mixed, small], 1)], 1)
    return xp.where(first_is_small, one, two)


def _sum(a: Channels, b: Channels, factor: Real = 1.0) -> Channels:
    return Channels(*(one + factor * two for one, two in zip(a, b, strict=True)))


def _scaled(a: Channels, factor: Real) -> Channels:
    return Channels(*(factor * one for one in a))


def _inverse(a: Channels) -> Channels:
    determinant = a.pp * a.mm - a.pm * a.mp
    return Channels(a.mm / determinant, -a.pm / determinant, -a.mp / determinant, a.pp / determinant)


def _turned(a: Channels) -> Channels:
    return Channels(a.pp, a.mp, a.pm, a.mm)


_UNIT = Channels(1.0, 0.0, 0.0, 1.0)


def _annulus(mode: Array, tracks: _Tracks) -> Channels:
    """Compliance of an annulus between the bore and the smaller radius at its rim, times 2G and its length [-]."""
    ratio = tracks.bore / tracks.small
    wall = Wall(1.0, ratio, tracks.kolosov, (1.0, 0.0), (1.0, 0.0))
    field = mode_field(mode=mode, decay=ratio**mode, wall=wall)
    return channel_product(_sum(_UNIT, field.echo, -1.0), field.motion)


def _disc(mode: Array, tracks: _Tracks) -> Channels:
    """The same without a bore."""
    return Channels(tracks.kolosov / (mode + 1.0), 0.0, 0.0, 1.0 / (mode - 1.0))


def _layer(mode: Array, tracks: _Tracks, ratio: Array) -> tuple[Channels, Channels, Channels]:
    """Stiffness of the annulus between both radii over 2GL: inner rim, outer rim, outer force by inner displacement."""
    kolosov = tracks.kolosov
    d1 = Channels((mode + 1.0) / kolosov, 0.0, 0.0, mode - 1.0)
    d2 = Channels(-(mode + 1.0), 0.0, 0.0, -(mode - 1.0) / kolosov)
    outer, inner = ratio ** (mode + 1.0), ratio ** (mode - 1.0)
    passed = Channels(outer, 0.0, d1.pp * (inner - outer), inner)
    returned = Channels(outer, -d2.mm * (inner - outer), 0.0, inner)
    resolvent = _inverse(_sum(_UNIT, channel_product(returned, passed), -1.0))
    first_by_inner = _scaled(channel_product(resolvent, returned), -1.0)
    second_by_inner = _sum(_UNIT, channel_product(passed, first_by_inner), -1.0)
    second_by_outer = _scaled(channel_product(passed, resolvent), -1.0)
    back = channel_product(d2, returned)
    at_outer = _sum(channel_product(d1, resolvent), channel_product(back, second_by_outer))
    outer_by_inner = _sum(channel_product(d1, first_by_inner), channel_product(back, second_by_inner))
    at_inner = _sum(
        channel_product(channel_product(d1, passed), first_by_inner), channel_product(d2, second_by_inner)
    )
    return _scaled(at_inner, -1.0), at_outer, outer_by_inner


def _higher(mode: Array, tracks: _Tracks, core: Channels) -> _Rims:
    """Modes n >= 2 of both tracks joined where they meet; the core's compliance is that below the smaller radius."""
    small = _scaled(core, 1.0 / tracks.small_length)
    alone = _scaled(core, 1.0 / tracks.large_length)
    ratio = tracks.small / tracks.large
    stepped = ratio < 1.0 - _ONE_RIM
    at_inner, at_outer, outer_by_inner = _layer(mode, tracks, xp.where(stepped, ratio, 0.5))
    inner_by_outer = _turned(outer_by_inner)
    below = _sum(_inverse(core), at_inner)
    eliminated = channel_product(channel_product(inner_by_outer, _inverse(at_outer)), outer_by_inner)
    meeting = _inverse(_sum(below, eliminated, -1.0))
    across = _scaled(channel_product(channel_product(meeting, inner_by_outer), _inverse(at_outer)), -1.0)
    eliminated = channel_product(channel_product(outer_by_inner, _inverse(below)), inner_by_outer)
    rim = _inverse(_sum(at_outer, eliminated, -1.0))
    meeting, across, rim = (
        Channels(
            *(
                xp.where(stepped, one / tracks.large_length, two)
                for one, two in zip(channels, alone, strict=True)
            )
        )
        for channels in (meeting, across, rim)
    )
    joined = _inverse(
        _sum(
            _scaled(small, _lengthwise(mode, tracks, small, tracks.small_length)),
            _scaled(meeting, _lengthwise(mode, tracks, meeting, tracks.large_length)),
        )
    )
    down = _turned(across)
    return _Rims(
        _sum(small, channel_product(channel_product(small, joined), small), -1.0),
        _sum(rim, channel_product(channel_product(down, joined), across), -1.0),
        channel_product(channel_product(small, joined), across),
    )


def _lengthwise(mode: Array, tracks: _Tracks, compliance: Channels, length: Real) -> Array:
    r"""How much stiffer a track is along all of its length than from the face where it meets the other, x coth x [-].

    The displacement decays along the axis over :math:`\ell`, as below a half-space whose load ends at a line:
    :math:`g = 16 G R_s^2 (1 - (R_i/R_s)^{2n}) / (\pi^2 (\kappa+1) n)`.
    """
    radial = 0.5 * (compliance.pp + compliance.pm + compliance.mp + compliance.mm)  # times 2G
    wall = 1.0 - (tracks.bore / tracks.small) ** (2.0 * mode)
    shear = 8.0 * tracks.small**2 * wall / (math.pi**2 * (tracks.kolosov + 1.0) * mode)  # over 2G
    x = 0.5 * length / xp.sqrt(shear * radial * length)
    return x / xp.tanh(x)


def _uniform(tracks: _Tracks) -> _Rims:
    """Mode n = 0: uniform pressures on both rims, and torques that balance, which twist the core between the tracks."""
    small, large, bore = tracks.small, tracks.large, tracks.bore
    total_length = tracks.small_length + tracks.large_length
    half = 0.5 * (tracks.kolosov - 1.0)
    a1, b1 = total_length * (small - bore**2 / small), tracks.large_length * (large**2 / small - small)
    a2, b2 = half * small + bore**2 / small, -(half * small + large**2 / small)
    determinant = a1 * b2 - a2 * b1
    # inner and outer coefficients of r under a force per angle on the smaller and on the larger rim
    loads = (
        (1.0, 0.0, 0.0),
        (large / small, -large / (tracks.large_length * small), large / tracks.large_length),
    )
    radial = []
    for one, two, rest in loads:
        inner, outer = (b2 * one - b1 * two) / determinant, (a1 * two - a2 * one) / determinant
        radial.append((a2 * inner, half * outer * large - (rest - outer * large**2) / large))
    # 2G times angle per torque between the middles, over pi / 2
    twist = 2.0 / (3.0 * total_length * (small**4 - bore**4))
    torque = [
        twist * one * two * radius * other
        for (one, radius), (two, other) in (
            ((tracks.large_length, small), (tracks.large_length, small)),
            ((tracks.small_length, large), (tracks.small_length, large)),
            ((tracks.large_length, small), (-tracks.small_length, large)),
        )
    ]
    pairs = zip((radial[0][0], radial[1][1], radial[1][0]), torque, strict=True)
    return _Rims(*(Channels(*_from_components(straight, around)) for straight, around in pairs))


def _from_components(radial: Real, tangential: Real) -> tuple[Real, Real, Real, Real]:
    """Channels of a radial and a tangential compliance without coupling."""
    same, other = 0.5 * (radial + tangential), 0.5 * (radial - tangential)
    return same, other, other, same


def _first(tracks: _Tracks) -> _Rims:
    """Mode n = 1 under forces that balance: they pass between the rims in the larger track, and between the tracks."""
    small, large, bore, kolosov = tracks.small, tracks.large, tracks.bore, tracks.kolosov
    large_length, total_length = tracks.large_length, tracks.small_length + tracks.large_length
    a1, b1 = (
        4.0 * total_length * (small**2 - bore**4 / small**2),
        4.0 * large_length * (large**4 / small**2 - small**2),
    )
    a2, b2 = kolosov * small**2 + bore**4 / small**2, -(kolosov * small**2 + large**4 / small**2)
    determinant = a1 * b2 - a2 * b1
    columns = []
    for number in range(4):  # the channels plus and minus of the smaller, then of the larger rim
        plus_small, minus_small, plus_large, minus_large = (float(number == k) for k in range(4))
        passing = (minus_large - minus_small) / (4.0 * (kolosov + 1.0) * large_length)
        rest = large**2 * (plus_large - 4.0 * large_length * passing) / (4.0 * large_length)
        one = plus_small + 4.0 * large_length * (passing + rest / small**2)
        two = -passing - rest / small**2
        inner, outer = (b2 * one - b1 * two) / determinant, (a1 * two - a2 * one) / determinant
        shift = 2.0 * kolosov * passing * xp.log(large / small) + 2.0 * (outer - inner) * small**2
        columns.append(
            (
                2.0 * a2 * inner,
                -4.0 * inner * small**2,
                2.0 * (kolosov * outer * large**2 - passing - (rest - outer * large**4) / large**2),
                2.0 * (shift - 2.0 * outer * large**2),
            )
        )
    matrix = xp.stack([xp.stack([xp.asarray(entry) for entry in column]) for column in columns], axis=1)
    matrix = 0.5 * (matrix + matrix.T)
    # 2G times displacement per force, in the channel minus
    sheared = 1.0 / (3.0 * total_length * (small**2 - bore**2))
    lever = xp.stack(
        [xp.asarray(0.0), xp.asarray(large_length), xp.asarray(0.0), -xp.asarray(tracks.small_length)]
    )
    matrix = matrix + sheared * lever[:, None] * lever[None]
    return _Rims(
        *(
            Channels(*(matrix[rows + k, columns + m] for k in range(2) for m in range(2)))
            for rows, columns in ((0, 0), (2, 2), (0, 2))
        )
    )

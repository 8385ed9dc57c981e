r"""The terms that form errors of the tracks add to the equations of a drive.

.. math::
    e = \delta + A u + \rho_1 \pm \rho_2, \qquad W = W(R_b + \rho_b), \qquad
    M_b = -(W^\mathsf{T} T)_b \pm N \rho_b'

Minus for the second surface of an internal contact: the ring. All are the work of the same forces on the same
movements, so that the powers of all members add up to creep and elastic energy at every instant. The carrier therefore
has the opposite of all moments that the form adds, and the moments on all members balance.
"""

from __future__ import annotations

import dataclasses

from asperity.drive.layout.drive import sectors_of_members, turning_levers
from asperity.drive.layout.form import Form, Hills
from asperity.drive.state.equations import Machine
from asperity.engine.arrays import xp


def with_form(machine: Machine, form: Form) -> Machine:
    """The same machine at an instant at which its tracks are not round.

    Parameters
    ----------
    machine : Machine
        With round tracks.
    form : Form
        Form at its contacts, of the size of its interference.

    Returns
    -------
    Machine
        With the radii there in differences of surface speeds and in levers; the rolling speed, of which creepages are
        thousandths, has the nominal ones. A form of zeros is the machine itself.

    References
    ----------
    Equations (R1) to (R3) of :doc:`/equations`.
    """
    drive, layout = machine.drive, machine.drive.layout
    rises = form.first + layout.outward * form.second
    first, second = drive.first_radius + form.first, drive.second_radius + form.second
    copies, relative = sectors_of_members(drive)[:, None], layout.relative
    hills = form.first_slope[:, None] * relative[layout.first] + (
        (layout.outward * form.second_slope)[:, None] * relative[layout.second]
    )
    turning = turning_levers(layout, first, second)
    more = machine.matrices.turning - turning
    carried = xp.where(layout.unit[layout.carrier] > 0.0, 0.0 * more if layout.in_frame else more, 0.0)
    return machine._replace(
        matrices=dataclasses.replace(machine.matrices, turning=turning),
        added=rises if machine.added is None else machine.added + rises,
        hills=Hills(copies * hills.T, copies * carried.T),
    )

"""Contacts of steel as the paper's drive has them."""

import functools

from asperity.drive.state.smooth_laws import smooth_contact_laws

#: Laws of the contacts of a drive, 5 mm long, in rings with walls of 60 mm.
steel_laws = functools.partial(
    smooth_contact_laws,
    youngs_modulus=206e9,
    poisson_ratio=0.3,
    friction_coefficient=0.12,
    contact_length=5e-3,
    ring_wall_thickness=60e-3,
    reference_force=500.0,
)

"""The content of the joint file of each type of drive: a class for each type, a field for each key."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from asperity.joint_file import limits
from asperity.joint_file.drive_sections import (
    MultirollerDrive,
    PartLengths,
    PlanetaryDrive,
    RingSupport,
    RollerDrive,
    SteppedPlanetDrive,
)
from asperity.joint_file.general_model import GeneralCase
from asperity.joint_file.model import AxisCase, Case, ModelChoice
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.sections import (
    BearingTorque,
    BodyLength,
    BranchEntry,
    CrownRadius,
    HeldBearing,
    Length,
    MultirollerBranch,
    PinEntry,
    PlanetaryBranch,
    PushAngle,
    SteppedPlanetBranch,
)


class WedgeDrive(RollerDrive):
    """Radii and arrangement of the drive."""

    planets: Annotated[Quantity, limits.PLANETS]
    """Number of planets, equally spaced."""
    sun_radius: Length
    """Radius R_s of the sun roller."""
    planet_radius: Length
    """Radius R_p of the planets."""
    loading_roller_radius: Length
    """Radius R_w of the loading rollers, two to a planet."""
    ring_radius: Length
    """Inner radius R_o of the fixed outer ring."""
    ring_wall_thickness: Annotated[Quantity, limits.WALL_THICKNESS]
    """Wall of the outer ring."""
    contact_length: PartLengths
    """Length B of the contact lines: one for all, or a table with sp, pwr, pwl, wro, wlo."""
    left_push_angle: PushAngle
    """Direction gamma_l of the carrier's push on the left loading roller, from the tangent."""
    right_push_angle: PushAngle
    """Direction gamma_r of the carrier's push on the right loading roller, from the tangent."""
    planet_length: BodyLength | None = None
    """Length of a planet, for its mass; if absent, the longest contact line on it."""
    loading_roller_length: BodyLength | None = None
    """Length of a loading roller, for its mass; if absent, the longest contact line on it."""
    planet_bore_diameter: Annotated[Quantity, limits.BORE_DIAMETER] | None = None
    """Diameter of the bore of hollow planets; solid if absent."""
    loading_roller_bore_diameter: Annotated[Quantity, limits.BORE_DIAMETER] | None = None
    """Diameter of the bore of hollow loading rollers; solid if absent."""
    sun_crown_radius: CrownRadius | None = None
    """Radius of the sun's crown along its axis, highest in the middle of the contact line; over a length B it drops by
    B^2/8 over this radius at the ends. A cylinder if absent."""
    planet_crown_radius: CrownRadius | None = None
    """Radius of the planets' crown along their axes; cylinders if absent."""
    loading_roller_crown_radius: CrownRadius | None = None
    """Radius of the loading rollers' crown along their axes; cylinders if absent."""
    ring_crown_radius: CrownRadius | None = None
    """Radius of the ring's crown along its axis; a cylinder if absent."""
    ring_support: RingSupport | None = None
    """What holds the outer rim of the ring: a rigid housing into which it is shrunk, nothing, so that it bends, or a
    housing with the ring_housing_stiffness of [compliance] or the sizes in [housing]. A rigid housing if absent."""


class WedgeBearings(PinEntry):
    """Friction of the bearings, and the pins of the loading rollers; a joint file without this section has none."""

    sun_torque: BearingTorque
    """Friction torque of one of the two sun bearings."""
    loading_roller_torque: BearingTorque
    """Constant friction torque of one of the two bearings of a loading roller."""
    carrier_torque: BearingTorque
    """Friction torque of one of the two carrier bearings."""
    pin_friction_coefficient: Annotated[Quantity, limits.PIN_FRICTION_COEFFICIENT]
    """Friction coefficient mu_b of the loading rollers' pins: friction force over pin force, at pin_friction_diameter,
    or at pin_diameter; it needs one of them."""


class WedgeModelChoice(ModelChoice):
    """Which variants of the model to use."""

    closure: Literal["elastic", "constant_pin_force"]
    """What keeps the preload under torque: the interference of the parts, or a soft spring that keeps the force of the
    right pin."""
    traction_split: Literal["springs", "equal_coefficients"] = "springs"
    """How both loading rollers of a planet share its torque while the drive stands: by the slip of their contacts, or
    with equal traction coefficients, as the paper's closure assumes; springs if absent."""
    carrier_balance: Literal["complete", "printed"] | None = None
    """Moment of the carrier: with the friction torques of the loading rollers' bearings, complete, or without them as
    equation (5) is printed; complete if absent."""


class WedgeCase(Case):
    """A joint file: a planetary traction drive under load."""

    type: Literal["zou2025"] = "zou2025"
    """Type of the drive: the paper's, with two loading rollers in the wedges between each planet and the ring, if
    absent."""
    drive: WedgeDrive
    """Radii and arrangement."""
    bearings: WedgeBearings | None = None
    """Friction of the bearings; none if the section is absent."""
    sun_bearing: HeldBearing | None = None
    """Rolling bearings of the sun's shaft, for their life under forces from outside."""
    carrier_bearing: HeldBearing | None = None
    """Rolling bearings of the carrier, for their life under forces from outside."""
    branch: tuple[BranchEntry, ...] | None = None
    """Sizes of each planet and its loading rollers, where they differ: a section [[branch]] for each planet."""
    model: WedgeModelChoice
    """Variants of the model."""


class PlanetaryCase(AxisCase):
    """A joint file with a plain planetary drive."""

    type: Literal["planetary"]
    """Type of the drive."""
    drive: PlanetaryDrive
    """Radii and arrangement."""
    branch: tuple[PlanetaryBranch, ...] | None = None
    """Sizes of each planet, where they differ: a section [[branch]] for each."""
    places: ClassVar[tuple[str, ...]] = ("pin",)


class MultirollerCase(AxisCase):
    """A joint file with a two-row multiroller drive."""

    type: Literal["multiroller"]
    """Type of the drive."""
    drive: MultirollerDrive
    """Radii and arrangement."""
    branch: tuple[MultirollerBranch, ...] | None = None
    """Sizes of the rollers of each sector, where they differ: a section [[branch]] for each."""
    branches_are: ClassVar[tuple[str, str]] = ("rollers_per_row", "rollers in a row")


class SteppedPlanetCase(AxisCase):
    """A joint file with a drive of stepped planets."""

    type: Literal["stepped_planet"]
    """Type of the drive."""
    drive: SteppedPlanetDrive
    """Radii and arrangement."""
    branch: tuple[SteppedPlanetBranch, ...] | None = None
    """Sizes of each planet, where they differ: a section [[branch]] for each."""
    places: ClassVar[tuple[str, ...]] = ("pin",)


#: Model of the joint file of each type of drive.
CASES: dict[str, type[Case]] = {
    "zou2025": WedgeCase,
    "planetary": PlanetaryCase,
    "multiroller": MultirollerCase,
    "stepped_planet": SteppedPlanetCase,
    "planar": GeneralCase,
}

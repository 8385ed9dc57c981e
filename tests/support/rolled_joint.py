"""What a duty needs of a joint that turns."""

from typing import NamedTuple


class Lives(NamedTuple):
    """The life of the drive."""

    drive: object


class Rolled(NamedTuple):
    """What a duty needs of a joint that turns."""

    cycles: object
    cycles_per_turn: object
    output_speed: object
    life_hours: Lives
    shakedown_ratio: object
    slip_ratio: object
    film_ratio: object

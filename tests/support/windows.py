"""Joint files of which a window shows much: temperatures, a housing, tolerances, a duty and a life."""

from pathlib import Path

EXAMPLES = Path(__file__).parents[2] / "examples"

#: Planetary drive with hollow planets whose ring sits in a housing of aluminium, which lets it go at 59 degC.
_HOUSED = {
    'ring_support = "free"  ': 'ring_support = "elastic_housing"',
    'ring_wall_thickness = "8 mm"': 'ring_wall_thickness = "20 mm"',
    '# planet_bore_diameter = "24 mm"': 'planet_bore_diameter = "26 mm"',
    'interference = "30 um"  ': 'interference = "40 um"',
    "# [temperature]\n# assembly": "[temperature]\nassembly",
    '# working = "60 degC"': 'working = "40 degC"',
    "# [housing]\n# outer_diameter": "[housing]\nouter_diameter",
    '# interference = "60 um"': 'interference = "60 um"',
    "# friction_coefficient = 0.12": "friction_coefficient = 0.12",
    'ring = "52100"': 'ring = "52100"\nhousing = "6061-T6"',
}

#: A duty in both directions with a load that stands.
DUTY = "".join(
    f'\n[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "{speed} rpm"\nshare = {share}\n'
    for torque, speed, share in ((6, 1500, 0.5), (-9, 600, 0.3), (12, 0, 0.2))
)


def housed(*, radius: str = "20 mm", life: str = "", duty: str = "") -> str:
    """Text of the joint file of the drive in the housing, with radius of the planets, required life and duty."""
    text = (EXAMPLES / "planetary.toml").read_text()
    changes = {**_HOUSED, 'planet_radius = "20 mm"': f'planet_radius = "{radius}"'}
    if life:
        changes["# [rolling]"] = f'[rolling]\nrequired_life = "{life}"\n'
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new, 1)
    return text + duty

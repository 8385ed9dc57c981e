"""The window of a planetary drive in a housing of aluminium: its torques over temperature, with tolerances and a duty.

The housing grows faster than the ring of steel that is pressed into it, and lets it go.

Run it: ``python examples/window.py [picture.png]``.
"""

import sys
from pathlib import Path

import asperity
from asperity.api.window import JointWindow
from asperity.show.window_figure import window_figure

HERE = Path(__file__).parent
PICTURE = HERE.parent / "docs" / "images" / "window.png"
TITLE = "A planetary drive in a housing of aluminium"
#: What the file of the plain planetary drive says in its comments, and further numbers.
CHANGES = {
    "# [temperature]\n# assembly": "[temperature]\nassembly",
    '# working = "60 degC"': 'working = "45 degC"',
    'ring_support = "free"  ': 'ring_support = "elastic_housing"  ',
    'ring_wall_thickness = "8 mm"': 'ring_wall_thickness = "20 mm"',
    '# planet_bore_diameter = "24 mm"': 'planet_bore_diameter = "26 mm"',
    'planet_radius = "20 mm"': 'planet_radius = "20 mm +- 1 um"',
    'interference = "30 um"  ': 'interference = "40 um +- 3 um"',
    "# [housing]\n# outer_diameter": "[housing]\nouter_diameter",
    '# interference = "60 um"': 'interference = "60 um"',
    "# friction_coefficient = 0.12": "friction_coefficient = 0.12",
    'ring = "52100"': 'ring = "52100"\nhousing = "6061-T6"',
}
#: Loads of the duty: torque [N·m], speed of the sun [rpm], share of the time [-].
LOADS = ((6, 1500, 0.6), (14, 600, 0.3), (19, 0, 0.1))


def joint_text() -> str:
    """The joint file."""
    text = (HERE / "planetary.toml").read_text(encoding="utf-8")
    for old, new in CHANGES.items():
        text = text.replace(old, new, 1)
    return text + "".join(
        f'\n[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "{speed} rpm"\nshare = {share}\n'
        for torque, speed, share in LOADS
    )


def main(picture: Path) -> JointWindow:
    """Draw the window, and return it."""
    joint = asperity.load(HERE / "planetary.toml").edited(joint_text())
    window = asperity.window(joint, start="0 degC", stop="70 degC", points=15)
    window_figure(window.window, title=TITLE).savefig(picture, dpi=110)
    return window


if __name__ == "__main__":
    print(main(Path(sys.argv[1]) if len(sys.argv) > 1 else PICTURE))

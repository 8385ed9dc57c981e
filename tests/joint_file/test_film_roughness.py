"""The roughness under the oil film: that of the file, or that which the Ra of the surfaces means."""

import math
import re
from pathlib import Path

import pytest
from assumed import assumptions

from asperity.joint_file.build import joint_from_values
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values

EXAMPLES = Path(__file__).parents[2] / "examples"
OIL = '\n[lubrication]\nviscosity = "30.5 mPa*s"\npressure_coefficient = "29 1/GPa"\n'
BY_AVERAGE = 'finish = "ground"\nroughness_average = "0.3 um"\n'


def roughness_of(text):
    return joint_from_values(si_values(parse_case(text, source="x"))).rolling.roughness


@pytest.mark.parametrize("name", ["zou2025", "planetary", "multiroller", "stepped_planet", "planar"])
def test_the_film_is_compared_with_the_heights_that_an_ra_means(name):
    """Normal heights: E|z| = sqrt(2/pi) Rq, and the squares of both bodies add: 0.3 and 0.4 um make 0.5 um of Ra."""
    text = (EXAMPLES / f"{name}.toml").read_text()
    text = re.sub(r"(?s)\[surface\].*?(?=\n\[|\Z)", "[surface]\n" + BY_AVERAGE, text)
    text = re.sub(r"(?ms)^\[lubrication\].*?(?=^\[|\Z)", "", text)
    alike, unlike = text, text.replace('"0.3 um"\n', '"0.3 um"\npartner_roughness_average = "0.4 um"\n')
    assert roughness_of(alike) is None  # no oil
    assert roughness_of(alike + OIL) == pytest.approx((math.sqrt(math.pi) * 0.3e-6,))
    assert roughness_of(unlike + OIL) == pytest.approx((math.sqrt(math.pi / 2.0) * 0.5e-6,))
    assert roughness_of(alike + OIL + 'roughness = "0.2 um"\n') == pytest.approx((0.2e-6,))
    case = parse_case(alike + OIL, source="x")
    said = assumptions(case)
    assert any("Rq = sqrt(pi/2) Ra = 1.2533 Ra" in sentence for sentence in said)


def test_without_the_ra_of_every_surface_there_is_no_roughness_to_compare():
    assert roughness_of((EXAMPLES / "zou2025.toml").read_text() + OIL) is None

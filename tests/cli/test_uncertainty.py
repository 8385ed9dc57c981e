"""``asperity uncertainty``: what it needs, and the interval of a result with a formula."""

import json
from pathlib import Path

import numpy as np
import pytest
from commands import run

from asperity.errors import InputError

FILE = str(Path(__file__).parents[2] / "examples" / "zou2025.toml")


pytestmark = pytest.mark.usefixtures("own_folder")


@pytest.mark.slow
def test_uncertainty_needs_tolerances_and_distributions(tmp_path):
    with pytest.raises(InputError, match="no tolerances"):
        run("uncertainty", FILE)
    text = Path(FILE).read_text().replace('"13.5 mm"', '"13.5 mm +- 5 um"')
    (tmp_path / "t.toml").write_text(text)
    with pytest.raises(InputError, match="not its distribution"):
        run("uncertainty", "t.toml")
    with pytest.raises(InputError, match="distributed as"):
        run("uncertainty", "t.toml", "--distribution", "gauss")
    arguments = [
        "--distribution",
        "uniform",
        "--samples",
        "500",
        "--results",
        "body_mass,speed_ratio",
        "--json",
        "--plot",
        "u.svg",
    ]
    done = run("uncertainty", "t.toml", *arguments)
    document = json.loads(done.stdout)
    mass = document["results"]["body_mass_planet"]
    # m = pi rho R^2 B of a solid steel roller
    assert mass["nominal"] == pytest.approx(np.pi * 7850.0 * 0.0135**2 * 0.005, rel=1e-12)
    # a uniform radius of half-width 5 um: relative standard deviation of m is 2 * 5 um / (sqrt(3) * 13.5 mm)
    assert mass["standard_deviation"] / mass["mean"] == pytest.approx(
        2.0 * 5e-6 / (3**0.5 * 13.5e-3), rel=0.1
    )
    assert document["inputs"]["drive.planet_radius"]["distribution"] == "uniform"
    assert (tmp_path / "u.svg").stat().st_size > 5_000

"""A finish in a surface: what it fills in, and what is refused with a reason."""

import pytest

from asperity.errors import InputError
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.finish_in_surface import dimension_text, fill_in_finishes
from asperity.joint_file.reader import parse_case
from asperity.library import read_finishes


@pytest.fixture(scope="module")
def case_with(example_text):
    head = example_text[: example_text.index("[surface]")]
    return lambda surface: parse_case(f"{head}{surface}\n", source="a.toml")


def test_a_finish_gives_the_published_range_of_d(case_with):
    entry = case_with('[surface]\nfinish = "ground"\nroughness_average = "0.2 um"').surface
    low, high = read_finishes()["ground"].published_dimension
    dimension = entry.fractal_dimension
    assert (dimension.value - dimension.tolerance, dimension.value + dimension.tolerance) == pytest.approx(
        (low, high)
    )
    assert dimension.distribution.kind == "uniform"
    assert entry.frequency_ratio.value == 1.5


def test_what_the_file_states_stays(case_with):
    text = '[surface]\nfinish = "honed"\nroughness_average = "0.2 um"\nfractal_dimension = "1.4 +- 0.1"'
    assert case_with(text).surface.fractal_dimension.tolerance == pytest.approx(0.1)


def test_each_contact_may_have_its_own():
    tables = {
        "surface": {
            "sp": {"finish": "ground", "roughness_average": "0.2 um"},
            "pwr": {"fractal_dimension": 1.4, "fractal_roughness": "1e-8 mm", "frequency_ratio": 1.5},
        }
    }
    filled, refused = fill_in_finishes(tables)
    assert refused == {}
    assert filled["surface"]["sp"]["fractal_dimension"] == dimension_text(read_finishes()["ground"])
    assert filled["surface"]["pwr"] == tables["surface"]["pwr"]
    assert "fractal_dimension" not in tables["surface"]["sp"]


@pytest.mark.parametrize(
    ("surface", "message"),
    [
        (
            'finish = "grund"\nroughness_average = "0.2 um"',
            r"a\.toml: surface\.finish: there is no finish 'grund'; known are ground, honed",
        ),
        ('roughness_average = "0.2 um"', "Ra fixes one combination of D and G; add a finish"),
        ('finish = "ground"\nRz = "1.6 um"', r"surface\.Rz: .* its ratio to Ra depends on the process"),
        ('finish = "ground"\nRa = "0.2 um"', "did you mean 'roughness_average'"),
        ('finish = "ground"', "exactly one of 'fractal_roughness' and 'roughness_average'.* got neither"),
        (
            'finish = "ground"\nroughness_average = "0.2 um"\nfractal_roughness = "1e-8 mm"',
            "got both",
        ),
        (
            'finish = "ground"\nfractal_roughness = "1e-8 mm"\ncut_off = "0.8 mm"',
            "cut_off: only with roughness_average",
        ),
        ('finish = "ground"\nroughness_average = "0.2 mm"', "200 um is not allowed.* at most 100 um"),
        ('finish = "ground"\nroughness_average = 0.2', r"expected a length with its unit as text"),
    ],
)
def test_what_makes_no_surface_is_refused_with_a_reason(case_with, surface, message):
    with pytest.raises(InputError, match=message):
        case_with(f"[surface]\n{surface}")


def test_a_g_takes_the_place_of_an_ra_and_its_companions(case_with):
    case = case_with(
        '[surface]\nfinish = "ground"\nroughness_average = "0.2 um"\npartner_roughness_average = "0.1 um"\n'
        'cut_off = "0.8 mm"  # of the instrument'
    )
    written = joint_file_text(case, {"surface.fractal_roughness": 1e-11}, comment="")
    assert written.endswith('[surface]\nfinish = "ground"\nfractal_roughness = "1e-08 mm"\n')
    back = joint_file_text(
        parse_case(written, source="b.toml"), {"surface.roughness_average": 1e-6}, comment=""
    )
    assert "fractal_roughness" not in back.split("[surface]\n")[1]

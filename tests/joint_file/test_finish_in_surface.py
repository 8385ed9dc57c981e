"""A finish in a surface: what it fills in, and what is refused with a reason."""

import pytest
import tomlkit
from assumed import assumptions

from asperity.errors import InputError
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.finish_in_surface import dimension_text, fill_in_finishes
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.library import read_finishes
from asperity.surface.roughness_average import depth_over_average


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


@pytest.mark.parametrize("height", ['roughness_average = "0.2 um"', 'mean_roughness_depth = "1.6 um"'])
def test_an_average_alone_has_the_range_of_all_finishes(case_with, height):
    case = case_with(f"[surface]\n{height}")
    dimension = case.surface.fractal_dimension
    ends = [end for finish in read_finishes().values() for end in finish.published_dimension]
    assert dimension.value - dimension.tolerance == pytest.approx(min(ends))
    assert dimension.value + dimension.tolerance == pytest.approx(max(ends))
    assert case.contact_law() == "exponential"
    told = " ".join(assumptions(case))
    assert "surface.roughness_average without a finish: D is that of any finish" in told
    assert "h = 1.2533 Ra of both bodies together" in told


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
        (
            'Rq = "0.2 um"',
            r"surface\.Rq: unknown key; did you mean 'rms_height', of both bodies together: sqrt\(2\)",
        ),
        ('finish = "ground"\nroughness_rz = "1.6 um"', "did you mean 'mean_roughness_depth'"),
        ('finish = "ground"\nRz = "1.6 um"', r"surface\.Rz: .* did you mean 'mean_roughness_depth'"),
        (
            'finish = "ground"\nRt = "1.6 um"',
            r"surface\.Rt: .* which a single scratch decides; give roughness_av",
        ),
        (
            'finish = "ground"\nmean_roughness_depth = "1.6 um"\nroughness_average = "0.3 um"',
            r"a\.toml: surface: both mean_roughness_depth and roughness_average are given",
        ),
        (
            'finish = "ground"\nmean_roughness_depth = "1.6 um"\nfractal_roughness = "1e-8 mm"',
            "both mean_roughness_depth and fractal_roughness are given",
        ),
        (
            'finish = "ground"\nmean_roughness_depth = 1.6',
            "mean_roughness_depth: expected a length with its unit",
        ),
        ('finish = "ground"\nmean_roughness_depth = "1 mm"', "1000 um is not allowed.* at most 100 um"),
        (
            'finish = "ground"\nmean_roughness_depth = "1.6 um"\ncut_off = "1 mm"',
            r"surface\.cut_off: .* 0\.8 mm, 2\.5 mm, 8 mm, got 1 mm; or give roughness_average",
        ),
        (
            'finish = "ground"\nmean_roughness_depth = "1.6 um +- 0.2 um, normal 2 sigma"',
            "ends of a range; leave 'normal 2 sigma' out",
        ),
        (
            'finish = "ground"\nmean_roughness_depth = "1.6 um +- 1.5 um"',
            "leaves Ra open down to zero; its tol",
        ),
        (
            'fractal_dimension = "1.9 +- 0.2"\nfrequency_ratio = 1.5\nmean_roughness_depth = "1.6 um"',
            "fractal_dimension: the Ra of an Rz needs a range between 1 and 2, got '1.9 \\+- 0.2'",
        ),
        (
            'finish = "ground"\nmean_roughness_depth = "1.6 um"\npartner_mean_roughness_depth = "0.4 um"',
            r"surface\.partner_mean_roughness_depth: .* the cut-off 0\.25 mm and the other body with 0\.8 mm; measure",
        ),
        (
            'finish = "ground"\nroughness_average = "0.05 um"\npartner_mean_roughness_depth = "1.6 um"',
            r"cut-off 0\.8 mm and the other body with 0\.25 mm; measure both with one cut-off, and give it as cut_off",
        ),
        (
            'finish = "ground"\nfractal_roughness = "1e-8 mm"\npartner_mean_roughness_depth = "1.6 um"',
            "surface: partner_mean_roughness_depth: only with roughness_average or mean_roughness_depth",
        ),
        (
            'finish = "ground"\nroughness_average = "0.1 um +- 0.2 um"',
            r"roughness_average: '0\.1 um \+- 0\.2 um' reaches below zero; its tolerance has to be smaller",
        ),
        (
            'finish = "ground"\nroughness_average = "0.2 um"\npartner_roughness_average = "0 um +- 0.1 um"',
            r"partner_roughness_average: '0 um \+- 0\.1 um' reaches below zero",
        ),
        (
            'finish = "ground"\nroughness_average = "0.2 um"\npartner_mean_roughness_depth = "1 um"\n'
            'partner_roughness_average = "0.1 um"',
            "both partner_mean_roughness_depth and partner_roughness_average are given",
        ),
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


RZ = '[surface]\nfinish = "ground"\nmean_roughness_depth = "1.6 um +- 0.2 um"  # drawing'


def test_an_rz_gives_the_range_of_ra_at_its_own_cut_off(case_with):
    """The ends of D with the ends of Rz: the ratio rises with D."""
    entry = case_with(RZ).surface
    assert (entry.cut_off.value, entry.mean_roughness_depth) == (pytest.approx(0.8e-3), "1.6 um +- 0.2 um")
    found = entry.roughness_average
    low, middle, high = (depth_over_average(fractal_dimension=d, cut_off=0.8e-3) for d in (1.15, 1.325, 1.5))
    assert found.value == pytest.approx(1.6e-6 / middle, rel=1e-5)
    assert found.tolerance == pytest.approx(
        max(1.8e-6 / low - found.value, found.value - 1.4e-6 / high), rel=1e-5
    )
    assert found.distribution.kind == "uniform"
    shorter = case_with(RZ.replace('1.6 um +- 0.2 um"', '0.5 um"')).surface
    assert shorter.cut_off.value == pytest.approx(0.25e-3)  # 0.1 um of Ra would have the same, 0.11 um not
    assert shorter.roughness_average.tolerance > 0.1 * shorter.roughness_average.value


def test_the_rz_of_a_partner_is_read_as_its_own_would_be(case_with):
    """1 um at the cut-off of both bodies: that of the other's Rz or Ra, or the one that is given."""
    alone = case_with(RZ.replace("1.6 um +- 0.2 um", "1 um")).surface.roughness_average
    for other, cut_off in (
        ('mean_roughness_depth = "1.6 um"', 0.8e-3),
        ('roughness_average = "0.3 um"', 0.8e-3),
        ('roughness_average = "0.05 um"\ncut_off = "0.8 mm"', 0.8e-3),
    ):
        entry = case_with(
            f'[surface]\nfinish = "ground"\n{other}\npartner_mean_roughness_depth = "1 um"'
        ).surface
        found = entry.partner_roughness_average
        assert (found.value, found.tolerance) == (alone.value, alone.tolerance)
        assert entry.cut_off.value == pytest.approx(cut_off)
    finer = 'mean_roughness_depth = "1.6 um"\ncut_off = "0.25 mm"\npartner_mean_roughness_depth = "1 um"'
    entry = case_with(f'[surface]\nfinish = "ground"\n{finer}').surface
    ratio = depth_over_average(fractal_dimension=1.325, cut_off=0.25e-3)
    assert entry.partner_roughness_average.value == pytest.approx(1e-6 / ratio, rel=1e-5)


PARTNER = 'partner_mean_roughness_depth = "1 um"'


@pytest.mark.parametrize("partner", ["", f"\n{PARTNER}"])
def test_a_surface_with_an_rz_that_was_filled_in_stays(case_with, partner):
    case = case_with(f"{RZ}{partner}")
    stated = {"finish": "ground", "mean_roughness_depth": case.surface.mean_roughness_depth}
    if partner:
        stated["partner_mean_roughness_depth"] = "1 um"
    filled, refused = fill_in_finishes({"surface": stated})
    assert (fill_in_finishes(filled), refused) == ((filled, {}), {})


@pytest.mark.parametrize("partner", ["", f"\n{PARTNER}"])
def test_a_file_with_an_rz_is_written_back_with_the_ra_that_a_study_had(case_with, partner):
    case = case_with(f"{RZ}{partner}")
    for changes in (
        {"surface.fractal_dimension": 1.4},
        {"surface.roughness_average": 4e-7},
        {"drive.planets": 4},
    ):
        written = joint_file_text(case, changes, comment="")
        back = parse_case(written, source="b.toml")
        assert back.surface.mean_roughness_depth is None
        assert back.surface.partner_mean_roughness_depth is None
        keys = list(tomlkit.parse(written)["surface"])  # the same whatever the hashes of texts are
        both = ["roughness_average", "cut_off", *(["partner_roughness_average"] if partner else [])]
        assert [key for key in keys if key in both] == both
        assert back.text == written
        wanted = replace_values(si_values(case), changes)["surface"]
        assert si_values(back)["surface"] == wanted
    with pytest.raises(InputError, match=r"vary 'surface\.sp\.roughness_average' instead"):
        replace_values(si_values(case), {"surface.sp.mean_roughness_depth": 1e-6})
    with pytest.raises(InputError, match=r"vary 'surface\.partner_roughness_average' instead"):
        replace_values(si_values(case), {"surface.partner_mean_roughness_depth": 1e-6})


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

"""A measured surface in the place of a joint file's."""

import dataclasses
import math
import re
import tomllib

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.special import erf

from asperity.contact.laws.measured import decay_ratio
from asperity.errors import InputError
from asperity.joint.description import contact_values
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.drawn_surface import with_measured_surface
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.felt_heights import Felt, assumed_heights
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.measured_surface import case_with_surface
from asperity.joint_file.solved_document import full_document, solved_case
from asperity.surface.height_spectrum import HeightSpectrum, spectrum_of_map, spectrum_of_profiles
from asperity.surface.measure_files import measured_files
from asperity.surface.measured_roughness import MeasuredRoughness
from asperity.surface.measurement import SurfaceMeasurement
from asperity.surface.pressed_map import pressed_map_from_document
from asperity.surface.synthesis import spectral_profile, spectral_surface
from asperity.surface.topography import Topography

OPTIONS = {
    **dict.fromkeys(("spacing", "start", "stop", "form", "degree", "outlier_threshold", "short_cutoff")),
    **dict.fromkeys(("long_cutoff", "shortest_wavelength", "longest_wavelength")),
    "decimal": "auto",
    "column": None,
    "no_data": None,
    "any_size": False,
    "missing": "refuse",
    "direction": "x",
    "estimator": "automatic",
    "frequency_ratio": 1.5,
}

NUMBERS = {"fractal_dimension": 1.25, "fractal_roughness": 3e-13, "frequency_ratio": 1.5}


def measured(**numbers):
    return SurfaceMeasurement(
        **{name: jnp.asarray(value) for name, value in (NUMBERS | numbers).items()},
        covariance=jnp.eye(2) * 1e-4,
        shortest_wavelength=jnp.asarray(1e-6),
        longest_wavelength=jnp.asarray(1e-3),
        estimator="test",
        profiles=1,
        source="test",
    )


def test_it_holds_for_every_contact_without_losing_a_digit(example_case):
    surface = with_measured_surface(example_case, measured()).surface
    assert {name: getattr(surface, name).value for name in NUMBERS} == pytest.approx(
        NUMBERS, rel=1e-15, abs=0.0
    )
    assert surface.roughness_average is None


def test_it_is_written_instead_of_the_files(example_case):
    case = with_measured_surface(example_case, measured())
    found = tomllib.loads(joint_file_text(case, {"load.preload": 900.0}, comment=""))
    assert found["surface"]["fractal_dimension"] == 1.25
    number, unit = found["surface"]["fractal_roughness"].split()
    assert float(number) * {"m": 1.0, "mm": 1e-3}[unit] == pytest.approx(3e-13, rel=1e-12, abs=0.0)
    assert found["load"]["preload"] == "900 N"


def test_what_no_joint_file_may_have_is_refused(example_case):
    with pytest.raises((InputError, ValueError), match="fractal_dimension"):
        with_measured_surface(example_case, measured(fractal_dimension=2.1))


def test_it_takes_the_place_of_those_of_other_drives(planar_case):
    case = with_measured_surface(planar_case("planetary"), measured())
    assert {name: getattr(case.surface, name).value for name in NUMBERS} == pytest.approx(
        NUMBERS, rel=1e-15, abs=0.0
    )
    assert case.type == "planetary"


def roughness(*spectra, fractal=None):
    of = "pair" if len(spectra) == 2 else "body"
    return MeasuredRoughness(fractal, "no power law" if fractal is None else "", spectra, "a surface", of)


def profile_spectrum(lay, factor=1.0):
    heights = spectral_profile(
        points=8000,
        spacing=1e-6,
        fractal_dimension=1.5,
        fractal_roughness=1e-12,
        periodic=False,
        random=np.random.default_rng(3),
    )
    return spectrum_of_profiles(profiles=factor * heights[None], spacing=1e-6, lay=lay, source="profile")


@pytest.fixture(scope="module")
def isotropic_map():
    heights = spectral_surface(
        rows=256,
        columns=256,
        spacing=2e-6,
        fractal_dimension=1.5,
        areal_fractal_roughness=4e-10,
        periodic=True,
        random=np.random.default_rng(3),
    )
    return spectrum_of_map(topography=Topography(heights, 2e-6, 2e-6, source="map"), rolling="x")


@pytest.mark.parametrize(
    ("lay", "width", "axial", "said"),
    [
        ("axis", 6e-3, 8e-5, "longer than 5.33 mm in the rolling direction.*those up to 6 mm"),
        ("axis", 1e-4, 8e-3, None),  # its waves are endless along the axis
        ("rolling", 6e-3, 8e-5, None),
        ("rolling", 1e-4, 8e-3, "longer than 5.33 mm along the axis"),
    ],
)
def test_a_surface_smaller_than_the_contact_is_said(lay, width, axial, said):
    spectrum = profile_spectrum(lay)  # 8 mm
    felt = {"sp": Felt(1e-7, 0.0, width, (axial,), 0.0, (1e-14,))}
    told = "; ".join(assumed_heights(roughness(spectrum), felt))
    assert bool(re.search(said or "nothing is known", told)) == (said is not None)


def grooves(case, name):
    """How much stiffer the lay of a contact makes it, (A12) by hand."""
    share = case.surface[name].rolling_share
    return 1.0 if share is None else 1.0 + 0.155 * abs(2.0 * share.value - 1.0) ** 1.5


@pytest.mark.slow
def test_heights_and_stiffness_of_a_joint_by_hand(example_case, isotropic_map):
    """h of the waves of both bodies, which are alike, at the printed width of each contact; K_n of 0.48 h.

    Nothing depends on the file's surface.
    """
    made = case_with_surface(example_case, roughness(isotropic_map))
    assert made.contact_law() == "exponential"
    joint = joint_from_case(made)
    result = solve_joint(joint).result
    widths = 2.0 * np.asarray(result.diagnostics.hertz_half_width)
    force, stiffness = np.asarray(result.forces.normal), np.asarray(result.contacts.normal_stiffness)
    for name, width, n, k in zip(("sp", "pwr", "pwl", "wro", "wlo"), widths, force, stiffness, strict=True):
        square, deviation = isotropic_map.felt(rolling=1.0 / width, axial=0.0)  # lines longer than the map
        height = made.surface[name].rms_height.value
        assert height == pytest.approx(math.sqrt(2.0 * square), rel=1e-3)
        assert k == pytest.approx(line_stiffness(n, 0.48 * height / grooves(made, name), joint), rel=1e-9)
        low, middle, high = made.measured.heights[f"surface.{name}"]
        assert (
            high / middle
            == pytest.approx(middle / low)
            == pytest.approx(math.exp(0.98 * deviation / square), rel=1e-3)
        )  # one measurement of both bodies: their scatter does not average out
    told = " ".join(made.measured.assumed)
    assert "the joint uses the measured spectrum; no power law" in told
    assert "nothing is known of waves longer than 0.341 mm along the axis, two thirds of its size" in told
    other = example_case.model_copy(update={"surface": SurfaceEntry.model_validate({"rms_height": "1 um"})})
    again = case_with_surface(other, roughness(isotropic_map)).surface["sp"].rms_height.value
    assert again == made.surface["sp"].rms_height.value


@pytest.mark.long
def test_the_interval_has_the_part_of_the_law_and_that_of_the_measurement(example_case):
    made = case_with_surface(example_case, roughness(profile_spectrum("rolling")))
    interval = made.measured.document(made, None)["stiffness_interval"]
    law, heights = (interval["parts"][name]["assembly"] for name in ("contact_law", "rms_height"))
    here = float(solve_joint(joint_from_case(made)).result.assembly.stiffness.output)
    for part in (law, heights, interval["assembly"]):
        assert part["low_Nm_per_rad"] < here < part["high_Nm_per_rad"]
    assert interval["assembly"]["low_Nm_per_rad"] < min(law["low_Nm_per_rad"], heights["low_Nm_per_rad"])


@pytest.mark.slow
def test_stiffness_of_the_asperities_at_the_ends_by_hand(example_case):
    """K_n of 0.48 h over the 1.155 of grooves, of preloads that the surfaces do not move: at 0.39 to 1.24 times h."""
    made = case_with_surface(example_case, roughness(profile_spectrum("rolling")))
    joint = joint_from_case(made)
    result = solve_joint(joint).result
    ends = made.measured.interval(made, None)["contacts"]["sp"]
    low, middle, high = made.measured.heights["surface.sp"]
    force, stiffness = float(result.forces.normal[0]), np.asarray(result.contacts.normal_stiffness)[0]
    assert stiffness == pytest.approx(line_stiffness(force, 0.48 / 1.155 * middle, joint), rel=1e-9)
    for part, (least, most) in {
        "both": (0.39 * low, 1.24 * high), "contact_law": (0.39 * middle, 1.24 * middle), "rms_height": (low, high),
    }.items():  # fmt: skip
        expected = [line_stiffness(force, 0.48 / 1.155 * end, joint) for end in (most, least)]
        assert ends["asperity_normal_stiffness_N_per_m"][part] == pytest.approx(expected, rel=0.02)
        ratio = np.divide(ends["asperity_tangential_stiffness_N_per_m"][part], expected)
        assert ratio == pytest.approx(float(result.contacts.tangential_stiffness[0]) / stiffness, rel=0.02)


@pytest.mark.slow
def test_form_that_the_line_load_does_not_close_is_in_the_soft_end(example_case):
    """Waves of 1 to 2.5 mm along the axis, longer than the cut-off of 0.8 mm, of 10 nm and of 10 um."""

    def made_with(form):
        spectrum = HeightSpectrum(
            rolling_edges=np.zeros(2),
            axial_edges=np.array([100.0, 400.0, 1000.0, 1300.0, 5e4]),
            mean_square=np.array([[0.0, form**2, 0.0, 0.15e-6**2]]),
            independent=np.full((1, 4), 40.0),
            lay="rolling",
            is_map=False,
            source="roller",
        )
        return case_with_surface(example_case, roughness(spectrum))

    closed, deep = made_with(10e-9), made_with(10e-6)
    assert closed.measured.heights == deep.measured.heights
    assert max(closed.measured.form.values()) < 1e-10
    assert not [told for told in closed.measured.assumed if told.startswith("form along the axis")]
    (told,) = [told for told in deep.measured.assumed if told.startswith("form along the axis")]
    height = deep.measured.heights["surface.sp"][1]
    assert f"{1.0 + deep.measured.form['sp'] / (0.48 / 1.155 * height):.3g} times at sp" in told
    interval = deep.measured.interval(deep, None)
    assert interval["form_decay_length_m"] == deep.measured.form
    joint = joint_from_case(deep)
    force = float(solve_joint(joint).result.forces.normal[0])
    soft = line_stiffness(force, 1.24 * 0.48 / 1.155 * height + deep.measured.form["sp"], joint)
    low, _ = interval["contacts"]["sp"]["asperity_normal_stiffness_N_per_m"]["contact_law"]
    assert low == pytest.approx(soft, rel=0.02)


@pytest.mark.long
@pytest.mark.parametrize(
    "kind", ["planar", *(pytest.param(kind, marks=pytest.mark.long) for kind in ("planetary", "multiroller"))]
)
def test_two_bodies_in_every_drive(planar_case, kind):
    """The mean squares of two bodies add: of heights in the ratio 3 to 4 the pair has 5, of 3 and 3 sqrt(18)."""
    one, other = (profile_spectrum("rolling", factor) for factor in (0.3, 0.4))
    case = planar_case(kind)
    pair = case_with_surface(case, roughness(one, other)).surface
    alone = case_with_surface(case, roughness(one)).surface
    for name, entry in pair.items():
        assert entry.rms_height.value / alone[name].rms_height.value == pytest.approx(
            5.0 / math.sqrt(18.0), rel=1e-6
        )


def test_a_profile_needs_a_stated_lay(example_case):
    with pytest.raises(InputError, match=r"with --lay: rolling .*isotropic \(no grooves\)$"):
        case_with_surface(example_case, roughness(profile_spectrum(None)))
    with pytest.raises(InputError, match=r'or state model\.contact_law = "zou_2025"'):
        case_with_surface(example_case, roughness(profile_spectrum(None), fractal=measured()))


def test_the_published_law_takes_d_and_g(example_case):
    def stated(law):
        return example_case.model_copy(
            update={"model": example_case.model.model_copy(update={"contact_law": law})}
        )

    made = case_with_surface(stated("zou_2025"), roughness(profile_spectrum(None), fractal=measured()))
    assert made.surface.fractal_dimension.value == pytest.approx(1.25)
    # G of both bodies, which are alike: G^(2 (D - 1)) doubles
    assert made.surface.fractal_roughness.value == pytest.approx(3e-13 * 2.0 ** (0.5 / 0.25), rel=1e-12)
    assert made.measured.heights is None
    (told,) = made.measured.assumed
    assert told.startswith("measured surface: each body as measured: a surface; both are alike")
    with pytest.raises(InputError, match=r"needs D and G, which a surface does not have \(no power law\)"):
        case_with_surface(stated("zou_2025"), roughness(profile_spectrum("rolling")))
    earlier = case_with_surface(example_case, roughness(fractal=measured()))
    assert earlier.contact_law() == "zou_2025"
    assert "a document of an earlier release" in earlier.measured.assumed[1]
    with pytest.raises(InputError, match="measure the surface again with this release"):
        case_with_surface(stated("exponential"), roughness(fractal=measured()))
    with pytest.raises(InputError, match="neither a power law nor a spectrum"):
        case_with_surface(example_case, roughness())


def test_a_flat_surface_is_one_message(example_case):
    flat = spectrum_of_profiles(profiles=np.zeros((1, 100)), spacing=1e-6, lay="axis", source="flat")
    with pytest.raises(InputError, match="flat: all heights are equal"):
        case_with_surface(example_case, roughness(flat))


@pytest.mark.parametrize("size", [1e-14, 1e-2])
def test_heights_beyond_those_of_a_joint_file_are_one_message(example_case, size):
    profile = size * np.random.default_rng(1).normal(size=(1, 100))
    spectrum = spectrum_of_profiles(profiles=profile, spacing=1e-6, lay="axis", source="x")
    with pytest.raises(
        InputError, match=r"makes rms_height: .* um is not allowed; it must be at least .* units"
    ):
        case_with_surface(example_case, roughness(spectrum))


@pytest.mark.slow
def test_a_roller_that_has_no_power_law_makes_a_joint(shared_data, example_case):
    """NU206-RE-1: Rq 0.127 µm on its middle 40 % after a parabola, by another program; both bodies are alike."""
    found = measured_files(
        [shared_data / "bearing_roller_profiles" / "NU206-RE-1.txt"],
        **OPTIONS | {"position_unit": "mm", "height_unit": "um", "lay": "rolling"},
    )
    assert isinstance(found.fit, str)
    made = case_with_surface(example_case, found.roughness)
    for entry in made.surface.values():
        assert entry.rms_height.value == pytest.approx(math.sqrt(2.0) * 0.127e-6, rel=0.05)
    assert "no power law over at least 1 decade" in made.measured.assumed[1]


def stated(case, law):
    return case.model_copy(update={"model": case.model.model_copy(update={"contact_law": law})})


def pressed(spectrum, *, scale=1.0, hardness=0.05, pressure=(1e-4, 2e-2)):
    """A spectrum with a table: the decay length falls from 0.5 to 0.3 of the heights, capped a fifth shorter."""
    elastic = scale * np.array([[0.51, 0.306], [0.5**2 / 0.51, 0.3**2 / 0.306]])
    table = {
        "pressure": list(pressure),
        "hardness": hardness,
        "rms_height": [1e-7, 1e-7],
        "decay_ratios": [elastic.tolist(), (0.8 * elastic).tolist()],
        "contact_fractions": [[[0.1, 0.5]] * 2] * 2,
        "tangential_ratios": [[0.8, 0.8]] * 2,
        "size": [1e-4, 1e-4],
    }
    return dataclasses.replace(spectrum, pressed=pressed_map_from_document(table))


@pytest.mark.slow
def test_the_measured_law_by_hand(example_case, isotropic_map):
    """K_n of u, that of the table times the heights of the exponential law; both ends of its error.

    Both bodies are alike: heights and pressures scale together, so that the table of one has u/h at N/(2 b L E) over
    the square root of 2.
    """
    made = case_with_surface(stated(example_case, "measured"), roughness(pressed(isotropic_map)))
    assert made.contact_law() == "measured"
    by_heights = case_with_surface(example_case, roughness(isotropic_map)).surface
    joint = joint_from_case(made)
    result = solve_joint(joint).result
    force, width = np.asarray(result.forces.normal), 2.0 * np.asarray(result.diagnostics.hertz_half_width)
    length = case_lengths(example_case)
    steel = joint.materials[0]
    modulus = float(steel.youngs_modulus) / (2.0 * (1.0 - float(steel.poisson_ratio) ** 2))
    share = np.log(force / (width * length * modulus) / math.sqrt(2.0) / 1e-4) / np.log(200.0)
    ratio = np.exp(
        (1.0 - share) * np.log(0.5) + share * np.log(0.3)
    )  # of two loads monotone cubics are lines
    heights = np.array([by_heights[name].rms_height.value for name in ("sp", "pwr", "pwl", "wro", "wlo")])
    expected = line_stiffness(force, ratio * heights, joint)
    np.testing.assert_allclose(result.contacts.normal_stiffness, expected, rtol=1e-3)
    ends = made.measured.interval(made, None)["contacts"]["sp"]["asperity_normal_stiffness_N_per_m"]
    low, middle, high = made.measured.heights["surface.sp"]
    stiff, here, soft = made.measured.ratios["surface.sp"]
    for part, lengths in {
        "contact_law": (middle * stiff, middle * soft),
        "rms_height": (low * ratio[0], high * ratio[0]),
        "both": (low * stiff, high * soft),
    }.items():
        expected = [line_stiffness(force[0], length, joint) for length in reversed(lengths)]
        assert ends[part] == pytest.approx(expected, rel=0.03)
    scatter = (
        12.706 * math.sqrt(3.0) * math.log(0.51 / 0.5)
    )  # Student's, one degree of freedom; both loads scatter alike
    assert soft / here == pytest.approx(math.exp(scatter), rel=1e-3)
    assert stiff / here == pytest.approx(0.8 * math.exp(-scatter), rel=1e-3)
    told = " ".join(made.measured.assumed)
    assert "contact law measured: the decay length over the rms of the heights" in told
    assert "outside of what boundary elements have" not in told
    again = tomllib.loads(joint_file_text(made, {}, comment=""))
    assert set(again["surface"]["sp"]) == {"decay_length", "rolling_share"}


def line_stiffness(force, decay_length, joint):
    """K_n = (1 + 1/(1 + 1.35 s)) N/u0 with s = pi E B u0/(4 N), of the first contact, or of all alike; steel."""
    steel = joint.materials[0]
    modulus = float(steel.youngs_modulus) / (2.0 * (1.0 - float(steel.poisson_ratio) ** 2))
    lengths = np.asarray(contact_values(joint, joint.contact_lengths))
    length = lengths if np.ndim(force) else lengths[0]
    s = 0.25 * math.pi * modulus * length * decay_length / force
    return force / decay_length * (1.0 + 1.0 / (1.0 + 1.35 * s))


def case_lengths(case):
    length = case.drive.contact_length
    return length.value if hasattr(length, "value") else np.array([entry.value for _, entry in length])


@pytest.mark.slow
def test_what_the_table_does_not_have_is_said(example_case, isotropic_map):
    case = stated(example_case, "measured")
    far = pressed(isotropic_map, pressure=(1e-6, 1e-5), hardness=0.5)
    told = " ".join(case_with_surface(case, roughness(far)).measured.assumed)
    assert "the pressure of sp, pwr, pwl, wro, wlo is outside of what boundary elements have" in told
    assert "has another hardness than the softer body" in told
    one, other = pressed(isotropic_map, scale=0.6), pressed(isotropic_map, scale=0.8)
    both = case_with_surface(case, roughness(one, other)).measured.ratios["surface.sp"][1]
    alone = case_with_surface(case, roughness(pressed(isotropic_map))).measured.ratios["surface.sp"][1]
    assert both / alone == pytest.approx(math.sqrt((0.36 + 0.64) / 2.0), rel=0.01)  # squares of bodies add


def test_two_bodies_alike_are_a_rougher_one_under_less_pressure(isotropic_map):
    """The decay ratio of the pair at p is that of the map at p/sqrt(2); beside a smooth body it is that at p."""
    table = pressed(isotropic_map)
    twin, smooth = dataclasses.replace(table, bodies=2), (1e-14, 1e-24)
    for pressure in (5e-4, 2e-3, 9e-3):
        at = 0.5 * (0.3 / 0.5) ** (math.log(pressure / math.sqrt(2.0) / 1e-4) / math.log(200.0))
        for spectra, squares in (((twin,), (2e-14,)), ((table, table), (1e-14, 1e-14))):
            ratio, error = decay_ratio(spectra, squares, pressure, capped=False)
            assert ratio == pytest.approx(math.sqrt(0.51 / 0.5) * at * math.sqrt(0.5 / 0.51), rel=1e-6)
            # one table of both is known no better than one
            alone = table.pressed.decay_ratio(pressure=pressure / math.sqrt(2.0), capped=False)[1]
            assert error == pytest.approx(alone / math.sqrt(len(spectra)), rel=1e-6)
        beside, _ = decay_ratio((table, table), smooth, pressure, capped=False)
        assert beside == pytest.approx(
            table.pressed.decay_ratio(pressure=pressure, capped=False)[0], rel=1e-6
        )


@pytest.mark.slow
def test_a_map_narrower_than_the_contact_is_refused(example_case):
    heights = np.random.default_rng(0).standard_normal((64, 64)) * 1e-7
    small = spectrum_of_map(topography=Topography(heights, 1e-6, 1e-6, source="small"), rolling="x")
    with pytest.raises(
        InputError, match=r"small: 0\.064 mm in the rolling direction, less than the contact .* wide"
    ):
        case_with_surface(stated(example_case, "measured"), roughness(pressed(small)))


def decay_length_by_hand(waves, pressure):
    """sqrt(2/pi) int [.45 + 1.65 P^2] exp(-x^2)/q dh', x = sqrt(2) p/(E h'), P = erf x, by the rule of trapezoids."""
    wavenumber, square = waves[:, np.argsort(waves[0])]
    slopes = np.sqrt(np.cumsum(square * wavenumber**2))
    slope = np.linspace(0.0, slopes[-1], 200_001)[1:]
    x = math.sqrt(2.0) * pressure / slope
    at = wavenumber[np.searchsorted(slopes, slope).clip(max=len(slopes) - 1)]
    return math.sqrt(2.0 / math.pi) * np.trapezoid((0.45 + 1.65 * erf(x) ** 2) * np.exp(-(x**2)) / at, slope)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("kind", "replaced"),
    [
        pytest.param("planetary", (), marks=pytest.mark.long),
        pytest.param(
            "planetary", (("[load]", 'planet_crown_radius = "20 m"\n\n[load]'),), marks=pytest.mark.long
        ),
        ("planar", ()),
        pytest.param("multiroller", (), marks=pytest.mark.long),
    ],
)
def test_perssons_theory_in_every_drive(planar_case, isotropic_map, kind, replaced):
    """K_n of u, by hand of the waves of both bodies that a contact feels, at its mean pressure where it is widest."""
    case = stated(planar_case(kind, *replaced), "persson_2007")
    made = case_with_surface(case, roughness(isotropic_map))
    assert made.contact_law() == "persson_2007"
    joint = joint_from_case(made)
    result = solve_joint(joint).result
    widths = 2.0 * np.asarray(result.diagnostics.hertz_half_width)
    pressure = 0.25 * math.pi * np.asarray(result.diagnostics.hertz_pressure)
    steel = joint.materials[0]
    modulus = float(steel.youngs_modulus) / (2.0 * (1.0 - float(steel.poisson_ratio) ** 2))
    lengths = [
        decay_length_by_hand(
            isotropic_map.waves(rolling=1.0 / width, axial=0.0) * [[1.0], [2.0]], p / modulus
        )
        for width, p in zip(widths, pressure, strict=True)
    ]
    expected = line_stiffness(np.asarray(result.forces.normal), np.array(lengths), joint)
    np.testing.assert_allclose(result.contacts.normal_stiffness, expected, rtol=5e-3)
    told = " ".join(made.measured.assumed)
    assert "contact law persson_2007: the decay length by Persson's theory of the waves above" in told
    first = made.surface[joint.contact_names[0]]
    assert set(first.stated_keys()) == {"decay_length", "rolling_share"}
    if kind == "planetary" and not replaced:
        interval = made.measured.interval(made, joint)
        part = interval["contacts"]["sp"]["asperity_normal_stiffness_N_per_m"]["contact_law"]
        force = float(result.forces.normal[0])
        ends = [line_stiffness(force, factor * lengths[0], joint) for factor in (1.14, 0.43)]
        assert part == pytest.approx(ends, rel=0.03)
        assert "The law is 0.43 to 1.14 times as stiff as boundary elements" in interval["words"]


def test_perssons_theory_needs_a_spectrum(example_case):
    case = stated(example_case, "persson_2007")
    with pytest.raises(InputError, match=r"\"persson_2007\" needs one: measure the surface again"):
        case_with_surface(case, roughness(fractal=measured()))
    with pytest.raises(InputError, match=r"needs the spectrum of a measured surface .* beside the file"):
        joint_from_case(case)


@pytest.mark.slow
def test_complete_contact_is_refused_where_the_exponential_law_holds(example_case):
    smooth = roughness(profile_spectrum("rolling", 0.03))
    with pytest.raises(InputError, match=r"100 % of the contact \w+ touches .* leave contact_law out"):
        case_with_surface(stated(example_case, "persson_2007"), smooth)
    made = case_with_surface(example_case, smooth)
    joint = joint_from_case(made)
    assert made.measured.laws(made, joint, solve_joint(joint).result) == []


@pytest.mark.slow
def test_a_map_that_the_joint_presses_flat_has_no_measured_law(example_case, isotropic_map):
    flat = roughness(pressed(isotropic_map, scale=1e-5))
    said = (
        r"the contact sp is pressed flat by boundary elements: in complete contact .* leave contact_law out"
    )
    with pytest.raises(InputError, match=said):
        case_with_surface(stated(example_case, "measured"), flat)
    made = case_with_surface(example_case, flat)
    joint = joint_from_case(made)
    laws = made.measured.laws(made, joint, solve_joint(joint).result)
    assert [entry["law"] for entry in laws] == ["exponential", "persson_2007"]


@pytest.mark.long
def test_all_laws_side_by_side_are_those_of_joints_with_each(planar_case, isotropic_map):
    surface = roughness(pressed(isotropic_map), fractal=measured(fractal_dimension=1.5))
    case = planar_case("planetary")
    order = ["zou_2025", "exponential", "persson_2007", "measured"]
    expected = {}
    for law in order:
        made = case_with_surface(stated(case, law), surface)
        joint = joint_from_case(made)
        result = solve_joint(joint).result
        expected[law] = (
            float(result.assembly.stiffness.output),
            float(result.rolling.drift_per_output_turn),
        )
        entries = made.measured.laws(made, joint, result)
        assert [entry["law"] for entry in entries] == order
        assert [entry["law"] for entry in entries if entry["used"]] == [law]
        last = {
            entry["law"]: (entry["assembly_Nm_per_rad"], entry["drift_rad_per_output_turn"])
            for entry in entries
        }
    assert len(set(expected.values())) == 4
    for law in order:
        assert last[law] == pytest.approx(expected[law], rel=1e-6)
    alone = case_with_surface(stated(case, "zou_2025"), roughness(profile_spectrum(None), fractal=measured()))
    assert alone.measured.laws(alone, joint, result) == []  # a profile without a lay has one law only


def test_the_measured_law_needs_boundary_elements(example_case, isotropic_map):
    case = stated(example_case, "measured")
    with pytest.raises(InputError, match="measure the map again with a hardness"):
        case_with_surface(case, roughness(isotropic_map))
    with pytest.raises(InputError, match="measure the map again with a hardness"):
        case_with_surface(case, roughness(fractal=measured()))
    with pytest.raises(InputError, match=r"a profile; .* needs a map of the surface"):
        case_with_surface(case, roughness(profile_spectrum("rolling")))
    with pytest.raises(InputError, match="needs a measured map that was pressed with a hardness"):
        joint_from_case(case)


@pytest.mark.long
def test_laws_side_by_side_with_unlike_branches(planar_case, isotropic_map):
    branches = '[[branch]]\nplanet_deviation = "2 um"\n\n[[branch]]\n\n[[branch]]\n\n[load]'
    case = planar_case("planetary", ("[load]", branches))
    made = case_with_surface(case, roughness(isotropic_map))
    laws = full_document(made, solved_case(made))["contact_laws"]
    assert [entry["law"] for entry in laws] == ["exponential", "persson_2007"]
    assert laws[1]["assembly_Nm_per_rad"] == pytest.approx(laws[0]["assembly_Nm_per_rad"], rel=0.1)

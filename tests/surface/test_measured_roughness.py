"""What a joint takes of a measurement: with and without a power law, one body and two, to and from its document."""

import dataclasses
import json

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.surface.height_spectrum import spectrum_of_profiles
from asperity.surface.measured_roughness import (
    MeasuredRoughness,
    equivalent_surface,
    measurement_of,
    read_roughness,
    roughness_document,
    roughness_from_document,
    two_bodies,
)
from asperity.surface.measurement import (
    SurfaceMeasurement,
    measurement_document,
    measurement_from_document,
)


def power_law(source, dimension=1.5, roughness=1e-11):
    return SurfaceMeasurement(
        fractal_dimension=jnp.asarray(dimension),
        fractal_roughness=jnp.asarray(roughness),
        frequency_ratio=jnp.asarray(1.5),
        covariance=jnp.eye(2) * 1e-4,
        shortest_wavelength=jnp.asarray(1e-6),
        longest_wavelength=jnp.asarray(1e-4),
        estimator="made up",
        profiles=1,
        source=source,
    )


def spectrum(source):
    heights = 1e-7 * np.random.default_rng(1).standard_normal((1, 512))
    return spectrum_of_profiles(profiles=heights, spacing=1e-6, lay="rolling", source=source)


ROLLER = MeasuredRoughness(power_law("roller"), "", (spectrum("roller"),), "roller")
RING = MeasuredRoughness(None, "no power law over a decade", (spectrum("ring"),), "ring")
EARLIER = MeasuredRoughness(power_law("earlier"), "", (), "earlier")


@pytest.mark.parametrize("measured", [ROLLER, RING, EARLIER])
def test_the_document_keeps_what_a_joint_takes(measured, tmp_path):
    file = tmp_path / "measured.json"
    file.write_text(json.dumps(roughness_document(measured)))
    again = read_roughness(path=file)
    assert (again.source, again.no_power_law) == (measured.source, measured.no_power_law)
    assert (again.fractal is None) == (measured.fractal is None)
    assert [each.source for each in again.spectra] == [each.source for each in measured.spectra]
    assert again.of == "body"
    file.write_text(json.dumps(roughness_document(dataclasses.replace(measured, of="pair"))))
    assert read_roughness(path=file).of == "pair"


@pytest.mark.parametrize("D", [1.2, 1.5, 1.8])
def test_one_measurement_makes_two_bodies_alike(D):
    """D and G as of two measurements that agree; their error is that of one, which moves both."""
    one = MeasuredRoughness(body(D, 1e-12), "", (), "roller")
    both, apart = one.pair.fractal, equivalent_surface(first=one.fractal, second=one.fractal)
    assert float(both.fractal_dimension) == D
    assert float(both.fractal_roughness) == pytest.approx(float(apart.fractal_roughness), rel=1e-8)

    def moved(dimension, factor):
        same = body(D + dimension, 1e-12 * factor)
        pair = equivalent_surface(first=same, second=same)
        return np.array([float(pair.fractal_dimension), np.log(float(pair.fractal_roughness))])

    steps = [(moved(1e-5, 1.0) - moved(-1e-5, 1.0)) / 2e-5]
    steps.append((moved(0.0, np.exp(1e-5)) - moved(0.0, np.exp(-1e-5))) / 2e-5)
    jacobian = np.array(steps).T
    expected = jacobian @ np.asarray(one.fractal.covariance) @ jacobian.T
    np.testing.assert_allclose(both.covariance, expected, rtol=1e-5)
    assert float(both.covariance[0, 0]) == pytest.approx(2.0 * float(apart.covariance[0, 0]), rel=1e-3)


def test_waves_of_two_bodies_alike():
    """Mean squares double, and so does their deviation; cut-off and steepness of a wave are those of one body."""
    one = spectrum("roller")
    (both,) = RING.pair.spectra
    (alone,) = RING.spectra
    at = {"rolling": 0.0, "axial": 2e3}
    assert both.felt(**at) == pytest.approx(np.multiply(2.0, alone.felt(**at)), rel=1e-14)
    many = {name: np.array([value, 3e3]) for name, value in at.items()}
    np.testing.assert_allclose(both.squares(**many), 2.0 * alone.squares(**many), rtol=1e-14)
    for waves in ("waves", "form"):
        numbers, squares = getattr(both, waves)(**at)
        np.testing.assert_array_equal(numbers, getattr(alone, waves)(**at)[0])
        np.testing.assert_allclose(squares, 2.0 * getattr(alone, waves)(**at)[1], rtol=1e-14)
    # an Ra of 0.075 um, of the class of 0.25 mm up to 0.1 um; the pair's is 0.11 um, of that of 0.8 mm
    heights = 0.075e-6 * np.sqrt(np.pi / 2.0) * np.random.default_rng(1).standard_normal((1, 4000))
    fine = spectrum_of_profiles(profiles=heights, spacing=1e-6, lay="rolling", source="fine")
    assert dataclasses.replace(fine, bodies=2).cut_off() == fine.cut_off() == 0.25e-3
    rougher = spectrum_of_profiles(
        profiles=np.sqrt(2.0) * heights, spacing=1e-6, lay="rolling", source="pair"
    )
    assert rougher.cut_off() == 0.8e-3
    assert one.bodies == 1


def test_a_pair_is_a_pair():
    pair = two_bodies(ROLLER, RING)
    assert (pair.of, pair.pair is pair) == ("pair", True)
    assert pair.words == "measured surface: the pair as measured: roller + ring"
    assert ROLLER.words.startswith("measured surface: each body as measured: roller; both are alike")
    with pytest.raises(InputError, match=r"roller \+ ring: a measurement of both bodies together"):
        two_bodies(pair, ROLLER)
    assert measurement_of(ROLLER, "pair").pair.spectra == ROLLER.spectra
    assert measurement_of(ROLLER, None) is ROLLER
    assert measurement_of(pair, "pair") == pair
    with pytest.raises(InputError, match="the document is that of a pair"):
        measurement_of(pair, "body")
    with pytest.raises(InputError, match="got 'half'"):
        measurement_of(ROLLER, "half")


def test_two_alike_whose_power_law_leaves_its_range():
    """At D = 1.001 a factor of 2 in the structure function is one of 2^500 in G."""
    flat = dataclasses.replace(ROLLER, fractal=power_law("flat", dimension=1.001))
    assert flat.pair.fractal is None
    assert "too near to 1" in flat.pair.no_power_law
    assert len(flat.pair.spectra) == 1
    with pytest.raises(NoSolutionError, match="too near to 1"):
        _ = dataclasses.replace(flat, spectra=()).pair


def test_documents_of_earlier_releases():
    for pair in (two_bodies(ROLLER, ROLLER), two_bodies(ROLLER, RING), two_bodies(EARLIER, EARLIER)):
        document = roughness_document(pair)
        assert document.pop("measurement_of") == "pair"
        assert roughness_from_document(document).of == "pair"
        with pytest.raises(InputError, match="of two surfaces must be 'pair'"):
            roughness_from_document(document | {"measurement_of": "body"})
    assert roughness_from_document(measurement_document(measurement=power_law("old"))).spectra == ()
    common = {"schema": "asperity-surface-measurement", "schema_version": 1, "source": "old"}
    with pytest.raises(InputError, match="refused by an earlier release: measure again"):
        roughness_from_document({**common, "refused": "no power law"})


def test_d_and_g_are_asked_of_a_surface_that_has_none():
    with pytest.raises(
        InputError, match="the measurement of ring has no D and G: no power law over a decade"
    ):
        measurement_from_document(document=roughness_document(RING))


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"spectra": 1}, "at most two spectra"),
        ({"spectra": [1]}, "damaged"),
        ({"no_power_law": 3}, "must be texts"),
        ({"source": 3}, "must be texts"),
        ({"measurement_of": "both"}, r"key 'measurement_of' .* got 'both'"),
        ({"measurement_of": ["pair"]}, r"got \['pair'\]"),
        ({"schema": "other"}, "not a surface measurement"),
    ],
)
def test_damaged_documents_are_one_message(change, says):
    with pytest.raises(InputError, match=says):
        roughness_from_document(roughness_document(RING) | change)


def test_two_bodies_keep_both_spectra():
    both = two_bodies(ROLLER, RING)
    assert both.fractal is None
    assert both.no_power_law == "ring: no power law over a decade"
    assert [each.source for each in both.spectra] == ["roller", "ring"]
    alike = two_bodies(ROLLER, ROLLER)
    assert float(alike.fractal.fractal_roughness) == pytest.approx(2e-11, rel=1e-6)  # S ~ G at D = 1.5
    assert len(alike.spectra) == 2


def test_two_power_laws_that_make_none_together():
    one = dataclasses.replace(ROLLER, fractal=power_law("steep", dimension=1.1, roughness=1e-16))
    other = dataclasses.replace(ROLLER, fractal=power_law("flat", dimension=1.9, roughness=2.5e-7))
    both = two_bodies(one, other)
    assert both.fractal is None
    assert "differ too much" in both.no_power_law
    with pytest.raises(NoSolutionError, match="differ too much"):
        two_bodies(*(dataclasses.replace(each, spectra=()) for each in (one, other)))


def body(D, G, gamma=1.5, band=(1e-7, 1e-4), sd=0.01):
    return SurfaceMeasurement(
        fractal_dimension=jnp.asarray(D),
        fractal_roughness=jnp.asarray(G),
        frequency_ratio=jnp.asarray(gamma),
        covariance=sd**2 * jnp.eye(2),
        shortest_wavelength=jnp.asarray(band[0]),
        longest_wavelength=jnp.asarray(band[1]),
        estimator="likelihood",
        profiles=1,
        source="s",
    )


@pytest.mark.parametrize("D", [1.2, 1.5, 1.8])
def test_equal_dimensions_add_in_closed_form(D):
    both = equivalent_surface(first=body(D, 1e-9), second=body(D, 3e-9))
    p = 2 * (D - 1)
    assert float(both.fractal_dimension) == pytest.approx(D, abs=1e-10)
    assert float(both.fractal_roughness) == pytest.approx((1e-9**p + 3e-9**p) ** (1 / p), rel=1e-8)


@pytest.mark.parametrize("D", [1.0 + 2.0**-52, 1.0 + 1e-7, 2.0 - 1e-7, 2.0 - 2.0**-52])
@pytest.mark.parametrize("other", [None, 1.5])
def test_dimensions_at_the_ends_of_their_range(D, other):
    try:
        both = equivalent_surface(first=body(D, 1e-9), second=body(other or D, 3e-9))
    except NoSolutionError:
        return
    assert 1.0 < float(both.fractal_dimension) < 2.0
    assert np.isfinite(both.covariance).all()
    assert 0.0 < float(both.fractal_roughness) < np.inf


def test_a_smooth_partner_changes_nothing_and_order_does_not_matter():
    one, two = body(1.5, 1e-8), body(1.45, 1e-20)
    both = equivalent_surface(first=one, second=two)
    assert float(both.fractal_dimension) == pytest.approx(1.5, abs=1e-3)
    np.testing.assert_allclose(both.covariance, one.covariance, atol=2e-6)
    swapped = equivalent_surface(first=two, second=one)
    assert float(swapped.fractal_roughness) == pytest.approx(float(both.fractal_roughness), rel=1e-9)


def test_two_equal_bodies_halve_the_variance_of_the_dimension():
    both = equivalent_surface(first=body(1.5, 1e-9), second=body(1.5, 1e-9))
    assert float(both.covariance[0, 0]) == pytest.approx(0.5e-4, rel=1e-4)


def test_refusals():
    with pytest.raises(InputError, match="gamma"):
        equivalent_surface(first=body(1.5, 1e-9), second=body(1.5, 1e-9, gamma=2.0))
    with pytest.raises(NoSolutionError, match="share only"):
        equivalent_surface(first=body(1.5, 1e-9), second=body(1.5, 1e-9, band=(5e-5, 1e-3)))
    with pytest.raises(NoSolutionError, match="differ too much"):
        equivalent_surface(first=body(1.1, 1e-16), second=body(1.9, 2.5e-7))

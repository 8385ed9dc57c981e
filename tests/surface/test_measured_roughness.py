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


def test_documents_of_earlier_releases():
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

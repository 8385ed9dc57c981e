import numpy as np
import pytest

import asperity
from asperity.api.joint import DescribedJoint
from asperity.errors import InputError, NoSolutionError
from asperity.surface.synthesis import self_affine_profile


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    """A profile of known D = 1.5 and G = 1e-9 m."""
    heights = self_affine_profile(
        points=3000,
        spacing=1e-7,
        fractal_dimension=1.5,
        fractal_roughness=1e-9,
        random=np.random.default_rng(1),
    )
    path = tmp_path_factory.mktemp("surface") / "profile.csv"
    rows = np.stack([1e-7 * np.arange(heights.size), heights], axis=1)
    np.savetxt(path, rows, delimiter=",", header="x [m],z [m]", comments="", fmt="%.17g")
    return path


@pytest.fixture(scope="module")
def measured(file):
    return asperity.measure_surface(file)


def test_values_are_those_of_the_command(measured, file, printed):
    document = printed("surface", "measure", file)
    assert measured.document == document
    assert measured["fractal_dimension"].value == document["fractal_dimension"]
    assert measured["fractal_roughness"].si == document["fractal_roughness_m"]
    (entry,) = document["files"]
    assert measured["Pa"].si == entry["Pa_m"]
    filtered = asperity.measure_surface(file, long_cutoff="0.08 mm")
    assert filtered["Ra"].si == filtered.document["files"][0]["roughness"]["Ra_m"]
    assert "Ra behind the cut-off 0.08 mm" in str(filtered)
    row = measured.to_frame().loc["fractal_dimension"]
    assert [row.si_lower, row.si_upper] == document["fractal_dimension_interval_95"]


def test_the_known_dimension_is_recovered(measured):
    low, high = measured.measurement.fractal.interval(confidence=0.999)["fractal_dimension"]
    assert low < 1.5 < high


def test_a_joint_takes_the_measured_surface(joint, measured):
    published = joint.case.model.model_copy(update={"contact_law": "zou_2025"})
    rough = DescribedJoint(joint.case.model_copy(update={"model": published}), joint.source).with_surface(
        measured.measurement
    )
    assert rough["surface.fractal_dimension"].si == measured["fractal_dimension"].si
    # both bodies are alike: S ~ G^(2 (D - 1)) doubles
    both = measured["fractal_roughness"].si * 2.0 ** (0.5 / (measured["fractal_dimension"].si - 1.0))
    assert rough["surface.fractal_roughness"].si == pytest.approx(both, rel=1e-14)
    pair = rough.with_surface(measured.measurement, measurement_of="pair")
    assert pair["surface.fractal_roughness"].si == pytest.approx(measured["fractal_roughness"].si, rel=1e-15)
    with pytest.raises(InputError, match='expected "body"'):
        rough.with_surface(measured.measurement, measurement_of="two")
    again = rough.with_values({"load.preload": "900 N"})  # its file is written anew
    assert again["surface.fractal_dimension"].si == measured["fractal_dimension"].si


@pytest.mark.slow
def test_by_default_a_joint_takes_the_measured_spectrum(joint, file, measured):
    with pytest.raises(InputError, match="measure it again with --lay"):
        joint.with_surface(measured.measurement)
    across = asperity.measure_surface(file, lay="rolling").measurement
    rough = joint.with_surface(across)
    (spectrum,) = across.spectra
    square, _ = spectrum.felt(rolling=0.0, axial=1.0 / spectrum.cut_off())
    assert rough["surface.sp.rms_height"].si == pytest.approx((2.0 * square) ** 0.5, rel=1e-12)
    pair = joint.with_surface(across, measurement_of="pair")
    assert pair["surface.sp.rms_height"].si == pytest.approx(square**0.5, rel=1e-12)
    again = pair.with_values({"load.preload": "900 N"})
    assert again["surface.sp.rms_height"].si == pytest.approx(square**0.5, rel=1e-12)


def test_text_and_figure(measured):
    assert "fractal dimension D" in repr(measured)
    assert measured.plot().axes


def test_wrong_input_is_refused(file):
    with pytest.raises(InputError, match="no file to measure"):
        asperity.measure_surface()
    with pytest.raises(InputError, match=r"^spacing: expected a length with its unit .* bare number"):
        asperity.measure_surface(file, spacing=1e-7)
    with pytest.raises(InputError, match="a profile has no direction y"):
        asperity.measure_surface(file, direction="y")


@pytest.mark.slow
def test_a_surface_without_a_power_law_has_a_spectrum(tmp_path):
    """White noise of 1 µm: its mean square lies in all frequencies alike, here up to 5 per µm."""
    position = np.arange(2000) * 1e-7
    rows = np.stack([position, 1e-6 * np.random.default_rng(0).standard_normal(2000)], axis=1)
    path = tmp_path / "noise.csv"
    np.savetxt(path, rows, delimiter=",", header="x [m],z [m]", comments="", fmt="%.17g")
    found = asperity.measure_surface(path, lay="axis")
    assert "no power law" in repr(found)
    assert "the joint uses the measured spectrum" in repr(found)
    assert found.keys()[:2] == ["Pa", "Pq"]
    assert found.plot().axes
    (spectrum,) = found.measurement.spectra
    square, _ = spectrum.felt(rolling=1.0 / 0.4e-6, axial=0.0)
    assert square == pytest.approx(0.5e-12, rel=0.1)
    np.savetxt(path, rows[:12], delimiter=",", header="x [m],z [m]", comments="", fmt="%.17g")
    with pytest.raises(NoSolutionError, match="64 or more are needed"):
        asperity.measure_surface(path, any_size=True)

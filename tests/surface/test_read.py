"""What is no surface: absent and huge files, contradicting units, implausible sizes, overflowing heights."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.read import read_surface


def test_folder_absent_and_huge_files(tmp_path):
    with pytest.raises(InputError, match="folder"):
        read_surface(path=tmp_path)
    with pytest.raises(InputError, match="there is no such file"):
        read_surface(path=tmp_path / "no.txt")
    with (tmp_path / "huge.dat").open("wb") as file:
        file.truncate(5 * 1024**3)
    with pytest.raises(InputError, match="4096 MiB"):
        read_surface(path=tmp_path / "huge.dat")


def profile_text(path, unit_x="mm", unit_z="um", rows=40, step=0.001):
    x = np.arange(rows) * step
    path.write_text(f"X [{unit_x}];Z [{unit_z}]\n" + "".join(f"{a:.6f};{np.sin(a):.6f}\n" for a in x))
    return path


def test_a_unit_that_contradicts_the_heading_is_refused(tmp_path):
    file = profile_text(tmp_path / "p.csv")
    assert read_surface(path=file, height_unit="micron").spacing == pytest.approx(1e-6)
    with pytest.raises(InputError, match="unit of its heights as um, not nm"):
        read_surface(path=file, height_unit="nm")


@pytest.mark.parametrize(
    ("unit_x", "unit_z", "step", "says"),
    [
        ("m", "um", 0.1, "its size is 4 m"),
        ("nm", "pm", 0.001, "its size is 4e-11 m"),
        ("um", "mm", 0.1, "heights span"),
    ],
)
def test_implausible_sizes_are_refused_unless_confirmed(tmp_path, unit_x, unit_z, step, says):
    file = profile_text(tmp_path / "p.csv", unit_x, unit_z, step=step)
    with pytest.raises(InputError, match=says):
        read_surface(path=file)
    assert read_surface(path=file, any_size=True).heights.shape == (40,)


@pytest.mark.parametrize("value", [1e300, 1e60])
def test_heights_that_overflow_are_refused_even_if_any_size_is_accepted(tmp_path, value):
    np.save(tmp_path / "a.npy", np.array([0.0, value, 1.0, -value]))
    with pytest.raises(InputError, match=r"cannot be evaluated|infinite heights"):
        read_surface(path=tmp_path / "a.npy", height_unit="m", spacing=1e-6, any_size=True)

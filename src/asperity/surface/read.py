"""Reading measured surfaces: the format is found, the file read, and its sizes checked for plausibility."""

from __future__ import annotations

from pathlib import Path

import numpy as np

<<<<<<< HEAD
from asperity.errors import InputError, MissingExtraError
from asperity.extras import install_command
from asperity.surface.length_units import metres_per_unit
=======
from asperity.errors import InputError
from asperity.surface.input_file import LARGEST_SPAN, MEBIBYTE, checked_file, file_bytes
from asperity.surface.read_instrument import instrument_topography, text_format
>>>>>>> surface-mends
from asperity.surface.read_text import looks_like_text, numpy_topography, text_topography
from asperity.surface.topography import Topography

#: Larger files are refused before they are opened [bytes].
LARGEST_FILE = 4096 * MEBIBYTE
#: A surface is expected to be longer and wider than the first and not larger than the second length [m].
EXPECTED_SIZES = (1e-6, 1.0)


def read_surface(
    *,
    path: str | Path,
    position_unit: str | None = None,
    height_unit: str | None = None,
    spacing: float | None = None,
    decimal: str = "auto",
    any_size: bool = False,
) -> Topography:
    """Profile or map from any supported file, heights and positions in metres.

    Parameters
    ----------
    path : str or Path
        The file. Text (columns of numbers) and ``.npy`` are read without further packages; X3P, SDF, SUR,
        AL3D, OPD, OPDX, Zygo, FRT, TMD, NetCDF and some 35 more need the extra ``surface``.
    position_unit, height_unit : str or None
        Unit of positions and heights, such as ``"mm"``. Needed only where the file does not name it; a unit
        that contradicts the file is refused.
    spacing : float or None
        Distance of the points [m], for files that hold heights only.
    decimal : {"auto", "point", "comma"}
        Decimal sign of text files.
    any_size : bool
        Accept sizes outside :data:`EXPECTED_SIZES`, and heights larger than the longest side.

    Returns
    -------
    Topography
        Missing points are NaN and counted; nothing is filled, levelled or filtered.

    Raises
    ------
    InputError
        If there is no such file, it is empty, too large or not understood, its units are not known, or its
        sizes are not plausible.
    MissingExtraError
        If the format needs SurfaceTopography and that is not installed.
    """
    path = checked_file(path=path, largest=LARGEST_FILE)
    if spacing is not None and not (spacing > 0.0 and np.isfinite(spacing)):
        raise InputError(f"the spacing is {spacing} m; it must be a positive length")
    beginning = file_bytes(path=path, largest=LARGEST_FILE, first=4096)
    if beginning.startswith(b"\x93NUMPY"):
        topography = numpy_topography(path=path, height_unit=height_unit, spacing=spacing)
    elif looks_like_text(beginning) and text_format(beginning) is None:
        topography = text_topography(
            path=path,
            position_unit=position_unit,
            height_unit=height_unit,
            spacing=spacing,
            decimal=decimal,
        )
    else:
        topography = instrument_topography(path=path, beginning=beginning, height_unit=height_unit)
    if np.isnan(topography.heights).all():
        raise InputError(
            f"{path.name} holds no valid height: all {topography.heights.size} points are missing"
        )
    if topography.heights.shape[-1] < 2:
        raise InputError(f"{path.name} holds {topography.heights.size} point(s); a profile needs more")
    _check_plausibility(topography, any_size)
    return topography


<<<<<<< HEAD
def _beginning(path: Path) -> bytes:
    if path.is_dir():
        raise InputError(f"{path} is a folder; name the file in it")
    if not path.is_file():
        raise InputError(f"there is no file {path}")
    try:
        size = path.stat().st_size
        if size == 0:
            raise InputError(f"{path} is empty")
        if size > LARGEST_FILE:
            raise InputError(
                f"{path} has {size / 1024**3:.1f} GiB; files above {LARGEST_FILE // 1024**3} GiB "
                f"are not read: cut it"
            )
        with path.open("rb") as file:
            return file.read(4096)
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror}") from None


def _instrument_topography(path: Path, height_unit: str | None, remark: str) -> Topography:
    """Heights of an instrument file through SurfaceTopography."""
    import logging
    import warnings

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            import SurfaceTopography
    except ImportError:
        raise MissingExtraError(
            f"{path.name} is not plain text or .npy, so it needs a package of instrument readers that is not "
            f"installed; run: {install_command('surface')}{remark and '.' + remark.rstrip('.')}"
        ) from None
    logging.getLogger("SurfaceTopography").setLevel(logging.ERROR)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            reader = SurfaceTopography.open_topography(_without_clutter(path))
            measured = reader.topography()
            heights = np.ma.filled(np.ma.asarray(measured.heights(), dtype=np.float64), np.nan)
        except Exception as error:  # the readers raise whatever their parsers stumble on
            kind = type(error).__name__
            why = (
                "its format is not known"
                if "CannotDetect" in kind
                else f"its content is not understood ({kind})"
            )
            raise InputError(f"{path.name} cannot be read: {why}.{remark}".rstrip(".")) from None
    return _from_reader(measured, heights, height_unit, path.name, len(reader.channels), reader.format())


def _from_reader(
    measured: Any, heights: np.ndarray, height_unit: str | None, source: str, channels: int, file_format: str
) -> Topography:
    unit = None if file_format in FORMATS_WITHOUT_UNIT else measured.unit
    if unit is None:
        if height_unit is None:
            raise InputError(
                f"{source} does not say in which unit its lengths and heights are; say it "
                "(--height-unit mm, um, nm or m)"
            )
        unit = height_unit
    elif height_unit is not None and metres_per_unit(height_unit) != metres_per_unit(unit):
        raise InputError(f"{source} says that its unit is {unit}, not {height_unit}; leave --height-unit out")
    scale = metres_per_unit(unit)
    notes = (f"the file has {channels} channels; the default one was read",) if channels > 1 else ()
    if measured.dim == 2:
        (length_x, length_y), (columns, rows) = measured.physical_sizes, measured.nb_grid_pts
        return Topography(
            np.ascontiguousarray(heights.T) * scale,
            float(length_x) * scale / columns,
            float(length_y) * scale / rows,
            source=source,
            notes=notes,
        )
    if not measured.is_uniform:
        raise InputError(f"{source}: positions are not equally spaced; resample the profile first")
    spacing = float(measured.physical_sizes[0]) * scale / heights.shape[0]
    return Topography(np.ascontiguousarray(heights) * scale, spacing, source=source, notes=notes)


def _without_clutter(path: Path) -> str | io.BytesIO:
    """An X3P container as the reader wants it: entries on top, no clutter, empty offsets written as zero."""
    if not zipfile.is_zipfile(path):
        return str(path)
    with zipfile.ZipFile(path) as archive:
        names = [
            n
            for n in archive.namelist()
            if not n.startswith("__MACOSX/") and not n.endswith((".DS_Store", "/"))
        ]
        main = [n for n in names if n.rsplit("/", 1)[-1] == "main.xml"]
        if len(main) != 1:
            return str(path)
        description = archive.read(main[0])
        repaired = re.sub(rb"<Offset\s*/>|<Offset>\s*</Offset>", b"<Offset>0.0</Offset>", description)
        folder = main[0][: -len("main.xml")]
        if not folder and repaired == description:
            return str(path)
        rebuilt = io.BytesIO()
        with zipfile.ZipFile(rebuilt, "w") as copy:
            for name in (n for n in names if n.startswith(folder)):
                copy.writestr(name[len(folder) :], repaired if name == main[0] else archive.read(name))
    rebuilt.seek(0)
    return rebuilt
=======
def _check_plausibility(topography: Topography, any_size: bool) -> None:
    """Refuse sizes that a wrong unit explains better than a measured surface."""
    smallest, largest = EXPECTED_SIZES
    known = topography.heights[~np.isnan(topography.heights)]
    with np.errstate(over="ignore"):
        height = float(known.max() - known.min())
    if not height < LARGEST_SPAN:
        raise InputError(f"{topography.source}: its heights span {height:.3g} m, which cannot be evaluated")
    if any_size:
        return
    sizes = " x ".join(f"{size:.4g} m" for size in topography.size)
    if not all(smallest <= size <= largest for size in topography.size):
        fault = f"its size is {sizes}; expected are {smallest:g} m to {largest:g} m"
    elif height > max(topography.size):
        fault = f"its heights span {height:.4g} m on a size of {sizes}; expected is less than the size"
    else:
        return
    raise InputError(
        f"{topography.source}: {fault}. A unit is probably wrong, in the options, in the file or in its "
        "reader. If these sizes are right, say so (--any-size)"
    )
>>>>>>> surface-mends

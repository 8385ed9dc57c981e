"""Surface files: one table of formats, by which they are told apart, and their size, content and units, checked."""

from __future__ import annotations

import zipfile
from dataclasses import dataclass
from pathlib import Path

from asperity.errors import InputError
from asperity.reading import check_regular
from asperity.units import Dimension, parse_quantity

#: What a file that holds numbers without a scale leaves open.
SCALE = "height unit, spacing"


@dataclass(frozen=True)
class FileFormat:
    """A format of surface files.

    ``extensions`` are the usual ends of file names, with blanks between; ``instruments`` what writes it; ``reader`` is
    text, npy, x3p, nanofocus, records or tiff, package for SurfaceTopography, whose names of it are ``package``, or
    empty where it is not read: then ``export`` says what to do. ``stated`` is what the file does not hold and the user
    has to say, ``signatures`` the first bytes of a file, after blanks.
    """

    name: str
    extensions: str
    instruments: str
    package: str = ""
    signatures: tuple[bytes, ...] = ()
    reader: str = "package"
    stated: str = ""
    export: str = ""

    @property
    def file_names(self) -> str:
        """Usual ends of its files, each with its dot."""
        return " ".join(f".{extension}" for extension in self.extensions.split())

    @property
    def title(self) -> str:
        """Name, ends of the files and instruments in one line."""
        details = ", ".join(part for part in (self.file_names, self.instruments) if part)
        return f"{self.name} ({details})" if details else self.name


TEXT = FileFormat(
    "text", "txt csv asc dat xyz", "export of any program; NIST, NPL", reader="text", stated="units, spacing"
)
X3P = FileFormat("X3P", "x3p", "any (ISO 25178-72); heights as binary data or text", reader="x3p")
_AS_TEXT = "export the profile as text (ASCII, positions and heights in two columns)"
_IN_ITS_PROGRAM = f"{_AS_TEXT}, or a map as SUR or X3P, in the program of the instrument"
_MAHR_TEXT = (
    f"{_AS_TEXT}; MarSurf PS1 and M 300: menu Profiles, profile format TXT, and state its RES as the height unit, such "
    "as '0.01 um'"
)
_NO_TABLE = "it is not a table of numbers; of an X3P measurement give the .x3p file itself"
_NO_SIZES = "it holds no sizes; save the heights as .npy or as text"

#: All formats, those without a package first.
FORMATS = (
    TEXT,
    FileFormat("NumPy", "npy", "Python", signatures=(b"\x93NUMPY",), reader="npy", stated=SCALE),
    X3P,
    FileFormat("NanoFocus NMS", "nms", "NanoFocus µsurf", reader="nanofocus"),
    FileFormat("SMD", "smd", "reference profiles (ISO 5436-2), NPL, PTB", "", (b"ISO 5436",), "records"),
    FileFormat("NPL profile", "prf", "softgauges of NPL, Form Talysurf as text", reader="records"),
    FileFormat("TIFF", "tif tiff", "grey images, 8 to 32 bit", "", (b"II*\0", b"MM\0*"), "tiff", SCALE),
    FileFormat("SDF", "sdf", "any (ISO 25178-71), NIST, NPL", "sdf", (b"aISO-1.0", b"bISO-1.0")),
    FileFormat("SUR", "sur pro", "Digital Surf, MountainsMap, many", "sur", (b"DIGITAL SURF",)),
    FileFormat("MNT", "mnt", "Digital Surf Mountains", "mnt"),
    FileFormat("AL3D", "al3d", "Bruker Alicona", "al3d", (b"AliconaImaging",)),
    FileFormat("OPD", "opd", "Bruker (Veeco) Wyko", "opd"),
    FileFormat("OPDX", "opdx", "Bruker Dektak", "opdx"),
    FileFormat("MetroPro", "dat", "Zygo", "metropro", (b"\x88\x1b\x03",)),
    FileFormat("DATX", "datx", "Zygo", "datx"),
    FileFormat("FRT", "frt", "FormFactor (FRT) MicroProf", "frt", (b"FRTM_GLIDERV",)),
    FileFormat("TMD", "tmd", "TrueMap", "tmd", (b"Binary TrueMap",), stated="unit"),
    FileFormat("VK", "vk3 vk4 vk6 vk7", "Keyence VK", "vk"),
    FileFormat("ZON", "zon", "Keyence", "zon"),
    FileFormat("ZMG", "zmg", "KLA Zeta", "zmg"),
    FileFormat("OS3D", "os3d", "Digital Metrology OmniSurf3D", "os3d"),
    FileFormat("PLU, PLUX", "plu apx plux", "Sensofar", "plu plux"),
    FileFormat("LEXT, OIR", "lext oir poir", "Evident (Olympus)", "lext oir poir"),
    FileFormat("QEP", "qep", "Mahr MarWin", "qep"),
    FileFormat("SurfTest", "xlsx", "Mitutoyo, its Excel sheets", "mitutoyo"),
    FileFormat("NMM", "zip", "SIOS nanomeasuring machine", "nmm"),
    FileFormat("Gwyddion GWY", "gwy", "Gwyddion, heights only", "gwy", (b"GWYP",)),
    FileFormat("Nanoscope", "spm 001", "Bruker (Veeco, DI)", "di", (b"\\*File list",)),
    FileFormat("Park TIFF", "tiff", "Park Systems", "ps"),
    FileFormat("Nanosurf", "ezd nid", "Nanosurf", "ezd", (b"[DataSet]",)),
    FileFormat("MI", "mi", "Molecular Imaging", "mi", (b"fileType",)),
    FileFormat("MDT", "mdt", "NT-MDT", "mdt"),
    FileFormat("JPK", "jpk", "Bruker JPK", "jpk"),
    FileFormat("IBW", "ibw", "Asylum Research, Igor", "ibw"),
    FileFormat("WSxM", "stp top cur", "WSxM", "wsxm", (b"WSxM file copyright",)),
    FileFormat("BCR", "bcr bcrf", "BCR-STM", "bcr", (b"fileformat = bcr",)),
    FileFormat("NetCDF", "nc", "SurfaceTopography", "nc"),
    FileFormat("Gwyddion, first version", "", "", "", (b"GWYO",), "", export="open it in Gwyddion and save it again"),
    FileFormat("XML", "xml", "", "", (b"<", b"\xef\xbb\xbf<"), "", export=_NO_TABLE),
    FileFormat("MATLAB, HDF5", "mat h5 npz", "", "mat h5 npz", reader="", export=_NO_SIZES),
    FileFormat("PRF", "prf", "Form Talysurf, Mahr, Metrex", "", (b"[p3dlin]",), "", export=_IN_ITS_PROGRAM),
    FileFormat("Taylor Hobson", "fts ruf mod ten six str", "Talysurf, Talyrond", reader="", export=_IN_ITS_PROGRAM),
    FileFormat("Mahr", "pcd pra s2p", "MarSurf, Perthometer", reader="", export=_MAHR_TEXT),
    FileFormat("Hommel", "pip hwp", "Jenoptik Hommel-Etamic", reader="", export=_IN_ITS_PROGRAM),
)  # fmt: skip


def signed_format(beginning: bytes) -> FileFormat | None:
    """The format that the first bytes of a file are the signature of, or None."""
    stripped = beginning.lstrip()
    return next((known for known in FORMATS if stripped.startswith(known.signatures)), None)


def file_format(path: Path, beginning: bytes) -> FileFormat:
    """The format of a file that is not bare text: by its signature, its content as a container, or its name."""
    extension = path.suffix.lstrip(".").lower()
    unknown = FileFormat(extension.upper() or "unknown", extension, "")
    named = (known for known in FORMATS if extension in known.extensions.split())
    by_name = next((known for known in named if known.reader != "records"), unknown)  # told by its content
    if is_x3p(path):
        return X3P
    signed = signed_format(beginning)
    return signed or (unknown if by_name.reader in ("text", "npy", "x3p", "tiff") else by_name)


def is_x3p(path: Path) -> bool:
    """Whether a file is a zip container with one ``main.xml``."""
    if not zipfile.is_zipfile(path):
        return False
    try:
        with zipfile.ZipFile(path) as archive:
            return len(descriptions(archive)) == 1
    except (zipfile.BadZipFile, OSError, ValueError, NotImplementedError):
        return False


def descriptions(archive: zipfile.ZipFile) -> list[str]:
    """Entries of a container that are called main.xml, without the clutter of file managers."""
    return [
        name
        for name in archive.namelist()
        if name.rsplit("/", 1)[-1] == "main.xml" and not name.startswith("__MACOSX/")
    ]


#: Bytes of a mebibyte.
MEBIBYTE = 1024**2
#: Larger heights overflow in powers [m].
LARGEST_SPAN = 1e50


def checked_file(*, path: str | Path, largest: int) -> Path:
    """The path, if it is a regular file that is not empty and not larger than a limit [bytes]."""
    size = check_regular(path)
    if size == 0:
        raise InputError(f"{path} is empty")
    if size > largest:
        raise InputError(
            f"{path} has {size / MEBIBYTE:.4g} MiB; the largest file of this kind that is read has "
            f"{largest / MEBIBYTE:.4g} MiB"
        )
    return Path(path)


def file_bytes(*, path: str | Path, largest: int, first: int = -1) -> bytes:
    """Content of a checked file, or only its first bytes.

    An ``InputError`` as by :func:`checked_file`, or if the file cannot be opened.
    """
    file = checked_file(path=path, largest=largest)
    try:
        with file.open("rb") as stream:
            return stream.read(first)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror or error}") from None


def metres_per_unit(unit: str) -> float:
    """Metres in one unit of length, or in one count of stated length.

    An ``InputError`` if this is not a unit of length, or the length is not positive.

    Examples
    --------
    >>> metres_per_unit("um"), metres_per_unit("2.5 um")
    (1e-06, 2.5e-06)
    """
    text = unit.strip()
    length = parse_quantity(text if text[:1] in tuple("+-.0123456789") else f"1 {text}", Dimension.LENGTH)
    if not length > 0.0:
        raise InputError(f"one count is '{text}'; it must be a positive length", options=["height-unit"])
    return length

"""The formats of surface files: one table, by which files are told apart, read, refused, and listed."""

from __future__ import annotations

import zipfile
from dataclasses import dataclass
from pathlib import Path

#: What a file that holds numbers without a scale leaves open.
SCALE = "height unit, spacing"


@dataclass(frozen=True)
class FileFormat:
    """A format of surface files.

    Attributes
    ----------
    name : str
        Name of the format.
    extensions : tuple of str
        Usual ends of file names, in lower case.
    instruments : str
        Instruments and programs that write it.
    reader : {"text", "npy", "x3p", "nanofocus", "tiff", "package", ""}
        Who reads it: this program, or the package SurfaceTopography; nobody if empty.
    stated : str
        What the file does not hold and the user has to state.
    signatures : tuple of bytes
        First bytes of the file, after blanks.
    package_names : tuple of str
        Its names in that package.
    export : str
        Of a format that is not read: what to do instead.
    """

    name: str
    extensions: tuple[str, ...]
    instruments: str
    reader: str = "package"
    stated: str = ""
    signatures: tuple[bytes, ...] = ()
    package_names: tuple[str, ...] = ()
    export: str = ""

    @property
    def file_names(self) -> str:
        """Usual ends of its files, each with its dot."""
        return " ".join(f".{extension}" for extension in self.extensions)

    @property
    def title(self) -> str:
        """Name, ends of the files and instruments in one line."""
        details = ", ".join(part for part in (self.file_names, self.instruments) if part)
        return f"{self.name} ({details})" if details else self.name


TEXT = FileFormat(
    "text", ("txt", "csv", "asc", "dat", "xyz"), "export of any program", "text", "units, spacing"
)
X3P = FileFormat("X3P", ("x3p",), "any (ISO 25178-72); heights as binary data or text", "x3p")
_TEXT_EXPORT = "export the profile as text (ASCII, positions and heights in two columns)"
_IN_ITS_PROGRAM = f"{_TEXT_EXPORT}, or a map as SUR or X3P, in the program of the instrument"

#: All formats, those without a package first.
FORMATS = (
    TEXT,
    FileFormat("NumPy", ("npy",), "Python", "npy", SCALE, (b"\x93NUMPY",)),
    X3P,
    FileFormat("NanoFocus NMS", ("nms",), "NanoFocus µsurf", "nanofocus"),
    FileFormat(
        "TIFF", ("tif", "tiff"), "grey images, 8 to 32 bit", "tiff", SCALE, (b"II*\0", b"MM\0*")
    ),
    FileFormat(
        "SDF", ("sdf",), "any (ISO 25178-71), NIST", signatures=(b"aISO-1.0", b"bISO-1.0"), package_names=("sdf",)
    ),
    FileFormat("SUR", ("sur", "pro"), "Digital Surf, MountainsMap, many", "package", "", (b"DIGITAL SURF",), ("sur",)),
    FileFormat("MNT", ("mnt",), "Digital Surf Mountains", package_names=("mnt",)),
    FileFormat("AL3D", ("al3d",), "Bruker Alicona", "package", "", (b"AliconaImaging",), ("al3d",)),
    FileFormat("OPD", ("opd",), "Bruker (Veeco) Wyko", package_names=("opd",)),
    FileFormat("OPDX", ("opdx",), "Bruker Dektak", package_names=("opdx",)),
    FileFormat("MetroPro", ("dat",), "Zygo", "package", "", (b"\x88\x1b\x03",), ("metropro",)),
    FileFormat("DATX", ("datx",), "Zygo", package_names=("datx",)),
    FileFormat("FRT", ("frt",), "FormFactor (FRT) MicroProf", "package", "", (b"FRTM_GLIDERV",), ("frt",)),
    FileFormat("TMD", ("tmd",), "TrueMap", "package", "unit", (b"Binary TrueMap",), ("tmd",)),
    FileFormat("VK", ("vk3", "vk4", "vk6", "vk7"), "Keyence VK", package_names=("vk",)),
    FileFormat("ZON", ("zon",), "Keyence", package_names=("zon",)),
    FileFormat("ZMG", ("zmg",), "KLA Zeta", package_names=("zmg",)),
    FileFormat("OS3D", ("os3d",), "Digital Metrology OmniSurf3D", package_names=("os3d",)),
    FileFormat("PLU, PLUX", ("plu", "apx", "plux"), "Sensofar", package_names=("plu", "plux")),
    FileFormat("LEXT, OIR", ("lext", "oir", "poir"), "Evident (Olympus)", package_names=("lext", "oir", "poir")),
    FileFormat("QEP", ("qep",), "Mahr MarWin", package_names=("qep",)),
    FileFormat("SurfTest", ("xlsx",), "Mitutoyo, its Excel sheets", package_names=("mitutoyo",)),
    FileFormat("NMM", ("zip",), "SIOS nanomeasuring machine", package_names=("nmm",)),
    FileFormat("Gwyddion GWY", ("gwy",), "Gwyddion, heights only", "package", "", (b"GWYP",), ("gwy",)),
    FileFormat(
        "Nanoscope", ("spm", "001"), "Bruker (Veeco, DI)", "package", "", (b"\\*File list",), ("di",)
    ),
    FileFormat("Park TIFF", ("tiff",), "Park Systems", package_names=("ps",)),
    FileFormat("Nanosurf", ("ezd", "nid"), "Nanosurf", "package", "", (b"[DataSet]",), ("ezd",)),
    FileFormat("MI", ("mi",), "Molecular Imaging", "package", "", (b"fileType",), ("mi",)),
    FileFormat("MDT", ("mdt",), "NT-MDT", package_names=("mdt",)),
    FileFormat("JPK", ("jpk",), "Bruker JPK", package_names=("jpk",)),
    FileFormat("IBW", ("ibw",), "Asylum Research, Igor", package_names=("ibw",)),
    FileFormat(
        "WSxM", ("stp", "top", "cur"), "WSxM", "package", "", (b"WSxM file copyright",), ("wsxm",)
    ),
    FileFormat("BCR", ("bcr", "bcrf"), "BCR-STM", "package", "", (b"fileformat = bcr",), ("bcr",)),
    FileFormat("NetCDF", ("nc",), "SurfaceTopography", package_names=("nc",)),
    FileFormat(
        "Gwyddion GWY (first version)", (), "", "", "", (b"GWYO",), export="open it in Gwyddion and save it again"
    ),
    FileFormat(
        "XML", ("xml",), "", "", "", (b"<", b"\xef\xbb\xbf<"),
        export="it is not a table of numbers; of an X3P measurement give the .x3p file itself",
    ),
    FileFormat(
        "MATLAB, HDF5", ("mat", "h5", "npz"), "", "", package_names=("mat", "h5", "npz"),
        export="it holds no sizes; save the heights as .npy or as text",
    ),
    FileFormat("PRF", ("prf",), "Form Talysurf, Mahr, Metrex", "", "", (b"[p3dlin]",), export=_IN_ITS_PROGRAM),
    FileFormat(
        "Taylor Hobson", ("fts", "ruf", "mod", "ten", "six", "str"), "Form Talysurf, Talysurf, Talyrond", "",
        export=_IN_ITS_PROGRAM,
    ),
    FileFormat(
        "Mahr", ("pcd", "pra", "s2p"), "MarSurf, Perthometer", "",
        export=f"{_TEXT_EXPORT}; MarSurf PS1 and M 300: menu Profiles, profile format TXT, and state its RES as "
        "the height unit, such as '0.01 um'",
    ),
    FileFormat("Hommel", ("pip", "hwp", "smd"), "Jenoptik Hommel-Etamic", "", export=_IN_ITS_PROGRAM),
)  # fmt: skip


def signed_format(beginning: bytes) -> FileFormat | None:
    """The format that the first bytes of a file are the signature of, or None."""
    stripped = beginning.lstrip()
    return next((known for known in FORMATS if stripped.startswith(known.signatures)), None)


def file_format(path: Path, beginning: bytes) -> FileFormat:
    """The format of a file that is not bare text: by its signature, its content as a container, or its name."""
    extension = path.suffix.lstrip(".").lower()
    unknown = FileFormat(extension.upper() or "unknown", (extension,), "")
    by_name = next((known for known in FORMATS if extension in known.extensions), unknown)
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

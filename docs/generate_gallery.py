"""Write docs/gallery.md and its pictures from the examples: `python docs/generate_gallery.py`; needs a Chromium.

The page at three widths, the drawing of every kind of drive, the oil in contacts over speed, and the first pages of a
report, each as it is now. The pictures have few colours, so that all of them together stay below 1.5 MB.
`--without-page` leaves the pictures of the page as they are, and needs no Chromium.
"""

from __future__ import annotations

import contextlib
import io
import sys
import tempfile
from pathlib import Path

from click.testing import CliRunner
from PIL import Image

from asperity.cli.commands import asperity
from asperity.joint_file.reader import read_case
from asperity.report.joint_report import ReportSource, joint_report
from asperity.report.pdf import report_pages

HERE = Path(__file__).parent
EXAMPLES = HERE.parent / "examples"
FOLDER = HERE / "images" / "gallery"
LARGEST = 1_500_000  # of all pictures together [byte]

#: Widths and heights of the browser's window, in pixels, and what they stand for.
WINDOWS = {1400: (1000, "a desk"), 1024: (900, "a tablet"), 390: (844, "a phone")}
DRIVES = {
    "planetary": "Planetary",
    "zou2025": "Wedge (Zou et al. 2025)",
    "multiroller": "Two-row multiroller",
    "stepped_planet": "Stepped planets",
    "planar": "Listed rollers and contacts",
    "wheel_pair": "Pair of wheels",
}
REPORT_PAGES = 4


def saved(picture: Image.Image, name: str, *, width: int, colours: int) -> str:
    """The name of the file, from the page, in which a picture is kept at this width."""
    height = round(picture.height * width / picture.width)
    small = picture.convert("RGB").resize((width, height), Image.Resampling.LANCZOS)
    small.quantize(colours, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(
        FOLDER / f"{name}.png", optimize=True
    )
    return f"images/gallery/{name}.png"


def screens() -> None:
    """Pictures of the page, each at one width of the window."""
    from page_in_browser import served

    with served(EXAMPLES / "planetary.toml") as opened:
        for width, (height, _) in WINDOWS.items():
            page = opened(width, height)
            taken = Image.open(io.BytesIO(page.screenshot()))
            saved(taken, f"page_{width}", width=min(width, 1100), colours=96)
            page.close()


def sheet(name: str) -> str:
    """The drawing of an example."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "sheet.png"
        arguments = ["draw", str(EXAMPLES / f"{name}.toml"), "--out", str(file)]
        CliRunner().invoke(asperity, arguments, catch_exceptions=False)
        return saved(Image.open(file), f"sheet_{name}", width=1000, colours=16)


def film() -> str:
    """The oil in the contacts of the example with oil, over speed at three temperatures."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "film.png"
        arguments = ["film", "oil.toml", "--temperature", "20,40,80 degC", "--points", "60"]
        with contextlib.chdir(EXAMPLES):  # the title is the file as it is named
            CliRunner().invoke(asperity, [*arguments, "--plot", str(file)], catch_exceptions=False)
        return saved(Image.open(file), "film", width=1000, colours=24)


def report(name: str) -> list[str]:
    """The first pages of the report of an example."""
    file = EXAMPLES / f"{name}.toml"
    source = ReportSource(file.name, file.read_text(encoding="utf-8"), read_case(file))
    pages = report_pages(joint_report(source), points_per_inch=75.0)[:REPORT_PAGES]
    return [
        saved(Image.open(io.BytesIO(page)), f"report_{number}", width=600, colours=32)
        for number, page in enumerate(pages, start=1)
    ]


def page() -> str:
    """The page, with its pictures made anew."""
    parts = [
        "# Gallery\n\n<!-- Written by docs/generate_gallery.py, which also makes the pictures. -->\n\n"
        "What `asperity` shows of its examples, as it is now.",
        "## The page\n\n`asperity serve planetary.toml` in windows of three widths ([](page.md)).",
        *(
            f"![The page, {width} pixels wide]({f'images/gallery/page_{width}.png'})\n\n*{width} pixels: {device}.*"
            for width, (_, device) in WINDOWS.items()
        ),
        "## Drawings\n\n`asperity draw FILE --out drive.pdf`, one for each kind of drive ([](drives.md)).",
        *(f"### {title}\n\n![{title}: the drawing]({sheet(name)})" for name, title in DRIVES.items()),
        '## Oil in contacts\n\n`asperity film oil.toml --temperature "20,40,80 degC" --points 60 --plot film.png` '
        "([](friction.md)).",
        f"![Largest traction and load on the asperities over the speed, of both contacts]({film()})",
        "## A report\n\n`asperity report planetary.toml --out report.pdf`, its first pages "
        "([](drawing_and_report.md)).",
        *(
            f"![Page {number} of the report]({file})"
            for number, file in enumerate(report("planetary"), start=1)
        ),
    ]
    return "\n\n".join(parts) + "\n"


def main() -> int:
    """Make the pictures, then the page; an error where the pictures are too large together."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    if "--without-page" not in sys.argv[1:]:
        screens()
    (HERE / "gallery.md").write_text(page(), encoding="utf-8")
    size = sum(file.stat().st_size for file in FOLDER.glob("*.png"))
    print(f"{size / 1e6:.2f} MB of pictures")
    return int(size > LARGEST)


if __name__ == "__main__":
    sys.exit(main())

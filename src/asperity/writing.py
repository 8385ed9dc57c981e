"""Files that are written: checked before anything is computed, and written completely or not at all."""

from __future__ import annotations

import csv
import os
import signal
import tempfile
import threading
import uuid
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Any

from asperity.errors import InputError
from asperity.made_files import IMAGE, MARK, Kind

if TYPE_CHECKING:
    from matplotlib.figure import Figure


#: Endings of images.
IMAGE_SUFFIXES = (".png", ".svg", ".pdf")
_DOTS_PER_INCH = 150
#: Ending → metadata of an image: what has made it, and no date.
_METADATA: dict[str, dict[str, str | None]] = {
    ".png": {"Software": MARK},
    ".svg": {"Creator": MARK, "Date": None},
    ".pdf": {"Creator": MARK, "CreationDate": None},
}


def cannot_write(path: str | Path, error: OSError) -> InputError:
    """The error that says why a file cannot be written."""
    return InputError(f"{path}: cannot be written: {error.strerror or error}")


def check_folder(path: str | Path | None) -> None:
    """Raise an ``InputError`` unless a new file or folder can be created here; None if nothing is to be written."""
    if path is None:
        return
    file = Path(path)
    if not file.parent.is_dir():
        raise InputError(f"{path}: there is no folder '{file.parent}' to write to; create it first")
    try:
        with tempfile.NamedTemporaryFile(dir=file.parent, prefix=f".{file.name}-"):
            pass
    except OSError as error:
        raise cannot_write(path, error) from None


def check_file(path: str | Path | None, *inputs: str | Path, kind: Kind | None = None) -> None:
    """Raise an ``InputError`` unless a file, None for none, can be written here.

    It is not one of the input files, by whatever name or link; and where something is there already, this is a file of
    the same kind that this package has made. Without a kind any regular file may be replaced.
    """
    if path is not None and Path(path).exists():
        if not Path(path).is_file():
            raise InputError(f"{path}: this exists and is not a regular file; give another name")
        if any(Path(input_file).exists() and Path(path).samefile(input_file) for input_file in inputs):
            raise InputError(f"{path}: this is the file that is read; give another name")
        if kind is not None:
            kind.refuse_other(path)
    check_folder(path)


def check_image(path: str | Path | None, *inputs: str | Path) -> None:
    """Raise an ``InputError`` unless an image can be written here: its ending is known, and as :func:`check_file`."""
    if path is not None and Path(path).suffix.lower() not in IMAGE_SUFFIXES:
        raise InputError(f"{path}: the name of an image must end in .png, .svg or .pdf")
    check_file(path, *inputs, kind=IMAGE)


def check_apart(**outputs: str | Path | None) -> None:
    """Raise an ``InputError`` if two files that are to be written, option → path or None, are one by any name."""
    options: dict[Path, str] = {}
    for name, path in outputs.items():
        if path is None:
            continue
        option = f"--{name.replace('_', '-')}"
        other = options.setdefault(Path(os.path.normcase(Path(path).resolve())), option)
        if other != option:
            raise InputError(f"{other} and {option} name the same file, {path}; give each a name of its own")


#: What is to be done if the process ends at once, in the order in which it was begun.
_IF_ABANDONED: list[Callable[[], Any]] = []


@contextmanager
def if_abandoned(clear: Callable[[], Any]) -> Iterator[None]:
    """Within the block, ``clear`` is called if the process ends at once and nothing that is being done goes on."""
    _IF_ABANDONED.append(clear)
    try:
        yield
    finally:
        _IF_ABANDONED.remove(clear)


def abandon() -> None:
    """Leave nothing half done behind as the process ends at once: do what :func:`if_abandoned` was told, last first."""
    for clear in reversed(tuple(_IF_ABANDONED)):
        with suppress(Exception):
            clear()


@contextmanager
def replacing(path: str | Path, *, kind: Kind | None = None) -> Iterator[Path]:
    """A temporary file that replaces a file in one step when it is complete, and is deleted otherwise; the same ending.

    An ``InputError`` as by :func:`check_file`, or if the system refuses.
    """
    check_file(path, kind=kind)
    file = Path(path).resolve()
    part = file.with_name(f".{uuid.uuid4().hex}{file.suffix}")
    try:
        with if_abandoned(lambda: part.unlink(missing_ok=True)):
            yield part
        part.replace(file)
    except OSError as error:
        raise cannot_write(path, error) from None
    finally:
        part.unlink(missing_ok=True)


@contextmanager
def interrupted_afterwards(shorten: Callable[[], Any] = lambda: None) -> Iterator[None]:
    """SIGINT and SIGTERM wait for the end of the block; processes that it starts never see the keyboard's SIGINT.

    ``shorten`` is called as a signal comes, to bring the end about, also by an error, which the interruption replaces.
    """
    if threading.current_thread() is not threading.main_thread() or not hasattr(signal, "pthread_sigmask"):
        yield
        return
    came: list[int] = []
    both = (signal.SIGINT, signal.SIGTERM)

    def keep(number: int, _: FrameType | None) -> None:
        came.append(number)
        shorten()

    before = [signal.signal(number, keep) for number in both]
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})  # threads and processes inherit it
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        for number, handler in zip(both, before, strict=True):
            signal.signal(number, handler)
        for kept in came:
            signal.raise_signal(kept)


def write_text(text: str, path: str | Path, *, kind: Kind | None = None) -> None:
    """Write a text file in UTF-8; line ends are not changed. An ``InputError`` if it cannot be written."""
    with replacing(path, kind=kind) as part:
        part.write_text(text, encoding="utf-8", newline="")


def write_image(figure: Figure, path: str | Path) -> None:
    """Write an image with an ending of :data:`IMAGE_SUFFIXES`; the same figure makes the same file.

    An ``InputError`` if it cannot be written.
    """
    from matplotlib import rc_context

    with replacing(path, kind=IMAGE) as part, rc_context({"svg.hashsalt": MARK}):
        figure.savefig(part, dpi=_DOTS_PER_INCH, metadata=_METADATA.get(Path(path).suffix.lower()))


def write_pages(figures: Sequence[Figure], path: str | Path) -> None:
    """Write figures as the pages of one PDF file; the same figures make the same file."""
    from matplotlib.backends.backend_pdf import PdfPages

    with replacing(path, kind=IMAGE) as part, PdfPages(part, metadata=_METADATA[".pdf"]) as pages:
        for figure in figures:
            pages.savefig(figure)


def write_columns(columns: Mapping[str, Any], path: str, *, kind: Kind | None = None) -> None:
    """Write columns of one length, header with its unit → numbers, completely or not at all."""
    import numpy as np

    rows = np.column_stack([np.asarray(column) for column in columns.values()])
    with replacing(path, kind=kind) as part, part.open("w", newline="") as target:
        writer = csv.writer(target)
        writer.writerow(columns)
        writer.writerows([repr(float(value)) for value in row] for row in rows)

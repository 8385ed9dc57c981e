"""A copy of the package in which a test does what a contributor does, and what is run in it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import asperity

#: What ``python -c`` runs in place of the command ``asperity``.
_COMMAND = "from asperity.cli import main; main()"


def package_copy(tmp_path: Path) -> Path:
    """The folder to put on PYTHONPATH, with a copy of the package's sources in it."""
    folder = tmp_path / "copy"
    source = Path(asperity.__file__).parent
    shutil.copytree(source, folder / "asperity", ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def run(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """The command ``asperity`` of the copy in a folder, with arguments; its output as text, whatever its exit code."""
    return run_python(folder, _COMMAND, *arguments)


def run_python(folder: Path, code: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Code with the copy in a folder, in a process of its own; warnings are errors."""
    environment = os.environ | {"PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", code, *arguments],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )


def changed_files(folder: Path) -> set[str]:
    """Files of the copy that differ from the package, by their path in it: added, changed or removed."""
    source, copy = Path(asperity.__file__).parent, folder / "asperity"
    files = {
        path.relative_to(root)
        for root in (source, copy)
        for path in root.rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    return {
        file.as_posix()
        for file in files
        if not all((root / file).is_file() for root in (source, copy))
        or (source / file).read_bytes() != (copy / file).read_bytes()
    }

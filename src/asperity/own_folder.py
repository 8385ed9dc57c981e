"""A folder whose files may be run: of this user, and writable by nobody else.

Compiled programs are machine code. Whoever can put a file into the folder that they are read from, or replace the
folder, decides what runs. Here a folder is accepted, and a file read, only if that is the user or the system alone.
"""

from __future__ import annotations

import os
import stat
from pathlib import Path

_OTHERS_WRITE = stat.S_IWGRP | stat.S_IWOTH
#: Users are known by number; elsewhere (Windows) the rights of the user's profile hold.
_HAS_USERS = hasattr(os, "geteuid")


class NotOwnError(OSError):
    """Others can write to a folder or a file, or have written it."""


def own_folder(path: Path) -> Path:
    """A folder, without symbolic links, that only this user can write to; made if there is none, for the user alone.

    :class:`NotOwnError` if it belongs to another user, or others can write to it, or replace it in the folders above;
    ``OSError`` if it cannot be made, or is no folder.
    """
    path.mkdir(mode=0o700, parents=True, exist_ok=True)
    folder = path.resolve()
    if not _HAS_USERS:
        return folder
    status = folder.lstat()
    if not stat.S_ISDIR(status.st_mode):
        raise NotADirectoryError(f"{folder} is no folder")
    if status.st_uid != os.geteuid():
        raise NotOwnError(f"{folder} belongs to another user")
    if status.st_mode & _OTHERS_WRITE:
        raise NotOwnError(f"others can write to {folder}; 'chmod 700' closes it to them")
    for above in folder.parents:
        mode, owner, group = (status := above.stat()).st_mode, status.st_uid, status.st_gid
        # in a sticky folder, such as /tmp, only the owner of an entry can replace it
        open_to = 0 if mode & stat.S_ISVTX else mode & _OTHERS_WRITE
        if group == os.getegid():  # a group of the user alone, on many systems
            open_to &= ~stat.S_IWGRP
        if open_to or owner not in (0, os.geteuid()):
            raise NotOwnError(f"others can replace {folder}, as they can write to {above}")
    return folder


def foreign_files(folder: Path, ending: str) -> list[str]:
    """Names of a folder's files that this user has not written, or that are no regular files."""
    with os.scandir(folder) as entries:
        return [
            entry.name
            for entry in entries
            if entry.name.endswith(ending) and not _is_own(entry.stat(follow_symlinks=False))
        ]


def read_own(file: Path) -> bytes:
    """The content of a file that only this user can have written; it is marked as used.

    An OSError if there is none that can be read; :class:`NotOwnError` if it is a pipe or a device, or belongs to or can
    be written by others.
    """
    if _HAS_USERS:
        folder = file.parent.lstat()
        if folder.st_uid != os.geteuid() or folder.st_mode & _OTHERS_WRITE:
            raise NotOwnError(f"others can write to {file.parent}")
    # a pipe must not wait for somebody who writes
    flags = (
        os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    )
    with open(os.open(file, flags), "rb") as stream:
        status = os.fstat(stream.fileno())
        if not _is_own(status) or (_HAS_USERS and status.st_mode & _OTHERS_WRITE):
            raise NotOwnError(f"{file} may be by another user")
        content = stream.read()
    os.utime(file)
    return content


def write_own(file: Path, content: bytes) -> None:
    """Write a new file that only this user can read or write; OSError if it exists or cannot be written."""
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
    with open(os.open(file, flags, 0o600), "wb") as stream:
        stream.write(content)


def _is_own(status: os.stat_result) -> bool:
    return stat.S_ISREG(status.st_mode) and (not _HAS_USERS or status.st_uid == os.geteuid())

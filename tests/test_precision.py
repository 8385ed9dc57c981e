"""Double precision is asked for, never assumed."""

import os
import subprocess
import sys
from pathlib import Path

import jax
import pytest

from asperity.errors import PrecisionError
from asperity.precision import _write_whole_files, require_double_precision, use_compilation_cache


def test_single_precision_is_refused_with_the_remedy():
    with jax.enable_x64(False), pytest.raises(PrecisionError, match="use_double_precision"):
        require_double_precision()


def test_double_precision_passes():
    require_double_precision()
    assert jax.numpy.ones(1).dtype == "float64"


def test_empty_cache_directory_switches_the_cache_off(monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    before = jax.config.jax_compilation_cache_dir
    use_compilation_cache()
    assert jax.config.jax_compilation_cache_dir == before


def test_half_of_a_program_is_not_kept(tmp_path, monkeypatch):
    """A full disk, or an interruption: JAX would say at every later start that it cannot read what was written."""
    cache = pytest.importorskip("jax._src.lru_cache").LRUCache(str(tmp_path), max_size=-1)
    _write_whole_files()  # also where the tests keep nothing
    write = Path.write_bytes

    def full(path, content):
        write(path, content[:5])
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(OSError, match="No space"):
        cache.put("program", b"machine code")
    assert cache.get("program") is None
    assert not list(tmp_path.iterdir())
    monkeypatch.undo()
    cache.put("program", b"machine code")
    assert cache.get("program") == b"machine code"


FOLDER = """
import os, pwd
import jax
from asperity.precision import use_compilation_cache
if "HOME" not in os.environ:  # nor an entry in the list of users, as in many containers
    pwd.getpwuid = pwd.getpwnam = {}.__getitem__
use_compilation_cache()
use_compilation_cache()
print(jax.config.jax_compilation_cache_dir)
"""


def _folder(folder=None, *, home=None):
    """The folder that a process uses, and what it says."""
    kept = {name: value for name, value in os.environ.items() if name not in ("HOME", "ASPERITY_CACHE_DIR")}
    kept = {name: value for name, value in kept.items() if not name.startswith("XDG_")}
    given = {"HOME": home, "ASPERITY_CACHE_DIR": folder, "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(
        [sys.executable, "-c", FOLDER],
        env=kept | {name: str(value) for name, value in given.items() if value is not None},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip(), done.stderr


@pytest.mark.slow
def test_a_new_folder_is_open_to_its_user_alone(tmp_path):
    assert _folder(tmp_path / "new" / "cache") == (str(tmp_path / "new" / "cache"), "")
    assert (tmp_path / "new" / "cache").stat().st_mode & 0o777 == 0o700
    (tmp_path / "link").symlink_to("new/cache")
    assert _folder(tmp_path / "link") == (str(tmp_path / "new" / "cache"), "")


@pytest.mark.slow
def test_a_tilde_stands_for_the_home_of_the_user(tmp_path):
    assert _folder("~/x", home=tmp_path) == (str(tmp_path / "x"), "")
    assert _folder(home=tmp_path)[0].startswith(str(tmp_path))


@pytest.mark.parametrize("folder", [None, "~/x"])
def test_without_a_home_nothing_is_kept(folder):
    assert _folder(folder) == ("None", "")


@pytest.mark.slow
def test_what_is_no_folder_or_cannot_be_made_is_passed_over(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for each in (tmp_path / "pipe", "/proc/none", "/dev/null/x", tmp_path / ("x" * 300)):
        assert _folder(each) == ("None", "")


@pytest.mark.slow
def test_a_folder_that_others_can_write_to_or_replace_is_not_used_and_a_note_says_so(tmp_path):
    cache = tmp_path / "above" / "cache"
    cache.mkdir(parents=True)
    cache.chmod(0o777)
    found, said = _folder(cache)
    assert found == "None"
    assert said.count("asperity: note: compiled programs are not kept: others can write to") == 1
    cache.chmod(0o700)
    assert _folder(cache) == (str(cache), "")
    cache.parent.chmod(0o777)
    assert "as they can write to" in _folder(cache)[1]
    cache.parent.chmod(0o1777)  # as /tmp
    assert _folder(cache) == (str(cache), "")


@pytest.mark.slow
def test_a_folder_of_another_user_and_with_files_of_another_is_not_used(tmp_path):
    if os.geteuid() != 0:
        pytest.skip("only root can give files away")
    os.mkfifo(tmp_path / "jit_x-cache")
    assert "jit_x-cache may be by another user" in _folder(tmp_path)[1]
    (tmp_path / "jit_x-cache").unlink()
    (tmp_path / "jit_x-cache").touch()
    assert _folder(tmp_path) == (str(tmp_path), "")
    os.chown(tmp_path / "jit_x-cache", 54321, -1)
    assert "jit_x-cache may be by another user" in _folder(tmp_path)[1]
    Path(tmp_path / "jit_x-cache").unlink()
    os.chown(tmp_path, 54321, -1)
    assert "belongs to another user" in _folder(tmp_path)[1]

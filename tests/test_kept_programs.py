"""What is stated of results is enough to hold their numbers again, and no more."""

import hashlib
import json
import os
import pickle
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import NamedTuple

import equinox
import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity import kept_programs
from asperity.kept_programs import Request, keep, kept, of_outline, outline, without_the_cache_of_jax

PACKAGE = __name__.partition(".")[0]
FAST = ({"xla_backend_optimization_level": 0}, {})


def _line(slope, numbers):
    return {"y": float(slope) * numbers["x"] + 1.0, "sum": jnp.sum(numbers["x"])}


def _solved(numbers):
    return {"x": jnp.linalg.solve(numbers["matrix"], numbers["right"])}


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """A cache of this test's own, which keeps the functions of this module."""
    monkeypatch.setattr(kept_programs, "_PACKAGE", PACKAGE)
    before = jax.config.jax_compilation_cache_dir
    jax.config.update("jax_compilation_cache_dir", str(tmp_path))
    yield tmp_path
    jax.config.update("jax_compilation_cache_dir", before)


def _request(numbers, *, function=_line, options=("2",)):
    leaves, structure = jax.tree.flatten((numbers,))
    return Request(function, options, structure, tuple((leaf.shape, leaf.dtype) for leaf in leaves))


def _compiled(request):
    """The program of the leaves, and what comes of it, by JAX alone."""

    def flat(leaves):
        return jax.tree.leaves(
            request.function(*request.options, *jax.tree.unflatten(request.structure, leaves))
        )

    shapes = [jax.ShapeDtypeStruct(*kind) for kind in request.kinds]
    results = jax.eval_shape(
        lambda *arguments: request.function(*request.options, *arguments),
        *jax.tree.unflatten(request.structure, shapes),
    )
    with without_the_cache_of_jax():
        return jax.jit(flat).lower(shapes).compile(), results


def _programs(folder):
    return sorted(folder.glob("asperity-*.program"))


def test_what_is_kept_computes_the_same(cache):
    numbers = {"x": np.arange(3.0)}
    request = _request(numbers)
    assert kept(request, FAST) is None
    keep(request, FAST, *_compiled(request))
    found = kept(request, FAST)
    assert jax.tree.map(lambda out: out.shape, found.results) == {"y": (3,), "sum": ()}
    total, line = found.load()(jax.tree.leaves(numbers))
    np.testing.assert_array_equal(line, [1.0, 3.0, 5.0])
    assert total == 3.0


MATRIX, RIGHT = np.array([[2.0, 1.0], [1.0, 3.0]]), np.array([3.0, 5.0])
IN_ANOTHER_PROCESS = """
import importlib
import sys
import jax
from asperity import kept_programs
test = importlib.import_module(sys.argv.pop())
for name, value in zip(sys.argv[1::2], sys.argv[2::2]):
    jax.config.update(name, {"True": True, "False": False}.get(value, value))
request = test._request({"matrix": test.MATRIX, "right": test.RIGHT}, function=test._solved, options=())
kept_programs._PACKAGE = test.PACKAGE
print(*kept_programs.kept(request, test.FAST).load()([test.MATRIX, test.RIGHT])[0].tolist())
"""


def test_linear_algebra_is_found_in_a_process_that_has_never_lowered_it(cache):
    request = _request({"matrix": MATRIX, "right": RIGHT}, function=_solved, options=())
    keep(request, FAST, *_compiled(request))
    settings = {
        "jax_enable_x64": True,
        "jax_disable_most_optimizations": jax.config.read("jax_disable_most_optimizations"),
        "jax_compilation_cache_dir": cache,
    }
    words = [str(word) for setting in settings.items() for word in setting]
    done = subprocess.run(
        [sys.executable, "-c", IN_ANOTHER_PROCESS, *words, __name__],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(Path(__file__).parents[1]), *sys.path])},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert [float(x) for x in done.stdout.split()] == pytest.approx([0.8, 1.4], rel=1e-14)


def test_without_a_folder_nothing_is_kept(cache):
    request = _request({"x": np.arange(3.0)})
    jax.config.update("jax_compilation_cache_dir", None)
    keep(request, FAST, *_compiled(request))
    assert kept(request, FAST) is None
    assert not list(cache.iterdir())


def test_a_full_disk_leaves_nothing_behind(cache, monkeypatch):
    request = _request({"x": np.arange(3.0)})

    def full(part, file):
        raise OSError

    monkeypatch.setattr(kept_programs.Path, "replace", full)
    keep(request, FAST, *_compiled(request))
    assert not list(cache.iterdir())


@pytest.mark.parametrize(
    "damage",
    [lambda content: content[:100], lambda content: content[:-50] + b"x" + content[-49:], lambda _: b""],
)
def test_a_damaged_file_is_as_good_as_none(cache, damage):
    request = _request({"x": np.arange(3.0)})
    keep(request, FAST, *_compiled(request))
    (file,) = _programs(cache)
    file.write_bytes(damage(file.read_bytes()))
    assert kept(request, FAST) is None


class _Planted:
    """A pickle of it runs code."""

    def __reduce__(self):
        return exec, ("import pathlib; pathlib.Path(__import__('os').environ['PLANTED']).touch()",)


@pytest.mark.parametrize("kind", ["folder", "file", "link", "owner"])
def test_what_others_can_have_written_is_not_read(cache, monkeypatch, kind):
    request = _request({"x": np.arange(3.0)})
    keep(request, FAST, *_compiled(request))
    (file,) = _programs(cache)
    assert kept(request, FAST) is not None
    if kind == "folder":
        cache.chmod(0o777)
    elif kind == "file":
        file.chmod(0o666)
    elif kind == "link":
        file.symlink_to(file.rename(cache / "planted"))
    else:
        monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    assert kept(request, FAST) is None


def _content(kind, head, machine_code):
    known = json.loads(head)
    return {
        "pickle": lambda: pickle.dumps(_Planted()),
        "pickled tuple": lambda: pickle.dumps(([((3,), np.dtype(float))], [0], machine_code, False)),
        "empty": lambda: b"",
        "number": lambda: b"5\n" + machine_code,
        "deep": lambda: b"[" * 100_000 + b"\n" + machine_code,
        "no entries": lambda: b"{}\n" + machine_code,
        "other class": lambda: json.dumps(known | {"results": ["module", "os", "environ", []]}).encode(),
        "other shapes": lambda: json.dumps(known | {"kinds": [["x", 3]]}).encode(),
        "fewer shapes": lambda: json.dumps(known | {"kinds": []}).encode(),
        "other program": lambda: json.dumps(known | {"file": "another"}).encode() + b"\n" + machine_code,
    }[kind]()


@pytest.mark.parametrize(
    "kind",
    [
        "pickle",
        "pickled tuple",
        "empty",
        "number",
        "deep",
        "no entries",
        "other class",
        "other shapes",
        "fewer shapes",
        "other program",
    ],
)
def test_other_content_with_its_own_digest_is_as_good_as_none(cache, monkeypatch, kind):
    monkeypatch.setenv("PLANTED", str(cache / "planted"))
    request = _request({"x": np.arange(3.0)})
    keep(request, FAST, *_compiled(request))
    (file,) = _programs(cache)
    head, _, machine_code = file.read_bytes()[32:].partition(b"\n")
    content = _content(kind, head, machine_code)
    file.write_bytes(hashlib.sha256(content).digest() + content)
    assert kept(request, FAST) is None
    assert not (cache / "planted").exists()


def test_machine_code_of_another_program_is_not_called(cache):
    requests = [_request({"x": np.arange(size)}) for size in (3.0, 4.0)]
    stored = []
    for each in requests:
        keep(each, FAST, *_compiled(each))
        (file,) = set(_programs(cache)) - {known for known, _ in stored}
        stored.append((file, file.read_bytes()[32:].partition(b"\n")))
    (file, (head, _, _)), (_, (_, _, other)) = stored
    content = head + b"\n" + other
    file.write_bytes(hashlib.sha256(content).digest() + content)
    with pytest.raises(ValueError, match="another program"):
        kept(requests[0], FAST).load()


class _PlantedClass(_Planted):
    """The same by what a name inside a class of JAX leads to, and by a function of JAX."""

    def __init__(self, made, *arguments):
        self.made, self.arguments = made, arguments

    def __reduce__(self):
        return self.made, self.arguments


@pytest.mark.parametrize(
    "planted",
    [_Planted(), _PlantedClass(jax.pure_callback, print), _PlantedClass(os.system, "true"), [_Planted()]],
)
def test_machine_code_that_names_more_than_classes_of_jax_is_not_read(cache, monkeypatch, planted):
    monkeypatch.setenv("PLANTED", str(cache / "planted"))
    request = _request({"x": np.arange(3.0)})
    keep(request, FAST, *_compiled(request))
    (file,) = _programs(cache)
    head, _, _ = file.read_bytes()[32:].partition(b"\n")
    content = head + b"\n" + pickle.dumps(planted)
    file.write_bytes(hashlib.sha256(content).digest() + content)
    with pytest.raises(ValueError, match="is no part of machine code"):
        kept(request, FAST).load()
    assert not (cache / "planted").exists()


def test_a_pipe_in_the_place_of_a_file_is_not_waited_for(cache):
    request = _request({"x": np.arange(3.0)})
    keep(request, FAST, *_compiled(request))
    (file,) = _programs(cache)
    file.unlink()
    os.mkfifo(file)
    assert kept(request, FAST) is None


def test_programs_that_nobody_uses_are_removed_after_three_months(cache):
    used, unused, recent, other = (_request({"x": np.arange(size)}) for size in (2.0, 3.0, 4.0, 5.0))
    unused_for = {}
    for each, days in ((used, 91), (unused, 91), (recent, 89)):
        keep(each, FAST, *_compiled(each))
        (file,) = set(_programs(cache)) - set(unused_for)
        unused_for[file] = days
    for file, days in unused_for.items():
        then = time.time() - days * 24 * 3600
        os.utime(file, (then, then))
    assert kept(used, FAST) is not None
    keep(other, FAST, *_compiled(other))
    assert [kept(each, FAST) is not None for each in (used, unused, recent)] == [True, False, True]
    assert len(_programs(cache)) == 3


def test_what_an_ended_process_left_half_written_is_removed_after_an_hour(cache):
    old, new = cache / "asperity-0.program.1.1.part", cache / "asperity-1.program.1.1.part"
    for file, minutes in ((old, 61), (new, 59)):
        file.touch()
        then = time.time() - 60.0 * minutes
        os.utime(file, (then, then))
    request = _request({"x": np.arange(3.0)})
    keep(request, FAST, *_compiled(request))
    assert not old.exists()
    assert new.exists()
    assert len(_programs(cache)) == 1


def test_a_fingerprint_stands_for_all_that_the_code_depends_on(monkeypatch):
    def fingerprint(**other):
        return _request({"x": np.arange(3.0)}, **other).fingerprint

    different = {
        fingerprint(),
        fingerprint(options=("3",)),
        fingerprint(function=_solved),
        _request({"x": np.arange(4.0)}).fingerprint,
        _request({"z": np.arange(3.0)}).fingerprint,
    }
    assert len(different) == 5
    assert fingerprint() in different
    monkeypatch.setattr(kept_programs, "_surroundings", lambda: b"another release")
    assert fingerprint() not in different


def test_other_options_of_the_compiler_are_other_machine_code(cache):
    request = _request({"x": np.arange(3.0)})
    keep(request, FAST, *_compiled(request))
    assert kept(request, FAST) is not None
    assert kept(request, ({},)) is None


@pytest.mark.parametrize(
    "change",
    [
        lambda patch: patch.setattr(kept_programs.Path, "read_bytes", lambda path: b"changed"),
        lambda patch: patch.setattr(kept_programs, "_processor", lambda: "another"),
        lambda patch: patch.setattr(jax, "__version__", "another"),
        lambda patch: patch.setenv("XLA_FLAGS", "another"),
    ],
    ids=["source", "processor", "release", "flags"],
)
def test_surroundings_are_source_releases_and_machine(monkeypatch, change):
    before = kept_programs._surroundings.__wrapped__()
    assert kept_programs._surroundings.__wrapped__() == before
    change(monkeypatch)
    assert kept_programs._surroundings.__wrapped__() != before


def test_a_closure_is_not_known_by_its_name(cache):
    factor = 2.0
    request = _request({"x": np.arange(3.0)}, function=lambda numbers: factor * numbers["x"], options=())
    assert not request.known_by_name
    assert _request({"x": np.arange(3.0)}).known_by_name
    keep(request, FAST, *_compiled(request))
    assert not _programs(cache)


def test_a_function_outside_the_package_is_not_known_by_its_name():
    """Its source may change while this package stays as it is."""
    assert not _request({"x": np.arange(3.0)}).known_by_name
    assert _request({"x": np.arange(3.0)}, function=jnp.sum, options=()).known_by_name is False
    assert _request({"x": np.arange(3.0)}, function=kept_programs.kept, options=()).known_by_name


def test_jax_keeps_nothing_while_a_block_is_open_in_any_thread():
    name = "jax_persistent_cache_min_compile_time_secs"
    before = getattr(jax.config, name)
    opened, close = threading.Event(), threading.Event()

    def other():
        with without_the_cache_of_jax():
            opened.set()
            close.wait(10.0)

    thread = threading.Thread(target=other)
    with without_the_cache_of_jax():
        assert getattr(jax.config, name) == float("inf")
        thread.start()
        assert opened.wait(10.0)
    assert getattr(jax.config, name) == float("inf")
    close.set()
    thread.join()
    assert getattr(jax.config, name) == before


class Pair(NamedTuple):
    first: object
    second: object


class Inner(equinox.Module):
    force: object
    name: str = equinox.field(static=True)


class Outer(equinox.Module):
    inner: Inner
    rows: dict
    absent: object
    names: tuple = equinox.field(static=True)


TREES = [
    Outer(Inner(1.0, "sp"), {"a": [3.0, (4.0,)], "b": 2.0}, None, ("x", ("y", 2, None, True))),
    Pair(1.0, Inner(None, "")),
    Outer(None, {}, (), Pair(("x",), Pair(1, None))),
    5.0,
    None,
    {},
    (),
    [{"x": ()}],
]


@pytest.mark.parametrize("tree", TREES)
def test_the_structure_survives_json(tree):
    found = of_outline(json.loads(json.dumps(outline(tree))))
    assert jax.tree.structure(found) == jax.tree.structure(tree)
    assert repr(found) == repr(jax.tree.map(lambda leaf: 0, tree))  # tuples of any name are equal
    assert all(leaf == 0 for leaf in jax.tree.leaves(found))


class NotKnown:
    """Neither a module nor a plain value."""


def test_what_cannot_be_stated_is_said():
    with pytest.raises(ValueError, match="NotKnown is no plain value"):
        outline(Inner(1.0, NotKnown()))


@pytest.mark.parametrize(
    "stated",
    [
        None,
        5,
        [],
        ["number", 1],
        ["class", "x"],
        ["module", "os", "system", []],
        ["module", "subprocess", "Popen", []],
        ["named", "builtins", "tuple.__new__", []],
        ["module", "not_loaded", "Module", []],
        ["module", "equinox", "Module", [["a", "static", ["list"]]]],
        ["dict", [[["list"], ["number"]]]],
    ],
)
def test_what_is_no_outline_is_refused(stated):
    with pytest.raises(ValueError, match=r"is no "):
        of_outline(stated)

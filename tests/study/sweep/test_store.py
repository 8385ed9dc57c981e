"""Blocks of a sweep on disk: what is written is found, what is unfinished is known, nothing else is touched."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.study.sweep.store import check_store, open_store, prepare_store, remove_store
from asperity.study.sweep.store_layout import unfinished_blocks
from asperity.study.sweep.sweep_plan import make_plan

pytest.importorskip("zarr")


def test_blocks_are_found_where_they_were_written(case, tmp_path, axes, written):
    plan = make_plan(case, axes, ("published_stiffness_output", "slip_ratio"), block_points=4)
    assert prepare_store(tmp_path / "s.zarr", plan) == [0, 1, 2]
    written(tmp_path / "s.zarr", plan, 1, 7.0)
    assert unfinished_blocks(tmp_path / "s.zarr") == prepare_store(tmp_path / "s.zarr", plan) == [0, 2]
    found = open_store(tmp_path / "s.zarr")
    assert list(found.data_vars) == ["status", *plan.results]
    np.testing.assert_array_equal(found["published_stiffness_output"][1], 7.0)
    np.testing.assert_array_equal(found["slip_ratio"][:, 1], 7.0)
    assert np.isnan(found["published_stiffness_output"][::2]).all()
    np.testing.assert_array_equal(found["status"], [[-1] * 4, [0] * 4, [-1] * 4])
    np.testing.assert_allclose(found["load.preload"], [800.0, 1000.0, 1200.0])


def test_a_store_made_anew_in_the_same_place_is_not_the_old_one(case, tmp_path, axes, written):
    path = tmp_path / "s.zarr"
    for results, value in ((("published_stiffness_output",), 1.0), (("slip_ratio",), 2.0)):
        plan = make_plan(case, axes, results)
        prepare_store(path, plan)
        written(path, plan, 0, value)
        np.testing.assert_array_equal(open_store(path)[results[0]], value)
        remove_store(path)
    assert not path.exists()


def test_what_is_no_store_or_another_sweeps_is_left_alone(case, tmp_path, axes):
    plan = make_plan(case, axes, ("slip_ratio",))
    (tmp_path / "mine").mkdir()
    for refused in (lambda: prepare_store(tmp_path / "mine", plan), lambda: remove_store(tmp_path / "mine")):
        with pytest.raises(InputError, match=r"is not the store of a sweep"):
            refused()
    assert (tmp_path / "mine").is_dir()
    prepare_store(tmp_path / "s.zarr", plan)
    with pytest.raises(InputError, match=r"another sweep \(different: the results\)"):
        prepare_store(tmp_path / "s.zarr", make_plan(case, axes, ("published_stiffness_output",)))
    with pytest.raises(InputError, match="there is no folder"):
        prepare_store(tmp_path / "nowhere" / "s.zarr", plan)


def test_a_store_with_files_of_others_or_behind_a_link_is_not_deleted(case, tmp_path, axes, written):
    plan = make_plan(case, axes, ("published_stiffness_output", "slip_ratio"))
    store = tmp_path / "s.zarr"
    prepare_store(store, plan)
    written(store, plan, 0, 7.0)
    (tmp_path / "link.zarr").symlink_to("s.zarr")
    with pytest.raises(InputError, match=r"link\.zarr: this is a link; give the name of the store itself"):
        remove_store(tmp_path / "link.zarr")
    # what a killed process leaves is the store's
    (store / f"status/c/0/1.{'0a' * 16}.partial").write_text("half of a chunk")
    for place in (
        *(
            "joint.toml",
            "slip_ratio/notes.txt",
            "c",
            "slip_ratio/c/notes.txt",
            "status/c/0/1b",
            "photos/zarr.json",
        ),
        *("c/joint.toml", "mass/c/0/0", "progress/c/0", "slip_ratio/c/0/0.partial", "status/c/0/٣"),
    ):
        folder = (store / place).parent
        new = [each for each in (folder, *folder.parents) if not each.exists()]
        folder.mkdir(parents=True, exist_ok=True)
        (store / place).write_text("mine")
        with pytest.raises(
            InputError, match=f"{place} in this store is of no sweep, so nothing is deleted; move it"
        ):
            remove_store(store)
        assert (store / place).read_text() == "mine"
        (store / place).unlink()
        for each in new:
            each.rmdir()
    np.testing.assert_array_equal(open_store(store)["status"][0], 0)
    remove_store(store)
    assert not store.exists()


def test_what_is_read_may_not_be_in_the_store(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "s.zarr" / "c").mkdir(parents=True)
    (tmp_path / "s.zarr" / "c" / "joint.toml").write_text("mine")
    (tmp_path / "joint.toml").symlink_to("s.zarr/c/joint.toml")
    (tmp_path / "link.zarr").symlink_to("s.zarr")
    for store, read in (
        ("s.zarr", "s.zarr/c/joint.toml"),
        (tmp_path / "s.zarr", "joint.toml"),
        ("link.zarr", "joint.toml"),
    ):
        with pytest.raises(
            InputError, match=r"joint\.toml, which is read, is in this folder; choose another"
        ):
            check_store(store, read)
    check_store("t.zarr", "joint.toml")


def test_two_first_runs_into_one_store(case, tmp_path, monkeypatch, axes):
    from asperity.study.sweep import store

    plan = make_plan(case, axes, ("slip_ratio",))
    build = store.build_store

    def overtaken(folder, plan):
        build(folder, plan)
        monkeypatch.undo()
        prepare_store(tmp_path / "s.zarr", plan)

    monkeypatch.setattr(store, "build_store", overtaken)
    with pytest.raises(
        InputError, match=r"s\.zarr: another run has just created this store; let it finish, or"
    ):
        prepare_store(tmp_path / "s.zarr", plan)
    assert [path.name for path in tmp_path.iterdir()] == ["s.zarr"]
    assert prepare_store(tmp_path / "s.zarr", plan) == [0]


def test_a_store_of_an_older_format_is_refused(case, tmp_path, monkeypatch, axes):
    plan = make_plan(case, axes, ("slip_ratio",))
    monkeypatch.setattr("asperity.study.sweep.store_layout.FORMAT", 1)
    prepare_store(tmp_path / "s.zarr", plan)
    monkeypatch.undo()
    with pytest.raises(InputError, match=r"different: the format of the store\); choose another folder"):
        prepare_store(tmp_path / "s.zarr", plan)


def test_a_full_disk_is_told_with_what_is_needed_and_free(case, tmp_path, axes, monkeypatch):
    """Twelve points of a byte and six numbers of eight bytes are 588 bytes."""
    plan = make_plan(case, axes, ("published_stiffness_output", "slip_ratio"))
    usage = SimpleNamespace(free=587)
    monkeypatch.setattr("asperity.study.sweep.store.shutil.disk_usage", lambda folder: usage)
    with pytest.raises(InputError, match=r"12 points .* about 5\.88e-07 GB and 5\.87e-07 GB are free"):
        prepare_store(tmp_path / "s.zarr", plan)
    usage.free = 588
    assert prepare_store(tmp_path / "s.zarr", plan) == [0]

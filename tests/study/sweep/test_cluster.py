"""A real cluster of separate processes: one worker is killed in the middle and nothing is lost."""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from multiprocessing.process import BaseProcess
from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.study.parameters import parse_axis
from asperity.study.sweep.cluster import _client, worker_environment
from asperity.study.sweep.store_layout import unfinished_blocks
from asperity.study.sweep.sweep import sweep

# distributed leaves sockets and a loop to the garbage collector when a scheduler or worker vanishes
pytestmark = pytest.mark.filterwarnings(
    "ignore:unclosed:ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning"
)
AXES = tuple(
    parse_axis(text)
    for text in ("load.output_torque=0 N*m:12 N*m:20", "surface.fractal_dimension=1.3:1.8:30")
)
SOURCES = Path(__file__).parents[3] / "src"
EXAMPLE = SOURCES.parent / "examples" / "zou2025.toml"


class Cluster:
    """A scheduler and two workers on this machine."""

    def __init__(self, folder, cache):
        self.file = folder / "scheduler.json"
        self.folder = folder
        self.environment = {
            **os.environ,
            **worker_environment(),
            "PYTHONPATH": str(SOURCES),
            "JAX_COMPILATION_CACHE_DIR": str(cache),
            "JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS": "0",
        }
        where = ["--scheduler-file", str(self.file), "--no-dashboard"]
        self.scheduler = self._start("dask_scheduler", "--host", "127.0.0.1", "--port", "0", *where)
        self.workers = [
            self._start("dask_worker", *where, "--nthreads", "1", "--no-nanny", "--memory-limit", "0")
            for _ in "12"
        ]

    def _start(self, module, *arguments):
        command = [sys.executable, "-m", f"distributed.cli.{module}", *arguments]
        log = (self.folder / "log.txt").open("a")
        with log:
            return subprocess.Popen(command, env=self.environment, stdout=log, stderr=log, cwd=self.folder)

    def address(self):
        for _ in range(600):
            if self.file.exists() and self.file.stat().st_size:
                return json.loads(self.file.read_text())["address"]
            time.sleep(0.1)
        raise AssertionError((self.folder / "log.txt").read_text())

    def close(self):
        for process in (*self.workers, self.scheduler):
            process.kill()
            process.wait()


@pytest.fixture
def cluster(tmp_path):
    made = Cluster(tmp_path, tmp_path / "cache")
    yield made
    made.close()


@pytest.mark.long
def test_a_killed_worker_loses_nothing(case, cluster, tmp_path, evaluated_directly):
    from distributed import Client

    store = tmp_path / "s.zarr"
    killed = []
    with Client(cluster.address(), timeout="60s") as client:
        client.wait_for_workers(2, timeout=120)

        def kill_one(done, total):
            if done and not killed:
                killed.append((done, total))
                cluster.workers[0].kill()
                cluster.workers[0].wait()

        found = sweep(
            case,
            AXES,
            results=("published_stiffness_output",),
            store=store,
            scheduler=client.scheduler.address,
            block_points=30,
            report=kill_one,
        )
    assert killed
    assert killed[0][0] < killed[0][1] == 600
    assert cluster.workers[0].poll() is not None
    assert cluster.workers[1].poll() is None
    assert unfinished_blocks(store) == []

    direct = np.asarray(evaluated_directly(AXES).published.output).reshape(20, 30)
    np.testing.assert_array_equal(found["status"].values, 0)
    np.testing.assert_allclose(found["published_stiffness_output"].values, direct, rtol=1e-10)


@pytest.mark.slow
def test_no_scheduler_there(case, tmp_path, monkeypatch):
    monkeypatch.setattr("asperity.study.sweep.cluster._CONNECT_SECONDS", "1s")
    with pytest.raises(InputError, match="no Dask scheduler answers"):
        sweep(
            case,
            AXES,
            results=("published_stiffness_output",),
            store=tmp_path / "s.zarr",
            scheduler="tcp://127.0.0.1:9",
        )
    assert not (tmp_path / "s.zarr").exists()
    with pytest.raises(InputError, match="no Dask scheduler answers at nonsense"):
        sweep(
            case,
            AXES,
            results=("published_stiffness_output",),
            store=tmp_path / "t.zarr",
            scheduler="nonsense://x y",
        )


@pytest.mark.skipif(
    not Path("/proc/self/environ").exists(), reason="the system does not show a process's start"
)
def test_local_workers_start_with_their_settings_and_leave_ours_alone():
    """What the allocator sees is the environment that the process started with."""
    names = ("XLA_FLAGS", "JAX_ENABLE_X64")
    before = {name: os.environ.get(name) for name in names}

    def seen():
        start = Path("/proc/self/environ").read_text().split("\0")
        return [each for each in start if each.startswith("MALLOC_TRIM")], os.environ["XLA_FLAGS"]

    with _client(None, 1) as client:
        ((allocator, flags),) = client.run(seen).values()
        server = client.cluster.scheduler.http_server  # Dask's own choice is port 8787
        assert server.address == "127.0.0.1"
        assert server.port != 8787
    assert allocator == ["MALLOC_TRIM_THRESHOLD_=268435456"]
    assert "multi_thread_eigen=false" in flags
    assert {name: os.environ.get(name) for name in names} == before


@pytest.mark.slow
def test_an_interruption_kills_the_workers_at_once_and_leaves_no_file(tmp_path, monkeypatch):
    """Dask would first wait for what they compute."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    kill, killed = os.kill, []
    monkeypatch.setattr(os, "kill", lambda *asked: (killed.append(asked), kill(*asked)))
    workers = set()

    def interrupted():
        with _client(None, 2) as client:
            workers.update(client.run(os.getpid).values())
            assert list(tmp_path.iterdir())
            client.submit(time.sleep, 1000.0)
            killed.clear()
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert sorted(killed) == sorted((worker, signal.SIGKILL) for worker in workers)
    assert not list(tmp_path.iterdir())
    for worker in workers:
        with pytest.raises(ProcessLookupError):
            kill(worker, 0)


@pytest.mark.slow
def test_an_interruption_while_workers_start_does_not_wait_for_them(tmp_path, monkeypatch, request):
    """The signal comes as the first worker has been started: it never gets as far as to answer."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    start, started = BaseProcess.start, []

    def strike(process):
        start(process)
        started.append(process)
        if len(started) == 1:  # Dask may start another one in its place
            os.kill(os.getpid(), signal.SIGINT)

    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # tests in the background ignore it
    request.addfinalizer(lambda: signal.signal(signal.SIGINT, before))
    monkeypatch.setattr(BaseProcess, "start", strike)
    with pytest.raises(KeyboardInterrupt), _client(None, 1):
        raise AssertionError("the workers were waited for")
    assert {process.exitcode for process in started} == {-signal.SIGKILL}
    assert not list(tmp_path.iterdir())


@pytest.mark.long
@pytest.mark.parametrize(
    ("number", "code", "word"), [("TERM", 143, "terminated"), ("INT", 130, "interrupted")]
)
def test_a_signal_ends_a_sweep_on_local_processes_without_noise(tmp_path, number, code, word):
    script = (
        "import signal\nfrom asperity.cli import main\n"
        "if __name__ == '__main__':\n"
        "    signal.signal(signal.SIGINT, signal.default_int_handler)\n    main()\n"
    )
    (tmp_path / "run.py").write_text(script)
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    command = [sys.executable, "run.py", "sweep", str(EXAMPLE), "--results", "published_stiffness_output"]
    command += ["--over", "load.preload=500 N:2000 N:3000", "--over", "load.output_torque=0 N*m:5 N*m:1000"]
    process = subprocess.Popen(
        [*command, "--out", "s.zarr", "--workers", "1"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(SOURCES), "TMPDIR": str(temporary)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    finished = tmp_path / "s.zarr" / "progress" / "finished" / "c"
    for _ in range(1200):
        if (finished.is_dir() and any(finished.iterdir())) or process.poll() is not None:
            break
        time.sleep(0.1)
    process.send_signal(getattr(signal, f"SIG{number}"))
    out, err = process.communicate(timeout=120)
    assert process.returncode == code, err
    assert out == ""
    assert not list(temporary.iterdir())
    # Python's own tracker of semaphores may still say that a worker ended with one of them open
    own = [line for line in err.splitlines() if line and "resource_tracker" not in line]
    assert [line for line in own if "warnings.warn" not in line] == [
        "the finished blocks are kept in s.zarr; the same command continues from there",
        f"asperity: {word}",
    ]
    assert unfinished_blocks(tmp_path / "s.zarr")

"""Blocks of a sweep on many processes, by Dask: a running cluster or local processes.

A block is computed and written where it runs; only its number comes back, so that memory stays bounded and the
loss of a worker costs the blocks it was busy with, which others repeat.
"""

from __future__ import annotations

import os
import signal
import tempfile
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from multiprocessing import active_children, resource_tracker
from pathlib import Path
from typing import Any

import jax

from asperity.errors import InputError
from asperity.precision import use_double_precision
from asperity.study.datasets import require
from asperity.study.sweep.store import write_block
from asperity.study.sweep.store_layout import unfinished_blocks
from asperity.study.sweep.sweep_plan import Plan, block_results
from asperity.writing import interrupted_afterwards

#: Blocks handed out ahead of each worker, so that none waits.
_AHEAD = 2
#: Freed memory that a worker keeps, and the size of an array above which it requests memory from the system [bytes].
#: Dask's own setting returns all memory after every block, and requesting it again is a quarter of the work.
_ALLOCATOR = {"MALLOC_TRIM_THRESHOLD_": str(1 << 28), "MALLOC_MMAP_THRESHOLD_": str(1 << 25)}
#: Threads of each worker: there is one worker per core.
_ONE_THREAD = "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"
_PRE_SPAWN = "distributed.nanny.pre-spawn-environ"
_CONNECT_SECONDS = "10s"
_BETWEEN_KILLS = 0.02  # s, of workers that Dask starts again


def compute_block(path: str, plan: Plan, index: int) -> int:
    """Compute one block and write it; what a worker runs."""
    use_double_precision()  # the flag does not travel to workers
    status, result_values = block_results(plan, plan.block(index), in_all=plan.points, threads=1)
    write_block(path, plan, index, status, result_values)
    return index


def run_on_cluster(
    plan: Plan,
    store: str | Path,
    blocks: list[int],
    *,
    scheduler: str | None,
    workers: int | None,
    finished: Callable[[int], Any],
) -> None:
    """Compute blocks of a sweep on a cluster."""
    if not blocks:
        return
    path = str(Path(store).absolute())
    with _client(scheduler, workers) as client:
        distributed = require("distributed")
        waiting = iter(blocks)
        threads = max(sum(client.nthreads().values()), 1)

        def submit(index: int) -> Any:
            return client.submit(compute_block, path, plan, index, pure=False, key=f"{path}-{index}")

        ahead = [submit(index) for _, index in zip(range(_AHEAD * threads), waiting, strict=False)]
        running = distributed.as_completed(ahead)
        first = True
        for future in running:
            index = future.result()
            if first and index in unfinished_blocks(path):
                raise InputError(
                    f"the workers of {scheduler} do not write to this machine's folder {path}; "
                    "choose a folder on a file system that they share",
                    options=["out"],
                )
            first = False
            finished(index)
            following = next(waiting, None)
            if following is not None:
                running.add(submit(following))


@contextmanager
def _client(scheduler: str | None, workers: int | None) -> Iterator[Any]:
    """A client of a running scheduler, or of local processes that end with it."""
    distributed, dask = require("distributed"), require("dask")
    if scheduler is not None:
        try:
            # a client that fails to connect would stay Dask's default for whatever this process does next
            distributed.Client(scheduler, timeout=_CONNECT_SECONDS, set_as_default=False).close()
            client = distributed.Client(scheduler, timeout=_CONNECT_SECONDS)
        except (OSError, ValueError, TypeError) as error:
            raise InputError(f"no Dask scheduler answers at {scheduler}: {error}") from None
        with client:
            yield client
        return
    count = workers or os.cpu_count() or 1
    # an allocator looks at its environment only as a process starts; Dask sets this one in our own process too
    before_start = {**dask.config.get(_PRE_SPAWN), **_ALLOCATOR}
    with ExitStack() as opened:
        # Dask does not delete its own folder, and a worker that is killed none of its files
        folder = tempfile.TemporaryDirectory(prefix="asperity-sweep-", ignore_cleanup_errors=True)
        settings = {
            "distributed.worker.multiprocessing-method": "spawn",
            _PRE_SPAWN: before_start,
            "temporary-directory": opened.enter_context(folder),
        }
        opened.enter_context(dask.config.set(settings))
        resource_tracker.ensure_running()  # which lets the signals through again where it starts
        with interrupted_afterwards(opened.enter_context(_killed_as_they_start())):
            cluster = opened.enter_context(_local_cluster(distributed, count))
            client = opened.enter_context(distributed.Client(cluster))
        try:
            yield client
        except BaseException:
            nannies = cluster.workers.values()
            for nanny in nannies:
                nanny.auto_restart = False
            _kill(nanny.pid for nanny in nannies)
            raise


@contextmanager
def _killed_as_they_start() -> Iterator[Callable[[], None]]:
    """What ends, once it is called, every process that has been started in the block, and is started from then on."""
    others, over = set(active_children()), threading.Event()

    def kill() -> None:
        while not over.wait(_BETWEEN_KILLS):
            _kill(child.pid for child in set(active_children()) - others)

    try:
        yield lambda: threading.Thread(target=kill, daemon=True).start()
    finally:
        over.set()


def _kill(workers: Iterable[int | None]) -> None:
    """End processes at once, None for one that has ended; Dask waits for seconds for what they do."""
    for worker in workers:
        if worker is not None:
            with suppress(ProcessLookupError):
                os.kill(worker, getattr(signal, "SIGKILL", signal.SIGTERM))


def _local_cluster(distributed: Any, count: int) -> Any:
    """Spawned workers."""
    return distributed.LocalCluster(
        n_workers=count,
        threads_per_worker=1,
        processes=True,
        dashboard_address=None,
        # without an address of its own the scheduler's web server would take port 8787
        scheduler_kwargs={"dashboard_address": "127.0.0.1:0", "dashboard": False},
        env=worker_environment(),
        silence_logs="CRITICAL",  # a worker that ends may miss a heartbeat; failures of blocks come as exceptions
        memory_limit=0,
    )


def worker_environment() -> dict[str, str]:
    """Environment of a local worker: double precision, one thread, this process's compilation cache."""
    environment = {
        "JAX_ENABLE_X64": "1",
        "OMP_NUM_THREADS": "1",
        **_ALLOCATOR,
        "DASK_DISTRIBUTED__WORKER__PROFILE__ENABLED": "False",  # it looks at every thread a hundred times a second
        "XLA_FLAGS": " ".join(filter(None, (os.environ.get("XLA_FLAGS"), _ONE_THREAD))),
    }
    cache = getattr(jax.config, "jax_compilation_cache_dir", None)
    if cache:
        environment["JAX_COMPILATION_CACHE_DIR"] = str(cache)
        environment["JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS"] = "0"
        environment["JAX_PERSISTENT_CACHE_MIN_ENTRY_SIZE_BYTES"] = "-1"
    return environment

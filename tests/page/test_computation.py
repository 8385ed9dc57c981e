"""One worker, a short queue, a limited memory."""

import asyncio
import threading

import pytest

from asperity.page.computation import (
    MOST_KEPT,
    MOST_WAITING,
    BusyError,
    Computations,
    KeptAnswers,
)


@pytest.fixture
def computations():
    found = Computations(longest=30.0)
    yield found
    found.close()


def test_computations_share_one_thread(computations):
    futures = [computations.submit(threading.get_ident) for _ in range(MOST_WAITING)]
    names = {future.result() for future in futures}
    assert len(names) == 1
    assert names != {threading.get_ident()}


def test_several_threads_run_side_by_side():
    computations = Computations(longest=30.0, threads=2)
    together = threading.Barrier(2)
    futures = [computations.submit(together.wait, 30.0) for _ in range(2)]
    assert sorted(future.result() for future in futures) == [0, 1]
    computations.close()


def test_a_full_queue_refuses_and_recovers(computations):
    hold = threading.Event()
    futures = [computations.submit(hold.wait) for _ in range(MOST_WAITING)]
    with pytest.raises(BusyError, match="8 computations are waiting"):
        computations.submit(hold.wait)
    hold.set()
    for future in futures:
        future.result()
    assert computations.submit(lambda: 7).result() == 7


def test_an_answer_that_takes_too_long_is_given_up():
    hold = threading.Event()
    computations = Computations(longest=0.05)
    with pytest.raises(BusyError, match=r"no answer within 0.05 s"):
        asyncio.run(computations.run(hold.wait))
    hold.set()
    computations.close()


def test_errors_come_through(computations):
    def fail():
        raise ValueError("because")

    with pytest.raises(ValueError, match="because"):
        asyncio.run(computations.run(fail))


def test_the_oldest_answers_are_forgotten():
    kept = KeptAnswers()
    for number in range(MOST_KEPT + 1):
        kept.keep(str(number), number)
    assert kept.get("0") is None
    assert kept.get("1") == 1
    assert kept.get(str(MOST_KEPT)) == MOST_KEPT

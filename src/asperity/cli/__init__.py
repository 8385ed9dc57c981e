"""The command line: parse, call, show; no physics."""

from __future__ import annotations

import atexit
import contextlib
import gc
import os
import signal
import sys
import threading
import time
from types import FrameType
from typing import NoReturn

#: Objects that are made before Python looks for garbage. Imports and tracing make many objects and hardly any garbage;
#: with Python's own 700, looking through them takes a fifth of the time of a short command.
_OBJECTS_BETWEEN_COLLECTIONS = 100_000
#: Time after which an interruption that has not arrived is raised again, and after which a second one ends at once [s].
_AGAIN, _AT_ONCE = 0.05, 1.0
#: Time for which an interruption may wait for the end of what Python itself cannot interrupt [s].
_LONGEST_STEP = 0.3


class Terminated(KeyboardInterrupt):
    """The system asks the process to end (SIGTERM)."""


#: Signal → what is said of it, and the exit code.
_LINES: dict[int, tuple[str, int]] = {
    signal.SIGINT: ("interrupted", 130),
    signal.SIGTERM: ("terminated", 143),
}


class Interruptions:
    """What the signals SIGINT and SIGTERM do while a command runs: a ``KeyboardInterrupt``, where it can arrive.

    Python raises it between any two steps. An extension module that is being imported may end the process upon it; in
    a callback of C code, as of the garbage collection or of a hash, it is lost. It therefore waits for such imports and
    is raised again until it arrives: until it is what is handled. ``said`` becomes the line and the exit code.

    Nor can Python raise it while one step takes long, such as a transform of NumPy. A thread that the system wakes then
    ends the process in its stead, and leaves nothing half done behind.
    """

    def __init__(self) -> None:
        self.said: tuple[str, int] | None = None
        self._over, self._since, self._unraisable = False, 0.0, sys.unraisablehook
        self._wakes: int | None = None  # where the system writes the numbers of signals
        self._first = (
            threading.Lock()
        )  # whoever has it ends the process: the handler of the signal or the thread

    def __enter__(self) -> Interruptions:
        sys.unraisablehook = self._dropped
        if threading.current_thread() is threading.main_thread():
            signal.signal(signal.SIGTERM, self._asked)
            if signal.getsignal(signal.SIGINT) is signal.default_int_handler:  # else it is ignored
                signal.signal(signal.SIGINT, self._asked)
            if os.name == "posix":
                woken, self._wakes = os.pipe()
                os.set_blocking(self._wakes, False)
                signal.set_wakeup_fd(self._wakes, warn_on_full_buffer=False)
                threading.Thread(target=self._watch, args=(woken,), daemon=True).start()
        return self

    def __exit__(self, _kind: object, error: BaseException | None, _trace: object) -> bool:
        self._over = True
        if self.said and hasattr(signal, "setitimer"):
            signal.setitimer(signal.ITIMER_REAL, 0.0)
        sys.unraisablehook = self._unraisable
        if self._wakes is not None:
            signal.set_wakeup_fd(-1)
            os.close(self._wakes)  # which ends the thread
        if error is None:  # it has ended in time
            self.said = None
        elif isinstance(error, KeyboardInterrupt):
            self.said = _LINES[signal.SIGTERM if isinstance(error, Terminated) else signal.SIGINT]
        return self.said is not None

    def leave(self, code: int) -> NoReturn:
        """End the process now, once what it has said is out: Python's own end waits for XLA, and takes it to pieces.

        What is still being compiled would hold the prompt for minutes, and XLA does not always survive to be taken to
        pieces in the middle of its work. Another signal, where the output is not taken, ends it at once.
        """
        self._over = True
        for stream in (sys.stdout, sys.stderr):
            with contextlib.suppress(OSError, ValueError, AttributeError):  # it is closed, or there is none
                stream.flush()
        os._exit(code)

    def _asked(self, number: int, frame: FrameType | None) -> None:
        line = _LINES[number]
        if self._over or (self.said and time.monotonic() > self._since + _AT_ONCE):
            os._exit(line[1])
        if self.said is None:
            if not self._first.acquire(blocking=False):
                time.sleep(_AT_ONCE)  # the thread is ending the process
                os._exit(line[1])
            self.said, self._since = line, time.monotonic()
            if hasattr(signal, "setitimer"):
                signal.signal(signal.SIGALRM, self._raise)
                signal.setitimer(signal.ITIMER_REAL, _AGAIN, _AGAIN)
        self._raise(number, frame)

    def _watch(self, woken: int) -> None:
        """End the process upon a signal that waits too long for its handler, where this is ours."""
        while read := os.read(woken, 1):
            number = read[0]
            if number not in (signal.SIGINT, signal.SIGTERM):
                continue
            time.sleep(_LONGEST_STEP)
            ours = signal.getsignal(number) == self._asked and not self._over
            if ours and self._first.acquire(blocking=False):
                if "asperity.writing" in sys.modules:
                    from asperity.writing import abandon

                    abandon()
                self.end(_LINES[number])
        os.close(woken)

    def end(self, line: tuple[str, int]) -> NoReturn:
        """Say the line, and end the process now with the exit code."""
        with contextlib.suppress(OSError):
            print(f"asperity: {line[0]}", file=sys.stderr, flush=True)
        self.leave(line[1])

    def _raise(self, _number: int, frame: FrameType | None) -> None:
        arrives = self._over or isinstance(sys.exc_info()[1], KeyboardInterrupt)
        if not arrives and not _extends(frame):
            raise Terminated if self.said == _LINES[signal.SIGTERM] else KeyboardInterrupt

    def _dropped(self, unraisable: sys.UnraisableHookArgs) -> None:
        if not isinstance(unraisable.exc_value, KeyboardInterrupt):
            self._unraisable(unraisable)


def _extends(frame: FrameType | None) -> bool:
    """Whether an extension module is being imported."""
    while frame is not None and not frame.f_code.co_qualname.startswith("ExtensionFileLoader."):
        frame = frame.f_back
    return frame is not None


def main() -> None:
    """Entry point of the ``asperity`` command."""
    gc.set_threshold(_OBJECTS_BETWEEN_COLLECTIONS)
    code = 0
    with Interruptions() as interruptions:
        atexit.register(gc.freeze)  # a process that ends need not look through its objects once more
        from asperity.cli.commands import run

        code = run()
    if interruptions.said is not None:
        interruptions.end(interruptions.said)
    sys.exit(code)

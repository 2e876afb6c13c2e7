"""Prints messages on standard error from another thread.

If standard error is a pipe without a reader, a write may never return, and a robot's loop cannot wait for that.
"""

from __future__ import annotations

import atexit
import queue
import sys
import threading
import time

_MAX_WAITING = 200
_EXIT_SECONDS = 0.25

_waiting: queue.Queue[str] = queue.Queue(_MAX_WAITING)
_lock = threading.Lock()
_is_started = False


def print_soon(message: str) -> None:
    """Writes the message soon, marked as badlog's. Messages that arrive while too many are waiting are dropped. Never
    raises.
    """
    global _is_started
    try:
        _waiting.put_nowait(message)
    except queue.Full:
        return
    with _lock:
        if _is_started:
            return
        try:
            threading.Thread(target=_print_all, name="badlog messages", daemon=True).start()
            _is_started = True
            # If the fault ends the program, the message must still be printed.
            atexit.register(await_printed, _EXIT_SECONDS)
        except RuntimeError:
            # The system has no thread for this, or the program is ending; the next message tries again.
            return


def await_printed(seconds: float) -> bool:
    """Waits until all messages are written, but no longer than that; returns whether they are."""
    end = time.monotonic() + seconds
    while _waiting.unfinished_tasks > 0:
        if time.monotonic() > end:
            return False
        time.sleep(0.001)
    return True


def _print_all() -> None:
    while True:
        message = _waiting.get()
        try:
            print(f"badlog: {message}", file=sys.stderr, flush=True)
        except Exception:
            # A program may have replaced the stream, or removed it.
            pass
        finally:
            _waiting.task_done()

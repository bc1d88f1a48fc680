"""The waits of the calls of the blocking client."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, Optional, TypeVar

from sbgc import _core
from sbgc.link import STOP, Link, SpeedControl, out_of_time, seconds_of

T = TypeVar("T")

# The duration of a wait before the interpreter may handle signals.
_SLICE = 0.05


class Waiting(Link):
    def wait_until_connected(self, *, timeout: float = 60.0) -> None:
        """Wait until the board is connected again; see the argument `reconnect` of connect()."""
        until = time.monotonic() + seconds_of(timeout)
        while not self.is_connected:
            self._link.require()  # raises if it is closed
            if time.monotonic() > until:
                raise out_of_time(timeout)
            time.sleep(_SLICE)
        self._log()

    def close(self) -> None:
        """Stop a camera that a call is moving, end all calls, and close the line."""
        self._is_closed = True
        self._link.close(STOP)
        self._log()

    def _wait(
        self,
        ask: Callable[[float], Optional[T]],
        timeout: Optional[float],
        problem: Callable[[float], Exception] = out_of_time,
    ) -> T:
        """Poll, waiting for this many seconds each time, until the answer is true."""
        seconds = seconds_of(timeout)
        until = self._link.now() + seconds
        while not (found := ask(_SLICE)):
            if self._link.now() > until:
                raise problem(seconds)
        return found

    def _end(self, operation: _core.Operation[Any]) -> None:
        """Cancel an operation, and wait until it is over."""
        operation.cancel()
        if operation.is_running():
            operation.wait(STOP)

    def _pause(self, seconds: float) -> None:
        self._link.pause(seconds)

    def _require_loop(self) -> None:
        """An asynchronous client belongs to a loop."""


class SpeedBlock:
    """The block of a SpeedControl, at whose end the camera stops."""

    def __init__(self, gimbal: Waiting, silence: float) -> None:
        self._held = _core.HeldSpeed(gimbal._link, silence)
        self._control = SpeedControl(self._held)
        # Not a Python function, before which Ctrl-C could end the block.
        self._exit = self._held.exit

    def __enter__(self) -> SpeedControl:
        return self._control

    @property
    def __exit__(self) -> Callable[..., None]:
        return self._exit

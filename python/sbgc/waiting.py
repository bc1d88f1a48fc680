"""How the calls of the blocking client wait."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, Optional, TypeVar

from sbgc import _core
from sbgc.link import STOP, Link, out_of_time, seconds_of

T = TypeVar("T")

# How long a wait lasts before the interpreter may handle signals.
_SLICE = 0.05


class Waiting(Link):
    def wait_until_connected(self, *, timeout: float = 60.0) -> None:
        """Wait until the board is connected again; see the argument `reconnect` of connect()."""
        until = time.monotonic() + seconds_of(timeout)
        while not self.is_connected:
            if time.monotonic() > until:
                raise out_of_time(timeout)
            time.sleep(_SLICE)

    def _wait(
        self,
        ask: Callable[[float], Optional[T]],
        timeout: Optional[float],
        problem: Callable[[Optional[float]], Exception] = out_of_time,
    ) -> T:
        """Ask, for so many seconds each time, until the answer is true."""
        until = self._link.now() + seconds_of(timeout)
        while not (found := ask(_SLICE)):
            if self._link.now() > until:
                raise problem(timeout)
        return found

    def _let_stop(self, operation: _core.Operation[Any]) -> None:
        operation.wait(STOP)

"""`sbgc gateway`: a terminal that closes."""

from __future__ import annotations

import signal
import time

from gateway import running_gateway
from safety_test import Stage, stage_, start_turning  # noqa: F401


def test_signals_do_not_keep_it_from_stopping(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        start_turning(stage)
        for number in (signal.SIGHUP, signal.SIGHUP, signal.SIGTERM, signal.SIGHUP):
            gateway.process.send_signal(number)
            time.sleep(0.01)
        assert gateway.process.wait(60) == 0
        assert stage.stands()

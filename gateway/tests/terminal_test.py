"""`sbgc gateway`: a terminal that closes."""

from __future__ import annotations

import signal
import time

from gateway import eventually, running_gateway
from safety_test import Stage, stage_, start_turning  # noqa: F401


def test_signals_do_not_keep_it_from_stopping(stage: Stage) -> None:
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        start_turning(stage)
        for number in (signal.SIGHUP, signal.SIGHUP, signal.SIGTERM, signal.SIGHUP):
            gateway.process.send_signal(number)
            time.sleep(0.01)
        assert gateway.process.wait(60) == 0
        assert stage.stands()


def test_nohup_goes_on(stage: Stage) -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    with running_gateway(stage.folder, stage.fleet()) as gateway:
        signal.signal(signal.SIGHUP, before)
        eventually(stage.online)
        gateway.process.send_signal(signal.SIGHUP)
        time.sleep(0.5)
        assert gateway.process.poll() is None
        assert gateway.end() == 0

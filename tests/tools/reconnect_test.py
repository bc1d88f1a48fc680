"""Tests of commands whose line vanishes and comes back."""

from __future__ import annotations

import json
import signal
from pathlib import Path

import pytest

from emulated_gimbal import emulated_gimbal
from sbgc_command import Running, two_free_ports


def ports_file(path: Path, *ports: tuple[str, str]) -> Path:
    """Writes a list of ports for SBGC_PORTS: names and the serial numbers of their adapters."""
    usb = {"vendor_id": 0x10C4, "product_id": 0xEA60, "manufacturer": "", "product": "adapter"}
    listed = [
        {"name": name, "description": "", "usb": {**usb, "serial_number": number}}
        for name, number in ports
    ]
    document = {"format": "sbgc-ports", "version": 1, "ports": listed}
    path.write_text(json.dumps(document), encoding="utf-8")
    return path


class Streaming(Running):
    """A running `sbgc stream` that prints JSON lines."""

    def __init__(self, address: str) -> None:
        options = ("--rate", "20", "--format", "jsonl", "--fields", "angle.*")
        super().__init__("stream", "RealtimeData4", *options, "-p", address)

    def read(self, count: int = 3) -> None:
        for _ in range(count):
            assert json.loads(self.line())["fields"]

    def finish(self) -> None:
        self.send_signal(signal.SIGINT)
        self.communicate(timeout=20)
        assert self.returncode == 0


def test_a_gimbal_that_is_killed_and_started_again() -> None:
    with emulated_gimbal() as gimbal:
        streaming = Streaming(gimbal.address)
        streaming.read()
        gimbal.kill()
        streaming.wait_for("connecting again")
        port = gimbal.address.rsplit(":", 1)[1]
        with emulated_gimbal("--tcp", port):
            streaming.wait_for("connected again")
            streaming.read()
            streaming.finish()


def test_a_gimbal_without_power_for_a_moment(tmp_path: Path) -> None:
    # The pseudo-terminal of a link has another name, as an adapter that is plugged in again.
    link = tmp_path / "gimbal"
    with emulated_gimbal("--pty", "--link", str(link)) as gimbal:
        streaming = Streaming(str(link))
        streaming.read()
        gimbal.kill()
        link.unlink()  # otherwise it may name the terminal of another program, and stays
        streaming.wait_for("connecting again")
        with emulated_gimbal("--pty", "--link", str(link)):
            streaming.wait_for("connected again")
            streaming.read()
            streaming.finish()


def test_an_adapter_under_another_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ports = tmp_path / "ports.json"
    monkeypatch.setenv("SBGC_PORTS", str(ports))
    with emulated_gimbal("--pty") as first, emulated_gimbal("--pty") as second:
        # Two terminals at once, so that their names differ.
        ports_file(ports, (first.address, "A"))
        streaming = Streaming(first.address)
        streaming.read()
        first.kill()
        streaming.wait_for("connecting again")
        ports_file(ports, ("/dev/pts/nothing", "B"), (second.address, "A"))
        streaming.wait_for(f"connected again: serial port {second.address}")
        streaming.read()
        streaming.finish()


def test_another_board_is_not_used() -> None:
    first = two_free_ports()
    with emulated_gimbal("--tcp", str(first + 1)) as gimbal:
        streaming = Streaming(gimbal.address)
        streaming.read()
        gimbal.kill()
        streaming.wait_for("connecting again")
        # The second of two boards has another serial number.
        with emulated_gimbal("--tcp", str(first), "--count", "2"):
            streaming.wait_for("found another board")
            streaming.finish()

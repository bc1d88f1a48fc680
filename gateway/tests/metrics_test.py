"""The metrics of `sbgc gateway`."""

from __future__ import annotations

import socket
import subprocess
import time
from contextlib import ExitStack
from pathlib import Path

from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gateway import eventually, running_gateway
from sbgc_command import run

HEAD = '[fleet]\nname = "test"\n[metrics]\nlisten = "LISTEN"\ninterval = "200ms"\n'


def section(name: str, gimbal: EmulatedGimbal, more: str = "") -> str:
    return f'[gimbal.{name}]\nport = "{gimbal.address}"\n{more}\n'


def test_metrics_of_gimbals(tmp_path: Path) -> None:
    """Values, counters and their names, also while one of two gimbals is lost and comes back."""
    telemetry = 'telemetry = ["RealtimeData4 20", "GetAngles 10"]'
    with emulated_gimbal() as front, emulated_gimbal() as back:
        port = back.address.rsplit(":", 1)[1]
        text = HEAD + section("front", front, telemetry) + section("back", back)
        with running_gateway(tmp_path, text) as gateway:
            eventually(lambda: gateway.is_up("front") and gateway.is_up("back"))
            for message in ("RealtimeData4", "GetAngles"):
                name = f'sbgc_telemetry_messages_total{{gimbal="front",message="{message}"}}'
                eventually(lambda: (gateway.metric(name) or 0) > 3)
            voltage = 'sbgc_bat_level_volts{gimbal="back"}'
            assert eventually(lambda: gateway.metric(voltage)) > 1
            power = 'sbgc_motor_power{gimbal="front",axis="yaw"}'
            eventually(lambda: gateway.metric(power) is not None)
            check = ["promtool", "check", "metrics"]
            checked = subprocess.run(
                check, input=gateway.metrics_text(), text=True, capture_output=True
            )
            # Its own names are the business of the library.
            complaints = [
                line for line in checked.stderr.splitlines() if not line.startswith("exposer_")
            ]
            assert complaints == []

            back.kill()
            eventually(lambda: not gateway.is_up("back"))
            values = gateway.metrics()
            assert voltage not in values and values['sbgc_connections_total{gimbal="back"}'] == 1
            answered = 'sbgc_response_time_seconds_count{gimbal="front"}'
            before = values[answered]
            eventually(lambda: (gateway.metric(answered) or 0) >= before + 5)
            with emulated_gimbal("--tcp", port):
                eventually(lambda: gateway.is_up("back"), 60)
                assert gateway.metric('sbgc_connections_total{gimbal="back"}') == 2
                # Counters go on where they were.
                frames = 'sbgc_received_frames_total{gimbal="back"}'
                assert (gateway.metric(frames) or 0) >= values[frames]
            assert gateway.end() == 0


def test_a_gimbal_that_comes_late(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal:
        port = gimbal.address.rsplit(":", 1)[1]
        text = HEAD + section("front", gimbal)
    with running_gateway(tmp_path, text) as gateway:
        eventually(lambda: "front is offline" in gateway.log.read_text())
        assert not gateway.is_up("front")
        with emulated_gimbal("--tcp", port):
            eventually(lambda: gateway.is_up("front"), 60)


def test_a_scrape_beside_those_that_say_nothing(tmp_path: Path) -> None:
    text = HEAD + '[gimbal.front]\nport = "tcp:127.0.0.1:1"\n'
    with running_gateway(tmp_path, text) as gateway, ExitStack() as stack:
        host, port = gateway.metrics_address.split("/")[2].split(":")
        lines = [
            stack.enter_context(socket.create_connection((host, int(port)))) for _ in range(100)
        ]
        for line in lines:
            line.settimeout(30)
        request = b"GET /metrics"
        for byte in request[:3]:
            for line in lines[:50]:
                line.send(bytes([byte]))
            begun = time.monotonic()
            assert "sbgc_gimbal_up" in gateway.metrics_text()
            assert time.monotonic() - begun < 2
            time.sleep(0.5)
        assert lines[-1].recv(1) == b""  # nobody keeps a place


def test_a_port_in_use(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal:
        with running_gateway(tmp_path, HEAD + section("front", gimbal)) as gateway:
            address = gateway.metrics_address.split("/")[2]
            other = tmp_path / "other.toml"
            other.write_text((HEAD + section("front", gimbal)).replace("LISTEN", address))
            result = run("gateway", "--config", str(other))
            assert result.status == 1 and f"cannot serve metrics at {address}" in result.error

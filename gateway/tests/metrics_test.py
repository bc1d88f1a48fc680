"""The metrics of `sbgc gateway`, and the sample alerts and dashboard, with the Prometheus of Debian."""

from __future__ import annotations

import json
import re
import socket
import subprocess
import time
import urllib.parse
import urllib.request
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gateway import eventually, running_gateway
from sbgc_command import free_port, run
from studio import fleet_of, gimbal_of, running_broker

HERE = Path(__file__).parent
SAMPLES = HERE.parent / "deploy"
HEAD = '[fleet]\nname = "test"\n[metrics]\nlisten = "LISTEN"\ninterval = "200ms"\n'


def section(name: str, gimbal: EmulatedGimbal, more: str = "") -> str:
    return f'[gimbal.{name}]\nport = "{gimbal.address}"\n{more}\n'


def test_metrics_of_gimbals(tmp_path: Path) -> None:
    """Values, counters and their names, also while one of two gimbals is lost and returns."""
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
            # The library's own names are not our concern.
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
                # Counters continue from their last values.
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


def promtool(*arguments: str) -> None:
    done = subprocess.run(["promtool", *arguments], capture_output=True, text=True, cwd=HERE)
    assert done.returncode == 0, done.stdout + done.stderr


def test_alerts_are_rules() -> None:
    promtool("check", "rules", str(SAMPLES / "alerts.yml"))


def test_alerts_fire() -> None:
    promtool("test", "rules", "alerts_test.yml")


class Prometheus:
    """It scrapes a target twice per second."""

    def __init__(self, folder: Path, target: str) -> None:
        configuration = {
            "global": {"scrape_interval": "500ms", "evaluation_interval": "500ms"},
            "rule_files": [str(SAMPLES / "alerts.yml")],
            "scrape_configs": [{"job_name": "sbgc", "static_configs": [{"targets": [target]}]}],
        }
        (folder / "prometheus.yml").write_text(json.dumps(configuration))
        self.address = f"127.0.0.1:{free_port()}"
        self.process = subprocess.Popen(
            [
                "prometheus",
                f"--config.file={folder}/prometheus.yml",
                f"--storage.tsdb.path={folder}/data",
                f"--web.listen-address={self.address}",
            ],
            stdout=subprocess.DEVNULL,
            stderr=(folder / "prometheus.log").open("wb"),
        )

    def get(self, path: str, **parameters: str) -> Any:
        url = f"http://{self.address}{path}?{urllib.parse.urlencode(parameters)}"
        with urllib.request.urlopen(url, timeout=20) as answer:
            return json.load(answer)["data"]

    def query(self, expression: str) -> list[Any]:
        found: list[Any] = self.get("/api/v1/query", query=expression)["result"]
        return found

    def is_ready(self) -> bool:
        try:
            return bool(self.query("sbgc_gimbal_up == 1"))
        except OSError:
            return False


@contextmanager
def running_prometheus(folder: Path, target: str) -> Iterator[Prometheus]:
    prometheus = Prometheus(folder, target)
    try:
        yield prometheus
    finally:
        prometheus.process.terminate()
        prometheus.process.wait()


def dashboard_queries() -> dict[str, str]:
    dashboard = json.loads((SAMPLES / "dashboard.json").read_text())
    return {
        panel["title"]: target["expr"].replace("$__rate_interval", "5s")
        for panel in dashboard["panels"]
        for target in panel["targets"]
    }


def test_every_query_has_an_answer(tmp_path: Path) -> None:
    """With a gimbal that reports an error, and one that is not there, no panel is empty."""
    fault = ("--fault", "imu,low-battery=10V")
    with running_broker(tmp_path) as broker, emulated_gimbal(*fault) as front:
        gone = gimbal_of("tcp:127.0.0.1:1", name="gone")
        there = gimbal_of(front.address, "", 'telemetry = "RealtimeData4 20"')
        text = fleet_of(f'"127.0.0.1:{broker.port}"', there, gone)
        text += '[metrics]\nlisten = "LISTEN"\ninterval = "500ms"\n'
        with running_gateway(tmp_path, text) as gateway:
            target = gateway.metrics_address.split("/")[2]
            with running_prometheus(tmp_path, target) as prometheus:
                eventually(prometheus.is_ready, 60)
                for title, query in dashboard_queries().items():
                    eventually(lambda: prometheus.query(query), 60)
                active = prometheus.get("/api/v1/rules")["groups"][0]["rules"]
                assert all(rule["health"] != "err" for rule in active)
                # The metrics in the alerts exist, even if they are not firing now.
                names = re.findall(r"sbgc_\w+", (SAMPLES / "alerts.yml").read_text())
                assert names
                for name in set(names):
                    eventually(lambda: prometheus.query(name), 60)

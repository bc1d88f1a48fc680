"""The sample alerts and dashboard, with the Prometheus of Debian."""

from __future__ import annotations

import json
import re
import subprocess
import urllib.parse
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from brokers import free_port
from emulated_gimbal import emulated_gimbal
from gateway import eventually, running_gateway
from studio import fleet_of, gimbal_of, running_broker

HERE = Path(__file__).parent
SAMPLES = HERE.parent / "deploy"


def promtool(*arguments: str) -> None:
    done = subprocess.run(["promtool", *arguments], capture_output=True, text=True, cwd=HERE)
    assert done.returncode == 0, done.stdout + done.stderr


def test_alerts_are_rules() -> None:
    promtool("check", "rules", str(SAMPLES / "alerts.yml"))


def test_alerts_fire() -> None:
    promtool("test", "rules", "alerts_test.yml")


class Prometheus:
    """It scrapes a target twice a second."""

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
                # What the alerts ask for exists, even if it is not the case now.
                names = re.findall(r"sbgc_\w+", (SAMPLES / "alerts.yml").read_text())
                assert names
                for name in set(names):
                    eventually(lambda: prometheus.query(name), 60)

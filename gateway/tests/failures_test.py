"""Tests of `sbgc gateway` when a disk is full, and when a broker refuses messages."""

from __future__ import annotations

import resource
import signal
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest

from broker_test import speed_of
from brokers import Commander, Mosquitto, Subscriber
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gateway import Gateway, eventually, running_gateway

HEAD = """[fleet]
name = "studio"
[broker]
address = "127.0.0.1:{port}"
journal = "fleet.db"
{broker}
"""
GIMBAL = """[gimbal.{name}]
port = "{address}"
allow = ["move", "motors", "get", "set", "home"]
{more}
"""
# Mosquitto takes the name of a user without a password.
EVERYTHING = "user tester\ntopic readwrite sbgc/#\nuser gateway\n"


@contextmanager
def broker_with_acl(folder: Path, acl: str, more: str = "") -> Iterator[Mosquitto]:
    (folder / "acl").write_text(EVERYTHING + acl)
    (folder / "acl").chmod(0o600)
    broker = Mosquitto(folder / "broker", f"allow_anonymous true\nacl_file {folder}/acl\n{more}")
    broker.start()
    try:
        yield broker
    finally:
        broker.kill()


def text(broker: Mosquitto, gimbal: EmulatedGimbal, settings: str = "") -> str:
    head = HEAD.format(port=broker.port, broker=settings)
    return head + GIMBAL.format(name="front", address=gimbal.address, more="")


def wait_until_online(seen: Subscriber) -> None:
    topic = "sbgc/studio/front/state"
    eventually(lambda: any('"online"' in one.text for one in seen.on(topic)))


def fill_disk(gateway: Gateway, folder: Path) -> None:
    """From now on, the gateway cannot extend its journal."""
    size = (folder / "fleet.db-wal").stat().st_size
    resource.prlimit(gateway.process.pid, resource.RLIMIT_FSIZE, (size, size))


def test_metrics_go_on_when_the_disk_is_full(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The limit of a file would otherwise end the process.
    monkeypatch.setattr("gateway.Gateway.keeps_signals", True)
    with broker_with_acl(tmp_path, "topic readwrite sbgc/#\n") as broker:
        seen = Subscriber(broker.port, "sbgc/#", "-u", "tester")
        say = Commander(broker.port, "studio", "-u", "tester")
        with emulated_gimbal() as front:
            fleet = text(broker, front, 'user = "gateway"') + '[metrics]\nlisten = "LISTEN"\n'
            with running_gateway(tmp_path, fleet) as gateway:
                wait_until_online(seen)
                assert seen.result(say.command("front", "motors", {"on": True}))["status"] == "done"
                assert gateway.metric("sbgc_broker_failed") == 0
                far = {"angles": {"pitch": -80}, "speed": 2, "timeout": 100}
                say.command("front", "move", far)
                eventually(lambda: speed_of(front) > 0)
                fill_disk(gateway, tmp_path)
                say.command("front", "get", {"names": ["pitch.p"]})
                eventually(lambda: gateway.metric("sbgc_broker_failed") == 1)
                assert gateway.metric("sbgc_broker_up") == 0 and gateway.is_up("front")
                eventually(lambda: speed_of(front) == 0)
                # The last will.
                states = "sbgc/studio/gateway/state"
                eventually(lambda: '"offline"' in seen.on(states)[-1].text)
                assert "nothing goes to the broker" in gateway.log.read_text()
                assert gateway.process.poll() is None
                assert gateway.end() == 1
        seen.close()


def test_without_metrics_it_ends_when_the_disk_is_full(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("gateway.Gateway.keeps_signals", True)
    with broker_with_acl(
        tmp_path, "topic readwrite sbgc/#\n"
    ) as broker, emulated_gimbal() as front:
        seen = Subscriber(broker.port, "sbgc/#", "-u", "tester")
        with running_gateway(tmp_path, text(broker, front, 'user = "gateway"')) as gateway:
            wait_until_online(seen)
            fill_disk(gateway, tmp_path)
            say = Commander(broker.port, "studio", "-u", "tester")
            say.command("front", "get", {"names": ["pitch.p"]})
            assert gateway.process.wait(timeout=60) == 1
        seen.close()


def test_a_result_that_the_broker_refuses_is_kept(tmp_path: Path) -> None:
    without_replies = "topic readwrite sbgc/studio/gateway/#\ntopic readwrite sbgc/studio/front/#\n"
    with broker_with_acl(tmp_path, without_replies) as broker, emulated_gimbal() as front:
        seen = Subscriber(broker.port, "sbgc/#", "-u", "tester")
        say = Commander(broker.port, "studio", "-u", "tester")
        with running_gateway(
            tmp_path, text(broker, front, 'user = "gateway"\nmqtt = "5"')
        ) as gateway:
            wait_until_online(seen)
            key = say.command("front", "get", {"names": ["pitch.p"]})
            said = "the broker refuses messages to sbgc/studio/reply/test: Not authorized"
            eventually(lambda: said in gateway.log.read_text())
            assert not seen.results()
            second = say.command("front", "get", {"names": ["pitch.i"]})
            with (tmp_path / "acl").open("a") as acl:
                acl.write("topic write sbgc/studio/reply/#\n")
            broker.signal(signal.SIGHUP)
            assert seen.result(key)["status"] == "done"
            assert seen.result(second)["status"] == "done"
            assert gateway.log.read_text().count("refuses messages") == 1
        seen.close()


def test_a_result_that_is_too_large_is_shortened(tmp_path: Path) -> None:
    with broker_with_acl(
        tmp_path, "topic readwrite sbgc/#\n", "max_packet_size 2000\n"
    ) as broker, emulated_gimbal() as front:
        seen = Subscriber(broker.port, "sbgc/#", "-u", "tester")
        say = Commander(broker.port, "studio", "-u", "tester")
        with running_gateway(tmp_path, text(broker, front, 'user = "gateway"\nmqtt = "5"')):
            wait_until_online(seen)
            names = [f"{axis}.{name}" for axis in ("roll", "pitch", "yaw") for name in "pid"]
            key = say.command("front", "get", {"names": names * 8})
            result = seen.result(key)
            assert result["status"] == "done" and result["shortened"] is True, result
            assert "result" not in result
        seen.close()


def test_a_fence_that_does_not_come_back_is_reported(tmp_path: Path) -> None:
    acl = "topic deny sbgc/studio/gateway/cmd/fence\ntopic readwrite sbgc/#\n"
    with broker_with_acl(tmp_path, acl) as broker, emulated_gimbal() as front:
        seen = Subscriber(broker.port, "sbgc/#", "-u", "tester")
        say = Commander(broker.port, "studio", "-u", "tester")
        with running_gateway(tmp_path, text(broker, front, 'user = "gateway"')) as gateway:
            wait_until_online(seen)
            topic = "sbgc/studio/gateway/cmd/fence"
            error = seen.result(say.command("front", "home"))["error"]
            assert (
                error["code"] == "queued"
                and f"not yet returned a message to {topic}" in error["message"]
            )
            eventually(
                lambda: f"not returned a message to {topic}"
                in " ".join(gateway.log.read_text().split())
            )
        seen.close()


def test_a_journal_that_is_gone_or_damaged(tmp_path: Path) -> None:
    with broker_with_acl(tmp_path, "topic readwrite sbgc/#\n") as broker:
        fleet = HEAD.format(port=broker.port, broker='user = "gateway"')
        fleet += GIMBAL.format(name="front", address="tcp:127.0.0.1:1", more="")
        with running_gateway(tmp_path, fleet) as gateway:
            eventually(lambda: "New client connected" in broker.log.read_text())
            assert gateway.end() == 0
            for change, row in (
                ("waiting VALUES (77, 1, 't', '{\"event', x'')", "row 77 of the table 'waiting'"),
                (
                    "commands VALUES (78, CAST(x'FF' AS TEXT), null, 'get {}', 0, null)",
                    "row 78 of the table 'commands'",
                ),
            ):
                with closing(sqlite3.connect(tmp_path / "fleet.db")) as journal, journal:
                    journal.execute(f"INSERT INTO {change}")
                gateway.restart()
                assert gateway.process.wait(timeout=60) == 1
                assert f"fleet.db is damaged: {row}" in gateway.log.read_text()
            (tmp_path / "fleet.db").unlink()
            broker.log.write_text("")
            gateway.restart()
            eventually(lambda: "New client connected" in broker.log.read_text())
            (tmp_path / "fleet.db").unlink()
            assert gateway.process.wait(timeout=60) == 1
            assert "fleet.db was removed or replaced" in gateway.log.read_text()


def most_memory(gateway: Gateway) -> int:
    """In MiB."""
    status = Path(f"/proc/{gateway.process.pid}/status").read_text()
    line = next(line for line in status.splitlines() if line.startswith("VmHWM"))
    return int(line.split()[1]) // 1024


@pytest.mark.long  # the peak depends on what the machine does meanwhile
def test_payloads_without_an_end(tmp_path: Path) -> None:
    """The gateway holds one message that is too long in memory, never several."""
    with broker_with_acl(
        tmp_path, "topic readwrite sbgc/#\n"
    ) as broker, emulated_gimbal() as front:
        seen = Subscriber(broker.port, "sbgc/studio/front/#", "-u", "tester")
        say = Commander(broker.port, "studio", "-u", "tester")
        with running_gateway(tmp_path, text(broker, front, 'user = "gateway"')) as gateway:
            wait_until_online(seen)
            before = most_memory(gateway)
            megabytes = 20
            count = 10
            gateway.process.send_signal(signal.SIGSTOP)
            for _ in range(count):
                say.publish("sbgc/studio/front/cmd/get", "x" * (megabytes << 20))
            gateway.process.send_signal(signal.SIGCONT)
            eventually(lambda: len(seen.events("front", "result")) == count, 60)
            # What arrives, and the copy that the library makes.
            assert most_memory(gateway) - before < 4 * megabytes
        seen.close()

"""Tests of `sbgc gateway` with a full disk, a broker that refuses messages, and another gateway."""

from __future__ import annotations

import resource
import signal
import sqlite3
from contextlib import AbstractContextManager, closing
from pathlib import Path

import pytest

from broker_test import speed_of
from brokers import Commander, Mosquitto, Subscriber, suspended
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from gateway import Gateway, eventually, running_gateway
from studio import Studio, fleet_of, gimbal_of, running_broker, running_studio

LISTENS = '[metrics]\nlisten = "LISTEN"\n'
PITCH = {"names": ["pitch.p"]}


def studio_with_acl(
    folder: Path,
    settings: str = "",
    *,
    acl: str = "topic readwrite sbgc/#\n",
    of_broker: str = "",
    more: str = "",
) -> AbstractContextManager[Studio]:
    # Mosquitto accepts a user name without a password.
    (folder / "acl").write_text("user tester\ntopic readwrite sbgc/#\nuser gateway\n" + acl)
    (folder / "acl").chmod(0o600)
    settings_of_broker = f"allow_anonymous true\nacl_file {folder}/acl\n{of_broker}"
    return running_studio(
        folder,
        f'user = "gateway"\n{settings}',
        of_broker=settings_of_broker,
        user=("-u", "tester"),
        more=more,
    )


def fill_disk(gateway: Gateway, folder: Path) -> None:
    """From now on, the gateway cannot extend its journal."""
    size = (folder / "fleet.db-wal").stat().st_size
    resource.prlimit(gateway.process.pid, resource.RLIMIT_FSIZE, (size, size))


def test_metrics_go_on_when_the_disk_is_full(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The file size limit would otherwise end the process.
    monkeypatch.setattr("gateway.Gateway.keeps_signals", True)
    with studio_with_acl(tmp_path, more=LISTENS) as studio:
        gateway, front, seen = studio.gateway, studio.front, studio.seen
        assert studio.result("motors", {"on": True})["status"] == "done"
        assert gateway.metric("sbgc_broker_failed") == 0
        studio.say.command("front", "move", {"angles": {"pitch": -80}, "speed": 2, "timeout": 100})
        eventually(lambda: speed_of(front) > 0)
        fill_disk(gateway, tmp_path)
        studio.say.command("front", "get", PITCH)
        eventually(lambda: gateway.metric("sbgc_broker_failed") == 1)
        assert gateway.metric("sbgc_broker_up") == 0 and gateway.is_up("front")
        eventually(lambda: speed_of(front) == 0)
        # The last will.
        states = "sbgc/studio/gateway/state"
        eventually(lambda: '"offline"' in seen.on(states)[-1].text)
        assert "nothing goes to the broker" in gateway.log.read_text()
        assert gateway.process.poll() is None
        assert gateway.end() == 1


def test_without_metrics_it_ends_when_the_disk_is_full(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("gateway.Gateway.keeps_signals", True)
    with studio_with_acl(tmp_path) as studio:
        fill_disk(studio.gateway, tmp_path)
        studio.say.command("front", "get", PITCH)
        assert studio.gateway.process.wait(timeout=60) == 1


def test_a_result_that_the_broker_refuses_is_kept(tmp_path: Path) -> None:
    acl = "topic readwrite sbgc/studio/gateway/#\ntopic readwrite sbgc/studio/front/#\n"
    with studio_with_acl(tmp_path, 'mqtt = "5"', acl=acl) as studio:
        log = studio.gateway.log
        keys = [studio.say.command("front", "get", PITCH)]
        said = "the broker refuses messages to sbgc/studio/reply/test: Not authorized"
        eventually(lambda: said in log.read_text())
        assert not studio.seen.results()
        keys.append(studio.say.command("front", "get", {"names": ["pitch.i"]}))
        with (tmp_path / "acl").open("a") as file:
            file.write("topic write sbgc/studio/reply/#\n")
        studio.broker.signal(signal.SIGHUP)
        for key in keys:
            assert studio.seen.result(key)["status"] == "done"
        assert log.read_text().count("refuses messages") == 1


def test_a_result_that_is_too_large_is_shortened(tmp_path: Path) -> None:
    with studio_with_acl(tmp_path, 'mqtt = "5"', of_broker="max_packet_size 2000\n") as studio:
        names = [f"{axis}.{name}" for axis in ("roll", "pitch", "yaw") for name in "pid"]
        result = studio.result("get", {"names": names * 8})
        assert result["status"] == "done" and result["shortened"] is True, result
        assert "result" not in result


def test_a_fence_that_does_not_come_back_is_reported(tmp_path: Path) -> None:
    topic = "sbgc/studio/gateway/cmd/fence"
    acl = f"topic deny {topic}\ntopic readwrite sbgc/#\n"
    with studio_with_acl(tmp_path, acl=acl) as studio:
        error = studio.result("home")["error"]
        assert error["code"] == "queued"
        assert f"not yet returned a message to {topic}" in error["message"]
        said = f"not returned a message to {topic}"
        eventually(lambda: said in " ".join(studio.gateway.log.read_text().split()))


def test_a_journal_that_is_gone_or_damaged(tmp_path: Path) -> None:
    with running_broker(tmp_path) as broker:
        fleet = fleet_of(f'"127.0.0.1:{broker.port}"', gimbal_of("tcp:127.0.0.1:1"))
        with running_gateway(tmp_path, fleet) as gateway:
            eventually(lambda: "New client connected" in broker.log.read_text())
            assert gateway.end() == 0
            command = "commands VALUES (78, CAST(x'FF' AS TEXT), null, 'get {}', 0, null)"
            for change, row in (
                ("waiting VALUES (77, 1, 't', '{\"event', x'')", "row 77 of the table 'waiting'"),
                (command, "row 78 of the table 'commands'"),
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
    """The peak memory in MiB."""
    status = Path(f"/proc/{gateway.process.pid}/status").read_text()
    line = next(line for line in status.splitlines() if line.startswith("VmHWM"))
    return int(line.split()[1]) // 1024


@pytest.mark.long  # the peak depends on what the machine does meanwhile
def test_payloads_without_an_end(tmp_path: Path) -> None:
    """The gateway holds at most one oversized message in memory."""
    with studio_with_acl(tmp_path) as studio:
        before = most_memory(studio.gateway)
        megabytes = 20
        count = 10
        with suspended(studio.gateway.process):
            for _ in range(count):
                studio.say.publish("sbgc/studio/front/cmd/get", "x" * (megabytes << 20))
        eventually(lambda: len(studio.seen.events("front", "result")) == count, 60)
        # The received message, and the copy of the library.
        assert most_memory(studio.gateway) - before < 4 * megabytes


def text_of(broker: Mosquitto, front: EmulatedGimbal, mqtt: str) -> str:
    address = f'"127.0.0.1:{broker.port}"'
    return fleet_of(address, gimbal_of(front.address, "raw"), settings=f'mqtt = "{mqtt}"')


def wait_for_answer(seen: Subscriber, say: Commander) -> None:
    """It is also a refusal that a gimbal is not online yet."""
    seen.result(say.command("front", "raw", {"message": "GetAnglesRequest"}))


@pytest.mark.parametrize("mqtt", ["3.1.1", "5"])
def test_the_later_one_gives_way(tmp_path: Path, mqtt: str) -> None:
    folders = [tmp_path / "first", tmp_path / "second"]
    for folder in folders:
        folder.mkdir()
    with (
        running_broker(tmp_path) as broker,
        closing(Subscriber(broker.port)) as seen,
        emulated_gimbal() as one,
        emulated_gimbal() as other,
        running_gateway(folders[0], text_of(broker, one, mqtt)) as first,
    ):
        say = Commander(broker.port)
        seen.wait_for()
        wait_for_answer(seen, say)
        with running_gateway(folders[1], text_of(broker, other, mqtt)) as second:
            assert second.process.wait(timeout=30) == 2
            assert "another gateway of this fleet" in second.log.read_text()
        wait_for_answer(seen, say)
        states = "sbgc/studio/gateway/state"
        eventually(lambda: '"online"' in seen.on(states)[-1].text)
        assert first.end() == 0


def test_a_gateway_is_no_rival_of_its_earlier_self(tmp_path: Path) -> None:
    with running_studio(tmp_path, 'mqtt = "3.1.1"') as studio:
        for _ in range(5):
            wait_for_answer(studio.seen, studio.say)
            studio.gateway.kill()
            studio.gateway.restart()
        wait_for_answer(studio.seen, studio.say)
        assert studio.gateway.end() == 0

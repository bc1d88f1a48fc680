"""Brokers, and programs that talk to them, for the tests of `sbgc gateway`."""

from __future__ import annotations

import json
import os
import shutil
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

from gateway import eventually
from sbgc_command import free_port


def program(name: str) -> str:
    """mosquitto and nats-server are in a folder that is only in root's path."""
    found = shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/usr/local/sbin")
    assert found is not None, f"{name} is missing"
    return found


def accepts(port: int) -> bool:
    with socket.socket() as probe:
        probe.settimeout(1)
        return probe.connect_ex(("127.0.0.1", port)) == 0


class Server:
    """A process that listens on a port."""

    def __init__(self, port: int, log: Path, *command: str) -> None:
        self.port = port
        self.log = log
        self.command = command
        self.process: Optional[subprocess.Popen[bytes]] = None

    def start(self) -> None:
        self.process = subprocess.Popen(
            self.command, stdout=self.log.open("ab"), stderr=subprocess.STDOUT
        )
        eventually(lambda: accepts(self.port))

    def signal(self, number: int) -> None:
        assert self.process is not None
        self.process.send_signal(number)

    def kill(self) -> None:
        if self.process is not None and self.process.poll() is None:
            self.process.kill()
            self.process.wait()


class Mosquitto(Server):
    def __init__(self, folder: Path, settings: str = "allow_anonymous true\n") -> None:
        folder.mkdir(exist_ok=True)
        port = free_port()
        file = folder / "mosquitto.conf"
        # Without the user line, a broker that root starts gives up its rights to the folder.
        file.write_text(
            f"listener {port} 127.0.0.1\n{settings}user root\npersistence true\n"
            f"persistence_location {folder}/\nlog_type all\n"
        )
        super().__init__(port, folder / "mosquitto.log", program("mosquitto"), "-c", str(file))


class Nats(Server):
    """One server of a cluster that speaks MQTT."""

    def __init__(self, folder: Path, number: int, routes: list[int]) -> None:
        folder.mkdir(exist_ok=True)
        port, self.own_port = free_port(), free_port()  # of MQTT and of NATS
        file = folder / "nats.conf"
        links = ", ".join(f'"nats://127.0.0.1:{one}"' for one in routes)
        file.write_text(
            f"server_name: n{number}\nlisten: 127.0.0.1:{self.own_port}\n"
            f'jetstream {{ store_dir: "{folder}" }}\nmqtt {{ listen: "127.0.0.1:{port}", ack_wait: "5s" }}\n'
            f"cluster {{ name: fleet, listen: 127.0.0.1:{routes[number]}, routes: [{links}] }}\n"
        )
        super().__init__(port, folder / "nats.log", program("nats-server"), "-c", str(file))


def client(name: str, port: int) -> list[str]:
    """The command of a program that talks to a broker."""
    return [name, "-h", "127.0.0.1", "-p", str(port), "-q", "1"]


@dataclass(frozen=True)
class Message:
    topic: str
    is_retained: bool
    text: str

    @property
    def json(self) -> Any:
        return json.loads(self.text)


class Subscriber:
    """Collects published messages. The constructor returns when the broker has subscribed it."""

    def __init__(self, port: int, filters: str | list[str] = "sbgc/#", *options: str) -> None:
        topics = [filters] if isinstance(filters, str) else filters
        form = ("-d", "-F", "\x01%t\t%r\t%p")
        self.process = subprocess.Popen(
            ["stdbuf", "-oL", *client("mosquitto_sub", port), *form, *options]
            + [word for topic in topics for word in ("-t", topic)],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
        )
        self.messages: list[Message] = []
        self.subscribed = threading.Event()
        threading.Thread(target=self._read, daemon=True).start()
        assert self.subscribed.wait(60), "not subscribed"

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            if line.startswith("\x01"):
                topic, retained, text = line[1:].rstrip("\n").split("\t", 2)
                self.messages.append(Message(topic, retained == "1", text))
            elif "SUBACK" in line:
                self.subscribed.set()

    def on(self, topic: str) -> list[Message]:
        return [one for one in list(self.messages) if one.topic == topic]

    def results(self) -> list[Any]:
        return [one.json for one in list(self.messages) if "/reply/" in one.topic]

    def result(self, key: str, seconds: float = 60) -> Any:
        """The first result of the command with this key."""
        return eventually(
            lambda: [one for one in self.results() if one.get("key") == key], seconds
        )[0]

    def events(self, gimbal: str, kind: str) -> list[Any]:
        found = [one.json for one in list(self.messages) if one.topic.endswith(f"/{gimbal}/event")]
        return [one for one in found if one["event"] == kind]

    def wait_for(self, gimbal: str = "front", state: str = "online") -> None:
        topic = f"sbgc/studio/{gimbal}/state"
        eventually(lambda: any(one.json["state"] == state for one in self.on(topic)))

    def close(self) -> None:
        self.process.kill()
        self.process.wait()


def now() -> int:
    return int(time.time() * 1000)


class Commander:
    """Publishes commands."""

    def __init__(self, port: int, fleet: str = "studio", *options: str) -> None:
        self.base = [*client("mosquitto_pub", port), *options]
        self.fleet = fleet
        self.count = 0

    def publish(self, topic: str, text: str, *options: str, check: bool = True) -> int:
        source = "-s" if text else "-n"
        done = subprocess.run(
            [*self.base, *options, "-t", topic, source],
            input=text,
            text=True,
            timeout=60,
            check=check,
        )
        return done.returncode

    def remove_retained(self, topic: str) -> None:
        subprocess.run([*self.base, "-t", topic, "-r", "-n"], timeout=60, check=True)

    def publish_many(
        self, topic: str, payloads: list[dict[str, Any]], padding: int = 0
    ) -> subprocess.Popen[str]:
        """Publishes them over one connection, in the background, each with trailing spaces."""
        process = subprocess.Popen(
            [*self.base, "-t", topic, "-l"], stdin=subprocess.PIPE, text=True
        )
        assert process.stdin is not None
        process.stdin.write("".join(json.dumps(one) + " " * padding + "\n" for one in payloads))
        process.stdin.close()
        return process

    def payload(self, parameters: Any = None, **members: Any) -> dict[str, Any]:
        self.count += 1
        payload: dict[str, Any] = {
            "version": 1,
            "key": f"key-{self.count}",
            "sent": now(),
            "deadline": now() + 20_000,
            "reply": f"sbgc/{self.fleet}/reply/test",
        }
        if parameters is not None:
            payload["parameters"] = parameters
        payload.update(members)
        return {name: value for name, value in payload.items() if value is not None}

    def command(
        self,
        gimbal: str,
        task: str,
        parameters: Any = None,
        options: tuple[str, ...] = (),
        **members: Any,
    ) -> str:
        """Publishes a command and returns its key."""
        payload = self.payload(parameters, **members)
        topic = "raw" if task == "raw" else f"cmd/{task}"
        self.publish(f"sbgc/{self.fleet}/{gimbal}/{topic}", json.dumps(payload), *options)
        return str(payload.get("key"))


@contextmanager
def suspended(process: subprocess.Popen[Any]) -> Iterator[None]:
    """Suspends it: it neither answers nor closes its connections."""
    process.send_signal(signal.SIGSTOP)
    try:
        yield
    finally:
        process.send_signal(signal.SIGCONT)


def openssl(folder: Path, *arguments: str) -> None:
    subprocess.run(["openssl", *arguments], cwd=folder, check=True, capture_output=True)


def signed(folder: Path, name: str, days: int = 2) -> None:
    """A key and a certificate for 127.0.0.1, valid for this many days."""
    openssl(folder, "req", "-newkey", "ed25519", "-nodes", "-keyout", f"{name}.key",
            "-out", f"{name}.csr", "-subj", f"/CN={name}")  # fmt: skip
    (folder / "names").write_text("subjectAltName=IP:127.0.0.1\n")
    openssl(folder, "x509", "-req", "-in", f"{name}.csr", "-CA", "ca.crt", "-CAkey", "ca.key",
            "-CAcreateserial", "-days", str(days), "-extfile", "names", "-out", f"{name}.crt")  # fmt: skip


def certificates(folder: Path) -> None:
    """Makes a CA, and a key and a certificate of the broker and of the gateway."""
    folder.mkdir(exist_ok=True)
    openssl(folder, "req", "-x509", "-newkey", "ed25519", "-nodes", "-keyout", "ca.key",
            "-out", "ca.crt", "-days", "2", "-subj", "/CN=test")  # fmt: skip
    for name in ("server", "sbgc-gateway"):
        signed(folder, name)

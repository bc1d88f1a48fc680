"""Measures a gateway with many emulated gimbals and mosquitto: what is lost, how late samples are, and what
each part costs.

    bench/fleet/fleet.py build/release/tools/sbgc [--gimbals 200] [--rate 50] [--seconds 600]
"""

from __future__ import annotations

import argparse
import json
import os
import re
import signal
import socket
import subprocess
import tempfile
import time
import urllib.request
from collections import Counter
from pathlib import Path

MESSAGE = "RealtimeDataCustom"
# So many gimbals get a command every second. Nobody wants the results, so that they become events.
COMMANDED = 20
RESULT = b'"status":"done"'
TIME = re.compile(rb'"time":(\d+)')


def free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port: int = free.getsockname()[1]
        return port


def wait_for_port(port: int) -> None:
    while True:
        try:
            socket.create_connection(("127.0.0.1", port)).close()
            return
        except OSError:
            time.sleep(0.05)


class Part:
    """A process of the measurement."""

    def __init__(self, name: str, *command: str, output: int | None = None, log: Path) -> None:
        self.name = name
        self.process = subprocess.Popen(command, stdout=output, stderr=log.open("wb"))

    def processor_seconds(self) -> float:
        fields = Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def memory(self) -> float:
        """In MiB."""
        pages = int(Path(f"/proc/{self.process.pid}/statm").read_text().split()[1])
        return pages * os.sysconf("SC_PAGESIZE") / 2**20

    def threads(self) -> int:
        return len(os.listdir(f"/proc/{self.process.pid}/task"))

    def end(self) -> None:
        self.process.terminate()
        try:
            self.process.wait(timeout=60)
        except subprocess.TimeoutExpired:
            self.process.kill()


def emulated(program: str, count: int, log: Path) -> tuple[Part, list[str]]:
    part = Part(
        "gimbals", program, "emulate", "--count", str(count), "--tcp", "0",
        output=subprocess.PIPE, log=log,
    )  # fmt: skip
    assert part.process.stdout is not None
    lines = [part.process.stdout.readline().decode() for _ in range(count)]
    return part, [line.split(": ", 1)[1].split()[0] for line in lines]


def metrics(address: str) -> dict[str, float]:
    with urllib.request.urlopen(f"http://{address}/metrics", timeout=60) as answer:
        lines = [line for line in answer.read().decode().splitlines() if not line.startswith("#")]
    return {name: float(value) for name, value in (line.rsplit(" ", 1) for line in lines)}


def total(values: dict[str, float], name: str) -> float:
    return sum(value for key, value in values.items() if key.split("{")[0] == name)


def quantile(delays: Counter[int], share: float) -> int:
    """Statistics of delays in milliseconds."""
    left = share * sum(delays.values())
    for delay in sorted(delays):
        left -= delays[delay]
        if left <= 0:
            return delay
    return 0


class Reader:
    """Reads what mosquitto_sub writes: "<unix time of arrival> <payload>"."""

    def __init__(self, lines: int) -> None:
        self.lines = lines
        self.rest = b""
        self.delays: Counter[int] = Counter()
        self.events = 0

    def read(self, seconds: float) -> None:
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.rest += os.read(self.lines, 1 << 20)
            *whole, self.rest = self.rest.split(b"\n")
            for line in whole:
                found = TIME.search(line)
                if found:
                    self.delays[round(float(line.split(b" ", 1)[0]) * 1000) - int(found[1])] += 1
                self.events += RESULT in line


class Commands:
    """Asks gimbals for a parameter."""

    def __init__(self, port: int) -> None:
        self.sent = 0
        self.senders = [
            subprocess.Popen(
                ["mosquitto_pub", "-h", "127.0.0.1", "-p", str(port), "-q", "1", "-l", "-t", f"sbgc/bench/g{number}/cmd/get"],
                stdin=subprocess.PIPE,
            )
            for number in range(COMMANDED)
        ]  # fmt: skip

    def send(self) -> None:
        for sender in self.senders:
            self.sent += 1
            now = int(time.time() * 1000)
            command = {
                "version": 1,
                "key": str(self.sent),
                "deadline": now + 30_000,
                "parameters": {"names": ["pitch.p"]},
            }
            assert sender.stdin is not None
            sender.stdin.write(json.dumps(command).encode() + b"\n")
            sender.stdin.flush()

    def end(self) -> None:
        for sender in self.senders:
            sender.terminate()
            sender.wait()


def measure(program: str, count: int, rate: float, seconds: float, folder: Path) -> None:
    port, metrics_address = free_port(), f"127.0.0.1:{free_port()}"
    gimbals, addresses = emulated(program, count, folder / "gimbals.log")
    (folder / "mosquitto.conf").write_text(f"listener {port} 127.0.0.1\nallow_anonymous true\n")
    broker = Part(
        "mosquitto", "mosquitto", "-c", f"{folder}/mosquitto.conf", log=folder / "mosquitto.log"
    )
    wait_for_port(port)
    fleet = f'[fleet]\nname = "bench"\n[metrics]\nlisten = "{metrics_address}"\n'
    fleet += f'[broker]\naddress = "127.0.0.1:{port}"\njournal = "journal.db"\n'
    for number, address in enumerate(addresses):
        fleet += f'[gimbal.g{number}]\nport = "{address}"\n'
        fleet += f'telemetry = "{MESSAGE} {rate:g} IMU_ANGLES|TARGET_ANGLES"\nallow = ["get"]\n'
    (folder / "fleet.toml").write_text(fleet)
    gateway = Part(
        "gateway",
        program,
        "gateway",
        "--config",
        f"{folder}/fleet.toml",
        log=folder / "gateway.log",
    )
    reader_part = Part(
        "reader", "mosquitto_sub", "-h", "127.0.0.1", "-p", str(port), "-F", "%U %p", "-q", "1",
        "-t", "sbgc/bench/+/telemetry/+", "-t", "sbgc/bench/+/event",
        output=subprocess.PIPE, log=folder / "reader.log",
    )  # fmt: skip
    assert reader_part.process.stdout is not None
    reader = Reader(reader_part.process.stdout.fileno())
    parts = [gimbals, broker, gateway, reader_part]
    commands = Commands(port)
    try:
        reader.read(3)
        while total(metrics(metrics_address), "sbgc_gimbal_up") < count:
            reader.read(2)
        reader.read(60)  # until everything runs evenly
        reader.delays.clear()
        before = metrics(metrics_address)
        memory = [gateway.memory()]
        start = time.monotonic()
        used = {part.name: part.processor_seconds() for part in parts}
        while time.monotonic() < start + seconds:
            commands.send()
            reader.read(1)
            memory.append(gateway.memory())
        span = time.monotonic() - start
        after = metrics(metrics_address)
        shares = {part.name: part.processor_seconds() - used[part.name] for part in parts}
        delays = reader.delays.copy()
        reader.read(5)  # what is on the way
        report(count, rate, span, delays, before, after)
        print(f"{commands.sent} commands, {reader.events} of their results at the reader")
        for part in parts:
            print(
                f"{part.name:10}  {100 * shares[part.name] / span:6.1f} % of a processor, {part.memory():6.1f} MiB"
            )
        tenths = [f"{memory[i * (len(memory) - 1) // 10]:.1f}" for i in range(11)]
        print(f"memory of the gateway, in MiB, in ten equal times: {' '.join(tenths)}")
        print(f"it has {gateway.threads()} threads")
    finally:
        commands.end()
        for part in reversed(parts):
            part.end()


def report(
    count: int,
    rate: float,
    span: float,
    delays: Counter[int],
    before: dict[str, float],
    after: dict[str, float],
) -> None:
    def increase(name: str) -> float:
        return total(after, name) - total(before, name)

    asked = count * rate * span
    taken = increase("sbgc_telemetry_messages_total")
    print(f"{count} gimbals at {rate:g} per second for {span:.0f} s: {asked:.0f} samples")
    print(f"{taken:.0f} taken by the gateway, {sum(delays.values())} received from the broker")
    print(f"{increase('sbgc_broker_thinned_samples_total'):.0f} thinned, "
          f"{increase('sbgc_broker_dropped_messages_total'):.0f} events dropped, "
          f"{increase('sbgc_connections_total'):.0f} reconnections")  # fmt: skip
    late = [quantile(delays, share) for share in (0.5, 0.9, 0.99, 1)]
    print(
        "delay from the gateway to a reader: median {} ms, 90 % {} ms, 99 % {} ms, most {} ms".format(
            *late
        )
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--gimbals", type=int, default=200)
    parser.add_argument("--rate", type=float, default=50)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--keep", help="a folder for configuration and logs")
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: exit(1))
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(arguments.keep or temporary)
        measure(arguments.program, arguments.gimbals, arguments.rate, arguments.seconds, folder)


if __name__ == "__main__":
    main()

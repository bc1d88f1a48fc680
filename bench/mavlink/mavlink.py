"""Latency and processor time of sbgc-mavlink: `mavlink.py PROGRAM FOLDER`, with a release build's sbgc and package.

Ten emulated gimbals in two systems; each gets the state of its vehicle and a new angle 50 times a second, as from
ArduPilot. The latency is from the datagram to the frame on the line of the gimbal. The figures are for report.py.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from contextlib import suppress
from importlib import import_module
from math import cos, nan, radians, sin
from pathlib import Path
from socket import AF_INET, SOCK_DGRAM, create_connection, create_server, socket
from typing import Any

SECONDS, RATE, SYSTEMS, GIMBALS = 20, 50, 2, (154, 171, 172, 173, 174)
COUNT = SYSTEMS * len(GIMBALS)
START = 8  # seconds until all gimbals are found
CONTROL, BODY = 67, 15  # CMD_CONTROL, and the size of its extended form
STEPS = 400  # angles of a sweep, in the unit of the board
sent: dict[tuple[int, int], float] = {}
late: list[float] = []


def tap(number: int, gimbal: Any, sbgc: Any) -> int:
    """Relay a line of TCP, and note when commands with a new angle pass."""
    server = create_server(("127.0.0.1", 0))

    def carry(source: socket, target: socket, parser: Any) -> None:
        with suppress(OSError):
            while data := source.recv(4096):
                now = time.monotonic()
                target.sendall(data)
                for frame in parser.feed(data) if parser else ():
                    if frame.id == CONTROL and len(frame.body) == BODY:
                        raw = int.from_bytes(frame.body[9:11], "little", signed=True)
                        if (at := sent.pop((number, raw), None)) is not None:
                            late.append(now - at)

    def serve() -> None:
        host, board = server.accept()[0], create_connection(gimbal)
        threading.Thread(target=carry, args=(board, host, None), daemon=True).start()
        carry(host, board, sbgc.Parser())

    threading.Thread(target=serve, daemon=True).start()
    port: int = server.getsockname()[1]
    return port


def main() -> None:
    program, folder = sys.argv[1:3]
    sys.path.insert(0, folder)
    sbgc: Any = import_module("sbgc")
    codec: Any = import_module("sbgc.mavlink.codec")
    command = [program, "emulate", "--tcp", "0", "--count", str(COUNT)]
    board = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert board.stdout is not None
    addresses = [board.stdout.readline().split()[3].rsplit(":", 1)[1] for _ in range(COUNT)]
    links, text = [], ""
    for system in range(SYSTEMS):
        link = socket(AF_INET, SOCK_DGRAM)
        link.bind(("127.0.0.1", 0))
        links.append(link)
        line = f"udpout:127.0.0.1:{link.getsockname()[1]}"
        text += f"[vehicle {system}]\nline = {line}\nsystem = {system + 1}\n"
    for number, address in enumerate(addresses):
        port = tap(number, ("127.0.0.1", int(address)), sbgc)
        text += f"[gimbal {number}]\nport = tcp:127.0.0.1:{port}\nvehicle = {number % SYSTEMS}\n"
    with tempfile.TemporaryDirectory() as temporary:
        file = Path(temporary) / "drones.ini"
        file.write_text(text, encoding="ascii")
        environment = {**os.environ, "PYTHONPATH": f"{folder}:{os.environ.get('PYTHONPATH', '')}"}
        command = [sys.executable, "-m", "sbgc.mavlink", "--config", str(file)]
        adapter = subprocess.Popen(command, env=environment, stderr=subprocess.DEVNULL)
        try:
            measure(adapter.pid, links, codec.Codec(None, Counter()))
        finally:
            adapter.terminate()
            adapter.wait()
            board.kill()


def measure(pid: int, links: list[socket], codec: Any) -> None:
    peers = [link.recvfrom(4096)[1] for link in links]
    time.sleep(START)
    sequence = 0

    def send(system: int, name: str, **fields: Any) -> None:
        nonlocal sequence
        sequence = (sequence + 1) % 256
        ids = (1 + system, 1)
        frame = codec.to_bytes(name, ids, sequence, target_system=1 + system, **fields)
        links[system].sendto(frame, peers[system])

    begin, used = time.monotonic(), processor_time(pid)
    for step in range(SECONDS * RATE):
        raw = 1 + step % STEPS
        half = radians(-raw * 360 / 16384) / 2  # the board counts down
        aim: dict[str, Any] = {f"angular_velocity_{axis}": nan for axis in "xyz"}
        aim["q"] = [cos(half), 0, sin(half), 0]
        state = {"q": [1, 0, 0, 0], "time_boot_us": step * 20000}
        for system, link in enumerate(links):
            send(system, "AUTOPILOT_STATE_FOR_GIMBAL_DEVICE", **state)
            for place, gimbal in enumerate(GIMBALS):
                sent[place * SYSTEMS + system, raw] = time.monotonic()
                send(system, "GIMBAL_DEVICE_SET_ATTITUDE", target_component=gimbal, **aim)
            link.setblocking(False)
            with suppress(BlockingIOError):
                while True:
                    link.recv(4096)
        time.sleep(max(0.0, begin + (step + 1) / RATE - time.monotonic()))
    share = (processor_time(pid) - used) / (time.monotonic() - begin)
    times = sorted(late)
    half_within, most_within = (times[int(len(times) * part)] * 1000 for part in (0.5, 0.99))
    latency = {"name": "mavlink/latency", "cpu_time": half_within, "time_unit": "ms"}
    latency["ms_of_99_percent"] = most_within
    latency["overtaken"] = SECONDS * RATE * COUNT - len(times)
    second = {"name": f"mavlink/second_of_{COUNT}_gimbals", "cpu_time": share, "time_unit": "s"}
    second["cpu_share"] = share
    json.dump({"benchmarks": [latency, second]}, sys.stdout, indent=1)


def processor_time(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


if __name__ == "__main__":
    main()

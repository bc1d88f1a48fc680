"""Latency and processor time of sbgc-mavlink: `mavlink.py PROGRAM FOLDER`, with a release build's sbgc and package.

Ten emulated gimbals in two systems; each gets the state of its vehicle and a new angle 50 times a second, as from
ArduPilot. The latency is from the datagram to the frame on the line of the gimbal.
"""

from __future__ import annotations

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
sent: dict[tuple[int, int], float] = {}
late: list[float] = []


def tap(number: int, gimbal: Any, sbgc: Any) -> int:
    """Relay a line of TCP, and note when commands with a new angle pass."""
    server = create_server(("127.0.0.1", 0))

    def carry(source: socket, target: socket, parser: Any) -> None:
        with suppress(OSError):
            relay(source, target, parser)

    def relay(source: socket, target: socket, parser: Any) -> None:
        while data := source.recv(4096):
            now = time.monotonic()
            target.sendall(data)
            for frame in parser.feed(data) if parser else ():
                if frame.id == 67 and len(frame.body) == 15:
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
    wanted = import_module("sbgc.mavlink.vehicle").WANTED
    count = SYSTEMS * len(GIMBALS)
    command = [program, "emulate", "--tcp", "0", "--count", str(count)]
    board = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert board.stdout is not None
    addresses = [board.stdout.readline().split()[3].rsplit(":", 1)[1] for _ in range(count)]
    links, text = [], ""
    for system in range(SYSTEMS):
        link = socket(AF_INET, SOCK_DGRAM)
        link.bind(("127.0.0.1", 0))
        links.append(link)
        text += f"[vehicle {system}]\nline = udpout:127.0.0.1:{link.getsockname()[1]}\nsystem = {system + 1}\n"
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
            measure(adapter.pid, links, codec.Codec(wanted, None, Counter()))
        finally:
            adapter.terminate()
            adapter.wait()
            board.kill()


def measure(pid: int, links: list[socket], codec: Any) -> None:
    peers = [link.recvfrom(4096)[1] for link in links]
    time.sleep(8)  # all gimbals are found
    begin, sequence, used = time.monotonic(), 0, processor_time(pid)
    for step in range(SECONDS * RATE):
        for system, link in enumerate(links):
            rest = dict.fromkeys(
                ("vx", "vy", "vz", "q_estimated_delay_us", "v_estimated_delay_us"), 0
            )
            rest.update(target_system=1 + system, estimator_status=0, landed_state=0)
            names = ("feed_forward_angular_velocity_z", "angular_velocity_z")
            fields = {"q": [1, 0, 0, 0], "time_boot_us": step * 20000, **dict.fromkeys(names, nan)}
            name = "AUTOPILOT_STATE_FOR_GIMBAL_DEVICE"
            frame = codec.encode(
                name, (1 + system, 1), sequence, target_component=0, **fields, **rest
            )
            link.sendto(frame, peers[system])
            sequence = (sequence + 1) % 256
            for place, gimbal in enumerate(GIMBALS):
                raw = 1 + step % 400  # of the board: down
                half = radians(-raw * 360 / 16384) / 2
                q, rates = [cos(half), 0, sin(half), 0], {
                    f"angular_velocity_{a}": nan for a in "xyz"
                }
                target = {"target_system": 1 + system, "target_component": gimbal, "flags": 0}
                name = "GIMBAL_DEVICE_SET_ATTITUDE"
                frame = codec.encode(name, (1 + system, 1), sequence, q=q, **rates, **target)
                sequence = (sequence + 1) % 256
                sent[place * SYSTEMS + system, raw] = time.monotonic()
                link.sendto(frame, peers[system])
        for link in links:
            link.setblocking(False)
            try:
                while True:
                    link.recv(4096)
            except BlockingIOError:
                pass
        time.sleep(max(0.0, begin + (step + 1) / RATE - time.monotonic()))
    share = (processor_time(pid) - used) / (time.monotonic() - begin)
    times = sorted(late)
    middle, most = (times[int(len(times) * part)] * 1000 for part in (0.5, 0.99))
    lost = SECONDS * RATE * len(GIMBALS) * SYSTEMS - len(times)
    print(f"latency: half within {middle:.1f} ms, 99 % within {most:.1f} ms; {lost} overtaken")
    print(
        f"processor: {share:.0%} of one for {SYSTEMS * len(GIMBALS)} gimbals in {SYSTEMS} systems"
    )


def processor_time(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


if __name__ == "__main__":
    main()

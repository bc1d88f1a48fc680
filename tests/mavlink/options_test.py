"""Options, the configuration file, `--check`, and lines other than datagrams."""

from __future__ import annotations

import os
import pty
import socket
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import pytest
from drone import NAMES, Gimbal, program

from sbgc.mavlink.codec import Codec
from sbgc.mavlink.options import Settings

TWO = """
[vehicle left]
line = tcpin:127.0.0.1:{port}
system = 1
[vehicle right]
line = {terminal},57600
system = 2
[gimbal a]
port = {address}
vehicle = left
[gimbal b]
port = {address}
vehicle = left
component = 154
manager = yes
[gimbal c]
port = {address}
vehicle = right
component = 173
arm = no
"""


def run(*arguments: str, answers: str = "") -> "subprocess.CompletedProcess[str]":
    command = [sys.executable, "-m", "sbgc.mavlink", *arguments]
    return subprocess.run(command, input=answers, capture_output=True, text=True, timeout=60)


@pytest.mark.parametrize(
    "arguments, said",
    [
        ([], "either the address of a gimbal is needed, or --config"),
        (["x", "--line=udpin:14550"], "'udpin:14550': udpin:HOST:PORT is needed"),
        (["x", "--line=ttyS0"], "/dev/PORT,RATE is needed"),
        (["x", "--component=1"], "argument --component: invalid choice: 1"),
        (["x", "--rate-timeout=60"], "argument --rate-timeout: 0.1 to 5 are possible"),
        (["x", "--key-file=/dev/null"], "a key has 32 bytes"),
        (["--config=/none"], "No such file"),
    ],
)
def test_wrong_options(arguments: list[str], said: str) -> None:
    done = run(*arguments)
    assert done.returncode in (1, 2) and said in done.stderr and "Traceback" not in done.stderr


@pytest.mark.parametrize(
    "text, said",
    [
        ("[gimbal]\nport = x\n", "there is no vehicle"),
        ("[vehicle]\n[gimbal]\n", "--port"),
        ("[vehicle]\n[gimbal]\nport = x\nspeed = fast\n", "--speed"),
        ("[vehicle]\nlines = x\n", "unrecognized arguments: --lines=x"),
        ("[vehicle]\n" + "".join(f"[gimbal {n}]\nport = x\n" for n in range(7)), "six gimbals"),
        ("nothing", "no section headers"),
    ],
)
def test_wrong_files(text: str, said: str, tmp_path: Path) -> None:
    file = tmp_path / "drones.ini"
    file.write_text(text)
    done = run(f"--config={file}")
    assert done.returncode in (1, 2) and said in done.stderr and "Traceback" not in done.stderr


def test_several_gimbals_of_two_systems_on_tcp_and_a_serial_port(tmp_path: Path) -> None:
    ours, theirs = pty.openpty()
    camera, counters = Gimbal(), Counter[str]()
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    file = tmp_path / "drones.ini"
    terminal = os.ttyname(theirs)
    file.write_text(TWO.format(port=port, terminal=terminal, address=camera.address))
    found: dict[str, set[tuple[int, int]]] = {"tcp": set(), "serial": set()}
    codecs = {name: Codec(NAMES, None, counters) for name in found}
    try:
        with program(f"--config={file}"):
            for _ in range(100):
                try:
                    line = socket.create_connection(("127.0.0.1", port), 1)
                    break
                except ConnectionRefusedError:
                    time.sleep(0.1)
            line.sendall(b"0 0 0 ")  # as ArduPilot begins
            os.write(ours, b"\xfd\x00\xfe\xfdnoise")
            with line:
                for _ in range(40):
                    for name, data in (("tcp", line.recv(4096)), ("serial", os.read(ours, 4096))):
                        found[name] |= {one.sender for one in codecs[name].decode(data)}
    finally:
        camera.close()
        os.close(ours)
        os.close(theirs)
    assert found == {"tcp": {(1, 171), (1, 154)}, "serial": {(2, 173)}} and not counters


def test_check_asks_what_was_seen_and_writes_it(tmp_path: Path) -> None:
    camera, file = Gimbal(), tmp_path / "drones.ini"
    line = "--line=udpout:127.0.0.1:9"
    try:
        done = run(
            camera.address, line, "--manager", "--check", str(file), answers="y\nn\nmaybe\nn\ny\n"
        )
        assert done.returncode == 0, done.stderr
        assert max(abs(joint) for joint in camera.joints()) < 1, "it has turned back"
    finally:
        camera.close()
    settings = Settings()
    settings.read(file)
    gimbal = settings.gimbals[""]
    assert (gimbal.roll_sign, gimbal.pitch_sign, gimbal.yaw_sign) == (-1, -1, 1)
    assert (gimbal.port, gimbal.component, gimbal.manager, gimbal.arm) == (
        camera.address,
        154,
        True,
        False,
    )
    assert settings.vehicles[""].line == [line.removeprefix("--line=")]

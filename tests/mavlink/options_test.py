"""Options, the configuration file, `--check`, and lines other than datagrams."""

from __future__ import annotations

import os
import pty
import socket
import subprocess
import sys
from collections import Counter
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from drone import Gimbal, program

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
port = {a}
vehicle = left
[gimbal b]
port = {b}
vehicle = left
component = 154
manager = yes
[gimbal c]
port = {c}
vehicle = right
component = 173
arm = FALSE
"""


def run(*arguments: str, answers: str = "") -> "subprocess.CompletedProcess[str]":
    command = [sys.executable, "-m", "sbgc.mavlink", *arguments]
    return subprocess.run(command, input=answers, capture_output=True, text=True, timeout=60)


GIMBALS = "".join(f"[gimbal {number}]\nport = tcp:x:{number + 1}\n" for number in range(7))


@pytest.mark.parametrize(
    "given, said",
    [
        ([], "either the address of a gimbal is needed, or --config"),
        (["/x", "--line=udpin:14550"], "'udpin:14550': udpin:HOST:PORT"),
        (["/x", "--line=ttyS0"], "/dev/PORT,RATE is needed"),
        (["x", "--component=1"], "argument --component: invalid choice: 1"),
        (["/x", "--rate-timeout=60"], "rate-timeout: 0.1 to 5 are possible"),
        (["/x", "--key-file=/dev/null"], "a key has 32 bytes"),
        (["/x", f"--key-file={__file__}"], "options_test.py: a key has 32 bytes"),
        (["/x", "--system=300"], "--system: 1 to 255 are possible, not '300'"),
        (["nonsense"], "'nonsense' is malformed: a port is written with its path"),
        (["--config=/none"], "No such file"),
        ("[gimbal]\nport = /x\n", "there is no vehicle"),
        ("[vehicle]\n", "there is no gimbal"),
        ("[vehicle]\n[gimbal]\n", "drones.ini:2: its port is missing"),
        ("[vehicle]\n[gimbal]\nport = x\nspeed = fast\n", "ini:4: speed: invalid float value"),
        ("[vehicle]\n[gimbal]\narm = 1\nport = x\n", "ini:3: arm: it is yes or no, not '1'"),
        ("[vehicle]\n[gimbal]\nport = x\n", "ini:3: The address 'x' is malformed"),
        ("[vehicle]\n[gimbal]\nprt = x\nport = /x\n", "ini:3: unknown key 'prt'; did you mean"),
        (
            "[vehicle]\nx = 1\n",
            "ini:2: unknown key 'x'; keys of [vehicle] are line, system, key-file",
        ),
        ("[other]\n", "ini:1: unknown section [other]; there are [vehicle], [vehicle NAME],"),
        ("[Vehicle]\n", "ini:1: unknown section [Vehicle]; did you mean 'vehicle'?"),
        (
            "[vehicle]\n[gimbal a]\nport = /dev/null\n[gimbal b]\nport = serial:/dev/../dev/null?baud=9600\n",
            "ini:5: [gimbal b] has the port of [gimbal a], serial:/dev/../dev/null",
        ),
        (f"[vehicle]\n{GIMBALS}", "six gimbals"),
        ("nothing", "no section headers"),
    ],
)
def test_wrong_options_and_files(given: Any, said: str, tmp_path: Path) -> None:
    if isinstance(given, str):
        file = tmp_path / "drones.ini"
        file.write_text(given)
        given = [f"--config={file}"]
    done = run(*given)
    assert done.returncode in (1, 2) and said in done.stderr and "Traceback" not in done.stderr


def test_several_gimbals_of_two_systems_on_tcp_and_a_serial_port(tmp_path: Path) -> None:
    (ours, theirs), file, counters = pty.openpty(), tmp_path / "drones.ini", Counter[str]()
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    found: dict[str, set[tuple[int, int]]] = {"tcp": set(), "serial": set()}
    codecs = {name: Codec(None, counters) for name in found}
    with closing(Gimbal()) as a, closing(Gimbal()) as b, closing(Gimbal()) as c:
        terminal, ports = os.ttyname(theirs), {"a": a.address, "b": b.address, "c": c.address}
        file.write_text(TWO.format(port=port, terminal=terminal, **ports))
        with program(f"--config={file}") as process:
            assert process.stderr is not None
            while f"{port}: open" not in process.stderr.readline():
                pass
            with socket.create_connection(("127.0.0.1", port), 1) as line:
                line.sendall(b"0 0 0 ")  # as ArduPilot begins
                os.write(ours, b"\xfd\x00\xfe\xfdnoise")
                for _ in range(40):
                    for name, data in (("tcp", line.recv(4096)), ("serial", os.read(ours, 4096))):
                        found[name] |= {one.sender for one in codecs[name].messages(data)}
    os.close(ours)
    os.close(theirs)
    assert found == {"tcp": {(1, 171), (1, 154)}, "serial": {(2, 173)}} and not counters


def test_check_asks_what_was_seen_and_writes_it(tmp_path: Path) -> None:
    file, line = tmp_path / "drones.ini", "udpout:127.0.0.1:9"
    with closing(Gimbal()) as camera:
        options = f"--line={line}", "--manager", f"--check={file}"
        done = run(camera.address, *options, answers="y\nn\nmaybe\nn\ny\n")
        assert done.returncode == 0, done.stderr
        assert max(abs(joint) for joint in camera.joints()) < 1, "it has turned back"
    settings = Settings()
    settings.read(file)
    gimbal = settings.gimbals[""]
    assert (gimbal.roll_sign, gimbal.pitch_sign, gimbal.yaw_sign) == (-1, -1, 1)
    assert (gimbal.port, gimbal.component) == (camera.address, 154)
    assert gimbal.manager and not gimbal.arm and settings.vehicles[""].line == [line]

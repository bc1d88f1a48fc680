"""Tests of sbgc info, of how commands find their gimbal, and of the list of serial ports, whose contents depend
on the machine."""

from __future__ import annotations

import json
import os
import re
import socketserver
import subprocess
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from board_command import limit_files
from emulated_gimbal import emulated_gimbal
from sbgc_command import MODEL, PROGRAM, frame, run

PortsFile = Callable[..., None]


@pytest.fixture(name="list_ports")
def listing_of_ports(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> PortsFile:
    """Returns a function that replaces the ports of this machine."""

    def replace(*names: str, usb: bool = True) -> None:
        identity = {"vendor_id": 0x10C4, "product_id": 0xEA60, "serial_number": "1"}
        ports = [{"name": name, "usb": identity if usb else None} for name in names]
        document = {"format": "sbgc-ports", "version": 1, "ports": ports}
        (tmp_path / "ports.json").write_text(json.dumps(document))

    monkeypatch.setenv("SBGC_PORTS", str(tmp_path / "ports.json"))
    return replace


def test_text_and_json() -> None:
    with emulated_gimbal("--firmware", "2.59") as gimbal:
        info = json.loads(run("info", "--format", "json", "-p", gimbal.address).text)
        text = run("info", "--all", "-p", gimbal.address).text
    assert (info["format"], info["version"]) == ("sbgc-info", 1)
    assert (info["board"], info["firmware"]) == ("3.0", "2.59")
    assert info["line"]["responses"] == info["line"]["requests"] == 20
    times = info["line"]["round_trip_ms"]
    assert 0 < times["min"] <= times["median"] <= times["max"] < 1000
    flags = {v["name"] for e in MODEL["enums"] if e["name"] == "BoardFeature" for v in e["values"]}
    assert flags <= set(info["features"]) | set(info["missing_features"])
    assert "BOARD_FEATURE_ENCODERS" in info["features"]
    assert "CMD_CONTROL_CONFIG" in info["unsupported_commands"]
    assert "CMD_CONTROL" not in info["unsupported_commands"]
    lacks_can = "BOARD_FEATURE_CAN_PORT" in info["missing_features"]
    assert ("CMD_CAN_DEVICE_SCAN" in info["unsupported_commands"]) == lacks_can
    words = text.split()
    for name in (*info["missing_features"], *info["unsupported_commands"]):
        assert name in words or name + "," in words
    assert all(len(line) <= 80 for line in text.splitlines())


def test_a_board_without_firmware() -> None:
    """It says who it is, as one that was posted did, and answers nothing else."""

    class Board(socketserver.BaseRequestHandler):
        def handle(self) -> None:
            while data := self.request.recv(4096):
                for _ in range(data.count(frame(86))):
                    self.request.sendall(bytes.fromhex("3e5612681e" + 17 * "00" + "1e"))

    with socketserver.ThreadingTCPServer(("127.0.0.1", 0), Board) as server:
        server.daemon_threads = True
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"tcp:127.0.0.1:{server.server_address[1]}"
        info = run("info", "-p", address)
        doctor = run("doctor", "--for", "1s", "-p", address)
        server.shutdown()
    problem = "0.00: unknown; the sensors are often unplugged"
    assert info.status == 0 and problem in " ".join(info.text.split())
    assert doctor.status == 1 and problem in " ".join((doctor.text + doctor.error).split())


def test_the_only_gimbal_is_used(list_ports: PortsFile) -> None:
    with emulated_gimbal("--pty") as gimbal:
        list_ports(gimbal.address)
        assert f"serial port {gimbal.address}" in run("info").text


def test_several_gimbals_are_listed(list_ports: PortsFile) -> None:
    with emulated_gimbal("--pty") as one, emulated_gimbal("--pty", "--firmware", "2.70") as two:
        list_ports(one.address, two.address)
        result = run("info")
    assert result.status == 1
    assert f"{one.address}  board 3.0, firmware 2.59" in result.error
    assert f"{two.address}  board 3.6, firmware 2.70" in result.error


def test_no_gimbal(list_ports: PortsFile, tmp_path: Path) -> None:
    list_ports()
    assert "there are no serial ports to search" in run("info").error
    list_ports(str(tmp_path / "one"), str(tmp_path / "two"), "/dev/null")
    said = run("info").error.splitlines()
    assert said[0] == "sbgc: found no gimbal; use --port. Searched:"
    assert said[1:] == [
        f"  {tmp_path / 'one'}, {tmp_path / 'two'}  there is no port",
        "  /dev/null  is not a serial port",
    ]
    list_ports(str(tmp_path / "nothing"))
    result = run("info")
    assert result.status == 1 and "found no gimbal; use --port" in result.error
    assert str(tmp_path / "nothing") in result.error
    (tmp_path / "ports.json").write_text("{")
    assert run("info").status == 1


def test_an_adapter_is_preferred(list_ports: PortsFile, tmp_path: Path) -> None:
    with emulated_gimbal("--pty") as gimbal:
        list_ports(gimbal.address, usb=False)
        assert run("info").status == 0
        listed = json.loads((tmp_path / "ports.json").read_text())
        adapter = {"name": str(tmp_path / "absent"), "usb": {"vendor_id": 1, "product_id": 2}}
        listed["ports"].append(adapter)
        (tmp_path / "ports.json").write_text(json.dumps(listed))
        assert gimbal.address not in run("info").error


def test_named_gimbals(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "config.toml"
    monkeypatch.setenv("SBGC_CONFIG", str(file))
    with emulated_gimbal() as gimbal:
        notes = "# " + "a." * 300 + "\n \t\n"
        file.write_text(
            notes + f'# mine\n[gimbal.front]\nport = "{gimbal.address}"\nattempts = 5\n'
        )
        for arguments in (["-g", "front", "info"], ["info", "--gimbal", "front"]):
            assert run(*arguments).status == 0
    result = run("info", "-g", "frnt")
    assert result.status == 2 and "did you mean 'front'?" in result.error
    assert run("info", "-g", "front", "-p", "tcp:x:1").status == 2


@pytest.mark.parametrize(
    "text, reason",
    [
        ("[gimbal.front]\nattempts = 3\n", ":1:1: [gimbal.front] has no port; add port = "),
        (
            '[gimbal.front]\nport = "x"\nattempt = 3\n',
            ":3:1: unknown key 'attempt' of [gimbal.front]",
        ),
        ('[gimbal.front]\nport = "x"\nattempts = many\n', ":3:12: Error while parsing value"),
        ("; mine\n", "comments begin with '#'"),
        ('[gimbal.front]\nport = "x"\nattempts = 0\n', "it must be a whole number from 1 to 100"),
        ('[gimbal.front]\nport = "x"\ntimeout = 0\n', ":3:11: 'timeout' is '0'; it must be a time"),
        ('port = "x"\n', "'port' is not in a section [gimbal.NAME]"),
        ('[camera.front]\nport = "x"\n', "is not in a section [gimbal.NAME]"),
        ('[gimbal.front]\nport = ["x", "y"]\n', "'port' has one value, not a list"),
        ("# limits\n[" + "a." * 16 + "b]\n", "nested deeper than 16 levels"),
        ("a." * 30000 + "b = 1\n", ":1:1: a line with more than 1000 dots"),
        ('[gimbal.front]\nport = "x\\u0000"\n', ":2:8: a text with a NUL"),
        ("[gimbal.größe]\n", "names with other characters than A-Z a-z 0-9 _ - need quotes"),
        ("#\n" * 40000, "has more than 65536 bytes"),
    ],
)
def test_mistakes_in_the_configuration(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, reason: str
) -> None:
    file = tmp_path / "config.toml"
    file.write_text(text)
    monkeypatch.setenv("SBGC_CONFIG", str(file))
    result = run("info", "-g", "front")
    assert result.status == 1 and str(file) in result.error and reason in result.error


def test_a_pipe_is_no_configuration(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pipe = tmp_path / "config.toml"
    os.mkfifo(pipe)
    monkeypatch.setenv("SBGC_CONFIG", str(pipe))
    result = run("info", "-g", "front")
    assert result.status == 1 and f"{pipe} is not a regular file" in result.error


@pytest.mark.parametrize("character", ["\x1b]0;x\x07", "\x9b31m", "\x7f"])
def test_files_do_not_control_the_terminal(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, character: str
) -> None:
    """Names from a file appear in errors and lists."""
    monkeypatch.setenv("SBGC_CONFIG", str(tmp_path / "config.toml"))
    name = "".join(f"\\u{ord(one):04x}" for one in character)
    (tmp_path / "config.toml").write_text(f'[gimbal.front]\n"{name}" = "x"\n', "utf-8")
    results = [run("info", "-g", "front")]
    state = tmp_path / "state.json"
    with emulated_gimbal("--state", str(state)):
        pass
    document = json.loads(state.read_text("utf-8"))
    state.write_text(json.dumps({character: 1} | document), "utf-8")
    results.append(run("emulate", "--state", str(state), "--seconds", "1"))
    ports = {"format": "sbgc-ports", "version": 1, "ports": [{"name": f"/dev/a{character}"}]}
    monkeypatch.setenv("SBGC_PORTS", str(tmp_path / "ports.json"))
    (tmp_path / "ports.json").write_text(json.dumps(ports), "utf-8")
    results += [run("ports"), run("info")]
    assert [result.status for result in results] == [1, 1, 0, 1]
    for result in results:
        said = result.error + result.text
        assert "?" in said and character[0] not in said


def test_verbose_prints_the_frames() -> None:
    with emulated_gimbal() as gimbal:
        result = run("info", "-v", "-p", gimbal.address)
    times = [float(time) for time in re.findall(r"^([\d.]+) s  CMD_", result.error, re.MULTILINE)]
    assert len(times) >= 40 and times == sorted(times)
    assert re.search(r"CMD_BOARD_INFO \(86\)  host to board, 0 bytes", result.error)
    assert re.search(r"^    firmware_ver +2590  2.59$", result.error, re.MULTILINE)
    assert "firmware_ver" not in result.text


def test_a_capture_that_can_no_longer_be_written_is_an_error(tmp_path: Path) -> None:
    capture = tmp_path / "c"
    with emulated_gimbal() as gimbal:
        info = ("info", "--capture", str(capture), "-p", gimbal.address)
        done = run(*info, preexec_fn=lambda: limit_files(300))
    assert done.status == 1
    assert "serial number" in done.text, "the rest is done"
    assert f"The capture {capture} cannot be written: File too large" in done.error


# A separate mount namespace, in which file systems can be mounted over others.
UNSHARE = ["unshare", "--mount"] + (["--map-root-user"] if os.geteuid() != 0 else [])
NO_PORTS = "No serial ports found.\n"
LIST = '{"format": "sbgc-ports", "version": 1, "ports": [%s]}'


def test_ports_are_listed() -> None:
    text = run("ports")
    assert text.status == 0 and text.text
    text_of_list = run("ports", "--format", "json").text
    assert '\n  "ports": [' in text_of_list
    listed = json.loads(text_of_list)
    assert (listed["format"], listed["version"]) == ("sbgc-ports", 1)
    ports = listed["ports"]
    for port in ports:
        assert port["name"] in text.text
        assert set(port) == {"name", "description", "usb"}
    if not ports:
        assert text.text == NO_PORTS


def test_a_system_without_sys_has_no_ports() -> None:
    """Containers and chroots often lack /sys."""
    if subprocess.run([*UNSHARE, "true"], capture_output=True, check=False).returncode != 0:
        pytest.skip("this user may not mount file systems")
    # If /sys is already missing, there is nothing to hide.
    script = """
        [ ! -d /sys/class ] || mount -t tmpfs none /sys || exit
        "$1" ports && "$1" ports --format json
    """
    done = subprocess.run(
        [*UNSHARE, "sh", "-c", script, "sh", PROGRAM], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(NO_PORTS)
    assert json.loads(done.stdout.removeprefix(NO_PORTS))["ports"] == []


@pytest.mark.parametrize(
    ("content", "repeats", "words"),
    [
        (LIST % '{"name": "/dev/a"}, {"name": 5}', 1, "port 2 has unexpected values"),
        (
            LIST % '{"name": "/dev/a", "usb": {"vendor_id": 1e300, "product_id": 1}}',
            1,
            "port 1 has",
        ),
        (LIST % '{"name": "/dev/a", "usb": {"vendor_id": 1, "product_id": -5}}', 1, "port 1 has"),
        (
            LIST % '{"name": "/dev/a", "usb": {"vendor_id": 1, "product_id": 65536}}',
            1,
            "port 1 has",
        ),
        (LIST.replace("[%s]", "null"), 1, "not a list of ports"),
        (LIST % ",".join(['{"name": "/dev/a"}'] * 129), 1, "more than 128 ports"),
        ('{"name": "/dev/a"}', 1, "not a list of ports"),
        ('[{"name": "/dev/a"}]', 1, "not a list of ports"),
        (LIST.replace("1", "2") % "", 1, "not a list of ports"),
        ("[", 2_000_000, "ports.json"),
    ],
)
def test_a_wrong_list_is_explained(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, content: str, repeats: int, words: str
) -> None:
    file = tmp_path / "ports.json"
    file.write_text(content * repeats)
    monkeypatch.setenv("SBGC_PORTS", str(file))
    result = run("ports")
    assert result.status == 1
    assert words in result.error
    assert "json.exception" not in result.error

"""`sbgc gateway --check` accepts whatever a gateway can start with, and rejects the rest like the start."""

from __future__ import annotations

import os
import random
import re
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from brokers import certificates
from gateway import Gateway, eventually
from sbgc_command import PROGRAM, Result, run

VALUES: dict[str, dict[str, str]] = {
    "fleet": {"name": '"studio"'},
    "metrics": {"listen": '"127.0.0.1:0"', "interval": '"1s"', "fields": '"angle,current"'},
    "broker": {
        "address": '"127.0.0.1:1"',
        "journal": '"fleet.db"',
        "mqtt": '"5"',
        "client-id": '"us"',
        "user": '"we"',
        "password-file": '"secret"',
        "ca-file": '"ca.crt"',
        "certificate-file": '"server.crt"',
        "key-file": '"server.key"',
        "keep-alive": '"10s"',
        "most-waiting": "10",
        "stop-after": "2",
    },
    "gimbal.front": {
        "port": '"tcp:127.0.0.1:1"',
        "attempts": "3",
        "password-file": '"secret"',
        "allow": '["stop"]',
        "telemetry": '"RealtimeData4 1"',
    },
}
MUTATIONS = (
    '""', "0", "2.5", "-1", "1e9", "true", "[]", '"x"', '"*:9110"', '"tcp:h:99999"', '"udp:"', '"."',
    '"tcp://127.0.0.1:1"', '"127.0.0.1:99999"', '"127.0.0.1:0,127.0.0.1:0"', '"[::1]:0"', '"a\\u0000b"',
    '"a\\u0007b"', '"no/such/file"', '"fleet.toml"', '"server.key"', '"empty"', '"names"', f'"{"n" * 300}"',
    f'"{"n" * 900}"', f'"{"n" * 9000}"', '"\udcff"',
)  # fmt: skip
CHANGES = [(s, key, text) for s in VALUES for key in VALUES[s] for text in MUTATIONS]


def text_with(section: str = "", key: str = "", value: str = "") -> str:
    return "".join(
        f"[{name}]\n"
        + "".join(f"{k} = {value if (name, k) == (section, key) else v}\n" for k, v in keys.items())
        for name, keys in VALUES.items()
    )


@pytest.fixture(name="folder", scope="module")
def the_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """With the files that the configuration names."""
    folder = tmp_path_factory.mktemp("fleet")
    certificates(folder)
    (folder / "empty").touch(mode=0o600)
    (folder / "secret").touch(mode=0o600)
    (folder / "secret").write_text("secret\n")
    yield folder


def check(file: Path) -> Result:
    return run("gateway", "--config", str(file), "--check")


def checked(folder: Path, text: str) -> str:
    """The error of --check, which creates nothing; "" if there is none."""
    file = folder / "fleet.toml"
    file.write_bytes(text.encode(errors="surrogateescape"))
    before = sorted(folder.iterdir())
    result = check(file)
    assert sorted(folder.iterdir()) == before
    if result.status == 0:
        return ""
    assert result.status == 1 and len(result.error) <= 500, result
    return " ".join(result.error.split())


def starts(folder: Path, text: str) -> None:
    before = set(folder.iterdir())
    gateway = Gateway(folder, text)
    try:
        eventually(
            lambda: "metrics at" in gateway.log.read_text() or gateway.process.poll() is not None
        )
        assert gateway.process.poll() is None, gateway.log.read_text()
    finally:
        gateway.kill()
        for made in set(folder.iterdir()) - before:
            made.unlink()


def check_against_start(folder: Path, changes: list[tuple[str, str, str]]) -> None:
    for section, key, value in changes:
        text = text_with(section, key, value)
        error = checked(folder, text)
        lines = text.split("\n")
        line = lines.index(f"{key} = {value}", lines.index(f"[{section}]"))
        if not error:
            starts(folder, text)
        elif value not in ('""', "[]"):  # what is empty may count as missing
            place = re.search(rf"fleet.toml:{line + 1}:(\d+): ", error)
            assert place and int(place[1]) >= len(key) + 4, (error, key, value)


def test_a_sample_of_changes(folder: Path) -> None:
    starts(folder, text_with())
    check_against_start(folder, random.Random(63).sample(CHANGES, 45))


@pytest.mark.long
def test_all_changes(folder: Path) -> None:
    check_against_start(folder, CHANGES)


@pytest.mark.parametrize(
    "section, key, value, reason",
    [
        ("metrics", "fields", '"angel"', "did you mean"),
        ("metrics", "listen", '"127.0.0.1:1,0.0.0.0:2"', "must be an IPv4 address and a port"),
        ("broker", "journal", '"gone/a.db"', "cannot write to the folder"),
        ("broker", "journal", '"server.key"', "is no journal of a gateway"),
        ("broker", "password-file", '"empty"', "a password is one line"),
        ("broker", "ca-file", '"names"', "is not a file of certificates in PEM"),
        ("broker", "key-file", '"ca.key"', "is not the key of the certificate"),
        ("broker", "most-waiting", "2.5", "a whole number from 1"),
        ("gimbal.front", "port", '"udp:"', "the port is missing"),
        ("gimbal.front", "password-file", '"a\\u0000b"', "a text with a NUL"),
    ],
)
def test_the_reason(folder: Path, section: str, key: str, value: str, reason: str) -> None:
    assert reason in checked(folder, text_with(section, key, value))


def test_beside_a_running_gateway(folder: Path) -> None:
    gateway = Gateway(folder, text_with())
    try:
        address = gateway.metrics_address.split("/")[2]
        assert not checked(folder, text_with("metrics", "listen", f'"{address}"'))
    finally:
        gateway.kill()


def test_a_file_that_this_user_may_not_read() -> None:
    """Root may read everything, so another user checks the file."""
    user = "nobody" if os.geteuid() == 0 else None
    with tempfile.TemporaryDirectory() as folder, open(PROGRAM, "rb") as program:
        os.chmod(folder, 0o755)
        file, secret = Path(folder) / "fleet.toml", Path(folder) / "secret"
        gimbal = '[gimbal.a]\nport = "tcp:a:1"\npassword-file = "secret"\n'
        file.write_text(f'[fleet]\nname = "a"\n[metrics]\n{gimbal}')
        secret.touch(mode=0o200)
        number = program.fileno()  # its own folder may be closed to others
        command = [f"/proc/self/fd/{number}", "gateway", "--config", str(file), "--check"]
        done = subprocess.run(
            command, stderr=-1, text=True, pass_fds=[number], check=False, user=user
        )
    name = subprocess.run(["id", "-un"], stdout=-1, text=True, check=True, user=user).stdout.strip()
    assert f"{secret} as the user {name}: Permission denied" in " ".join(done.stderr.split())


FLEET = """[fleet]
name = "studio"
[metrics]
[gimbal.front]
port = "tcp:127.0.0.1:1"
"""
SAMPLE = Path(__file__).parents[1] / "deploy/fleet.toml"


def test_the_sample_is_a_fleet(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text(SAMPLE.read_text().replace("/var/lib/sbgc-gateway", str(tmp_path)))
    result = check(file)
    assert result.status == 0 and "studio: 2 gimbals" in result.error


@pytest.mark.parametrize(
    "text, place, reason",
    [
        ("", "1:1", "[fleet] with its name"),
        ('[fleet]\nname = "Studio"\n', "2:8", "'Studio' cannot be a part of a topic"),
        (
            '[fleet]\nname = "a"\n[metrics]\n',
            "1:1",
            "a section [gimbal.NAME] with a port is missing",
        ),
        (FLEET.replace("[metrics]\n", ""), "1:1", "[metrics] or [broker]"),
        ('[gimbal."a/b"]\n', "6:1", "'a/b' cannot be a part of a topic"),
        ("[gimbal.reply]\n", "6:1", "'reply' has another meaning"),
        ("[gimbal.front]\n", "6:1", "cannot redefine existing table 'gimbal.front'"),
        (
            '[gimbal.back]\nport = "tcp:127.0.0.1:1"\n',
            "7:8",
            "[gimbal.back] has the port of [gimbal.front], tcp:127.0.0.1:1",
        ),
        (
            '[gimbal.a]\nport = "/dev/null"\n[gimbal.b]\nport = "serial:/dev/../dev/null"\n',
            "9:8",
            "[gimbal.b] has the port of [gimbal.a], /dev/null",
        ),
        ("[gimbals.back]\n", "6:1", "did you mean 'gimbal'?"),
        ('prot = "x"\n', "6:1", "unknown key 'prot' of [gimbal.front]; did you mean 'port'?"),
        ('allow = ["mov"]\n', "6:10", "no task 'mov'; did you mean 'move'?"),
        ('raw-effects = ["reads",\n  "explodes"]\n', "7:3", "no effect 'explodes'"),
        ('units = "V"\n', "6:9", '\'units\' must be "yes" or "no"'),
        ('telemetry = ["RealtimeData4"]\n', "6:14", "is not a message and its rate"),
        ('telemetry = "RealtimeDat4 1"\n', "6:13", "did you mean 'RealtimeData4'"),
        (
            'telemetry = "RealtimeDataX 1"\n',
            "6:13",
            "; did you mean 'RealtimeData3' or 'RealtimeData4'?",
        ),
        ('telemetry = "RealtimeDataCustom 1"\n', "6:13", "say what RealtimeDataCustom contains"),
        (
            'telemetry = ["RealtimeData4 1", "REALTIME_DATA_4 2"]\n',
            "6:33",
            "RealtimeData4 is there twice",
        ),
        ('password-file = "-"\n', "6:17", "nobody to ask"),
        ("[broker]\n", "6:1", "[broker] has no address"),
        ('[broker]\naddress = "a:b"\n', "7:11", "'a:b' is not an address"),
        ('[broker]\naddress = "a"\nmqtt = "4"\n', "8:8", 'must be "3.1.1" or "5"'),
        ('[broker]\naddress = "a"\nkeep-alive = "100000s"\n', "8:14", "at most 65535 s"),
        ('[broker]\naddress = "a"\nstop-after = "100h"\n', "8:14", "at most 60 s"),
        ('[broker]\naddress = "a"\nclock-skew = "2m"\n', "8:14", "at most 60 s"),
        ('[broker]\naddress = "a"\nlongest-deadline = "25h"\n', "8:20", "at most 86400 s"),
        ('[broker]\naddress = "a"\nkey-file = "k"\n', "8:12", "belong together"),
        (
            FLEET.replace("[metrics]", '[metrics]\nlisten = "9110"'),
            "4:10",
            "an IPv4 address and a port",
        ),
        ('allow = ["move\n', "6:15", "Error while parsing string"),
        ("allow = [move]\n", "6:10", "texts need quotes"),
        ('allow = ["move" "stop"]\n', "6:17", "expected comma or closing ']'"),
        ("attempts = 3 4\n", "6:14", "expected a comment or whitespace"),
        ('port = "y"\n', "6:8", "cannot redefine existing string 'port'"),
    ],
)
def test_mistakes(tmp_path: Path, text: str, place: str, reason: str) -> None:
    file = tmp_path / "fleet.toml"
    is_whole = not text or text.startswith("[fleet]")
    file.write_text(text if is_whole else FLEET + text)
    result = check(file)
    assert result.status == 1 and f"{file}:{place}: " in result.error
    assert reason in " ".join(result.error.split())


def test_names_and_values_of_toml(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text(
        "fleet.name = 'a' # the first letter\r\n\r\n[metrics]\r\n"
        '[ gimbal . "b" ]\n"port" = "t\\u0063p:127.0.0.1:1"\nallow = [ # two\n  "move",\n  \'stop\',\n]\n'
    )
    result = check(file)
    assert result.status == 0 and "a: 1 gimbal" in result.error


def test_files_count_from_the_configuration(tmp_path: Path) -> None:
    file = tmp_path / "fleet.toml"
    file.write_text(FLEET + 'password-file = "front.password"\n')
    result = check(file)
    assert result.status == 1 and f"{tmp_path}/front.password" in result.error

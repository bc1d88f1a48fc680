"""`sbgc gateway --check` accepts what a gateway can start with, and refuses the rest as the start does."""

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
from sbgc_command import PROGRAM, run

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


def checked(folder: Path, text: str) -> str:
    """The error of --check, which creates nothing; "" if there is none."""
    file = folder / "fleet.toml"
    file.write_bytes(text.encode(errors="surrogateescape"))
    before = sorted(folder.iterdir())
    result = run("gateway", "--config", str(file), "--check")
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
        ("metrics", "listen", '"127.0.0.1:1,0.0.0.0:2"', "not one number of version 4 and a port"),
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
    """Root may read everything, so that another user looks."""
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

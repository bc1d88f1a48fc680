"""Tests of the list of serial ports. Its contents depend on the machine."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest

from sbgc_command import PROGRAM, run

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

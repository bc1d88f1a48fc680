"""Tests of the list of serial ports. Its contents depend on the machine."""

from __future__ import annotations

import json
import os
import subprocess

import pytest

from sbgc_command import PROGRAM, run

# A separate mount namespace, in which file systems can be mounted over others.
UNSHARE = ["unshare", "--mount"] + (["--map-root-user"] if os.geteuid() != 0 else [])
NO_PORTS = "No serial ports found.\n"


def test_ports_are_listed() -> None:
    text = run("ports")
    assert text.status == 0 and text.text
    ports = json.loads(run("ports", "--format", "json").text)
    assert isinstance(ports, list)
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
    assert (done.returncode, done.stdout, done.stderr) == (0, NO_PORTS + "[]\n", "")

"""Recording for Wireshark: `sbgc record --pcapng`, `sbgc decode --format pcapng`, and the extcap program."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from captures import ANGLES, CAPTURE, FROM_BOARD, TO_BOARD, record, session
from line import DISSECTOR, ROOT, shown, tshark
from sbgc_command import PROGRAM, frame, run

EXTCAP = ROOT / "tools" / "bytes" / "wireshark" / "sbgc-extcap"


def test_a_capture_opens_with_its_times_and_directions(tmp_path: Path) -> None:
    (tmp_path / "capture").write_bytes(
        CAPTURE + session(1_700_000_100) + record(TO_BOARD, 1, frame(86))
    )
    (tmp_path / "packets").write_bytes(
        run("decode", "--format", "pcapng", str(tmp_path / "capture")).out
    )
    names = ("frame.time_epoch", "frame.comment", "frame.p2p_dir", "data.len", "sbgc.message")
    rows = tshark(tmp_path / "packets", "-Tfields", *(f"-e{name}" for name in names)).split("\n")
    found = [row.split("\t") for row in rows if row]
    assert [row[0] for row in found] == [
        f"17000000{seconds}000"
        for seconds in ("00.000000", "00.250000", "00.500000", "00.625000", "01.750000")
    ] + ["1700000100.000000000", "1700000101.000000000"]
    assert [row[2] for row in found] == ["", "0", "1", "0", "1", "", "0"]
    assert found[1][1] == "serial port /dev/ttyUSB0, 115200 8N1"
    assert [row[4] for row in found] == [
        *(
            "",
            "GetAnglesRequest",
            "",
            "GetAnglesRequest",
            "GetAngles,GetAngles",
            "",
            "BoardInfoRequest",
        )
    ]
    only = run("decode", "--format", "pcapng", "--from", "host", str(tmp_path / "capture")).out
    (tmp_path / "host").write_bytes(only)
    assert [one.text("sbgc.direction") for one in shown(tmp_path / "host")] == ["1"] * 3


@pytest.mark.parametrize("option", ["--real", "--message=86", "--show-passwords"])
def test_options_of_frames_are_refused(option: str) -> None:
    assert run("decode", "--format", "pcapng", option, "-", stdin=CAPTURE).status == 2


@pytest.mark.parametrize("is_text", [False, True])
def test_bytes_without_times_need_a_sender(is_text: bool, tmp_path: Path) -> None:
    data = b"noise" + frame(86) + frame(86) + b">\x43"
    given = data.hex(" ").encode() if is_text else data
    refused = run("decode", "--format", "pcapng", stdin=given)
    assert refused.status == 2 and "needs --from board or --from host" in refused.error
    assert not refused.out
    (tmp_path / "packets").write_bytes(
        run("decode", "--format", "pcapng", "--from", "host", stdin=given).out
    )
    rows = tshark(tmp_path / "packets", "-2", "-Tfields", "-esbgc.message", "-eframe.len")
    assert rows.split("\n") == ["\t5", "BoardInfoRequest\t5", "BoardInfoRequest\t5", "\t2", ""]
    nothing = run("decode", "--format", "pcapng", "--from", "board", stdin=b"\x01\x02")
    assert nothing.status == 1 and nothing.out and "no frame in 2 bytes" in nothing.error


def test_recording_to_a_file_and_to_tshark(tmp_path: Path) -> None:
    (tmp_path / "in").write_bytes(CAPTURE)
    line = f"capture:{tmp_path / 'in'}?timing=fast"
    for _ in range(2):  # the second time, the file gets another session
        assert run("record", "--pcapng", line, str(tmp_path / "out.pcapng")).status == 0
    found = [one.text("sbgc.message") for one in shown(tmp_path / "out.pcapng")]
    assert [one for one in found if one] == ["GetAngles"] * 4
    assert run("record", "--pcapng", line, str(tmp_path / "in")).status == 1
    assert (tmp_path / "in").read_bytes() == CAPTURE
    live = subprocess.run(
        f"'{PROGRAM}' record --pcapng '{line}' - | tshark -n -X lua_script:'{DISSECTOR}' -r -",
        shell=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=60, check=True,
    )  # fmt: skip
    assert b"< GetAngles" in live.stdout


def test_wireshark_lists_gimbals_and_captures_from_them(tmp_path: Path) -> None:
    def extcap(*options: str) -> str:
        return subprocess.run(
            [EXTCAP, *options],
            env={**os.environ, "SBGC": PROGRAM},
            stdout=subprocess.PIPE,
            check=True,
            timeout=60,
        ).stdout.decode()

    assert "interface {value=sbgc}" in extcap("--extcap-interfaces", "--extcap-version=4.0")
    assert "{number=160}" in extcap("--extcap-interface", "sbgc", "--extcap-dlts")
    assert "{call=--address}" in extcap("--extcap-interface", "sbgc", "--extcap-config")
    (tmp_path / "in").write_bytes(CAPTURE)
    line = f"capture:{tmp_path / 'in'}?timing=fast"
    extcap(
        "--extcap-interface",
        "sbgc",
        "--capture",
        "--fifo",
        str(tmp_path / "out"),
        "--address",
        line,
    )
    assert "GetAngles" in tshark(tmp_path / "out")


def test_the_dissector_is_registered_without_any_setup(tmp_path: Path) -> None:
    """The dissector is a plugin in the user's folder, without an option or a preference."""
    plugins = tmp_path / ".local/lib/wireshark/plugins"
    plugins.mkdir(parents=True)
    shutil.copy(DISSECTOR, plugins)
    (tmp_path / "capture").write_bytes(session() + record(FROM_BOARD, 0, ANGLES))
    (tmp_path / "packets").write_bytes(
        run("decode", "--format", "pcapng", str(tmp_path / "capture")).out
    )
    done = subprocess.run(
        ["tshark", "-n", "-r", str(tmp_path / "packets")],
        env={**os.environ, "HOME": str(tmp_path)}, stdout=subprocess.PIPE, timeout=60, check=True,
    )  # fmt: skip
    assert b"SBGC" in done.stdout and b"GetAngles" in done.stdout

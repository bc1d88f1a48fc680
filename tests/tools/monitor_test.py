"""Tests of sbgc monitor, in terminals of different sizes."""

from __future__ import annotations

import os
import re
import signal
from pathlib import Path

import pytest

from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import run
from screens import Terminal, terminal

KEYS = "1-4, Tab: page   p: pause"


def begin(shell: Terminal, gimbal: EmulatedGimbal) -> list[str]:
    shell.run("monitor", "-p", gimbal.address)
    return shell.wait("motor power")


def angle(lines: list[str], axis: str) -> float:
    (line,) = [line for line in lines if re.match(rf"  {axis} +-?\d", line)][:1]
    return float(line.split()[1])


def test_old_firmware_is_polled(tmp_path: Path) -> None:
    with emulated_gimbal("--firmware", "2.43b9") as gimbal, terminal(tmp_path) as shell:
        assert "firmware 2.43b9" in begin(shell, gimbal)[0]
        shell.press("4")
        shell.wait("instead of a data stream")
        shell.press("q")


def test_pages_at_80x24(tmp_path: Path) -> None:
    with emulated_gimbal("--firmware", "2.70") as gimbal, terminal(tmp_path) as shell:
        lines = begin(shell, gimbal)
        assert len(lines) == 24 and all(len(line) <= 80 for line in lines)
        assert "board 3.6, firmware 2.70" in lines[0] and "connected 00:00:0" in lines[0]
        assert lines[-1].strip().startswith(KEYS)
        text = "\n".join(lines)
        assert re.search(r"battery +1[0-9]\.\d\d V", text) and "errors    none" in text
        assert re.search(r"IMU +\d+ degC", text)
        assert "degrees, vibration in deg/s; positive pitch is down, positive yaw is right" in text
        for axis in ("roll", "pitch", "yaw"):
            assert re.search(rf"^  {axis} .* +\d+ %$", text, re.MULTILINE)
        (current,) = [i for i, line in enumerate(lines) if "current" in line]
        assert lines[current].index("current") == lines[current + 1].index("I2C errors")
        shell.press("2")
        shell.wait(r"pitch power +[\d.]+ %")
        # The ranges of the charts, in two columns.
        span = re.compile(r"[\d.]+ to -?[\d.]+")
        shell.wait(
            lambda now: {one.end() for line in now for one in span.finditer(line)} == {38, 78}
        )
        shell.press("3")
        lines = shell.wait("axes.roll.acc_data")
        shell.press("Down")
        assert "axes.roll.gyro_data" in shell.wait(lambda now: now[3] != lines[3])[3]
        for _ in range(20):
            shell.press("PageDown")
        # The end of the list stays at the end of the screen.
        lines = shell.wait("motor_out")
        assert lines[-2].strip() and lines[-1].strip().startswith(KEYS)
        shell.press("Tab")
        lines = shell.wait("bytes skipped")
        assert f"TCP connection to {gimbal.address[4:]}" in "\n".join(lines)
        assert re.search(r"framing +v2", "\n".join(lines))


def test_the_page_that_is_chosen_is_marked(tmp_path: Path) -> None:
    names = ["1 Overview", "2 Charts", "3 Values", "4 Line"]
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        lines = begin(shell, gimbal)
        assert re.split(" {2,}", lines[1].strip()) == names
        for page, name in enumerate(names):
            shell.press(str(page + 1))
            shell.wait(lambda now: shell.marked(1) == [name])
        assert shell.tmux("display-message", "-p", "#{cursor_flag}").strip() == "0"


@pytest.mark.parametrize("locale", ["C.UTF-8", "C"])
def test_charts_have_a_dot_for_each_message(tmp_path: Path, locale: str) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path, locale=locale) as shell:
        shell.run("monitor", "--rate", "200", "-p", gimbal.address)

        def dots(lines: list[str]) -> list[set[int]]:
            """Returns the columns with dots in the chart of each axis."""
            begin, end = (
                next(i for i, line in enumerate(lines) if re.match(start, line))
                for start in ("  errors ", r" 1-4")
            )
            height = (end - begin - 2) // 3
            charts = [lines[begin + 2 + axis * height :][:height] for axis in range(3)]
            return [
                {x for line in chart for x in range(19, len(line)) if line[x] != " "}
                for chart in charts
            ]

        shell.wait("motor power")
        full = set(range(19, 77))
        lines = shell.wait(lambda now: dots(now) == [full] * 3)
        characters = {one for line in lines[12:23] for one in line[19:77] if one != " "}
        if locale == "C":
            assert characters == {"*"}
        else:
            assert all("\u2800" < one <= "\u28ff" for one in characters), "Braille"
        labels = [re.match(r"  [a-z ]{5} +(-?\d+\.\d\d)( |$)", line) for line in lines[12:23]]
        assert [label.end(1) for label in labels if label] == [17] * 6, "the range of each chart"


def test_resizing_while_it_runs(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        begin(shell, gimbal)
        shell.resize(200, 60)
        lines = shell.wait(lambda now: now[59].strip().startswith(KEYS))
        assert re.search(r"connected \d\d:\d\d:\d\d$", lines[0].rstrip())
        assert len(lines[0].rstrip()) == 199
        assert any(len(line.rstrip()) > 150 for line in lines[12:58]), "charts fill the screen"
        shell.press("3")
        lines = shell.wait("system_state_flags")
        assert "axes." in lines[3] and lines[3].count("   ") > 3, "several columns"
        shell.resize(60, 10)
        lines = shell.wait(lambda now: len(now) == 10 and now[9].strip().startswith(KEYS))
        shell.resize(20, 5)
        shell.wait("too small")
        shell.resize(80, 24)
        shell.wait(lambda now: now[23].strip().startswith(KEYS))


def test_a_small_screen(tmp_path: Path) -> None:
    with emulated_gimbal("--firmware", "2.70") as gimbal, terminal(tmp_path, 40, 10) as shell:
        shell.run("monitor", "-p", gimbal.address)
        lines = shell.wait("balance")
        assert re.fullmatch(r" 3\.6, firmware 2\.70 +connected \d\d:\d\d:\d\d", lines[0].rstrip())
        assert lines[1].split() == "1 Overview 2 Charts 3 Values 4 Line".split()
        assert lines[2].split() == ["angle", "target", "balance"]
        assert all(re.search(r" -?\d+ %$", line) for line in lines[3:6]), lines
        assert re.search(r"motors +ON +battery +1\d\.\d\d V", lines[6])
        assert lines[8].split() == ["errors", "none"]
        assert lines[9].strip() == "1-4, Tab: page   ?: keys   q: quit"
        shell.press("2")
        assert re.fullmatch(r" \?: keys   q: quit +1–3 of 8", shell.wait("of 8")[9])
        for _ in range(9):
            shell.press("Down")
        assert "current" in shell.wait("6–8 of 8")[6]
        shell.press("3")
        lines = shell.wait("1–7 of 5")
        assert lines[2].split()[0].startswith("axes.roll.") and all(lines[2:9])
        assert re.match(r" axes\.roll\.gyro_data {4}\S.* deg/s", lines[3]), "the unit has room"
        shell.press("4")
        lines = shell.wait("TCP connection to$")
        assert lines[3].strip() == gimbal.address[4:], "long texts go on in the next line"


def test_the_keys(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        begin(shell, gimbal)
        shell.press("?")
        lines = shell.wait("pause the display")
        assert shell.marked(1) == [] and "motor power" not in "\n".join(lines)
        shell.press("?")
        shell.wait("motor power")
        shell.press("?")
        shell.wait("pause the display")
        shell.press("2")
        shell.wait("roll power")


def test_a_key_records_and_a_key_marks(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        begin(shell, gimbal)
        shell.press("m")
        shell.wait("^ nothing is recorded: r begins")
        assert list(tmp_path.glob("*.capture")) == []
        shell.press("r")
        shell.wait(r"^ recording to monitor-\d{8}T\d{6}Z\.capture")
        assert "REC  connected" in shell.lines()[0]
        shell.press("m")
        shell.wait("^ mark 1")
        shell.press("m")
        shell.wait("^ mark 2")
        (capture,) = tmp_path.glob("monitor-*.capture")
        shell.wait(lambda _: capture.stat().st_size > 1000)  # with samples
        shell.press("q")
        shell.wait("^sbgc: recorded in monitor-")
    text = run("decode", str(capture)).text
    notes = re.findall(r'note: "(.*)"', text)
    assert notes == [f"TCP connection to {gimbal.address[4:]}", "mark 1", "mark 2"]
    assert "CMD_REALTIME_DATA" in text


def test_a_terminal_that_cannot_be_drawn_on(tmp_path: Path) -> None:
    with terminal(tmp_path) as shell:
        shell.type("TERM=dumb ")
        shell.run("monitor", "-p", "tcp:127.0.0.1:1")
        shell.wait(r"^sbgc: monitor cannot draw on this terminal \(TERM=dumb\)")
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        shell.type("TERM=unheard-of ")
        shell.run("monitor", "-p", gimbal.address)
        shell.wait(r"TERM is 'unheard-of'; `sbgc stream`")


def test_pause_and_zero(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        begin(shell, gimbal)
        shell.press("p")
        paused = shell.wait("PAUSED")
        move = ("move", "--pitch", "-20", "--speed", "60", "--yes")
        assert run(*move, "-p", gimbal.address).status == 0
        assert abs(angle(paused, "pitch")) < 1
        shell.press("p")
        shell.wait(lambda now: angle(now, "pitch") < -19.5)
        shell.press("z")
        shell.wait(
            lambda now: "relative to the zero" in "\n".join(now) and abs(angle(now, "pitch")) < 0.5
        )
        shell.press("z")
        shell.wait(lambda now: angle(now, "pitch") < -19.5)


def test_it_connects_again(tmp_path: Path) -> None:
    gimbal = EmulatedGimbal()
    port = gimbal.address.rsplit(":", 1)[1]
    with terminal(tmp_path) as shell:
        begin(shell, gimbal)
        gimbal.kill()
        shell.wait("NOT CONNECTED")
        with emulated_gimbal("--tcp", port):
            shell.wait(r"connected 00:00:0\d$")
            shell.press("4")
            shell.wait("connection 2")


def test_the_rate_of_the_messages(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        shell.run("monitor", "--rate", "2", "-p", gimbal.address)
        shell.wait("motor power")
        shell.press("4")
        shell.wait(r"received +\d+ frames, (1\.9|2\.[01]) per second of live data")


@pytest.mark.parametrize("way", ["q", "C-c", signal.SIGTERM, signal.SIGHUP, signal.SIGKILL])
def test_the_terminal_is_restored(tmp_path: Path, way: str | signal.Signals) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        before = shell.state()
        begin(shell, gimbal)
        if isinstance(way, str):
            shell.press(way)
        else:
            os.kill(shell.process(), way)
        # The shell's screen is back, with what was on it. After a kill, its prompt may have been
        # printed on the other one.
        lines = shell.wait("monitor -p")
        assert "motor power" not in "\n".join(lines)
        assert shell.state() == before
        assert shell.tmux("display-message", "-p", "#{cursor_flag}#{alternate_on}").strip() == "10"


@pytest.mark.parametrize("way", ["q", signal.SIGKILL])
def test_jog_restores_the_terminal(tmp_path: Path, way: str | signal.Signals) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path) as shell:
        before = shell.state()
        shell.run("jog", "--yes", "-p", gimbal.address)
        shell.wait("q: quit")
        if isinstance(way, str):
            shell.press(way)
        else:
            os.kill(shell.process(), way)
        shell.wait(r"^\$")
        assert shell.state() == before


def test_without_utf8(tmp_path: Path) -> None:
    with emulated_gimbal() as gimbal, terminal(tmp_path, locale="C") as shell:
        text = "\n".join(begin(shell, gimbal))
        assert text.isascii() and "####" in text


def test_the_overview_shows_vibration(tmp_path: Path) -> None:
    with emulated_gimbal("--fault", "resonance=37Hz:10:pitch") as shaking:
        with terminal(tmp_path, 120, 30) as shell:
            shell.run("monitor", "--rate", "50", "-p", shaking.address)

            def shows_it(lines: list[str]) -> bool:
                rows: dict[str, list[str]] = {}
                for words in filter(None, map(str.split, lines)):
                    rows.setdefault(words[0], words)  # before the charts
                head = next((line.split() for line in lines if "deviation" in line), [])
                if "vibration" not in head or "-" in rows.get("pitch", ["-"]):
                    return False
                place = head.index("vibration") + 1
                pitch, roll = (float(rows[axis][place]) for axis in ("pitch", "roll"))
                # The frequencies are those of the same spectrum as that of `sbgc doctor`.
                if not re.search(r"vibration in deg/s from [12] to \d\d Hz", "\n".join(lines)):
                    return False
                # A sine of this amplitude.
                return abs(pitch - 10 / 2**0.5) < 1 and roll < 0.5

            shell.wait(shows_it)

"""Tests of the completion, and of the manual pages."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

from sbgc_command import PROGRAM, run


def candidates(*words: str) -> list[str]:
    lines = run("__complete", "--", *words).text.splitlines()
    return [line.split("\t")[0] for line in lines]


def test_candidates_are_what_the_command_accepts() -> None:
    assert candidates("inf") == ["info"]
    assert candidates("info", "--form") == ["--format"]
    assert candidates("info", "--format", "") == ["text", "json"]
    assert candidates("info", "--format", "j") == ["json"]
    assert candidates("decode", "--hex", "") == [":files"]
    assert {"serial:", "tcp:", "udp:"} <= set(candidates("info", "-p", ""))
    assert candidates("nonsense", "") == candidates("")


def test_names_are_candidates() -> None:
    assert "axes.pitch.p" in candidates("params", "get", "axes.pi")
    assert candidates("params", "get", "pitch.po") == ["pitch.poles", "pitch.power"]
    assert candidates("params", "set", "pitch.po") == ["pitch.poles=", "pitch.power="]
    assert "LPF_FREQ_ROLL" in candidates("vars", "get", "LPF")
    assert candidates("stream", "RealtimeData4") == ["RealtimeData4"]
    assert candidates("send", "get_angles", "") == []
    assert "CMD_MOTORS_ON" in candidates("send", "CMD_MOT")
    assert candidates("send", "Control", "control_m") == ["control_mode="]
    assert "num_vars=" not in candidates("send", "SetAdjVarsVal", ""), "it follows from the others"
    modes = candidates("send", "CMD_CONTROL", "control_mode=MODE_ANGLE")
    assert "control_mode=MODE_ANGLE" in modes and "control_mode=MODE_ANGLE_REL_FRAME" in modes
    assert "MODE_ANGLE" in candidates("describe", "MODE_")
    assert candidates("manual", "dec") == ["decode"]
    assert candidates("decode", "--from", "b") == ["board"]
    assert candidates("calibrate", "g") == ["gyro"]
    assert candidates("calibrate", "gyro", "--imu", "") == ["active", "main", "frame"]
    assert candidates("emulate", "--motion", "") == [
        "rest", "handheld", "drone", "vehicle", ":files"
    ]  # fmt: skip


def test_words_that_people_use_are_candidates_once_begun() -> None:
    assert candidates("params", "get", "tilt.po") == ["tilt.poles", "tilt.power"]
    assert candidates("params", "set", "axes.pan.i") == ["axes.pan.i=", "axes.pan.invert="]
    assert candidates("params", "show", "ti") == ["tilt"]
    assert candidates("params", "show", "vibr") == ["vibration", "vibrations"]
    assert "horizon" in candidates("describe", "hor")
    for command in ("get", "show"):
        names = candidates("params", command, "")
        assert "pitch.power" in names or "pid" in names
        assert not any("tilt" in name.split(".") or name == "gain" for name in names)


def test_parts_of_a_stream_are_candidates() -> None:
    formats = candidates("stream", "RealtimeData4", "--format", "")
    assert sorted(formats) == ["csv", "jsonl", "text"]
    fields = candidates("stream", "RealtimeData4", "--fields", "angle.roll,angle.")
    assert "angle.roll,angle.pitch" in fields
    custom = candidates("stream", "realtime_data_custom", "--fields", "")
    flags = candidates("stream", "realtime_data_custom", "--with", "")
    assert len(custom) > len(flags) > 10
    both = candidates("stream", "realtime_data_custom", "--with", f"{flags[0]}|")
    assert f"{flags[0]}|{flags[1]}" in both
    assert candidates("stream", "Nothing", "--fields", "") == []


def test_names_of_the_protocol_are_candidates() -> None:
    assert candidates("bode", "roll", "--stimulus", "S") == ["SINE_SWEEP"]
    systems = candidates("bode", "roll", "--system", "")
    assert len(systems) == 8 and "OPEN_LOOP_PLANT" in systems
    assert "MENU_CMD_RESET" in candidates("menu", "")


def test_every_listed_command_has_help_and_a_description() -> None:
    commands = [line.split("\t") for line in run("__complete", "--", "").text.splitlines()]
    assert len(commands) > 5
    for name, description in commands:
        assert description
        assert run(name, "--help").status == 0


def test_gimbals_of_the_configuration_are_candidates(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "config.toml"
    file.write_text('[gimbal.front]\nport = "tcp:a:1"\n[gimbal.rear]\nport = "tcp:b:1"\n')
    monkeypatch.setenv("SBGC_CONFIG", str(file))
    assert candidates("info", "-g", "") == ["front", "rear"]
    assert candidates("info", "--gimbal", "f") == ["front"]


def environment() -> dict[str, str]:
    return {**os.environ, "PATH": f"{Path(PROGRAM).resolve().parent}:{os.environ['PATH']}"}


def test_bash() -> None:
    script = """
        source <(sbgc completion bash)
        complete_line() {
          COMP_LINE=$1$2; COMP_POINT=${#COMP_LINE}
          _sbgc sbgc "$2"
          printf '%s\\n' "${COMPREPLY[@]}" end
        }
        complete_line 'sbgc ' inf
        complete_line 'sbgc info --format ' ''
        complete_line 'sbgc info -p ' tcp
        complete_line 'sbgc info -p tcp:' ''
    """
    done = subprocess.run(
        ["bash", "-c", script], env=environment(), capture_output=True, text=True, check=True
    )
    # bash keeps what precedes the colon.
    expected = ["info", "end", "text", "json", "end", "tcp:", "end", "", "end"]
    assert done.stdout.splitlines() == expected
    assert "command not found" not in done.stderr


@pytest.mark.parametrize("name", ["", "decode", "info"])
def test_manual_pages(name: str) -> None:
    page = run("manual", *([name] if name else [])).text
    assert page.startswith(f'.TH "sbgc{"-" + name if name else ""}" 1')
    help_text = run(*([name] if name else []), "--help").text
    for option in re.findall(r"--[a-z][a-z-]+", help_text.split("\n\n")[1]):
        assert option.replace("-", "\\-") in page
    assert not re.search(r"^'", page, re.MULTILINE)
    assert set(re.findall(r"^\.(\w+)", page, re.MULTILINE)) <= {
        *("TH", "SH", "SS", "TP", "PP", "nf", "fi")
    }


def usages() -> dict[str, tuple[str, str]]:
    """Returns the description and the usage of each command and nested command."""
    result = {}
    for command in candidates(""):
        nested = candidates(command, "")
        has_nested = run(command, "--help").text.split("\n", 2)[1].endswith("] COMMAND")
        for name in [[command], *([command, one] for one in nested if has_nested)]:
            description, usage = run(*name, "--help").text.splitlines()[:2]
            result[" ".join(name)] = (description, usage.removeprefix("Usage: "))
    return result


def shape(usage: str) -> str:
    """Returns the usage without the names of its arguments, which the help calls differently."""
    command, arguments = usage.split(" [OPTIONS]")
    return command + re.sub(r"[^\s\[\].]+", "X", arguments)


def test_manual_pages_have_the_description_and_the_synopsis_of_each_command() -> None:
    for name, (description, usage) in usages().items():
        page = run("manual", name.split()[0]).text
        plain = re.sub(r"\\f[BIR]", "", page).replace("\\-", "-")
        if " " in name:
            part = plain.split(f"\n.SS sbgc {name}\n", 1)[1]
            assert part.startswith(f"{description}.\n.PP\nsbgc {name} [OPTIONS]"), name
            synopsis = part.splitlines()[2]
        else:
            assert f"\n.SH NAME\nsbgc-{name} - {description}\n.SH SYNOPSIS\n" in plain
            synopsis = plain.split("\n.SH SYNOPSIS\n", 1)[1].split("\n.SH OPTIONS\n", 1)[0]
        assert shape(synopsis) == shape(usage), name
        assert not re.search(r"[^\n]\.(TH|SH|SS|TP|PP|nf|fi)\b", page), "a request inside a line"


def test_all_manual_pages_are_written(tmp_path: Path) -> None:
    assert run("manual", "--folder", str(tmp_path)).status == 0
    pages = {file.stem for file in tmp_path.iterdir()}
    assert pages == {"sbgc"} | {f"sbgc-{name}" for name in candidates("")}
    assert run("manual", "--folder", str(tmp_path / "missing")).status == 1
    assert "no command 'nothing'" in run("manual", "nothing").error

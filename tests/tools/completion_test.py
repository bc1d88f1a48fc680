"""Tests of the completion and of the manual pages. Names that a shell would obey are arguments only, when they
are completed and entered."""

from __future__ import annotations

import json
import os
import pty
import re
import select
import shlex
import signal
import subprocess
import termios
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Optional

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


START = {
    "bash": ["bash", "--noprofile", "--rcfile", "start", "-i"],
    "zsh": ["zsh", "-d", "-i"],
    "fish": ["fish", "--private", "--init-command", "sbgc completion fish | source", "-i"],
}
START_FILES = {
    "start": "source <(sbgc completion bash)\n",
    ".zshrc": "autoload -U compinit; compinit -u\nsetopt extended_glob\n"
    "source <(sbgc completion zsh)\n",
    # It completes, and otherwise only records its arguments.
    "bin/sbgc": "#!/bin/sh\n"
    f'case $1 in completion | __complete) exec {shlex.quote(PROGRAM)} "$@" ;; esac\n'
    "printf '%s\\0' \"$@\" >got.new && mv got.new got\n",
}


class Shell:
    """A shell with the completion of sbgc."""

    def __init__(self, name: str, folder: Path) -> None:
        self.name = name
        self.folder = folder
        (folder / "bin").mkdir(parents=True)
        for file, text in START_FILES.items():
            (folder / file).write_text(text)
        (folder / "bin/sbgc").chmod(0o755)
        self.shown = b""
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.environ.update(
                PATH=f"{folder}/bin:{os.environ['PATH']}", HOME=str(folder), ZDOTDIR=str(folder)
            )
            os.environ.update(LC_ALL="C.UTF-8", SBGC_PORTS=f"{folder}/ports.json")
            os.execvp(START[name][0], START[name])

    def wait(self, condition: Callable[[], bool], seconds: float) -> bool:
        """Waits for a condition, and reads what the shell shows meanwhile."""
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                return False
            if select.select([self.terminal], [], [], 0.01)[0]:
                self.shown += os.read(self.terminal, 65536)
        return True

    def reads_keys(self) -> bool:
        """True if the shell edits a line; a terminal that runs a command has lines of its own."""
        is_canonical = termios.tcgetattr(self.terminal)[3] & termios.ICANON
        return not is_canonical and os.tcgetpgrp(self.terminal) == self.process

    def press(self, keys: str) -> Optional[list[str]]:
        """Returns the arguments of sbgc after these keys and Enter; None if it did not run."""
        got = self.folder / "got"
        got.unlink(missing_ok=True)
        self.shown = b""
        assert self.wait(self.reads_keys, 20), self.shown
        os.write(self.terminal, keys.encode() + b"\r")
        if self.wait(got.exists, 20):
            return [os.fsdecode(word) for word in got.read_bytes().split(b"\0")[:-1]]
        os.write(self.terminal, b"\x03")
        return None


@contextmanager
def interactive_shell(name: str, folder: Path) -> Iterator[Shell]:
    result = Shell(name, folder)
    try:
        yield result
    finally:
        os.kill(result.process, signal.SIGKILL)
        os.close(result.terminal)
        os.waitpid(result.process, 0)


# Whatever runs one of them makes the file P.
NAMES = [
    *("x$(touch${IFS}P)", "x`touch P`", "x;touch P;", "x\\;touch P;", "x&&touch P|touch P&"),
    *("x<(touch P)>P", "x=$(touch P):~root=~", "x';touch P;'", 'x";touch P;"', "x  two  spaces "),
    *("x'", 'x"', "x\\", "x\\'\\\"$", "x$HOME${HOME}", "x!!!sbgc", "x!", "x*?[a-z]{a,b}", "x~"),
    *("x@y#^%(P)[", "x\u00e4\u00f6 \u20ac", "$(touch P)", "`touch P`", ";touch P", "~root", "=ls"),
    *("#x", "-x", "!!", " x", "'", '"', "\\", "*", "{a,b}", "\u00e4", "%1", "&"),
]  # fmt: skip


@pytest.fixture(scope="module", params=START)
def shell(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Shell]:
    with interactive_shell(request.param, tmp_path_factory.mktemp(request.param)) as result:
        yield result


def write_ports(folder: Path, *ports: dict[str, str]) -> None:
    lists = {"format": "sbgc-ports", "version": 1, "ports": ports}
    (folder / "ports.json").write_text(json.dumps(lists))


def typed(first: str) -> list[str]:
    """Returns the ways to type the first character of a name."""
    if first.isalnum():
        return [first, f"'{first}", f'"{first}', f"'{first}'", f"''{first}"]
    return [f"\\{first}", *([] if first in "'\\" else [f"'{first}"])]


@pytest.mark.parametrize("number,name", enumerate(NAMES), ids=NAMES)
def test_a_completed_name_is_one_argument(shell: Shell, number: int, name: str) -> None:
    """The first names begin in all ways; of the others, each in the next one."""
    write_ports(shell.folder, {"name": name})
    ways = typed(name[0])
    for way in ways if number < 3 else [ways[number % len(ways)]]:
        arguments = shell.press(f"sbgc info -p {way}\t")
        assert arguments == ["info", "-p", name], (way, shell.shown)
        assert not (shell.folder / "P").exists()


def test_a_common_beginning_of_names_is_completed(shell: Shell) -> None:
    write_ports(shell.folder, {"name": "x$(touch P)'a b"}, {"name": "x$(touch P)'a c"})
    for way in ["x", "'x", '"x']:
        keys = {"'": "c'", '"': 'c"'}.get(way[0], "c")
        arguments = shell.press(f"sbgc info -p {way}\t{keys}")
        assert arguments == ["info", "-p", "x$(touch P)'a c"], shell.shown
    assert not (shell.folder / "P").exists()


@pytest.mark.parametrize(
    "name", ["x$(touch${IFS}P)", "x`touch P`", "x; touch P", "x'y\"z", "x\\y", "x!!", "x*{a,b}"]
)
def test_a_completed_file_is_one_argument(shell: Shell, name: str) -> None:
    (shell.folder / name).touch()
    # zsh itself does not close a quote that the name of a file contains.
    ways = [way for way in ["x", "'x", '"x'] if way[0] == "x" or way[0] not in name]
    got = [shell.press(f"sbgc decode {way}\t") for way in ways]
    (shell.folder / name).unlink()
    assert got == [["decode", name]] * len(ways), shell.shown
    assert not (shell.folder / "P").exists()


def completed(*words: str, **environment: str) -> list[bytes]:
    return run("__complete", "--", *words, env={**os.environ, **environment}).out.splitlines()


def test_control_characters_and_other_bytes_are_not_offered(tmp_path: Path) -> None:
    others = ["\n", "\t", "\r", "\0", "\x1b[31m", "\x7f", "\x9b", "\x85"]
    write_ports(
        tmp_path,
        *({"name": f"x{other}y"} for other in others),
        *({"name": f"z{i}", "description": f"a{other}b"} for i, other in enumerate(others)),
    )
    lines = completed("info", "-p", "", SBGC_PORTS=str(tmp_path / "ports.json"))
    assert [line for line in lines if line.startswith((b"x", b"z"))] == [
        b"z0\ta",
        *(f"z{i}\ta?{'[31m' if i == 4 else ''}b".encode() for i in range(1, len(others))),
    ]
    file = tmp_path / "config.toml"
    file.write_text(
        '[gimbal."x\\u001bz"]\nport="a"\n[gimbal."x\\u009b"]\nport="a"\n'
        '[gimbal."x$(touch P)"]\nport="\\u001b[31m\\u009b"\n'
    )
    assert completed("info", "-g", "", SBGC_CONFIG=str(file)) == [b"x$(touch P)\t?[31m?"]
    assert completed("stream", "RealtimeData4", "--fields", "\x1b[31m,") == []

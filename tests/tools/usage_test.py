"""Tests of the sbgc command: wrong usage, texts that come from an editor of Windows or are none, unreadable
input and unwritable output. Commands refuse before they ask what cannot succeed, and ask for what they name."""

from __future__ import annotations

import fcntl
import os
import pty
import re
import struct
import subprocess
import termios
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from board_command import Terminal, answer_on_terminal
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import MODEL, PROGRAM, ROOT, Result, frame, run

GET_ANGLES = frame(73)
LINE = '{"message":"GetAnglesRequest","fields":{}}\n'


def test_version() -> None:
    """The first line has the version, which is defined only in version.hpp."""
    header = ROOT / "runtime" / "core" / "include" / "sbgc" / "version.hpp"
    numbers = re.findall(r"#define SBGC_VERSION_[A-Z]+ (\d+)$", header.read_text("utf-8"), re.M)
    version, protocol, model = run("--version").text.splitlines()
    assert version == f"sbgc {'.'.join(numbers)}"
    facts = MODEL["protocol"]
    revision, newest = f"{facts['revision']} ({facts['date']})", facts["newest_firmware"]
    assert protocol == f"protocol: {facts['name']}, revision {revision} and firmware up to {newest}"
    assert model == f"model: {MODEL['fingerprint']}"


COMMANDS = ("decode", "emulate", "encode", "ports", "record")
HELP = [["--help"], ["--help-all"]] + [[command, "--help"] for command in COMMANDS]


def test_help_of_a_command() -> None:
    assert run("help").text == run("--help").text
    page = run().text
    assert page.startswith("To begin with:\n  sbgc ports") and page.count("\n") < 24
    named = re.findall(r"(\w+)(?:, |$)", page.partition("All commands:")[2], re.MULTILINE)
    assert named == [name for names in commands_by_heading().values() for name in names]
    for words in (["stream"], ["params", "get"], ["help"]):
        assert run("help", *words).text == run(*words, "--help").text
    assert "unknown command 'x?[2J'" in run("x\x1b[2J").error


def test_the_first_commands_without_a_gimbal_work(tmp_path: Path) -> None:
    readme = (ROOT / "README.md").read_text("utf-8")
    for text in (run().text, readme):
        found = re.search(
            r"sbgc (emulate --link \S+) &.*?sbgc (-p \S+) (?:info|monitor)", text, re.S
        )
        assert found
        with subprocess.Popen(
            [PROGRAM, *found[1].split()], cwd=tmp_path, stdout=subprocess.PIPE
        ) as emulator:
            assert emulator.stdout and emulator.stdout.readline()
            assert run(*found[2].split(), "info", cwd=tmp_path).status == 0
            emulator.terminate()


def test_the_options_of_a_gimbal_are_explained_once() -> None:
    connection = run("help", "connection").text
    for option in ("-p,--port ADDRESS", "--attempt-time TIME", "--password-file FILE", "[gimbal."):
        assert option in connection
        for words in ([], ["info"], ["params", "get"]):
            assert option not in run(*words, "--help").text
    for words in ([], ["info"]):
        assert "-p ADDRESS, -g GIMBAL" in run(*words, "--help").text
    assert "-p ADDRESS" not in run("decode", "--help").text
    pages = {name: run("manual", *name).text for name in ((), ("info",), ("params",))}
    assert r"\-\-attempts" in pages[()]
    for name in (("info",), ("params",)):
        assert r"\-\-attempts" not in pages[name]
        assert r"\fB\-p\fR \fIADDRESS\fR and others, are in \fBsbgc\fR(1)." in pages[name]


def commands_by_heading() -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for line in run("--help").text.splitlines():
        if heading := re.fullmatch(r"(\w+):", line):
            names = found.setdefault(heading[1], [])
        elif command := re.match(r"  ([a-z]+)  +\S", line):
            names.append(command[1])
    return {heading: names for heading, names in found.items() if names}


def test_the_guide_lists_the_commands_of_the_help() -> None:
    guide = (ROOT / "docs/12-command.md").read_text("utf-8")
    rows = re.findall(r"^\| (\w+) \| (`.*`) \|$", guide, re.MULTILINE)
    listed = {purpose.capitalize(): re.findall(r"`(\w+)`", names) for purpose, names in rows}
    assert listed == commands_by_heading()


def test_help_tells_what_the_exit_status_means() -> None:
    only_success_or_failure = {"completion", "help", "manual", "params", "ports", "vars"}
    for command in set(sum(commands_by_heading().values(), [])) - only_success_or_failure:
        text = " ".join(run(command, "--help").text.split())
        assert re.search(r"[Tt]he exit status is .* 2 for wrong usage", text), text


def lines_of_help(arguments: list[str], **environment: str) -> list[str]:
    """Returns the lines of the help if the standard output is not a terminal."""
    plain = {key: value for key, value in os.environ.items() if key != "COLUMNS"}
    return run(*arguments, env={**plain, **environment}).text.splitlines()


@pytest.mark.parametrize("arguments", HELP)
def test_help_breaks_lines_between_words(arguments: list[str]) -> None:
    words = " ".join(lines_of_help(arguments, COLUMNS="2000")).split()
    for columns in ("", "40", "60", "80", "132", "nonsense"):
        lines = lines_of_help(arguments, COLUMNS=columns)
        assert " ".join(lines).split() == words, "nothing is lost, no word is broken"
        width = int(columns) if columns.isdigit() else 80
        # Examples and names of options are not wrapped.
        whole = re.compile(" +((sbgc|emulated gimbal|-)|[^ ]+$)")
        assert not [line for line in lines if len(line) > width and not whole.match(line)]
        if width >= 80:
            assert max(map(len, lines)) <= width


@pytest.mark.parametrize("arguments", HELP)
def test_paragraphs_of_the_help_are_filled(arguments: list[str]) -> None:
    lines = lines_of_help(arguments, COLUMNS="100")
    for line, following in zip(lines, lines[1:]):
        is_heading = line.endswith(":")
        if re.match("[A-Za-z]", line) and re.match("[a-z]", following) and not is_heading:
            assert len(line) + 1 + len(following.split()[0]) > 100, line


def test_the_names_of_options_take_three_eighths_of_a_narrow_terminal() -> None:
    for columns, names in (("40", 15), ("48", 18), ("80", 30), ("132", 30)):
        (line,) = [
            line
            for line in lines_of_help(["ports", "--help"], COLUMNS=columns)
            if "-h,--help" in line
        ]
        assert line.index("Print") == names


def test_help_is_as_wide_as_the_terminal() -> None:
    plain = {key: value for key, value in os.environ.items() if key != "COLUMNS"}
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("<4H", 24, 61, 0, 0))
    with subprocess.Popen([PROGRAM, "ports", "--help"], stdout=slave, env=plain) as process:
        os.close(slave)
        text = b""
        while b"Output format" not in text:
            text += os.read(master, 4096)
        assert process.wait(60) == 0
    os.close(master)
    assert b"\x1b[1mOptions:\x1b[0m" in text, "headings are bold"
    plain_text = re.sub(r"\x1b\[\d+m", "", text.decode())
    shown = plain_text.replace("\r\n", "\n").splitlines()
    assert shown == lines_of_help(["ports", "--help"], COLUMNS="61")[: len(shown)]


def test_errors_are_red_on_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    def shown(**environment: str) -> str:
        for name, value in {"TERM": "xterm", "NO_COLOR": "", **environment}.items():
            monkeypatch.setenv(name, value)
        terminal = Terminal("movee")
        assert terminal.status() == 2
        return terminal.shown.decode().replace("\r\n", "\n")

    colored = shown()
    assert colored.startswith("\x1b[1m\x1b[31msbgc:\x1b[0m\x1b[0m unknown command 'movee'")
    assert "\x1b[32m'move'\x1b[0m" in colored and "\x1b[32msbgc --help\x1b[0m" in colored
    plain = run("movee").error
    assert re.sub(r"\x1b\[\d+m", "", colored) == plain
    assert "\x1b" not in plain and shown(NO_COLOR="1") == plain == shown(TERM="dumb")


def assert_one_complaint(result: Result) -> None:
    assert result.status == 1
    (complaint,) = re.findall(r"^sbgc: .*writ.*", result.error, re.MULTILINE)
    assert "standard output" in complaint


@pytest.mark.parametrize(
    "arguments, stdin",
    [(arguments, b"") for arguments in HELP]
    + [
        (["--version"], b""),
        (["decode"], GET_ANGLES),
        (["decode"], GET_ANGLES * 2000),
        (["decode"], b""),
        (["decode", "--format", "jsonl"], GET_ANGLES),
        (["decode", "--format", "jsonl"], GET_ANGLES * 2000),
        (["decode", "--hex"], GET_ANGLES.hex().encode()),
        (["encode"], LINE.encode()),
        (["encode"], LINE.encode() * 2000),
        (["encode", "--hex"], LINE.encode()),
        (["ports"], b""),
        (["ports", "--format", "json"], b""),
        (["describe"], b""),
        (["menu", "--list"], b""),
        (["calibrate", "--list"], b""),
        (["completion", "bash"], b""),
        (["manual", "decode"], b""),
        (["record", "pty:", "/dev/null", "--seconds", "0"], b""),
        (["record", "pty:", "-", "--seconds", "0"], b""),
        (["emulate", "--seconds", "0"], b""),
    ],
)
def test_output_that_cannot_be_written(arguments: list[str], stdin: bytes) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("no /dev/full")
    with open("/dev/full", "wb") as full:
        result = run(*arguments, stdin=stdin, stdout=full.fileno())
    assert_one_complaint(result)


@pytest.fixture(scope="module")
def gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal() as running:
        yield running


@pytest.mark.parametrize(
    "command",
    [
        *("info", "info --format json", "params show", "params show --format json"),
        *("params get pitch.p", "params profiles", "params profiles --format json"),
        *("params set pitch.p=99 --dry-run", "params rename 1 x --yes", "vars list"),
        *("vars list --format json", "vars set LPF_FREQ_ROLL=31Hz --yes", "script list"),
        *(
            "send CMD_GET_ANGLES",
            "send CMD_GET_ANGLES --format jsonl",
            "send CMD_GET_ANGLES --dry-run",
        ),
        *("stream RealtimeData4 --for 0.2s", "stream RealtimeData4 --for 0.2s --format csv"),
        *("record --for 0.2s -", "record --for 0.2s /dev/null"),
    ],
)
def test_output_of_a_gimbal_that_cannot_be_written(gimbal: EmulatedGimbal, command: str) -> None:
    with open("/dev/full", "wb") as full:
        result = run(*command.split(), "-p", gimbal.address, stdout=full.fileno())
    assert_one_complaint(result)


@pytest.fixture(name="new_gimbal", scope="module")
def one_new_gimbal() -> Iterator[EmulatedGimbal]:
    with emulated_gimbal("--firmware", "2.72", "--board", "3.6") as new_gimbal:
        yield new_gimbal


@pytest.mark.parametrize("answer", ["y", "Y", "yes", "YES", "Yes"])
def test_yes_in_any_case(new_gimbal: EmulatedGimbal, answer: str) -> None:
    assert answer_on_terminal(answer, "motors", "OFF", "-p", new_gimbal.address).status == 0


def about_profiles() -> list[str]:
    return [
        message["name"]
        for message in MODEL["messages"]
        if message["direction"] == "to_board"
        and "stores" in message["effect"]["does"]
        and any(field["path"] == "profile_id" for field in message["layout"])
    ]


@pytest.mark.parametrize("message", about_profiles())
def test_a_profile_is_named_as_people_count(new_gimbal: EmulatedGimbal, message: str) -> None:
    def asked(*values: str) -> str:
        command = ("send", message, *values, "--no-validate", "-p", new_gimbal.address)
        return " ".join(run(*command).error.split())

    assert "with profile_id = 1 (profile 2)" in asked("profile_id=1")
    assert asked("profile_id=1").count("profile_id") == 1
    assert "with profile_id = 4 (profile 5)" in asked("PROFILE_ID=raw:4")
    assert "(profile 1)" in asked() or "(profile 5)" in asked(), "a default is named, too"


FLEET = '[fleet]\nname = "studio"\n[metrics]\n[gimbal.front]\nport = "tcp:127.0.0.1:1"\n'
MOTION = "time,roll,pitch,yaw\n0,0,0,0\n1,10,0,0\n"
READERS: dict[str, tuple[str, Callable[[str], Result]]] = {
    "configuration": ("[gimbal.a]\nport = 'capture:/none'\n", lambda _: run("info", "-g", "a")),
    "fleet": (FLEET, lambda file: run("gateway", "--config", file, "--check")),
    "motion": (MOTION, lambda file: run("emulate", "--stdio", "--for", "10ms", "--motion", file)),
    "table": ("t,a\n0,0\n1,1\n", lambda file: run("plot", file)),
    "json": ('{"message":"GetAnglesRequest","fields":{}}\n', lambda file: run("encode", file)),
}


@pytest.mark.parametrize("kind", READERS)
def test_ends_of_lines_and_byte_order_marks(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text, read = READERS[kind]
    file = tmp_path / "file"
    monkeypatch.setenv("SBGC_CONFIG", str(file))
    content = text.encode()
    file.write_bytes(content)
    plain = read(str(file))
    assert "file:" not in plain.error, "the text itself is right"
    for other in (b"\xef\xbb\xbf" + content, content.replace(b"\n", b"\r\n")):
        file.write_bytes(other)
        assert read(str(file)) == plain
    for damaged in (content[:-3] + b"\0" + content[-3:], text.encode("utf-16")):
        file.write_bytes(damaged)
        refused = read(str(file))
        assert refused.status in (1, 2) and refused.error and not refused.out


def test_lines_of_the_shell() -> None:
    script = b"describe MODE_ANGLE\ndescribe pid\n"
    with emulated_gimbal() as gimbal:
        plain = run("shell", "-p", gimbal.address, stdin=script)
        assert plain.status == 0
        other = b"\xef\xbb\xbf" + script.replace(b"\n", b"\r\n")
        assert run("shell", "-p", gimbal.address, stdin=other).out == plain.out
        refused = run("shell", "-p", gimbal.address, stdin=b"describe pid\ndescribe\0 pid\n")
    assert refused.status == 1 and "line 2 has a NUL byte" in refused.error

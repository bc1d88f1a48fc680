"""Tests of the sbgc command: wrong usage, unreadable input and unwritable output."""

from __future__ import annotations

import fcntl
import os
import pty
import re
import struct
import subprocess
import termios
from collections.abc import Iterator
from pathlib import Path

import pytest

from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import MODEL, PROGRAM, ROOT, Result, frame, run

GET_ANGLES = frame(73)
LINE = '{"message":"GetAnglesRequest","fields":{}}\n'


@pytest.mark.parametrize(
    "arguments",
    [
        ["nonsense"],
        ["params"],
        ["help", "nonsense"],
        ["decode", "--format", "xml"],
        ["decode", "--format"],
        ["decode", "--from", "mars"],
        ["decode", "--nonsense"],
        ["decode", "one", "two"],
        ["encode", "--from", "host"],
        ["encode", "one", "two"],
        ["ports", "--format", "jsonl"],
        ["ports", "one"],
        ["record"],
        ["record", "pty:"],
        ["record", "pty:", "file", "--seconds", "soon"],
    ],
)
def test_wrong_usage(arguments: list[str]) -> None:
    result = run(*arguments)
    assert result.status == 2
    assert result.out == b""


OTHER_WORDS = (
    "mode code body pose note node done log step save type tone trigger second model table"
).split()
"""They look like commands that move the camera or write, and mean something else."""


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["params"], "expected a command: "),
        (["teleport"], "unknown command 'teleport'"),
        (["ifno"], "unknown command 'ifno'; did you mean 'info'?"),
        (["info", "--prot", "x"], "unknown option '--prot'; did you mean '--port'?"),
        (["decod"], "unknown command 'decod'; did you mean 'decode'?"),
        (["encdoe", "--hex", "file"], "unknown command 'encdoe'; did you mean 'encode'?"),
        (["emulator", "--help"], "unknown command 'emulator'; did you mean 'emulate'?"),
        (["rec"], "unknown command 'rec'; did you mean 'record'?"),
        (["INFO"], "unknown command 'INFO'; did you mean 'info'?"),
        (["params", "help", "show"], "unknown command 'help'; did you mean '--help'?"),
        (["home"], "unknown command 'home'; did you mean 'menu home_position'?"),
        (["reboot"], "unknown command 'reboot'; did you mean 'reset'?"),
        (["mvoe"], "unknown command 'mvoe'; did you mean 'move'?"),
        (["sped"], "unknown command 'sped'; did you mean 'speed'?"),
        (["streem"], "unknown command 'streem'; did you mean 'stream'?"),
        *[([word], f"unknown command '{word}'\n") for word in OTHER_WORDS],
        (["hlp"], "unknown command 'hlp'; did you mean 'help'"),
        (["--verson"], "unknown option '--verson'; did you mean '--version'?"),
        (["decode", "--hx"], "unknown option '--hx'; did you mean '--hex'?"),
        (["decode", "--fomat=jsonl"], "unknown option '--fomat=jsonl'; did you mean '--format'?"),
        (["emulate", "--tpc", "5000"], "unknown option '--tpc'; did you mean '--tcp'?"),
        (["decode", "--qqqqqq"], "unknown option '--qqqqqq'\n"),
        (["ports", "one"], "unexpected argument 'one'"),
        (["x\x1b[2J"], "unknown command 'x?[2J'"),
    ],
)
def test_wrong_usage_says_what_may_have_been_meant(arguments: list[str], words: str) -> None:
    result = run(*arguments)
    assert result.status == 2
    assert result.error.startswith(f"sbgc: {words}")
    assert re.search(r"^Run `sbgc.* --help` for help\.$", result.error, re.MULTILINE)


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


@pytest.mark.parametrize("arguments", HELP)
def test_help(arguments: list[str]) -> None:
    result = run(*arguments)
    assert result.status == 0
    assert "Usage" in result.text


def test_help_of_a_command() -> None:
    assert run("help").text == run("--help").text
    page = run().text
    assert page.startswith("To begin with:\n  sbgc ports") and page.count("\n") < 24
    named = re.findall(r"(\w+)(?:, |$)", page.partition("All commands:")[2], re.MULTILINE)
    assert named == [name for names in commands_by_heading().values() for name in names]
    for words in (["stream"], ["params", "get"], ["help"]):
        assert run("help", *words).text == run(*words, "--help").text
    wrong = run("help", "params", "gte")
    assert wrong.status == 2 and "no help for 'gte'; did you mean 'get'?" in wrong.error


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
            done = subprocess.run([PROGRAM, *found[2].split(), "info"], cwd=tmp_path, check=False)
            emulator.terminate()
        assert done.returncode == 0


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
    done = subprocess.run(
        [PROGRAM, *arguments], env={**plain, **environment}, capture_output=True, check=True
    )
    return done.stdout.decode().splitlines()


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


def test_errors_are_red_on_a_terminal() -> None:
    def shown(**environment: str) -> str:
        master, slave = pty.openpty()
        names = {**os.environ, "TERM": "xterm", "NO_COLOR": "", **environment}
        subprocess.run([PROGRAM, "movee"], stderr=slave, env=names, timeout=60, check=False)
        os.close(slave)
        text = os.read(master, 4096).decode()
        os.close(master)
        return text.replace("\r\n", "\n")

    colored = shown()
    assert colored.startswith("\x1b[1m\x1b[31msbgc:\x1b[0m\x1b[0m unknown command 'movee'")
    assert "\x1b[32m'move'\x1b[0m" in colored and "\x1b[32msbgc --help\x1b[0m" in colored
    plain = run("movee").error
    assert re.sub(r"\x1b\[\d+m", "", colored) == plain
    assert "\x1b" not in plain and shown(NO_COLOR="1") == plain == shown(TERM="dumb")


@pytest.mark.parametrize("command", ["decode", "encode"])
def test_input_that_cannot_be_read(command: str, tmp_path: Path) -> None:
    missing = run(command, str(tmp_path / "missing"))
    assert missing.status == 1 and str(tmp_path / "missing") in missing.error
    folder = run(command, str(tmp_path))
    assert folder.status == 1 and str(tmp_path) in folder.error
    empty = run(command, "")
    assert empty.status == 1
    if os.geteuid() != 0:
        secret = tmp_path / "secret"
        secret.write_bytes(GET_ANGLES)
        secret.chmod(0)
        assert run(command, str(secret)).status == 1


@pytest.mark.parametrize(
    "text, place",
    [
        ("3e4", "line 1 column 3"),
        ("3e4 9", "line 1 column 4"),
        ("3e49\n00 zz", "line 2 column 4"),
        ("3e 04 4\n", "line 1"),
        ("# ok\n3e 49 00 49 00\n\n3e!", "line 4 column 3"),
        ("\x01", "line 1 column 1"),
    ],
)
def test_text_that_is_not_hex(text: str, place: str) -> None:
    result = run("decode", "--hex", "--format", "jsonl", stdin=text)
    assert result.status == 1
    assert place in result.error


def test_what_is_before_a_bad_digit_is_decoded_once() -> None:
    for text in ("3e49004900 3e49004900 3", "3e49004900 3e49004900 x"):
        result = run("decode", "--hex", "--format", "jsonl", stdin=text)
        assert result.status == 1
        assert [line["offset"] for line in result.objects] == [0, 5]


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


@pytest.mark.parametrize(
    "arguments",
    [
        ["stream", "RealtimeData4", "--rate", "nan"],
        ["monitor", "--rate", "nan"],
        ["record", "file", "--seconds", "inf"],
        ["replay", "file", "--speed", "nan"],
    ],
)
def test_options_need_finite_numbers(arguments: list[str]) -> None:
    result = run(*arguments)
    assert result.status == 2
    assert "is not a number from" in result.error


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (["record"], "[OPTIONS] [ADDRESS] FILE\n"),
        (["params", "diff"], "[OPTIONS] [FILE...]\n"),
        (["emulate"], "--count NUMBER (1)"),
        (["emulate"], "--input-buffer BYTES (0)"),
        (["emulate"], "--tcp [HOST:]PORT"),
    ],
)
def test_help_names_values(command: list[str], words: str) -> None:
    assert words in run(*command, "--help").text


def test_words_have_any_case() -> None:
    for word in ("JSONL", "Jsonl", "jsonl"):
        decoded = run("decode", "--from", "BOARD", "--format", word, stdin=frame(67, b"\0\0"))
        assert decoded.objects[0]["direction"] == "from_board"
    assert run("emulate", "--parity", "EVEN", "--baud", "Settings", "--seconds", "0").status == 0
    assert "unknown calibration" not in run("calibrate", "GYRO", "-p", "TCP:127.0.0.1:1").error
    assert run("completion", "BASH").text == run("completion", "bash").text


@pytest.mark.parametrize(
    "arguments, words",
    [
        (("vars", "get"), "VARIABLE is missing"),
        (("move", "--pitch", "abc"), "--pitch must be a number in deg, not 'abc'"),
        (("move", "--pitch", "nan", "--yes"), "--pitch must be a number in deg, not 'nan'"),
        (("move", "--pitch"), "--pitch needs a value"),
        (("info", "--timeout", "0"), "--timeout: '0' is not a duration; write 500ms"),
        (("info", "--timeout", "nan"), "--timeout: 'nan' is not a duration"),
        (("info", "--attempt-time", "-1"), "--attempt-time: '-1' is not a duration"),
        (("params", "diff", "--format", "xml"), "--format must be text or json, not 'xml'"),
        (("params", "backup", "-"), "name a file"),
    ],
)
def test_errors_are_sentences(arguments: tuple[str, ...], words: str) -> None:
    result = run(*arguments)
    assert result.status == 2 and words in result.error

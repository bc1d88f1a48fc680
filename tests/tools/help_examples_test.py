"""Tests that what the help recommends works: its examples, commands and names."""

from __future__ import annotations

import json
import os
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest

from captures import FROM_BOARD, record, session
from emulated_gimbal import EmulatedGimbal, emulated_gimbal
from sbgc_command import PROGRAM, run
from screens import terminal

PATIENCE = 60.0
VENDOR_FILE = Path(__file__).parents[2] / "tests/data/studio.profile"

SERVERS = ("emulate", "bridge", "replay")
"""Commands that go on until a signal."""

INTERACTIVE = {
    "monitor": ("motor power", "q"),
    "jog": ("q: quit", "q"),
    "shell": ("^sbgc>$", "C-d"),
}
"""Commands that need a terminal: what they show, and the key that ends them."""

OTHERS = {
    *("SBGC_CONFIG", "SBGC_PORTS", "SBGC_TOKEN", "NO_COLOR"),
    *("MENU_CMD_", "FLAG_A", "FLAG_B", "MiB", "NaN", "SimpleBGC", "WebSocket", "WebSockets"),
}
"""Words in the help that look like names of the protocol, but are not."""

NAME = re.compile(r"\b(?:[A-Z][A-Z0-9]*_[A-Z0-9_]*|[a-z]+(?:_[a-z0-9]+)+|[A-Z][a-z]+[A-Z0-9]\w*)")


def help_of_commands(*path: str) -> Iterator[tuple[tuple[str, ...], str]]:
    text = run(*path, "--help").text
    usage = " ".join(["Usage: sbgc", *path])
    if not re.search(rf"^{usage}( |$)", text, re.MULTILINE):
        return  # an argument, not a command
    yield path, text
    for word in re.findall(r"^  ([a-z]+)(?:  .*)?$", text, re.MULTILINE):
        yield from help_of_commands(*path, word)


HELP = dict(help_of_commands())


def examples() -> list[str]:
    """Indented lines with a command, without what is before it, such as the name of a shell."""
    found = [
        re.sub(r"^(bash|zsh|fish): +", "", line.strip())
        for text in HELP.values()
        for line in text.splitlines()
        if re.match(r" .*\bsbgc [a-z]", line) and not line.lstrip().startswith("-")
    ]
    return [line for line in found if re.match(r"(sbgc|source) ", line)]


def capture() -> bytes:
    """Has what the examples look for."""
    frames: list[dict[str, Any]] = [
        {"message": "Confirm", "fields": {"cmd": "CMD_CONTROL"}},
        {
            "message": "RealtimeData4",
            "fields": {"angle": {"pitch": 1000}, "system_error": "ERR_LOW_BAT1"},
        },
    ]
    lines = "".join(json.dumps(frame) + "\n" for frame in frames)
    return session() + record(FROM_BOARD, 1, run("encode", "--defaults", stdin=lines).out)


def prepare(gimbal: EmulatedGimbal, *command: str) -> None:
    assert run(*command, "-p", gimbal.address).status == 0


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder in which `sbgc` finds a gimbal with running motors, and what examples name."""
    path = tmp_path_factory.mktemp("examples")
    modules = ("--board", "3.6", "--firmware", "2.70b0")
    quick = ("--calibration-time", "5")
    with (
        emulated_gimbal(*modules, *quick, "--link", f"{path}/gimbal") as gimbal,
        emulated_gimbal("--board", "3.6", "--firmware", "2.74.5") as newest,
    ):
        for name, address in (("ports", gimbal.address), ("newest", newest.address)):
            ports = {"name": address, "description": "", "usb": None}
            document = {"format": "sbgc-ports", "version": 1, "ports": [ports]}
            (path / f"{name}.json").write_text(json.dumps(document))
        studio = VENDOR_FILE.read_text().replace("<boardVer>31<", "<boardVer>36<")
        (path / "studio.profile").write_text(studio)
        (path / "sbgc").symlink_to(PROGRAM)
        for name in ("gimbals", ".zfunc", ".config/fish/completions"):
            (path / name).mkdir(parents=True)
        (path / "capture").write_bytes(capture())
        fleet = f'[fleet]\nname = "a"\n[metrics]\nlisten = "127.0.0.1:0"\n'
        (path / "fleet.toml").write_text(fleet + f'[gimbal.b]\nport = "{gimbal.address}"\n')
        (path / "commands").write_text("info\nparams get pitch.p\n")
        (path / "frames.jsonl").write_text('{"message": "CMD_MOTORS_ON", "fields": {}}\n')
        for name in ("part", "driver"):
            (path / f"{name}.bin").write_bytes(b"\0" * 64)
        for name in ("gimbal", "other"):
            prepare(gimbal, "params", "backup", f"{path}/{name}.json")
        for number in ("0", "5"):
            prepare(gimbal, "files", "put", number, f"{path}/part.bin", "--yes")
        prepare(gimbal, "motors", "on", "--yes")
        yield path


def in_folder(folder: Path, example: str) -> str:
    """Returns the example with a place here for each place that it names, and shorter times."""
    gimbal = f"serial:{folder}/gimbal?baud=115200"
    for place, here in (
        ("/dev/ttyUSB0", gimbal),
        ("tcp:10.0.0.7:5000", gimbal),
        ("/tmp/gimbal", f"{folder}/link"),
        ("--tcp 5000", "--tcp 0"),
        ("--for 20s", "--for 1s"),
        ("--seconds 8", "--seconds 4"),
    ):
        example = example.replace(place, here)
    command = re.match(r"sbgc ([a-z]+(?: [a-z]+)?)", example)
    path = tuple(command[1].split()) if command else ()
    text = HELP.get(path) or HELP.get(path[:1], "")
    has_question = "-y,--yes" in text and not re.search("--dry-run|diff gimbal", example)
    is_asking = has_question and "--yes" not in example
    return f"{example} --yes" if is_asking else example


def run_on_terminal(
    folder: Path, example: str, environment: dict[str, str], shown: str, key: str
) -> None:
    with TemporaryDirectory() as own, terminal(Path(own), environment=environment) as screen:
        screen.enter(f"cd {folder}; {example}")
        screen.wait(shown)
        screen.press(key)
        screen.wait(r"^\$$")
        screen.enter("echo status $?")
        screen.wait("^status 0")


@pytest.mark.parametrize("example", examples())
def test_examples_work(folder: Path, example: str) -> None:
    (folder / "link").unlink(missing_ok=True)
    environment = {
        **os.environ,
        "HOME": str(folder),
        "PATH": f"{folder}:{os.environ['PATH']}",
        # The newest board loads firmware into modules, but does not tune.
        "SBGC_PORTS": str(folder / f"{'newest' if ' module ' in example else 'ports'}.json"),
    }
    needs = INTERACTIVE.get(example.split()[1])
    if needs and "<" not in example:
        return run_on_terminal(folder, in_folder(folder, example), environment, *needs)
    shell = ["bash", "-c", "exec " * example.startswith("sbgc ") + in_folder(folder, example)]
    with subprocess.Popen(
        shell, cwd=folder, env=environment, stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    ) as process:  # fmt: skip
        assert process.stdout is not None
        first = b""
        if example.split()[1] in SERVERS:
            first = process.stdout.readline()
            process.terminate()
        out, error = process.communicate(timeout=PATIENCE)
    # 1: there are differences.
    statuses = (0, 1) if example.startswith("sbgc params diff") else (0,)
    assert process.returncode in statuses, (out, error)
    is_silent = ">" in example or example.startswith(("source ", "sbgc params diff gimbal"))
    assert first + out + error or is_silent, "nothing happens"


def test_every_command_has_an_example() -> None:
    known = examples()
    for path in HELP:
        nested = any(other[: len(path)] == path and other != path for other in HELP)
        if path and not nested:
            command = " ".join(["sbgc", *path])
            assert any(re.search(rf"{command}( |$|\))", example) for example in known), command


def test_commands_in_sentences_exist() -> None:
    for path, text in HELP.items():
        for command in re.findall(r"`sbgc ([^`|]*)", " ".join(text.split())):
            words = [word for word in command.split() if not word.startswith("--")]
            options = [word for word in command.split() if word.startswith("--")]
            if words == ["COMMAND"]:
                continue
            assert tuple(words[:1]) in HELP, (path, command)
            described = run(*words, "--help")
            assert described.status == 0, (path, command)
            assert all(option in described.text for option in options), (path, command)


def test_names_exist() -> None:
    names = {name for text in HELP.values() for name in NAME.findall(text)} - OTHERS
    assert {"CMD_CONTROL", "MODE_ANGLE", "RealtimeData4", "get_angles"} <= names
    unknown = [name for name in sorted(names) if run("describe", name).status != 0]
    assert not unknown


def choices() -> Iterator[tuple[str, ...]]:
    """Yields a command, with the option unless it is an argument, and a word that may be its value."""
    for path, text in HELP.items():
        for name, words in re.findall(
            r"^  (?:-\w,)?(\S+) ([a-z]+(?:\|[a-z]+)+)(?: |$)", text, re.M
        ):
            before = (*path, name) if name.startswith("--") else path
            yield from ((*before, word) for word in words.split("|"))


def test_words_of_a_choice_have_any_case() -> None:
    found = list(choices())
    assert {("motors", "on"), ("info", "--format", "json"), ("completion", "zsh")} <= set(found)
    for *before, word in found:
        for given in (word.upper(), word.capitalize()):
            assert run(*before, given, "--help").status == 0, (before, given)

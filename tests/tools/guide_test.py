"""Tests what the guides say about the command: the tasks of one send the messages that it lists, and the
table of a recording is what the recipes of another expect; recipes.py runs them."""

from __future__ import annotations

import csv
import json
import os
import re
import shlex
import socket
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from emulated_gimbal import emulated_gimbal
from sbgc_command import PROGRAM, run

GUIDE = (Path(__file__).parents[2] / "docs/12-command.md").read_text(encoding="utf-8")


def recipe(language: str) -> str:
    (text,) = re.findall(rf"^```{language}\n(.*?)^```$", GUIDE, re.DOTALL | re.MULTILINE)
    return str(text)


@pytest.fixture(name="folder", scope="module")
def fixture_folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder where the commands of the guide have run, for a second instead of a minute."""
    folder = tmp_path_factory.mktemp("recipes")
    (folder / "sbgc").symlink_to(Path(PROGRAM).resolve())
    commands = re.findall(r"^\$ (sbgc (?:record|decode) .*)$", GUIDE, re.MULTILINE)
    assert len(commands) == 2
    with emulated_gimbal() as gimbal:
        port = f"record -p {shlex.quote(gimbal.address)}"
        script = "\n".join(commands).replace("sbgc record", f"sbgc {port}").replace("60s", "1s")
        path = f"{folder}{os.pathsep}{os.environ['PATH']}"
        subprocess.run(
            ["bash", "-euc", script], cwd=folder, env={**os.environ, "PATH": path}, check=True
        )
    yield folder


def test_the_table_has_the_columns_of_the_recipes(folder: Path) -> None:
    with (folder / "flight.csv").open(encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    named = set(re.findall(r'"([\w.]+\[[^"\]]+\])"', recipe("python") + recipe("gnuplot")))
    assert len(named) == 3 and named <= set(header) and header[0] == "time[s]"
    assert len(set(header)) == len(header), "PlotJuggler wants different names"
    assert len(rows) > 20 and all(len(row) == len(header) for row in rows)
    times = [float(row[0]) for row in rows]
    assert times == sorted(times), "and times that do not fall"
    assert all(float(cell) is not None for row in rows for cell in row if cell)


def test_live_json_over_udp(folder: Path) -> None:
    with emulated_gimbal() as gimbal, socket.socket(type=socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.settimeout(20)
        command = recipe("bash")
        assert command.startswith("sbgc stream ") and "/127.0.0.1/9870" in command
        command = command.replace("9870", str(receiver.getsockname()[1]))
        command = command.replace(
            "sbgc stream", f"./sbgc -p {shlex.quote(gimbal.address)} stream --for 0.6s"
        )
        subprocess.run(["bash", "-c", command], cwd=folder, check=True)
        messages = [json.loads(receiver.recv(65536)) for _ in range(5)]
    times = [message["time"] for message in messages]
    assert times == sorted(set(times))
    assert all("angle.pitch" in message["fields"] for message in messages)


TASKS_GUIDE = Path(__file__).resolve().parents[2] / "docs/26-how-do-i.md"
TASKS = re.findall(
    r"^\| `sbgc ([^`]+ [^`]+|\w+)` \| (`\w+`(?:, `\w+`)*) \|$", TASKS_GUIDE.read_text(), re.M
)


def sent(capture: Path) -> set[str]:
    """Returns the names of the messages to the board in a capture."""
    decoded = run("decode", str(capture), "--from", "host", "--format", "jsonl")
    return {line["message"] for line in decoded.objects}


def test_tasks_send_what_the_guide_says(tmp_path: Path) -> None:
    assert len(TASKS) > 15
    with emulated_gimbal() as gimbal:
        for number, (task, cell) in enumerate(TASKS):
            capture = tmp_path / f"{number}.sbgc"
            words = [str(tmp_path / w) if w.endswith(".bin") else w for w in task.split()]
            common = ["-p", gimbal.address, *words, "--capture", str(capture)]
            done = run(*common, "--yes")
            if done.status == 2:  # it asks nothing
                done = run(*common)
            assert done.status == 0, f"{task}: {done.error}"
            assert set(re.findall(r"\w+", cell)) <= sent(capture), task

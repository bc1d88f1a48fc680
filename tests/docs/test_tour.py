"""The tour of the command, docs/14-tour.md, shows what its commands print. `--write` renders it again:

    SBGC=build/debug/tools/sbgc generator/python tests/docs/test_tour.py --write

A block ```console holds commands after "$ " and what they print on a terminal of 80 columns. All run
in one home folder, with an emulated gimbal that the configuration file calls "front". Numbers and the
count of samples may differ from run to run, so only the text around them is compared, and a block whose
text is right stays as it is.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
TOUR = ROOT / "docs" / "14-tour.md"
BLOCK = re.compile(r"^```console\n(.*?)^```$", re.DOTALL | re.MULTILINE)


@contextmanager
def gimbal(program: Path) -> Iterator[str]:
    """Runs the emulated gimbal of the tour; yields its address, which is as wide as on the page."""
    # Some systems give ports with fewer digits.
    for port in (0, *range(45454, 45554)):
        with subprocess.Popen(
            [program, "emulate", "--tcp", str(port), "--firmware", "2.70b8"],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        ) as process:
            assert process.stdout is not None
            address = process.stdout.readline().partition(": ")[2].strip()
            try:
                if re.search(r":\d{5}$", address):
                    yield address
                    return
            finally:
                process.kill()
    raise OSError("no port is free")


@contextmanager
def stage() -> Iterator[dict[str, str]]:
    """Yields the environment of the commands: a folder, with the command, its gimbal and nothing else."""
    program = Path(os.environ["SBGC"]).resolve()
    with tempfile.TemporaryDirectory() as folder, gimbal(program) as address:
        (Path(folder) / "sbgc").symlink_to(program)
        config = Path(folder) / ".config" / "sbgc" / "config.toml"
        config.parent.mkdir(parents=True)
        config.write_text(f'[gimbal.front]\nport = "{address}"\n', encoding="utf-8")
        yield {
            "PATH": f"{folder}:{os.environ['PATH']}",
            "HOME": folder,
            "COLUMNS": "80",
            "LC_ALL": "C.UTF-8",
            "PWD": folder,
        }


def run(block: str, environment: dict[str, str]) -> str:
    """Returns the block with the output of its commands."""
    result = ""
    for command in re.findall(r"^\$ (.*(?:\\\n.*)*)", block, re.MULTILINE):
        done = subprocess.run(
            ["bash", "-c", command],
            cwd=environment["PWD"],
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=60,
            check=False,
        )
        result += f"$ {command}\n" + done.stdout.replace(environment["HOME"], "~")
        if result[-1] != "\n":
            result += "\n"
    return result


def text_of(block: str) -> str:
    """Returns a block without its numbers, the spaces that align them and repeated lines of samples."""
    text = re.sub(r"[ -]*-?\d[\d.]*(?:e[-+]?\d+)?|[ -]+", " ", block)
    return re.sub(r"^([ ,]+\n)\1+", r"\1", text, flags=re.MULTILINE)


def rendered(page: str) -> str:
    """Returns the page with the output of its commands, unless only numbers differ."""
    with stage() as environment:

        def render(match: re.Match[str]) -> str:
            new = run(match[1], environment)
            return match[0] if text_of(new) == text_of(match[1]) else f"```console\n{new}```"

        return BLOCK.sub(render, page)


@pytest.mark.skipif("SBGC" not in os.environ, reason="SBGC does not name the sbgc command")
def test_the_tour_is_what_the_command_prints() -> None:
    page = TOUR.read_text(encoding="utf-8")
    assert len(BLOCK.findall(page)) >= 10
    # To accept a change, see above.
    new: list[str] = BLOCK.findall(rendered(page))
    old: list[str] = BLOCK.findall(page)
    assert [block.splitlines() for block in new] == [block.splitlines() for block in old]


def test_only_numbers_may_differ() -> None:
    assert text_of("pitch -20.0 deg") == text_of("pitch 3 deg")
    assert text_of("pitch -20.0 deg") != text_of("yaw -20.0 deg")
    assert text_of("a  b") == text_of("a b")
    assert text_of("time\n 0.1, 2\n 0.2, 3\n") == text_of("time\n 0.1, 2\n")
    assert text_of("time\n 0.1, 2\n") != text_of("time\n")


def main() -> int:
    before = TOUR.read_text(encoding="utf-8")
    after = rendered(before)
    if "--write" in sys.argv[1:]:
        TOUR.write_text(after, encoding="utf-8")
        return 0
    return 0 if after == before else 1


if __name__ == "__main__":
    sys.exit(main())

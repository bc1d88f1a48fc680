"""Compilers that know nothing of CMake, and what the generator writes for them."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Union

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PREFIX = Path(os.environ["SBGC_PREFIX"])  # where this build of sbgc is installed

HOSTS = [name for name in ("g++", "clang++") if shutil.which(name)]
ARM = "arm-none-eabi-g++"
WARNINGS = ["-Wall", "-Wextra", "-Werror"]
STRICT = [
    *WARNINGS,
    "-Wpedantic",
    "-Wconversion",
    "-Wsign-conversion",
    "-Wold-style-cast",
    "-Wundef",
]
BARE = ["-ffreestanding", "-fno-exceptions", "-fno-rtti"]

GUIDE = (ROOT / "docs/11-library.md").read_text(encoding="utf-8")

Argument = Union[str, Path]


def run(*command: Argument, **environment: str) -> str:
    """Runs a command and returns what it prints; fails with its messages."""
    done = subprocess.run(
        command,
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, **environment},
    )
    assert done.returncode == 0, f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}"
    return done.stdout


def blocks(language: str) -> list[str]:
    """Returns the fenced blocks of a language in the guide of the library."""
    return re.findall(rf"^```{language}\n(.*?)^```$", GUIDE, re.DOTALL | re.MULTILINE)


def generate(command: str, folder: Path) -> Path:
    """Runs the line of the guide that writes the library in another form; returns what it wrote."""
    (line,) = (block for block in blocks("sh") if f" {command} " in block)
    run("bash", "-c", f"cd '{folder}' && '{ROOT}'/{line}")
    (made,) = folder.iterdir()
    return made


def machine(compiler: str) -> list[str]:
    return ["-mcpu=cortex-m4", "-mthumb"] if compiler == ARM else []

"""Compilers that know nothing of CMake, and what the generator writes for them."""

from __future__ import annotations

import os
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
BARE = ["-ffreestanding", "-fno-exceptions", "-fno-rtti"]

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


def generate(command: str, output: Path) -> Path:
    """Runs a command of the generator that writes the library in another form."""
    run(ROOT / "generator/python", "-m", "sbgcgen", command, "--root", ROOT, "--output", output)
    return output


def machine(compiler: str) -> list[str]:
    return ["-mcpu=cortex-m4", "-mthumb"] if compiler == ARM else []

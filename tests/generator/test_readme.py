"""README.md, CONTRIBUTING.md and the guide to the library refer only to existing things."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
LIBRARY = (ROOT / "docs/11-library.md").read_text(encoding="utf-8")
CONTRIBUTING = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["first_frame", "tilt"])
def test_the_examples_are_those_that_are_built(name: str) -> None:
    example = (ROOT / f"examples/{name}.cpp").read_text(encoding="utf-8")
    assert f"`examples/{name}.cpp`" in README and f"```cpp\n{example}```" in README


def test_every_header_in_the_table_exists() -> None:
    headers = re.findall(r"^\| `(sbgc/[a-z/_]+\.hpp)`", LIBRARY, re.MULTILINE)
    assert len(headers) > 5
    folders = [*ROOT.glob("*/include"), *ROOT.glob("runtime/*/include")]
    for header in headers:
        assert any((folder / header).is_file() for folder in folders), header


def test_every_folder_of_the_map_exists() -> None:
    rows = re.findall(r"^\| (`[a-z/]+/`(?: `[a-z/]+/`)*) \|", CONTRIBUTING, re.MULTILINE)
    folders = [name for row in rows for name in re.findall(r"`([a-z/]+)/`", row)]
    assert len(folders) >= 9
    for folder in folders:
        assert (ROOT / folder).is_dir(), folder


def test_every_command_of_dev_that_they_name_exists() -> None:
    known = subprocess.run([ROOT / "dev"], capture_output=True, text=True, check=True).stdout
    for command in set(re.findall(r"\./dev ([a-z]+)", README + CONTRIBUTING)):
        assert re.search(rf"^  {command}\b", known, re.MULTILINE), command

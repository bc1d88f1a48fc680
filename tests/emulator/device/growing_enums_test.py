"""Enums and flag sets of the protocol grow in YAML alone: no code relies on a switch with all of their values."""

import os
import re
import subprocess
from itertools import groupby
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
FOLDERS = ("emulator", "tools", "runtime", "examples")
INCLUDES = [ROOT / "emulator", ROOT / "emulator/include", ROOT / "tools"]
INCLUDES += [
    *ROOT.glob("runtime/*/include"),
    ROOT / "runtime/client/src",
    ROOT / "runtime/tasks/internal",
    ROOT / "runtime/tasks/src",
]
# A value that no enum has.
VALUE = 113


@pytest.fixture(scope="module", name="grown")
def headers_with_further_values(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the generated header of the enums, each of which has one more value."""
    text = (ROOT / "generated/include/sbgc/enums.hpp").read_text()
    values = re.compile(r"(enum class \w+ : [\w:]+ \{\n)(.*?)\};", re.DOTALL)
    assert len(values.findall(text)) > 50
    folder = tmp_path_factory.mktemp("grown")
    (folder / "sbgc").mkdir()
    text = values.sub(rf"\1\2  a_further_value = {VALUE},\n}};", text)
    # Its own functions would be generated with the further values.
    (folder / "sbgc/enums.hpp").write_text(f"#pragma GCC system_header\n{text}")
    return folder


def sources() -> list[Path]:
    """The sources with a switch over a value of the protocol, as far as its cases tell."""
    names = (ROOT / "generated/include/sbgc/enums.hpp").read_text()
    enums = set(re.findall(r"^enum class (\w+)", names, re.MULTILINE))
    files = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*.?pp")]
    texts = {path: path.read_text() for path in files}
    alias = re.compile(r"\busing (\w+) = (?:\w+::)*(\w+);")
    enums |= {name for text in texts.values() for name, of in alias.findall(text) if of in enums}
    case = re.compile(rf"\bcase (?:\w+::)*(?:{'|'.join(sorted(enums))})::\w+:")
    found = [path for path, text in texts.items() if case.search(text)]
    return sorted(path for path in found if path.suffix == ".cpp")


def warnings_of(source: Path, grown: Path, *options: str) -> str:
    """Returns the compiler's warnings about the switches in a file."""
    includes = [f"-I{path}" for path in (grown, *INCLUDES, ROOT / "generated/include")]
    command = [os.environ.get("CXX", "g++"), "-std=c++20", "-fsyntax-only", "-Wswitch", "-Werror"]
    done = subprocess.run(
        [*command, *includes, *options, source], capture_output=True, text=True, check=False
    )
    return done.stderr


def test_a_switch_with_all_values_is_noticed(grown: Path, tmp_path: Path) -> None:
    source = tmp_path / "switch.cpp"
    source.write_text(
        """#include <sbgc/enums.hpp>
int f(sbgc::msg::CoggingAction action) {
  switch (action) {
    case sbgc::msg::CoggingAction::calibrate: return 1;
    case sbgc::msg::CoggingAction::erase: return 2;
  }
  return 0;
}
"""
    )
    assert "a_further_value" in warnings_of(source, grown)
    assert not warnings_of(source, tmp_path)


def test_every_switch_takes_values_that_come_later(grown: Path, tmp_path: Path) -> None:
    """Compiles the files of a library as one, because their headers take the time."""
    found = sources()
    assert len(found) > 5
    for library, files in groupby(found, lambda path: path.relative_to(ROOT).parts[:2]):
        source = tmp_path / f"{library[-1]}.cpp"
        source.write_text("".join(f'#include "{file}"\n' for file in files))
        assert not warnings_of(source, grown)

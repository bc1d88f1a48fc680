"""The guides in docs/ are correct: C++ compiles, commands print their output. Links of all prose are valid. The
figures in SECURITY.md are those of the code. Code to copy moves every axis slowly: in an angle mode, speed 0 means the
parameters' speed."""

from __future__ import annotations

import builtins
import os
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

import pytest

from sbgcgen.model import Layout
from sbgcgen.oracle.example import example_of

ROOT = Path(__file__).resolve().parents[2]
CXX = os.environ.get("CXX", "g++")
GUIDES = sorted((ROOT / "docs").glob("*.md"))
PROSE = [*GUIDES, *ROOT.glob("*.md"), *(ROOT / "bench").glob("*.md")]
FLAGS = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fno-exceptions", "-fno-rtti"]
INCLUDES = [*ROOT.glob("runtime/*/include"), ROOT / "emulator/include", ROOT / "generated/include"]
FLAGS += [f"-I{folder}" for folder in INCLUDES]
# A guide shows a task of FreeRTOS, all of which is in one header here.
FLAGS.append(f"-I{ROOT}/tests/docs")
OTHERS_OF_FREERTOS = re.compile(r'#include [<"](?:queue|stream_buffer|task)\.h[>"]\n')


def stem_of(guide: Path) -> str:
    """Returns the id of a guide in pytest."""
    return guide.stem


def blocks(guide: Path, language: str) -> list[str]:
    """Returns the fenced blocks of a language."""
    text = guide.read_text(encoding="utf-8")
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)


def compile_text(source: str, *options: str) -> str:
    """Returns the messages of the compiler; empty on success."""
    command = [CXX, *FLAGS, "-x", "c++", *options, "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True, check=False)
    return done.stderr


def joined(sources: list[str]) -> str:
    """Returns the blocks of a guide as one source: the lines that include, and a namespace for each block."""
    includes = re.findall(r"^#include .*$", "".join(sources), re.MULTILINE)
    rest = [re.sub(r"^#include .*$", "", source, flags=re.MULTILINE) for source in sources]
    spaces = [f"namespace block_{i} {{\n{code}}}\n" for i, code in enumerate(rest)]
    return "\n".join([*dict.fromkeys(includes), *spaces])


def test_all_cpp_compiles(tmp_path: Path) -> None:
    sources = []
    for guide in GUIDES:
        found = [OTHERS_OF_FREERTOS.sub("", source) for source in blocks(guide, "cpp")]
        # In a namespace, main() is a function like others.
        programs = [source for source in found if "int main(" in source]
        programs.append(joined([source for source in found if source not in programs]))
        sources += [(guide.name, source) for source in programs if source]
    assert len(sources) >= 10

    # Several include this large header, which is compiled for them once.
    client = "#include <sbgc/client/client.hpp>\n"
    compiled = tmp_path / "client.hpp"
    compiled.write_text(client, encoding="utf-8")
    assert not compile_text(client, "-x", "c++-header", "-o", f"{compiled}.gch")

    def check(source: str) -> str:
        options = ["-include", str(compiled)] if client in source else []
        # Asio needs what the library does without.
        options = ["-fexceptions", "-frtti"] if "<asio/" in source else options
        return compile_text(source, "-fsyntax-only", *options)

    with ThreadPoolExecutor(2) as pool:
        complaints = list(pool.map(lambda s: check(s[1]), sources))
    for (name, _), complaint in zip(sources, complaints):
        assert not complaint, f"{name}: {complaint}"


# Conditions that the functions of the guides must fulfill.
PROMISES = {
    "1-getting-started": "turn_to(45, frame).size() == 18 && turn_to(800, frame).empty()",
    "4-framing": "frames_after_a_broken_one() == 1",
    "5-units": "creep(sbgc::msg::FineSpeed(20)).control_mode.yaw.raw() == 0x81",
    "6-parameters": "with_deadband({}, 7).rc_deadband == 7",
    "7-streams": "sbgc::encode_frame(angles_at_50_hz(), frame).size == 26",
    "8-microcontrollers": "turn(frame) == 18",
}


def test_code_does_what_the_guides_say(tmp_path: Path) -> None:
    frame = "static std::array<std::uint8_t, sbgc::max_frame_size> frame{};\n"
    sources = ["#include <cstdio>\n#include <sbgc/message.hpp>\n"]
    calls = ""
    for number, (name, condition) in enumerate(PROMISES.items(), 1):
        function = re.match(r"(?:sbgc::encode_frame\()?(\w+)", condition)
        assert function
        found = blocks(ROOT / f"docs/{name}.md", "cpp")
        (source,) = [source for source in found if f" {function[1]}(" in source]
        sources.append(f"{source}[[maybe_unused]] {frame}bool holds() {{ return {condition}; }}\n")
        calls += f'if (!block_{number}::holds()) std::puts("{name}");\n'
    program = tmp_path / "program"
    assert not compile_text(joined(sources) + f"int main() {{\n{calls}}}\n", "-o", str(program))
    assert subprocess.run([program], check=True, capture_output=True).stdout == b""


def prose(guide: Path) -> str:
    """Returns a guide without its fenced blocks."""
    text = guide.read_text(encoding="utf-8")
    return re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)


def shell_blocks() -> list[tuple[str, str, str | None]]:
    """Returns guide, commands that use sbgc, and their expected output, if the guide shows it."""
    found = []
    for guide in GUIDES:
        text = guide.read_text(encoding="utf-8")
        for match in re.finditer(
            r"^```sh\n(.*?)^```\n(?:\n```text\n(.*?)^```$)?", text, re.DOTALL | re.MULTILINE
        ):
            if re.search(r"\bsbgc (?:de|en)code\b", match[1]):
                found.append((guide.name, match[1], match[2]))
    return found


@pytest.mark.skipif("SBGC" not in os.environ, reason="SBGC does not name the sbgc command")
@pytest.mark.parametrize("name,commands,output", shell_blocks())
def test_commands_run_and_print_what_the_guide_says(
    name: str, commands: str, output: str | None, tmp_path: Path
) -> None:
    (tmp_path / "sbgc").symlink_to(Path(os.environ["SBGC"]).resolve())
    path = f"{tmp_path}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", commands],
        cwd=ROOT,
        env={**os.environ, "PATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    said = re.search(r"# exit status (\d)", commands)
    assert done.returncode == (int(said[1]) if said else 0), f"{name}: {done.stderr}"
    assert done.stdout
    if output is not None:
        assert done.stdout == output, name


def test_there_are_commands_with_output() -> None:
    assert sum(output is not None for _, _, output in shell_blocks()) >= 3


def anchors(path: Path) -> list[str]:
    """Returns the anchors that a code host gives the headings of a page, or the keys of a YAML file."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".yaml":
        return re.findall(r"^ *(\w+):", text, re.MULTILINE)
    titles = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    return [re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles]


@pytest.mark.parametrize("guide", PROSE, ids=stem_of)
def test_links_lead_somewhere(guide: Path) -> None:
    for link in re.findall(r"\]\(([^)]+)\)", prose(guide)):
        target, _, where = link.partition("#")
        path = guide.parent / target if target else guide
        assert "://" in target or path.exists(), link
        assert not where or where in anchors(path), link


@pytest.mark.parametrize("guide", GUIDES, ids=stem_of)
def test_names_of_the_library_exist(guide: Path) -> None:
    """Includes the names of messages, fields and headers in running text."""
    text = prose(guide)
    for name in re.findall(r"`(?:sbgc::)?([A-Za-z][A-Za-z0-9_]+)(?:\(\))?`", text):
        assert name in known_words() or name in ("sbgc", "memcpy", "double", "i16"), name
    for header in re.findall(r"`(sbgc/[a-z_/]+\.hpp)`", text):
        assert any((folder / header).is_file() for folder in INCLUDES)


@cache
def known_words() -> frozenset[str]:
    """Returns the words of the library, the protocol, the commands and the packages."""
    files = [path for folder in INCLUDES for path in folder.rglob("*.hpp")]
    files += [*(ROOT / "spec").glob("*.yaml"), ROOT / "generator/schema/sbgc-spec.schema.json"]
    files.append(ROOT / "generated/simplebgc.json")
    # Commands and options of sbgc.
    files += [*(ROOT / "tools").rglob("*.cpp"), *(ROOT / "gateway").glob("*.cpp")]
    files += [*(ROOT / "python/sbgc").rglob("*.py"), *(ROOT / "generated/python").rglob("*.py")]
    files += (ROOT / "web/src").glob("*.ts")
    words = {
        word for path in files for word in re.findall(r"\w+", path.read_text(encoding="utf-8"))
    }
    return frozenset({*words, *dir(builtins)})


def test_commands_of_dev_exist() -> None:
    known = subprocess.run([ROOT / "dev"], capture_output=True, text=True, check=True).stdout
    for guide in PROSE:
        for command in re.findall(r"\./dev ([a-z]+)", guide.read_text(encoding="utf-8")):
            assert re.search(rf"^  {command}\b", known, re.MULTILINE), command


@pytest.mark.parametrize("name", ["first_frame", "tilt"])
def test_the_examples_of_readme_are_those_that_are_built(name: str) -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    example = (ROOT / f"examples/{name}.cpp").read_text(encoding="utf-8")
    assert f"`examples/{name}.cpp`" in readme and f"```cpp\n{example}```" in readme


def test_every_folder_of_the_map_exists() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (`[a-z/]+/`(?: `[a-z/]+/`)*) \|", text, re.MULTILINE)
    folders = [name for row in rows for name in re.findall(r"`([a-z/]+)/`", row)]
    assert len(folders) >= 9
    for folder in folders:
        assert (ROOT / folder).is_dir(), folder


def test_the_ways_through_the_code_exist() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    steps = re.findall(r"^(\d+)\. `([^`]+)`: (.*)$", text, re.MULTILINE)
    assert [int(step) for step, _, _ in steps] == [*range(1, 14), *range(1, 15)]
    for _, path, functions in steps:
        source = (ROOT / path).read_text(encoding="utf-8")
        for function in re.findall(r"`([^`]+)`", functions):
            assert re.search(rf"\b{function}\b", source), f"{path}: {function}"


def test_each_problem_has_a_command_and_a_page_of_the_reference() -> None:
    sections = re.split(r"^## ", (ROOT / "docs/20-problems.md").read_text("utf-8"), flags=re.M)[1:]
    assert len(sections) >= 11
    for section in sections:
        name = section.splitlines()[0]
        assert re.search(r"`sbgc [a-z]+|^sbgc [a-z]+", section, re.MULTILINE), name
        assert re.search(r"\]\(\.\./(generated/fields|spec)/", section), name


SECURITY = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| [^|]+ \| (\d+)( bytes| MiB|) \| `(\S+)` \| `(\S+)` \|$", SECURITY, re.M)
LIMITS = SECURITY.split("## Limits")[1]


def value_of(constant: str, file: str) -> int:
    """Returns the value of an integer constant, or of a member's default, as the source says it."""
    source = (ROOT / file).read_text(encoding="utf-8")
    name = constant.rpartition("::")[2]
    (expression,) = set(re.findall(rf"\b(?:size_t|int|unsigned) {name} = ([^;]+);", source))
    plain = re.sub(r"std::size_t\{(\w+)\}", r"\1", expression)
    plain = re.sub(r"(\d)U\b", r"\1", plain).replace("'", "")
    assert re.fullmatch(r"[\d <]+", plain), expression
    return int(eval(plain))  # pylint: disable=eval-used


def test_every_row_is_checked() -> None:
    assert len(ROWS) == LIMITS.count("\n| ") - 1 > 20


@pytest.mark.parametrize("figure, unit, constant, file", ROWS)
def test_the_figure_is_that_of_the_code(figure: str, unit: str, constant: str, file: str) -> None:
    factor = 2**20 if unit == " MiB" else 1
    assert value_of(constant, file) == int(figure) * factor


AXES = ("roll", "pitch", "yaw")
ANGLE_MODE = re.compile(r"ControlMode(Kind)?::\w*angle\w*")


def sources() -> dict[str, str]:
    """Returns the C++ of guides, README and examples by location."""
    found = {}
    for path in (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))):
        text = path.read_text(encoding="utf-8")
        for i, block in enumerate(
            re.findall(r"^```cpp\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
        ):
            found[f"{path.name}, block {i}"] = block
    for path in sorted((ROOT / "examples").glob("*.cpp")):
        found[path.name] = path.read_text(encoding="utf-8")
    return found


def sets_speed_of(axis: str, code: str) -> bool:
    """Returns True if the code sets the speed of an axis by name, pointer loop or braces."""
    loops = re.findall(r"for \(auto\* (\w+) : \{([^}]*)\}\)\s*\{?\s*\1->speed = ", code)
    in_loop = any(f"axes.{axis}" in members for _, members in loops)
    by_name = rf"axes\.{axis}\.speed = |\.{axis} = \{{\.speed = "
    return in_loop or re.search(by_name, code) is not None


def test_code_with_an_angle_mode_sets_the_speed_of_every_axis() -> None:
    moving = {name: code for name, code in sources().items() if ANGLE_MODE.search(code)}
    assert len(moving) >= 3
    for name, code in moving.items():
        assert [a for a in AXES if not sets_speed_of(a, code)] == [], name


def test_examples_of_the_reference_set_the_speed_of_every_axis_that_moves(layout: Layout) -> None:
    angle_modes = {2, 5}
    moving = 0
    for name in ("Control", "ControlExt"):
        fields = example_of(next(m for m in layout.messages if m.name == name), layout).fields
        for axis in AXES:
            mode = fields["control_mode"]
            mode = mode[axis] if isinstance(mode, dict) else mode
            if mode & 0x0F in angle_modes:
                moving += 1
                assert fields["axes"][axis]["speed"] != 0, f"{name}: {axis}"
    assert moving == 4

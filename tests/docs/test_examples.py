"""Every example on the site is correct: the C++ and the commands do what the pages describe."""

from __future__ import annotations

import json
import os
import re
import subprocess
from dataclasses import dataclass
from math import hypot
from itertools import takewhile
from pathlib import Path

import pytest

from sbgcgen.oracle.example import Piece, example_of
from sbgcgen.model import Enum, Layout, Message, Quantity, Scalar
from sbgcgen.model.names import slug

from conftest import LAYOUT, PROJECT
from pages import Element, Page

Pages = dict[str, Page]

SIDES = {side for d in LAYOUT.directions for side in (d.positive, d.negative) if side}

SBGC = os.environ.get("SBGC", str(PROJECT / "build" / "release" / "tools" / "sbgc"))
COMPILER = [w for w in (os.environ.get("CXX_LAUNCHER", ""), os.environ.get("CXX", "g++")) if w]
WARNINGS = (
    "-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wold-style-cast "
    "-Wdouble-promotion -Wformat=2 -Werror -Wno-deprecated-declarations"
)


PARTS = ("core", "any", "session", "tasks", "io", "client")


def only(page: Page, name: str) -> Element:
    (element,) = page.root.with_class(name)
    return element


def values_of(page: Page) -> list[list[str]]:
    """Returns path, raw value and meaning of each row of the example."""
    rows = [e for e in page.root.all("tr") if "data-value" in e.attributes]
    return [json.loads(row.get("data-value")) for row in rows]


def shown_frame(page: Page) -> str:
    """Returns the frame shown on the page, in lower case without blanks."""
    (frame,) = [e for e in page.root.all("pre") if "data-frame" in e.attributes]
    return re.sub(r"\s", "", frame.text).lower()


@pytest.fixture(scope="module")
def message_pages(pages: Pages, layout: Layout) -> dict[str, Page]:
    return {m.name: pages[f"messages/{slug(m.name)}.html"] for m in layout.definitions}


# ---- the frames ----


def test_rows_hold_the_bytes_of_the_frame(message_pages: dict[str, Page]) -> None:
    for name, page in message_pages.items():
        (table,) = page.root.with_class("values")
        at = 0
        joined = ""
        for row in table.all("tbody")[0].all("tr"):
            cells = row.children
            data = re.sub(r"\s", "", cells[1].text)
            assert int(cells[0].text) == at, name
            at += len(data) // 2
            joined += data.lower()
        assert joined == shown_frame(page), name


def test_examples_show_something(message_pages: dict[str, Page], layout: Layout) -> None:
    """A message with content has an example with values."""
    for message in layout.definitions:
        values = values_of(message_pages[message.name])
        known = [leaf for leaf in message.leaves if not leaf.field.reserved]
        free = [leaf for leaf in known if leaf.type != "bytes" and leaf.field.role != "copy"]
        assert bool(values) >= bool(known), message.name
        if free and not message.example:
            assert any(raw not in ("0", "") for _, raw, _ in values), message.name


# ---- safety: a copied example does no harm ----


def harmless(message: Message) -> list[Piece]:
    """Returns the values of an example, without padding."""
    return [p for p in example_of(message, LAYOUT).pieces if not p.field.reserved]


def test_a_minimum_is_not_above_its_maximum() -> None:
    pairs = 0
    for message in LAYOUT.messages:
        values = {piece.path: piece.value for piece in harmless(message)}
        for path, value in values.items():
            partner = re.sub(r"(?<![a-z])min(?![a-z])", "max", path)
            if partner != path and partner in values:
                pairs += 1
                assert value <= values[partner], f"{message.name}: {path}"
    assert pairs > 40


def test_what_moves_does_so_slowly() -> None:
    speeds = 0
    for message in LAYOUT.messages:
        for piece in harmless(message):
            if not isinstance(piece.type, Quantity) or piece.type.unit != "deg/s":
                continue
            if message.effect and "moves" in message.effect.words:
                speeds += 1
                assert abs(piece.type.real(piece.value)) <= 30, f"{message.name}: {piece.path}"
    assert speeds >= 6


def test_captures_to_try_the_decoder_with_move_slowly() -> None:
    """These may be copied, too."""
    done = subprocess.run(
        f"cat {PROJECT}/docs/captures/*.hex | {SBGC} decode --hex --format jsonl --from host",
        shell=True,
        capture_output=True,
        text=True,
        check=True,
    )
    speeds = [
        axis["speed"]
        for line in done.stdout.splitlines()
        for axis in json.loads(line).get("fields", {}).get("axes", {}).values()
        if "speed" in axis
    ]
    assert len(speeds) == 3
    assert all(abs(speed) * 4000 / 32767 <= 30 for speed in speeds)


def test_vectors_have_the_length_1() -> None:
    vectors = 0
    for message in LAYOUT.messages:
        values = {piece.path: piece.value for piece in harmless(message)}
        for field in message.fields:
            scalar = isinstance(field.type, Scalar) and field.type.is_float
            if field.dim == "xyz" and scalar and field.maximum == 1 and f"{field.name}.x" in values:
                vectors += 1
                length = hypot(*(values[f"{field.name}.{axis}"] for axis in "xyz"))
                assert abs(length - 1) < 1e-6, f"{message.name}: {field.name}"
    assert vectors >= 4


def test_nothing_is_out_of_range_or_unnamed() -> None:
    """Includes checks that `sbgc encode`, as the pages show it, does not make."""
    for message in LAYOUT.messages:
        for piece in harmless(message):
            field, value = piece.field, piece.value
            if any(special.value == value for special in field.special):
                continue
            where = f"{message.name}: {piece.path} = {value}"
            if field.minimum is not None and field.maximum is not None:
                assert field.minimum <= value <= field.maximum, where
            if isinstance(piece.type, Enum) and piece.type.kind == "enum":
                assert value in {v.value for v in piece.type.values}, where


def test_examples_of_the_attitude_are_those_of_the_normal_position() -> None:
    seen = 0
    for message in LAYOUT.messages:
        values = {p.path: p.value for p in harmless(message)}
        if message.command == "CMD_AHRS_HELPER" and "h1_vector.x" in values:
            seen += 1
            assert [values[f"z1_vector.{axis}"] for axis in "xyz"] == [0, 0, 1], message.name
            assert [values[f"h1_vector.{axis}"] for axis in "xyz"] == [0, 1, 0], message.name
    assert seen == 3


def test_storage_is_written_with_what_was_read() -> None:
    """The examples that write memory of unknown meaning write the values of the reading examples."""
    bodies = {m.name: example_of(m, LAYOUT).body for m in LAYOUT.messages}
    assert bodies["EepromWrite"] == bodies["EepromRead"]
    assert len(bodies["WriteExternalData"]) == len(bodies["ReadExternalData"])
    changes = zip(bodies["WriteExternalData"], bodies["ReadExternalData"])
    assert sum(new != old for new, old in changes) == 1


def test_live_data_look_like_those_of_a_board_that_works() -> None:
    for name in ("RealtimeData3", "RealtimeData4"):
        message = next(m for m in LAYOUT.messages if m.name == name)
        values = {p.path: p for p in harmless(message)}
        components = []
        for axis in ("roll", "pitch", "yaw"):
            part = values[f"axes.{axis}.acc_data"]
            assert isinstance(part.type, Quantity)
            components.append(part.type.real(part.value))
        length = hypot(*components)
        assert abs(length - 1) < 0.01
        for path, piece in values.items():
            if "error_c" in path or path in ("system_error", "system_sub_error"):
                assert piece.value == 0, f"{name}: {path}"
            if "temperature" in path:
                assert 0 < piece.value < 60, f"{name}: {path}"


def test_no_example_erases_a_board_or_turns_a_motor_around() -> None:
    for message in LAYOUT.messages:
        for piece in harmless(message):
            if message.direction == "to_board":
                meanings = [s.name for s in piece.field.special if s.value == piece.value]
                assert "erase_eeprom" not in meanings, message.name
            if "inverted" in piece.field.summary and piece.field.maximum == 1:
                assert piece.value == 0, f"{message.name}: {piece.path}"


def test_what_only_the_board_knows_is_read_before_it_is_written(pages: Pages) -> None:
    storing = [m for m in LAYOUT.messages if m.stores]
    assert len(storing) >= 6
    for message in storing:
        page = pages[f"messages/{slug(message.name)}.html"]
        code = only(page, "example-cpp").text
        assert f"sbgc::msg::{message.name} message{{read}};" in code
        assert len(re.findall(r"^message\.", code, re.MULTILINE)) == 1, code
        read = example_of(message, LAYOUT).read
        assert read is not None and example_of(message, LAYOUT).changed


# ---- the command lines ----


def run(commands: str, folder: Path) -> str:
    """Runs all in one shell, which names the first that fails, and ends."""
    script = folder / "commands.sh"
    script.write_text(f"trap 'echo \"$BASH_COMMAND\" >&2' ERR\n{commands}", encoding="utf-8")
    done = subprocess.run(
        ["bash", "-e", str(script)],
        capture_output=True,
        text=True,
        timeout=600,
        # Bash complains about missing locales.
        env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"},
    )
    assert (done.returncode, done.stderr) == (0, ""), done.stdout[-500:]
    return done.stdout


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder for PATH that contains the command under the name sbgc."""
    path = tmp_path_factory.mktemp("bin")
    assert Path(SBGC).is_file(), f"{SBGC} is not built"
    (path / "sbgc").symlink_to(SBGC)
    return path


def test_every_command_gives_what_the_page_says(pages: Pages, folder: Path) -> None:
    found = [(p, code) for p in pages.values() for code in p.root.with_class("example-command")]
    assert len(found) > 2 * len([p for p in pages if p.startswith("messages/")])
    outputs = run("\nprintf '\\0'\n".join(code.text for _, code in found), folder).split("\0")
    assert len(outputs) == len(found)
    for (page, code), out in zip(found, outputs):
        expected = code.get("data-gives")
        if expected == "values":
            rows = [line.split() for line in frames_of(out)[-1][1:]]
            # A lone frame whose request decides is read in the other way, too.
            rows = list(takewhile(lambda row: row[:3] != ["The", "request", "decides"], rows))
            shown = [" ".join(row).split() for row in values_of(page)]
            # The page also says which way an angle is.
            assert rows == [row[:-1] if row[-1] in SIDES else row for row in shown], page.path
        elif expected == "summary":
            assert out.splitlines()[-1].startswith(code.get("data-summary")), page.path
        else:
            is_trial = code.text.startswith("sbgc send")  # which also says what it does
            frame = out.splitlines()[0] if is_trial else out.strip()
            assert frame == expected == shown_frame(page), page.path


def test_tasks_of_the_guide_are_on_the_pages_of_their_messages(pages: Pages) -> None:
    def tasks_of(page: str) -> list[str]:
        return [
            code.text for code in pages[f"messages/{page}.html"].root.with_class("example-task")
        ]

    assert tasks_of("calib-gyro") == ["sbgc calibrate gyro"]
    assert tasks_of("control-ext")[0] == "sbgc move --pitch 5 --speed 30"
    assert set(tasks_of("control")) == set(tasks_of("control-ext")) and "sbgc stop" in tasks_of(
        "control"
    )
    assert tasks_of("get-angles") == [] == tasks_of("confirm")


def test_what_is_related_is_linked_once(pages: Pages, layout: Layout) -> None:
    for message in layout.definitions:
        page = pages[f"messages/{slug(message.name)}.html"]
        (section,) = [e for e in page.root.all("section") if e.get("id") == "see-also"]
        links = [a.get("href") for a in section.all("a")]
        assert links and len(links) == len(set(links)), page.path
        assert f"../{page.path}" not in links


def frames_of(text: str) -> list[list[str]]:
    """Returns the lines of `sbgc decode` by frame, without the summary in the last line."""
    frames: list[list[str]] = []
    *lines, last = text.splitlines()
    assert re.match(r"\d+ frames?, 0 bytes skipped", last), text
    for line in lines:
        if line.startswith("@"):
            assert "no frame" not in line and "error" not in line, text
            frames.append([])
        frames[-1].append(line)
    return frames


# ---- the C++ ----


@dataclass(frozen=True)
class Snippet:
    name: str
    includes: tuple[str, ...]
    statements: str
    expected: str


def snippet_of(page: Page) -> Snippet:
    code = only(page, "example-cpp")
    text = code.text
    includes = tuple(re.findall(r"^#include <.+>$", text, re.MULTILINE))
    statements = re.sub(r"^#include .+$", "", text, flags=re.MULTILINE).strip()
    output = page.root.with_class("output-cpp")
    expected = output[0].text if output else ""
    if "encode_frame" in statements:
        statements += "\n  show(written, frame.data());"
        expected = shown_frame(page)
    return Snippet(code.get("data-name"), includes, statements, expected)


def program_of(snippets: list[Snippet]) -> str:
    """Returns one program for several examples, each in its own function."""
    includes = sorted({name for s in snippets for name in s.includes})
    lines = [*includes, "#include <cstddef>", "#include <cstdio>", "#include <sbgc/status.hpp>", ""]
    lines += [
        "[[maybe_unused]] static void show(const sbgc::WriteResult& w, const std::uint8_t* bytes) {",
        '  if (!w) std::puts("not encoded");',
        '  for (std::size_t i = 0; i < w.size; ++i) std::printf("%02x", bytes[i]);',
        '  std::puts("");',
        "}",
    ]
    for i, snippet in enumerate(snippets):
        lines += [f"static void example_{i}() {{", snippet.statements, "}"]
    lines.append("int main() {")
    for i, snippet in enumerate(snippets):
        lines += [f'  std::puts("== {snippet.name}");', f"  example_{i}();"]
    return "\n".join([*lines, "}", ""])


def test_cpp_examples(pages: Pages, layout: Layout, tmp_path: Path) -> None:
    """One program, because the headers take most of the time: it prints what the pages show."""
    snippets = []
    family = {slug(m.name): m.family for m in layout.definitions}
    for path, page in pages.items():
        if page.root.with_class("example-cpp"):
            kind, _, name = path.removesuffix(".html").partition("/")
            snippets.append(snippet_of(page))
            header = "units" if kind == "units" else f"messages/{family[name]}"
            assert f"#include <sbgc/{header}.hpp>" in snippets[-1].includes, path
    assert len(snippets) == len(layout.definitions) + len(layout.quantities)
    source, program = tmp_path / "examples.cpp", str(tmp_path / "examples")
    source.write_text(program_of(snippets), encoding="utf-8")
    includes = [f"-I{PROJECT / name}" for name in ("runtime/core/include", "generated/include")]
    command = [*COMPILER, "-std=c++20", *WARNINGS.split(), *includes, str(source), "-o", program]
    subprocess.run(command, check=True)
    done = subprocess.run([program], capture_output=True, text=True, timeout=60, check=True)
    printed = dict(part.split("\n", 1) for part in done.stdout.split("== ")[1:])
    for snippet in snippets:
        found = printed[snippet.name].strip()
        assert found == snippet.expected.strip(), f"{snippet.name}: {found} {snippet.expected}"


def test_examples_with_the_client(pages: Pages, layout: Layout, tmp_path: Path) -> None:
    """All have the statements of the codec; a sample of both directions compiles."""
    sample: list[str] = []
    for message in layout.definitions:
        page = pages[f"messages/{slug(message.name)}.html"]
        codec = only(page, "example-cpp").text
        found = page.root.with_class("example-client")
        assert bool(found) != ("message{read};" in codec), message.name
        if not found:
            continue
        kinds = r"^ *(?:message[.(]|std::(?:printf|puts)).*$"
        said = [line.strip() for line in re.findall(kinds, found[0].text, re.MULTILINE)]
        wanted = [line.strip() for line in re.findall(kinds, codec, re.MULTILINE)]
        assert [line for line in said if "sent.error" not in line] == wanted, message.name
        if len(sample) < 12 and (hash_of(message.name) % 12 == 0 or message.name == "Control"):
            sample.append(found[0].text)
    assert len(sample) > 6 and any("subscribe" in s for s in sample)
    includes = sorted({i for s in sample for i in re.findall(r"^#include .+$", s, re.MULTILINE)})
    lines = [*includes, ""]
    for i, code in enumerate(sample):
        statements = re.sub(r"^#include .+$", "", code, flags=re.MULTILINE)
        lines += [f"void example_{i}(sbgc::Client& client);"]
        lines += [f"void example_{i}(sbgc::Client& client) {{", statements, "}"]
    source = tmp_path / "client.cpp"
    source.write_text("\n".join([*lines, ""]), encoding="utf-8")
    folders = [*(f"runtime/{name}/include" for name in PARTS), "generated/include"]
    command = [*COMPILER, "-std=c++20", *WARNINGS.split(), "-fsyntax-only", str(source)]
    subprocess.run([*command, *(f"-I{PROJECT / name}" for name in folders)], check=True)


def hash_of(name: str) -> int:
    """A number that is the same in each run."""
    return sum(name.encode())

"""Unreadable and broken files: a clear message with a position, exit status 1, never a traceback and no hang.
Broken YAML is generated from, or refused with findings that name a place."""

from __future__ import annotations

import shutil
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from broken_yaml import LIMIT, broken, outcome
from sbgcgen.build import load_protocol
from sbgcgen.cli import main
from sbgcgen.targets import outputs
from support import HERE, Capture, findings, write_spec


@pytest.mark.parametrize(
    ("content", "where", "what"),
    [
        (b"family: probe\nsummary: 20 \xb0C\n", "2:13", "the file is not UTF-8"),
        ("family: probe\n".encode("utf-16"), "1:1", "the file is not UTF-8"),
        (b"family: probe\nsummary: a\0b\n", "2:11", "control characters are not allowed"),
        (b"\x89PNG\r\n\x1a\n", "1:1", "the file is not UTF-8"),
        (b"", "1:1", "a spec file is a mapping"),
        (b"# nothing but a comment\n", "1:1", "a spec file is a mapping"),
        (b"{}\n", "1:1", "a spec file"),
        (b"# nothing\n{}\n", "1:1", "a spec file"),
        (b"family: probe\nsummary: [\n", "3:1", "not valid YAML"),
        (b"family: probe\nsummary: " + b"[" * 2000 + b"]" * 2000, "1:1", "nested too deeply"),
    ],
)
def test_content_that_is_no_yaml(content: bytes, where: str, what: str, tmp_path: Path) -> None:
    found = findings(tmp_path, content)
    assert [(str(d.position), d.code) for d in found] == [(f"spec/probe.yaml:{where}", "SBGC001")]
    assert what in found[0].message


@pytest.mark.parametrize("bom", [b"", b"\xef\xbb\xbf"])
@pytest.mark.parametrize("newline", [b"\n", b"\r\n"])
def test_windows_editors_do_no_harm(bom: bytes, newline: bytes, tmp_path: Path) -> None:
    text = b"family: probe\nsummary: \xc2\xb0C and \xe2\x80\x9cquotes\xe2\x80\x9d\nmisspelt: 1\n"
    found = findings(tmp_path, bom + text.replace(b"\n", newline))
    assert [str(d.position) for d in found] == ["spec/probe.yaml:3:1"]


def _drop(name: str) -> Callable[[Path], None]:
    return lambda spec: (spec / name).unlink()


def _folder(spec: Path) -> None:
    (spec / "base.yaml").unlink()
    (spec / "base.yaml").mkdir()


def _dangling_link(spec: Path) -> None:
    (spec / "base.yaml").unlink()
    (spec / "base.yaml").symlink_to("nowhere.yaml")


@pytest.mark.parametrize(
    ("damage", "start"),
    [
        (_drop("simplebgc.yaml"), "spec:1:1: SBGC001 no file has the key 'protocol'"),
        (_drop("errata.yaml"), "spec/base.yaml:78:16: SBGC023 there is no erratum E001"),
        (_drop("base.yaml"), "spec/base.yaml:1:1: SBGC001 cannot read the file: No such file"),
        (_folder, "spec/base.yaml:1:1: SBGC001 cannot read the file: Is a directory"),
        (_dangling_link, "spec/base.yaml:1:1: SBGC001 cannot read the file: No such file"),
        (shutil.rmtree, "spec:1:1: SBGC001 no file has the key 'protocol'"),
    ],
)
def test_files_that_are_not_there(
    damage: Callable[[Path], None], start: str, tmp_path: Path, capsys: Capture
) -> None:
    spec = write_spec(tmp_path)
    damage(spec)
    assert main(["lint", "--spec", str(spec)]) == 1
    output = capsys.readouterr()
    lines = output.err.splitlines()
    (found,) = [line for line in lines if "SBGC" in line]
    assert found.startswith(start)
    assert (output.out, lines[-1]) == ("", "1 error in spec/")


def test_families_that_are_no_names_are_not_opened(tmp_path: Path) -> None:
    main_file = write_spec(tmp_path) / "simplebgc.yaml"
    text = main_file.read_text().replace(
        "[base, probe]", "[base, probe, ../../etc/passwd, null, 3]"
    )
    found = findings(tmp_path, text, "simplebgc.yaml")
    assert {d.code for d in found} == {"SBGC004"}
    assert {d.position.line for d in found} == {29}
    assert len(found) == 3


SPEC = (
    (HERE / "minimal" / "base.yaml").read_text(encoding="utf-8")
    + """\
  CMD_SHAPES:
    id: 2
    since: {firmware: 2.60, board: 3.0}
    summary: Everything that a body can hold.
    to_board:
      source: Outgoing commands L50-L60
      effect: reads
      errata: [E001]
      answer: {confirm: always, retry: safe}
      forms:
        simple:
          summary: Short.
          fields:
            - {name: MODE, type: Mode, summary: A mode.}
            - name: "axes[axis]"
              struct: Target
              summary: Targets.
              fields:
                - {name: "SPEED_{AXIS}", type: Speed, range: -100..100, summary: A speed.}
            - {name: A, type: u16, when: {field: MODE, is: MODE_ON}, summary: A number.}
        extended:
          summary: Long.
          fields:
            - {name: OPTIONS, type: Options, summary: Options.}
            - {name: S, type: Speed, alternative: {type: FineSpeed, of: OPTIONS, flag: OPTION_FINE}, summary: S.}
            - {name: "B[3]", type: Angle, special: {-32768: undefined}, summary: Numbers.}
            - {name: "SERVO{1..4}", type: u8, summary: Numbers.}
            - {name: N, type: u8, range: 0..4, summary: How many.}
            - {name: "pairs[N]", type: Pair, summary: Pairs.}
            - {reserved: 3}
            - {name: DATA, type: "bytes[]", max_count: 9, summary: The rest.}
"""
)


@pytest.mark.parametrize("part", range(4))
def test_a_small_spec(part: int, tmp_path: Path) -> None:
    spec = write_spec(tmp_path, SPEC, "base.yaml")
    contents = {path: path.read_bytes() for path in sorted(spec.iterdir())}
    # Most of what can be said is in this file.
    files = [spec / "base.yaml"] * 4 + list(contents)
    refused = 0
    for seed in range(part, 300, 4):
        file = files[seed // 4 % len(files)]
        file.write_bytes(broken(seed, contents[file]))
        if outcome(spec):
            refused += 1
        else:
            assert outputs(load_protocol(spec).layout, tmp_path)
        file.write_bytes(contents[file])
    assert refused > 40


def test_what_a_finding_quotes_is_one_short_line(tmp_path: Path) -> None:
    text = f'family: probe\n"key\\e[31m\\nnext\\u202e": 1\ncommands: {"x" * 5000}\n'
    found = findings(tmp_path, text)
    for finding in found:
        assert finding.message.isprintable() and len(finding.message) < 1200
    assert any("key\\x1b[31m\\nnext\\u202e" in finding.message for finding in found)
    assert any("not 'xxx" in finding.message for finding in found)


def test_the_time_per_finding_does_not_grow(tmp_path: Path) -> None:
    """Comparing each finding with all others would take minutes."""
    lines = "".join(f"key{number}: 1\n" for number in range(20_000))
    start = time.monotonic()
    assert len(findings(tmp_path, "family: probe\nsummary: A family.\n" + lines)) == 20_000
    assert time.monotonic() - start < LIMIT

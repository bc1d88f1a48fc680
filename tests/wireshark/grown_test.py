"""Elements of a list that grew with a firmware: the dissector finds their size as all other decoders do."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from line import ROOT, Packet, line, shown
from sbgc_command import frame

PROBE = """family: probe
summary: A list that grew.
commands:
  CMD_PROBE:
    id: 9
    summary: Lamps.
    from_board:
      source: L1
      fields:
        - {name: NUM, type: u8, summary: How many.}
        - name: LAMPS[NUM]
          struct: Lamp
          summary: Lamps.
          fields:
            - {name: LEVEL, type: u8, summary: Brightness.}
            - {name: COLOR, type: u16, since: {firmware: 2.70}, summary: Color.}
  CMD_REST:
    id: 10
    summary: Lamps without a counter.
    from_board:
      source: L1
      fields:
        - name: PLACES[]
          struct: Place
          summary: Places.
          fields:
            - {name: NAME, type: "bytes[19]", summary: Name.}
            - {name: HEIGHT, type: u16, since: {firmware: 2.70}, summary: Height.}
"""
CASES = [
    (9, "020105", {"level": ["1", "5"], "color": []}),
    (9, "02010203040506", {"level": ["1", "4"], "color": ["770", "1541"]}),
    (9, "0101020304", {"level": [], "color": []}),  # no firmware has elements of 4 bytes
    (10, 19 * "41" + 19 * "42", {"name": ["41" * 19, "42" * 19], "height": []}),
    (10, 19 * "41" + "0102", {"name": ["41" * 19], "height": ["513"]}),
]


@pytest.fixture(scope="module", name="dissector")
def dissector_of_probe(tmp_path_factory: pytest.TempPathFactory) -> Path:
    spec = tmp_path_factory.mktemp("probe") / "spec"
    shutil.copytree(ROOT / "tests/generator/minimal", spec)
    (spec / "probe.yaml").write_text(PROBE, encoding="utf-8")
    out = spec.parent / "generated"
    command = [
        ROOT / "generator/python",
        "-m",
        "sbgcgen",
        "generate",
        "--spec",
        spec,
        "--output",
        out,
    ]
    subprocess.run(command, check=True, timeout=120)
    (found,) = (out / "wireshark").glob("*.lua")
    return found


@pytest.mark.parametrize(("number", "body", "wanted"), CASES)
def test_all_sizes(
    dissector: Path, tmp_path: Path, number: int, body: str, wanted: dict[str, list[str]]
) -> None:
    (tmp_path / "packets").write_bytes(line([Packet(frame(number, bytes.fromhex(body)))]))
    (only,) = shown(tmp_path / "packets", dissector=dissector)
    for name, values in wanted.items():
        found = [one for one in only.fields if str(one.get("name")).endswith(f".{name}")]
        assert [_number(one) for one in found] == values, name
    assert ("malformed" in only.experts) == (not any(wanted.values()))


def _number(element: object) -> str:
    show = str(element.get("show"))  # type: ignore[attr-defined]
    return show.replace(":", "")

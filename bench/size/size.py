"""Measure the flash and RAM of the programs in programs/, and compare them with bench/README.md.

usage: size.py [--accept] FOLDER...    (the folders of the programs, one for each processor)

The figures are what a program needs in addition to `nothing`, linked with all that it calls. Fails if
one exceeds its bar in ../bars.yaml, or differs by over 2 % from the table in bench/README.md; --accept
writes that table. The keys of a bar:

flash, ram   the limits
per          the flash is divided by the number of functions with this name
same_as      the program needs exactly as much as this one; it has no row in the table
"""

from __future__ import annotations

import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

HERE = Path(__file__).parent
PROGRAMS = HERE / "programs"
README = HERE.parent / "README.md"
BARS: dict[str, dict[str, Any]] = yaml.safe_load((HERE.parent / "bars.yaml").read_text("utf-8"))[
    "size"
]
TOLERANCE = 0.02
PROCESSORS = {"m0plus": "Cortex-M0+", "m4f": "Cortex-M4F", "m7": "Cortex-M7"}
TABLE = re.compile(r"^\| program \|.*?(?=^$)", re.DOTALL | re.MULTILINE)


@dataclass(frozen=True)
class Size:
    flash: int
    ram: int

    def __str__(self) -> str:
        return f"{self.flash:,} + {self.ram:,}"


# The sizes of a program, by processor.
Row = dict[str, Size]


def output_of(*command: str | Path) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def linked_size(program: Path) -> Size:
    text, data, bss = map(int, output_of("arm-none-eabi-size", program).splitlines()[1].split()[:3])
    return Size(text + data, data + bss)


def count_functions(program: Path, name: str) -> int:
    symbols = output_of("arm-none-eabi-nm", "--demangle", program).splitlines()
    return sum(re.search(rf"\b{name}<", symbol) is not None for symbol in symbols)


def measure(name: str, folder: Path) -> Size:
    """Returns what a program needs in addition to the start-up."""
    size, start = linked_size(folder / name), linked_size(folder / "nothing")
    per = BARS.get(name, {}).get("per")
    parts = count_functions(folder / name, per) if per else 1
    return Size(round((size.flash - start.flash) / parts), size.ram - start.ram)


def summary(name: str) -> str:
    """Returns the comment at the beginning of a program."""
    comment = re.match(r"(?:// .*\n)+", (PROGRAMS / f"{name}.cpp").read_text(encoding="utf-8"))
    assert comment, name
    return comment[0].replace("// ", "").replace("\n", " ").strip()


def table(rows: dict[str, Row]) -> str:
    processors = next(iter(rows.values())).keys()
    lines = [
        f"| program | {' | '.join(PROCESSORS[each] for each in processors)} | at most | |",
        f"|---|{'--:|' * len(processors)}--:|---|",
    ]
    for name, row in rows.items():
        bar = BARS.get(name, {})
        limit = " + ".join(f"{bar[key]:,}" for key in ("flash", "ram") if key in bar)
        cells = [f"`{name}`", *map(str, row.values()), limit, summary(name)]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def accepted_rows() -> dict[str, Row]:
    """Returns the rows of the table in the README."""
    found = TABLE.search(README.read_text(encoding="utf-8"))
    assert found, "bench/README.md has no table of programs"
    head, _, *lines = ([cell.strip() for cell in line.split("|")] for line in found[0].splitlines())
    columns = {key: head.index(name) for key, name in PROCESSORS.items() if name in head}
    return {
        cells[1].strip("`"): {key: read_size(cells[column]) for key, column in columns.items()}
        for cells in lines
    }


def read_size(cell: str) -> Size:
    flash, ram = cell.replace(",", "").split(" + ")
    return Size(int(flash), int(ram))


def is_close(now: int, before: int) -> bool:
    return abs(now - before) <= before * TOLERANCE


def over_the_bars(rows: dict[str, Row]) -> list[str]:
    wrong = []
    for name, row in rows.items():
        bar = BARS.get(name, {})
        for processor, size in row.items():
            where = f"{name} on {PROCESSORS[processor]}"
            if size.flash > bar.get("flash", size.flash) or size.ram > bar.get("ram", size.ram):
                wrong.append(f"{where}: {size} bytes exceed the bar")
            if "same_as" in bar and size != rows[bar["same_as"]][processor]:
                wrong.append(f"{where}: {size} bytes, but {bar['same_as']} needs other ones")
    return wrong


def off_the_table(rows: dict[str, Row], accepted: dict[str, Row]) -> list[str]:
    wrong = [f"{name}: no such program" for name in accepted.keys() - rows.keys()]
    for name, row in rows.items():
        for processor, now in row.items():
            before = accepted.get(name, {}).get(processor)
            if before is None:
                wrong.append(f"{name} on {PROCESSORS[processor]}: missing in the table")
            elif not (is_close(now.flash, before.flash) and is_close(now.ram, before.ram)):
                wrong.append(f"{name} on {PROCESSORS[processor]}: {now} bytes, not {before}")
    return wrong


def main(arguments: list[str]) -> int:
    accept = arguments[:1] == ["--accept"]
    folders = [Path(path) for path in arguments[accept:]]
    if not folders:
        print(__doc__, file=sys.stderr)
        return 2
    names = sorted({path.stem for path in PROGRAMS.glob("*.cpp")} | BARS.keys() - {"nothing"})
    measured = {name: {path.name: measure(name, path) for path in folders} for name in names}
    rows = {name: row for name, row in measured.items() if "same_as" not in BARS.get(name, {})}
    rows.pop("nothing")
    rows = dict(sorted(rows.items(), key=lambda row: row[1][folders[0].name].flash))
    print(table(rows), end="")
    too_large, changed = over_the_bars(measured), []
    if accept:
        README.write_text(TABLE.sub(table(rows), README.read_text(encoding="utf-8")), "utf-8")
    else:
        changed = off_the_table(rows, accepted_rows())
    for complaint in too_large + changed:
        print(f"size: {complaint}", file=sys.stderr)
    if changed:
        print("./dev size --accept writes the table, if there is a reason", file=sys.stderr)
    return 1 if too_large or changed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

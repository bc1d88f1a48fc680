"""Measure which lines the committed inputs of the fuzzers run, and compare each area with the bar.

usage: coverage.py BUILD [--lines]

BUILD is the folder of the preset `coverage`. Each fuzzer replays its committed inputs; a line counts
as covered if any fuzzer runs it in any instantiation. areas.yaml lists the areas and the lines that
need no coverage, each with the reason. Fails if an area is below its bar, or if an excepted line is
covered or no longer exists. --lines prints the lines that are not covered.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

ROOT = Path(__file__).resolve().parents[2]
AREAS = Path(__file__).with_name("areas.yaml")

Lines = dict[int, bool]  # by number: whether the line is covered


@dataclass
class Area:
    """Files that are measured together."""

    name: str
    files: re.Pattern[str]
    bar: float
    covered: int = 0
    excepted: int = 0
    missing: list[str] = field(default_factory=list)

    @property
    def share(self) -> float:
        """The share of covered lines, of those that need it."""
        needed = self.covered + len(self.missing)
        return 100 * self.covered / needed if needed else 0.0


def replay(program: Path, folder: Path) -> dict[str, Lines]:
    """Runs a fuzzer on its committed inputs; returns the lines of each file of the project."""
    name = program.name[len("fuzz_") :]
    raw, profile = folder / f"{name}.profraw", folder / f"{name}.profdata"
    places = (program.parent / "seeds", program.parent / "corpus", ROOT / "fuzz/regressions")
    inputs = [str(place / name) for place in places]
    done = subprocess.run(
        [program, *inputs],
        env={**os.environ, "LLVM_PROFILE_FILE": str(raw)},
        capture_output=True,
        text=True,
    )
    if done.returncode != 0:
        sys.exit(f"coverage: {program.name} failed:\n{done.stdout}{done.stderr}")
    subprocess.run(["llvm-profdata", "merge", "-sparse", "-o", profile, raw], check=True)
    exported = subprocess.run(
        ["llvm-cov", "export", "-format=lcov", f"-instr-profile={profile}", program],
        check=True,
        capture_output=True,
        text=True,
    )
    return dict(files_of(exported.stdout))


def files_of(lcov: str) -> Iterator[tuple[str, Lines]]:
    """The files of the project in the output of llvm-cov, and their lines."""
    for record in lcov.split("end_of_record"):
        source = re.search(r"^SF:(.*)$", record, re.M)
        path = os.path.relpath(os.path.realpath(source[1]), ROOT) if source else "../"
        if path.startswith("../"):
            continue
        counts = re.findall(r"^DA:(\d+),(\d+)$", record, re.M)
        yield path, {int(line): count != "0" for line, count in counts}


def measure(build: Path) -> dict[str, Lines]:
    """The lines of all files, of all fuzzers together."""
    folder = build / "profiles"
    folder.mkdir(exist_ok=True)
    programs = sorted(p for p in (build / "fuzz").glob("fuzz_*") if os.access(p, os.X_OK))
    if not programs:
        sys.exit(f"coverage: no fuzzers in {build}/fuzz")
    files: dict[str, Lines] = {}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for measured in pool.map(lambda program: replay(program, folder), programs):
            for path, lines in measured.items():
                union = files.setdefault(path, {})
                for line, is_covered in lines.items():
                    union[line] = union.get(line, False) or is_covered
    return files


def block(lines: list[str], first: int) -> range:
    """The numbers of the lines from `first` to the brace that closes what begins there."""
    indent = lines[first - 1][: -len(lines[first - 1].lstrip())]
    last = first
    while last < len(lines) and lines[last - 1].rstrip(";") != indent + "}":
        last += 1
    return range(first, last + 1)


def named_lines(part: dict[str, str], texts: dict[str, list[str]]) -> dict[str, set[int]]:
    """The numbers of the lines that a part of an exception names, by file."""
    result: dict[str, set[int]] = {}
    for path, lines in texts.items():
        if re.fullmatch(part["files"], path):
            numbers = list(range(1, len(lines) + 1))
            kind = next((kind for kind in ("line", "function") if kind in part), None)
            if kind:
                numbers = [n for n in numbers if lines[n - 1].strip() == part[kind]]
            if kind == "function":
                numbers = [n for first in numbers for n in block(lines, first)]
            result[path] = set(numbers)
    return result


def parts_of(entry: dict[str, Any]) -> Iterator[dict[str, str]]:
    """The parts of an exception, each of which must name a line that is not covered."""
    files = entry["files"]
    kinds = [kind for kind in ("line", "function") if kind + "s" in entry]
    for kind in kinds:
        yield from ({"files": files, kind: text} for text in entry[kind + "s"])
    if not kinds:
        yield {"files": files}


def main() -> int:
    """Prints the share of each area."""
    options = sys.argv[1:]
    if not options or len(options) > 2 or options[1:] not in ([], ["--lines"]):
        sys.exit(__doc__)
    files = measure(Path(options[0]).resolve())
    known = yaml.safe_load(AREAS.read_text())
    texts = {path: (ROOT / path).read_text().splitlines() for path in sorted(files)}
    uncovered = {path: {n for n, done in files[path].items() if not done} for path in files}

    exceptions: dict[str, set[int]] = {}
    stale = []
    for part in (part for entry in known["exceptions"] for part in parts_of(entry)):
        named = named_lines(part, texts)
        if not any(numbers & uncovered[path] for path, numbers in named.items()):
            stale.append(" ".join(part.values()))
        for path, numbers in named.items():
            exceptions.setdefault(path, set()).update(numbers)

    areas = [Area(a["name"], re.compile(a["files"]), a["bar"]) for a in known["areas"]]
    for path, lines in sorted(files.items()):
        area = next((area for area in areas if area.files.fullmatch(path)), None)
        if area is None:
            continue
        for number, is_covered in sorted(lines.items()):
            if is_covered:
                area.covered += 1
            elif number in exceptions.get(path, ()):
                area.excepted += 1
            else:
                area.missing.append(f"{path}:{number}: {texts[path][number - 1].strip()}")

    print(f"{'area':20}{'lines':>8}{'excepted':>10}{'missing':>9}{'covered':>10}")
    for area in areas:
        total = area.covered + area.excepted + len(area.missing)
        verdict = "" if area.share >= area.bar else f"  below {area.bar} %"
        print(
            f"{area.name:20}{total:8}{area.excepted:10}{len(area.missing):9}"
            f"{area.share:8.1f} %{verdict}"
        )
    if options[1:]:
        print(*(line for area in areas for line in area.missing), sep="\n")
    for problem in stale:
        print(f"coverage: areas.yaml excepts what is covered or does not exist: {problem}")
    return int(bool(stale) or any(area.share < area.bar for area in areas))


if __name__ == "__main__":
    sys.exit(main())

"""Print the figures of benchmark runs with the bars that they have to reach.

usage: report.py [--svg FILE] FILE...    (written with --benchmark_format=json)

A benchmark is named group/case. The case "memcpy" is the baseline of its group. Repetitions count by their
median. bars.yaml, next to this script, has the bars; the last line tells how many hold. --svg draws the
speed of some relative to memcpy.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any, Optional

import yaml

BASELINE = "memcpy"
NANOSECONDS = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}

# Suffixes that Google Benchmark appends to a name.
RUN_SUFFIXES = ("repeats:", "min_time:", "min_warmup_time:", "iterations:", "real_time")

# Numbers that Google Benchmark reports for every run; all others are counters.
FACTS = """family_index per_family_instance_index repetitions repetition_index threads iterations
real_time cpu_time bytes_per_second items_per_second""".split()


@dataclass(frozen=True)
class Figure:
    """The median of one benchmark's repetitions. The time is that of one item."""

    name: str
    nanoseconds: float
    bytes_per_second: Optional[float]
    counters: dict[str, float]

    @property
    def group(self) -> str:
        return self.name.partition("/")[0]

    @property
    def case(self) -> str:
        return self.name.partition("/")[2]

    def speed_against(self, other: Figure) -> float:
        if self.bytes_per_second and other.bytes_per_second:
            return self.bytes_per_second / other.bytes_per_second
        return other.nanoseconds / self.nanoseconds


@dataclass(frozen=True)
class Bar:
    """A limit: at least or at most this number of units."""

    is_minimum: bool
    limit: float
    unit: str

    @classmethod
    def parse(cls, text: str) -> Bar:
        found = re.fullmatch(r"(>=|<=) ([\d.]+) (?:x )?(\S+)", text)
        if not found:
            raise SystemExit(f"report: invalid bar: {text}")
        return cls(found[1] == ">=", float(found[2]), found[3])

    def measured(self, figure: Figure, figures: dict[str, Figure]) -> float:
        if self.unit in figures:
            return figure.nanoseconds / figures[self.unit].nanoseconds
        return figure.counters[self.unit]

    def holds(self, figure: Figure, figures: dict[str, Figure]) -> bool:
        value = self.measured(figure, figures)
        return value >= self.limit if self.is_minimum else value <= self.limit


def bare_name(run_name: str) -> str:
    return "/".join(p for p in run_name.split("/") if not p.startswith(RUN_SUFFIXES))


def read_figures(document: dict[str, Any]) -> list[Figure]:
    runs: dict[str, list[dict[str, Any]]] = {}
    for run in document["benchmarks"]:
        if run.get("error_occurred"):
            raise SystemExit(f"report: {run['name']} failed: {run.get('error_message')}")
        if run.get("run_type", "iteration") == "iteration":
            runs.setdefault(bare_name(run.get("run_name", run["name"])), []).append(run)
    figures = []
    for name, repetitions in runs.items():
        speeds = [r["bytes_per_second"] for r in repetitions if "bytes_per_second" in r]
        times = [
            (
                1e9 / r["items_per_second"]
                if "items_per_second" in r
                else r["cpu_time"] * NANOSECONDS[r["time_unit"]]
            )
            for r in repetitions
        ]
        names = [k for k, v in repetitions[0].items() if k not in FACTS and not isinstance(v, str)]
        counters = {k: median(r[k] for r in repetitions) for k in names}
        figures.append(Figure(name, median(times), median(speeds) if speeds else None, counters))
    return figures


def time_text(nanoseconds: float) -> str:
    unit = next((u for u in ("s", "ms", "us") if nanoseconds >= NANOSECONDS[u]), "ns")
    return f"{nanoseconds / NANOSECONDS[unit]:.3g} {unit}"


def print_table(figures: dict[str, Figure], bars: dict[str, str]) -> None:
    width = max(len(f.case) for f in figures.values())
    group = ""
    for name, figure in figures.items():
        if figure.group != group:
            group = figure.group
            print(f"\n{group:<{width + 2}} {'time':>9} {'MB/s':>8} {'x memcpy':>9}")
        speed = f"{figure.bytes_per_second / 1e6:8.0f}" if figure.bytes_per_second else f"{'':>8}"
        baseline = figures.get(f"{group}/{BASELINE}")
        ratio = f"{figure.speed_against(baseline):9.3f}" if baseline else f"{'':>9}"
        line = f"  {figure.case:<{width}} {time_text(figure.nanoseconds):>9} {speed} {ratio}"
        line += "".join(f"  {key} {value:.4g}" for key, value in figure.counters.items())
        if name in bars:
            held = Bar.parse(bars[name]).holds(figure, figures)
            line += f"  {bars[name]}: {'holds' if held else 'DOES NOT HOLD'}"
        print(line)


def print_verdict(figures: dict[str, Figure], bars: dict[str, str]) -> None:
    missed = [
        name
        for name, bar in bars.items()
        if name in figures and not Bar.parse(bar).holds(figures[name], figures)
    ]
    measured = sum(name in figures for name in bars)
    print(f"\n{measured - len(missed)} of {len(bars)} bars hold", end="")
    print(f"; {len(bars) - measured} are not measured" if measured != len(bars) else "")
    for name in missed:
        bar = Bar.parse(bars[name])
        value = bar.measured(figures[name], figures)
        print(f"  {name}: {bars[name]}, but it is {value:.3g}")


# The picture

ROW, TEXT, LINE = 22, 190, 420  # heights and widths


def draw(figures: dict[str, Figure], names: list[str]) -> str:
    """Draws the speed of these figures relative to memcpy."""
    drawn = [figures[name] for name in names if name in figures]
    ratios = [f.speed_against(figures[f"{f.group}/{BASELINE}"]) for f in drawn]
    longest = max([1.0, *ratios])
    height = ROW * len(drawn) + 46
    scale = LINE / longest
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{TEXT + LINE + 60}" height="{height}" '
        'font-family="sans-serif" font-size="12" role="img" aria-label="Speed relative to memcpy">',
        "<style>text{fill:#444}.bar{fill:#3b7dd8}.one{stroke:#999;stroke-dasharray:3}"
        "@media(prefers-color-scheme:dark){text{fill:#bbb}}</style>",
    ]
    for row, (figure, ratio) in enumerate(zip(drawn, ratios)):
        y = ROW * row + 8
        lines += [
            f'<text x="{TEXT - 8}" y="{y + 12}" text-anchor="end">{figure.name}</text>',
            f'<rect class="bar" x="{TEXT}" y="{y}" width="{ratio * scale:.1f}" height="15"/>',
            f'<text x="{TEXT + ratio * scale + 6:.1f}" y="{y + 12}">{ratio:.2f}</text>',
        ]
    one = TEXT + scale
    bottom = ROW * len(drawn) + 8
    lines += [
        f'<line class="one" x1="{one:.1f}" y1="0" x2="{one:.1f}" y2="{bottom}"/>',
        f'<text x="{one:.1f}" y="{bottom + 14}" text-anchor="middle">memcpy</text>',
        f'<text x="{TEXT}" y="{bottom + 32}">Speed relative to memcpy of the same bytes.</text>',
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--svg", type=Path)
    parser.add_argument("files", type=Path, nargs="+")
    arguments = parser.parse_args()
    wanted = yaml.safe_load(Path(__file__).with_name("bars.yaml").read_text(encoding="utf-8"))
    figures: dict[str, Figure] = {}
    for path in arguments.files:
        document = json.loads(path.read_text(encoding="utf-8"))
        figures.update((figure.name, figure) for figure in read_figures(document))
    order = sorted(figures.values(), key=lambda f: (f.group, f.case != BASELINE, f.case))
    figures = {figure.name: figure for figure in order}
    print_table(figures, wanted["bars"])
    print_verdict(figures, wanted["bars"])
    if arguments.svg:
        arguments.svg.write_text(draw(figures, wanted["picture"]), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())

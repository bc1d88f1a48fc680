"""Print the figures of Google Benchmark runs relative to memcpy of the same run.

usage: ratios.py FILE...    (written with --benchmark_format=json; - is standard input)

A benchmark is named group/case. The case "memcpy" is the baseline of its group: the last column is the
speed relative to it, followed by the benchmark's own counters. Repetitions count by their median.
Benchmarks that report no bytes are compared by time.
"""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from statistics import median
from typing import Any, Optional

BASELINE = "memcpy"


@dataclass(frozen=True)
class Figure:
    """The median of one benchmark's repetitions."""

    name: str
    nanoseconds: float
    bytes_per_second: Optional[float]
    counters: dict[str, float]

    def speed_against(self, baseline: Figure) -> float:
        if self.bytes_per_second and baseline.bytes_per_second:
            return self.bytes_per_second / baseline.bytes_per_second
        return baseline.nanoseconds / self.nanoseconds


NANOSECONDS = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}

# Suffixes that Google Benchmark appends to a name.
RUN_SUFFIXES = ("repeats:", "min_time:", "min_warmup_time:", "iterations:", "real_time")


# Numbers that Google Benchmark reports for every run; all others are counters.
FACTS = """family_index per_family_instance_index repetitions repetition_index threads iterations
real_time cpu_time bytes_per_second items_per_second""".split()


def bare_name(run_name: str) -> str:
    return "/".join(p for p in run_name.split("/") if not p.startswith(RUN_SUFFIXES))


def read_figures(document: dict[str, Any]) -> list[Figure]:
    runs: dict[str, list[dict[str, Any]]] = {}
    for run in document["benchmarks"]:
        if run.get("error_occurred"):
            raise SystemExit(f"ratios: {run['name']} failed: {run.get('error_message')}")
        if run.get("run_type", "iteration") == "iteration":
            runs.setdefault(bare_name(run.get("run_name", run["name"])), []).append(run)
    figures = []
    for name, repetitions in runs.items():
        speeds = [r["bytes_per_second"] for r in repetitions if "bytes_per_second" in r]
        time = median(r["cpu_time"] * NANOSECONDS[r["time_unit"]] for r in repetitions)
        names = [k for k, v in repetitions[0].items() if k not in FACTS and not isinstance(v, str)]
        counters = {k: median(r[k] for r in repetitions) for k in names}
        figures.append(Figure(name, time, median(speeds) if speeds else None, counters))
    return figures


def print_table(figures: list[Figure]) -> None:
    groups: dict[str, list[Figure]] = {}
    for figure in figures:
        groups.setdefault(figure.name.partition("/")[0], []).append(figure)
    width = max(len(f.name.partition("/")[2]) for f in figures)
    for group, members in groups.items():
        baseline = next((f for f in members if f.name == f"{group}/{BASELINE}"), None)
        print(f"\n{group:<{width + 2}} {'ns':>12} {'MB/s':>10} {'x memcpy':>10}")
        for f in members:
            speed = f"{f.bytes_per_second / 1e6:10.0f}" if f.bytes_per_second else f"{'':>10}"
            ratio = f"{f.speed_against(baseline):10.3f}" if baseline else f"{'':>10}"
            counters = "".join(f"  {name} {value:.4g}" for name, value in f.counters.items())
            name = f.name.partition("/")[2]
            print(f"  {name:<{width}} {f.nanoseconds:12.1f} {speed} {ratio}{counters}")


def main(paths: list[str]) -> int:
    if not paths:
        print(__doc__, file=sys.stderr)
        return 2
    for path in paths:
        if path == "-":
            document = json.load(sys.stdin)
        else:
            with open(path, encoding="utf-8") as file:
                document = json.load(file)
        print_table(read_figures(document))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""Runs random specs through the generator, a compiler, and random messages in both directions.

For each seed, a random spec (spec_maker.py) is generated, and the program of tests/core/codec_vectors_test.cpp
is compiled with the generated headers. Its input is vectors of random messages from the reference codec
(random_messages.py), with which the C++ codec must agree byte by byte, including the bodies it rejects, and
random settings for headers_test.cpp.

The folder of a failure is kept; `--seed N` reproduces it.
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
import traceback
from pathlib import Path

import random_messages
from spec_maker import write_spec

from sbgcgen.build import load_protocol
from sbgcgen.spec.diagnostics import SpecError
from sbgcgen.output import Output
from sbgcgen.targets import outputs

ROOT = Path(__file__).resolve().parents[2]
SOURCES = [
    *(ROOT / "runtime/any/src").glob("*.cpp"),
    ROOT / "tests/core/messages.cpp",
    ROOT / "tests/core/codec_vectors_test.cpp",
    ROOT / "tests/core/framing_vectors_test.cpp",
    ROOT / "tests/random_schemas/headers_test.cpp",
]
WARNINGS = """-Wall -Wextra -Wpedantic -Wcast-align -Wcast-qual -Wconversion -Wdouble-promotion
    -Wextra-semi -Wformat=2 -Wimplicit-fallthrough -Wold-style-cast -Wshadow -Wsign-conversion -Wundef
    -Wunused -Werror""".split()
SANITIZERS = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]


class Failure(Exception):
    """A failure of one spec."""


class Trial:
    """One random spec in its own folder."""

    def __init__(self, seed: int, folder: Path, options: argparse.Namespace) -> None:
        self.seed = seed
        self.folder = folder
        self.options = options
        self.spec = folder / "spec"
        self.vectors = folder / "generated" / "vectors"
        self.program = folder / "program"

    def run(self) -> str:
        """Runs all steps; returns a summary of their amount. Raises Failure."""
        shutil.rmtree(self.folder, ignore_errors=True)
        write_spec(self.spec, self.seed, self.options.size)
        messages, lines = self.generate()
        self.import_modules()
        compiler = self.options.compiler[self.seed % len(self.options.compiler)]
        self.compile(compiler)
        self.compare()
        return f"{messages} messages, {lines} random lines, {Path(compiler).name}"

    def generate(self) -> tuple[int, int]:
        """Runs the generator, and adds vectors of random messages and random settings."""
        try:
            layout = load_protocol(self.spec, allow_slips=True).layout
            Output(self.folder / "generated", outputs(layout, self.folder)).write()
            lines = list(random_messages.lines_of(layout, self.seed, self.options.messages))
            settings = list(
                random_messages.settings_lines_of(layout, self.seed, self.options.messages)
            )
        except SpecError as error:
            raise Failure(f"the spec has findings:\n{error}") from error
        except Exception as error:
            raise Failure(f"the generator failed:\n{traceback.format_exc()}") from error
        (self.vectors / "random.jsonl").write_text("".join(lines), encoding="utf-8")
        told = "".join(settings)
        (self.folder / "generated" / "settings.jsonl").write_text(told, encoding="utf-8")
        return len(layout.messages), len(lines)

    def import_modules(self) -> None:
        """Imports the classes of the Python package, which needs its extension only for values."""
        package = self.folder / "package" / "sbgc"
        shutil.copytree(ROOT / "python" / "sbgc", package)
        shutil.copytree(self.folder / "generated" / "python" / "sbgc" / "msg", package / "msg")
        (package / "_core.py").write_text("class AnyMessage: get = len\n", encoding="utf-8")
        (package / "__init__.py").write_text("", encoding="utf-8")
        command = [sys.executable, "-W", "error", "-c", "import sbgc.msg"]
        environment = {**os.environ, "PYTHONPATH": str(package.parent)}
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        if done.returncode:
            raise Failure(f"the Python modules cannot be imported:\n{done.stderr}")

    def compile(self, compiler: str) -> None:
        """Compiles and links the program that runs the vectors."""
        flags = ["-std=c++20", *WARNINGS, '-DSBGC_GENERATED="."']
        flags += ["-O0", *(["-g1", *SANITIZERS] if self.options.sanitize else [])]
        folders = ("generated/include", *ROOT.glob("runtime/*/include"), ROOT / "tests/core")
        flags += [f"-I{folder}" for folder in folders]
        command = [*shlex.split(self.options.launcher), compiler, *flags]
        objects = [f"{source.stem}.o" for source in SOURCES]
        steps = [
            subprocess.Popen(
                [*command, "-c", str(source), "-o", name],
                cwd=self.folder,
                stderr=subprocess.PIPE,
                text=True,
            )
            for source, name in zip(SOURCES, objects)
        ]
        for step in steps:
            _, errors = step.communicate()
            if step.returncode:
                told = [text for text in errors.splitlines() if "error:" in text]
                raise Failure("it does not compile:\n" + "\n".join(told[:5] or [errors[:2000]]))
        libraries = ["-lgtest", "-lgtest_main", "-pthread"]
        linked = [compiler, *flags, *objects, "-o", "program", *libraries]
        subprocess.run(linked, cwd=self.folder, check=True)

    def compare(self) -> None:
        """Runs the vectors; reports the shortest one that fails."""
        output = self.run_program(self.folder / "generated")
        if not output:
            return
        failing = []
        for name, number in sorted(set(re.findall(r"(\w+)\.jsonl:([0-9]+)", output))):
            lines = (self.vectors / f"{name}.jsonl").read_text(encoding="utf-8").splitlines()
            failing.append(lines[int(number) - 1])
        if not failing:
            raise Failure(output[-3000:])
        shortest = self.folder / "shortest" / "vectors"
        shortest.mkdir(parents=True)
        line = min(failing, key=len)
        (shortest / "failure.jsonl").write_text(line + "\n", encoding="utf-8")
        told = self.run_program(shortest.parent, "--gtest_filter=*Vectors*")
        raise Failure(f"{len(failing)} vectors fail; the shortest:\n{line[:1500]}\n{told[:3000]}")

    def run_program(self, folder: Path, *options: str) -> str:
        """Runs the program on a folder; returns its output if it fails."""
        command = [str(self.folder.resolve() / "program"), "--gtest_brief=1", *options]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        return (done.stdout + done.stderr) if done.returncode else ""


def options_of(arguments: list[str] | None) -> argparse.Namespace:
    """Returns the options of a run."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--seed", type=int, help="seed of the first spec (default: 1; long: any)")
    parser.add_argument("--count", type=int, help="number of specs, with consecutive seeds")
    parser.add_argument("--messages", type=int, help="random lines for each message")
    parser.add_argument("--size", type=int, help="approximate number of commands in a spec")
    parser.add_argument("--sanitize", action="store_true", help="with address and UB sanitizers")
    parser.add_argument("--compiler", action="append", help="used in turn if there are several")
    parser.add_argument("--launcher", default="", help="compiler launcher, such as ccache")
    parser.add_argument("--folder", type=Path, default=ROOT / "build/random_schemas")
    parser.add_argument("--keep", action="store_true", help="also keep specs that passed")
    parser.add_argument("--long", action="store_true", help="many large specs, with sanitizers")
    options = parser.parse_args(arguments)
    defaults = {"count": 1, "messages": 60, "size": 4, "seed": 1}
    if options.long:
        options.sanitize = True
        fresh = int(time.time()) % 1_000_000
        defaults = {"count": 20, "messages": 250, "size": 10, "seed": fresh}
    for name, value in defaults.items():
        if getattr(options, name) is None:
            setattr(options, name, value)
    if not options.compiler:
        both = [name for name in ("g++", "clang++") if shutil.which(name)]
        options.compiler = both if options.long else [os.environ.get("CXX", "g++")]
    return options


def main(arguments: list[str] | None = None) -> int:
    """Runs the trials; returns exit status 1 if one fails."""
    options = options_of(arguments)
    failed = []
    for seed in range(options.seed, options.seed + options.count):
        folder = options.folder / str(seed)
        begin = time.monotonic()
        print(f"seed {seed}: ", end="", flush=True)
        try:
            told = Trial(seed, folder, options).run()
            print(f"{told}, {time.monotonic() - begin:.1f} s", flush=True)
            if not options.keep:
                shutil.rmtree(folder)
        except Failure as failure:
            failed.append(seed)
            again = f"--seed {seed} --size {options.size} --messages {options.messages}"
            print(
                f"FAILED\n{failure}\nkept: {folder}\nagain: {Path(__file__).name} {again}",
                flush=True,
            )
    if failed:
        print(f"failed seeds: {' '.join(map(str, failed))}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

"""Write the inputs of the fuzzers as libFuzzer reads them, or gather inputs that it has found.

usage: corpus.py FOLDER                    write fuzz/corpus/FUZZER.txt as files FOLDER/corpus/FUZZER/1, 2 ...
                                           and fuzz/regressions/FUZZER.txt as FOLDER/regressions/FUZZER/NAME
       corpus.py --add FUZZER FILE...      add these inputs to fuzz/corpus/FUZZER.txt
       corpus.py --failed FUZZER FILE NAME add an input that has failed to fuzz/regressions/FUZZER.txt

A line of a corpus is an input in hex, the shortest first; a line of regressions has its name before it.
"""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

HERE = Path(__file__).parent
CORPUS = HERE / "corpus"
REGRESSIONS = HERE / "regressions"


def inputs_of(text: Path) -> dict[str, bytes]:
    """The inputs of a text file by name; those without a name are numbered."""
    lines = text.read_text().splitlines() if text.exists() else []
    words = ([str(number), *line.split()] for number, line in enumerate(lines, start=1))
    return {name: bytes.fromhex(data) for *_, name, data in words}


def write(folder: Path) -> None:
    for texts in (CORPUS, REGRESSIONS):
        shutil.rmtree(folder / texts.name, ignore_errors=True)
        for text in texts.glob("*.txt"):
            target = folder / texts.name / text.stem
            target.mkdir(parents=True)
            for name, data in inputs_of(text).items():
                (target / name).write_bytes(data)


def add(fuzzer: str, files: list[str]) -> None:
    corpus = CORPUS / f"{fuzzer}.txt"
    data = {*inputs_of(corpus).values(), *(Path(file).read_bytes() for file in files)}
    corpus.write_text("".join(f"{one.hex()}\n" for one in sorted(data, key=lambda d: (len(d), d))))


def add_failed(fuzzer: str, file: str, name: str) -> None:
    regressions = REGRESSIONS / f"{fuzzer}.txt"
    known = {**inputs_of(regressions), name: Path(file).read_bytes()}
    regressions.write_text("".join(f"{one} {data.hex()}\n" for one, data in sorted(known.items())))


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["--add", fuzzer, *files] if files:
            add(fuzzer, files)
        case ["--failed", fuzzer, file, name]:
            add_failed(fuzzer, file, name)
        case [folder]:
            write(Path(folder))
        case _:
            sys.exit(__doc__)

"""Write the corpora of the fuzzers as libFuzzer reads them, or gather inputs that it has found.

usage: corpus.py FOLDER           write fuzz/corpus/NAME.txt as files FOLDER/NAME/1, 2 ...
       corpus.py --add NAME FILE...  add these inputs to fuzz/corpus/NAME.txt

A corpus has one input in hex a line, the shortest first.
"""

from __future__ import annotations

import sys
from pathlib import Path

CORPUS = Path(__file__).parent / "corpus"


def inputs_of(corpus: Path) -> list[bytes]:
    return [bytes.fromhex(line) for line in corpus.read_text().splitlines()]


def write(folder: Path) -> None:
    for corpus in CORPUS.glob("*.txt"):
        target = folder / corpus.stem
        target.mkdir(parents=True, exist_ok=True)
        for old in target.iterdir():
            old.unlink()
        for number, data in enumerate(inputs_of(corpus), start=1):
            (target / str(number)).write_bytes(data)


def add(name: str, files: list[str]) -> None:
    corpus = CORPUS / f"{name}.txt"
    known = inputs_of(corpus) if corpus.exists() else []
    data = {*known, *(Path(file).read_bytes() for file in files)}
    corpus.write_text("".join(f"{one.hex()}\n" for one in sorted(data, key=lambda d: (len(d), d))))


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["--add", name, *files] if files:
            add(name, files)
        case [folder]:
            write(Path(folder))
        case _:
            sys.exit(__doc__)

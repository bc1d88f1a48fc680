"""A record of the files that the last run of `generate` read and wrote.

If all files match the record, a run has nothing to do. This module imports nothing slow, so that such
a run is quick.
"""

from __future__ import annotations

import hashlib
import os
import sys
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path

from sbgcgen.blocking import source_of

_HERE = Path(__file__).resolve().parent


def inputs(project: Path) -> list[Path]:
    """Files that the output depends on, besides the spec."""
    files = [*_files_in(_HERE), *_files_in(_HERE.parent / "schema"), *source_of(project)]
    return [path for path in files if "__pycache__" not in path.parts]


class Record:
    """The record for one spec folder and one output folder of a project.

    It must be made before the spec is read: if a file changes meanwhile, the next run reads it again.
    """

    def __init__(self, project: Path, spec_dir: Path, output: Path) -> None:
        self._output = output
        name = _digest({"spec": bytes(spec_dir), "output": bytes(output)})[:16]
        self._path = project / "build" / "generator" / f"{name}.txt"
        self._inputs = ""
        with suppress(OSError):  # loading the spec reports it
            generator = {"": sys.version.encode(), **_contents(_HERE, inputs(project))}
            spec = _contents(spec_dir, _files_in(spec_dir))
            self._inputs = f"{_digest(generator)} {_digest(spec)}"

    def unchanged(self) -> tuple[int, list[Path]] | None:
        """The number of files in the output, and the spec files read for them.

        None if any file of the spec, the generator or the output differs from the record.
        """
        with suppress(OSError, ValueError):
            read, written, *spec_files = self._path.read_text(encoding="utf-8").split("\n")[:-1]
            files = _contents(self._output, _files_in(self._output))
            if self._inputs and read == self._inputs and written == _digest(files):
                return len(files), [Path(file) for file in spec_files]
        return None

    def write(self, files: Mapping[str, bytes], spec_files: Iterable[Path]) -> None:
        """Record a run that has written these files."""
        lines = [self._inputs, _digest(files), *map(str, spec_files)]
        # Other programs see all of it or nothing. On a read-only file system, no record is written.
        unfinished = self._path.with_name(f"{self._path.name}.{os.getpid()}")
        with suppress(OSError):
            self._path.parent.mkdir(parents=True, exist_ok=True)
            unfinished.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
            unfinished.replace(self._path)


def _files_in(folder: Path) -> list[Path]:
    return [Path(at, name) for at, _, names in os.walk(folder) for name in names]


def _contents(folder: Path, files: Iterable[Path]) -> dict[str, bytes]:
    return {os.path.relpath(path, folder): path.read_bytes() for path in files}


def _digest(files: Mapping[str, bytes]) -> str:
    """A digest of names and contents."""
    digest = hashlib.blake2b(digest_size=32)
    for name in sorted(files):
        digest.update(f"{len(files[name])} {name}\n".encode(errors="surrogateescape"))
        digest.update(files[name])
    return digest.hexdigest()

"""Writes the changed files of an output folder and reports differences."""

from __future__ import annotations

import errno
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Output:
    """The expected content of a folder."""

    folder: Path
    files: dict[str, bytes]
    # A file that every such output contains. A folder without it is not cleaned.
    mark: str = "frames.jsonl"

    def _there(self) -> set[str]:
        """The files in the folder."""
        if not self.folder.is_dir():
            return set()
        return {
            p.relative_to(self.folder).as_posix() for p in self.folder.rglob("*") if p.is_file()
        }

    def drift(self) -> list[str]:
        """One line for each missing, differing or unexpected file."""
        stale = sorted(self._there() - self.files.keys())
        lines = [f"{name}: not generated from the spec" for name in stale]
        for name, content in sorted(self.files.items()):
            path = self.folder / name
            if not path.is_file():
                lines.append(f"{name}: missing")
            elif path.read_bytes() != content:
                lines.append(f"{name}: differs")
        return lines

    def write(self) -> int:
        """Update the folder; returns how many files were written or deleted.

        Deletes files that are not generated, so the folder must be empty or hold an earlier output.
        Raises OSError, also if the folder holds other files.
        """
        there = self._there()
        stale = sorted(there - self.files.keys())
        if stale and not (self.folder / self.mark).is_file():
            raise FileExistsError(errno.EEXIST, "it holds other files", str(self.folder))
        changed = 0
        folders = set()
        for name, content in self.files.items():
            path = self.folder / name
            if name in there and path.read_bytes() == content:
                continue
            if path.parent not in folders:
                path.parent.mkdir(parents=True, exist_ok=True)
                folders.add(path.parent)
            path.write_bytes(content)
            changed += 1
        for name in stale:
            path = self.folder / name
            path.unlink()
            changed += 1
            while path.parent != self.folder and not any(path.parent.iterdir()):
                path = path.parent
                path.rmdir()
        return changed

"""Finds a version of the spec in a folder or in a git revision."""

from __future__ import annotations

import contextlib
import io
import subprocess
import tarfile
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from sbgcgen.model import Position


# The folder of the generator; if a revision has it, its own generator reads it.
_GENERATOR = "generator"


class UnknownRevision(Exception):
    """The name is neither a folder nor a revision with a spec."""


@dataclass(frozen=True)
class Version:
    """A spec folder, the prefix for names of its files, and its own generator, if any."""

    folder: Path
    prefix: str
    generator: Optional[Path] = None

    def where(self, position: Position) -> str:
        """A position with the name of the version: HEAD~2:spec/control.yaml:12:7."""
        _, _, name = position.file.partition("/")
        return f"{self.prefix}{name}:{position.line}:{position.column}"


@contextlib.contextmanager
def version(name: str, root: Path, spec_name: str) -> Iterator[Version]:
    """The spec folder `name`, or the spec of the git revision `name` of the project `root`.

    Extracts the spec of a revision, and its generator if it has one, to a temporary folder. A name
    of both a folder and a revision means the folder.
    """
    folder = Path(name)
    if name and folder.is_dir():
        yield Version(folder.resolve(), f"{folder.as_posix().rstrip('/')}/")
        return
    tree = _git(root, "rev-parse", "--verify", "--quiet", f"{name}^{{commit}}:./{spec_name}")
    if name.startswith("-") or tree is None:
        commit = _git(root, "rev-parse", "--verify", "--quiet", f"{name}^{{commit}}")
        if name.startswith("-") or commit is None:
            raise UnknownRevision(f"'{name}' is neither a folder nor a revision")
        raise UnknownRevision(f"revision {name} has no folder {spec_name}/")
    with tempfile.TemporaryDirectory(prefix="sbgcgen-") as temporary:
        target = Path(temporary) / Path(spec_name).name
        _extract(root, tree.decode().strip(), target)
        generator = None
        tree = _git(root, "rev-parse", "--verify", "--quiet", f"{name}^{{commit}}:./{_GENERATOR}")
        if tree is not None:
            generator = Path(temporary) / "of the revision" / _GENERATOR
            _extract(root, tree.decode().strip(), generator)
        yield Version(target, f"{name}:{spec_name}/", generator)


def _git(root: Path, *arguments: str) -> bytes | None:
    """The output of a git command in the project; None if it fails."""
    command = ["git", "-C", str(root), *arguments]
    try:
        return subprocess.run(command, capture_output=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return None


def _extract(root: Path, tree: str, target: Path) -> None:
    """Write the files of a git tree to a folder."""
    top = _git(root, "rev-parse", "--show-toplevel")
    content = _git(Path(top.decode().strip()) if top else root, "archive", "--format=tar", tree)
    if content is None:
        raise UnknownRevision(f"git cannot read the tree {tree}")
    with tarfile.open(fileobj=io.BytesIO(content)) as archive:
        for member in archive:
            stream = archive.extractfile(member) if member.isfile() else None
            if stream is not None:
                path = target / member.name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(stream.read())

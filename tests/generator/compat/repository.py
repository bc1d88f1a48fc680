"""A git repository for tests."""

from __future__ import annotations

import subprocess
from pathlib import Path


def git(folder: Path, *arguments: str) -> None:
    """Runs a git command with a fixed user."""
    user = ["-c", "user.name=Test", "-c", "user.email=test@example.org"]
    command = ["git", *user, "-C", str(folder), *arguments]
    subprocess.run(command, check=True, capture_output=True)


def start(folder: Path) -> Path:
    """Creates an empty repository."""
    folder.mkdir(parents=True)
    git(folder, "init", "--quiet")
    return folder


def commit(folder: Path, tag: str) -> None:
    """Commits all files and tags the revision `tag`."""
    git(folder, "add", ".")
    git(folder, "commit", "--quiet", "-m", tag)
    git(folder, "tag", tag)

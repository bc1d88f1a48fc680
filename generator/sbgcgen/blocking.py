"""Makes the blocking client of the Python package from the asynchronous one."""

from __future__ import annotations

import re
from pathlib import Path

# The path in the project and in generated/.
SOURCE = "python/sbgc/aio/client.py"
MADE = "python/sbgc/client.py"

_HEADER = f"# Generated from {SOURCE} by generator/: edit those, then run ./dev generate.\n"
_REPLACED = (
    (r"\b(async|await) ", ""),
    (r"\basynccontextmanager\b", "contextmanager"),
    (r"\bAsyncIterator\b", "Iterator"),
    (r"\bStopAsyncIteration\b", "StopIteration"),
    (r"\b__a(enter|exit|iter|next)__\b", r"__\1__"),
    (r"\bfrom sbgc\.aio\.", "from sbgc."),
)


def source_of(project: Path) -> list[Path]:
    """The source; empty in a project without the package."""
    return [path for path in [project / SOURCE] if path.is_file()]


def blocking(text: str) -> str:
    """The same module with blocking calls."""
    for asynchronous, replacement in _REPLACED:
        text = re.sub(asynchronous, replacement, text)
    return _HEADER + text

"""Keeps compiled templates between runs, because compiling takes longer than rendering."""

from __future__ import annotations

import marshal
from contextlib import suppress
from pathlib import Path

import jinja2
from jinja2.bccache import Bucket

from sbgcgen.record import generator_digest, save

_FOLDER = Path(__file__).resolve().parents[3] / "build" / "generator" / "templates"


class BytecodeCache(jinja2.BytecodeCache):
    """A file for each template: a checksum and the compiled template.

    Jinja evaluates filters of constants when it compiles. So a file is valid only for the generator,
    Jinja and Python that made it.
    """

    def get_source_checksum(self, source: str) -> str:
        """A checksum of all that determines the compiled template."""
        return f"{super().get_source_checksum(source)} {generator_digest()} {jinja2.__version__}"

    def load_bytecode(self, bucket: Bucket) -> None:
        """Load a template. If there is none, Jinja compiles it."""
        with suppress(OSError, EOFError, ValueError, TypeError):
            checksum, code = (_FOLDER / bucket.key).read_bytes().split(b"\n", 1)
            if checksum == bucket.checksum.encode():
                bucket.code = marshal.loads(code)

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Save a compiled template."""
        content = bucket.checksum.encode() + b"\n" + marshal.dumps(bucket.code)
        save(content, _FOLDER / bucket.key)

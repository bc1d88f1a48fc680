# Generated from spec/ by generator/: edit those, then run ./dev generate.
"""Constants of the protocol."""

from __future__ import annotations

from enum import IntEnum

__all__ = ["Framing"]


class Framing(IntEnum):
    """The bytes around the body of a message on the line. Every board understands the first."""

    V1 = 0
    V2 = 1

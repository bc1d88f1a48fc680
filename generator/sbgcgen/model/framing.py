"""The parts of a frame."""

from __future__ import annotations

from dataclasses import dataclass

# Size of each kind of checksum in bytes.
CHECKSUM_SIZES = {"sum8": 1}
# The parts that are not checksums; each but the body has one byte.
START, ID, SIZE, BODY = "start", "id", "size", "body"


@dataclass(frozen=True)
class Checksum:
    """A checksum of a frame: its name as a part, its kind, and the parts that it covers."""

    name: str
    kind: str
    covers: tuple[str, ...]

    @property
    def size(self) -> int:
        return CHECKSUM_SIZES[self.kind]


@dataclass(frozen=True)
class Framing:
    """The parts around a body in wire order: `START`, `ID`, `SIZE` and names of checksums."""

    start: int
    header: tuple[str, ...]
    trailer: tuple[str, ...]
    checksums: tuple[Checksum, ...]
    max_body: int
    source: str
    errata: tuple[str, ...]

    @property
    def header_size(self) -> int:
        return sum(self.size_of(part) for part in self.header)

    @property
    def trailer_size(self) -> int:
        return sum(self.size_of(part) for part in self.trailer)

    def size_of(self, part: str) -> int:
        """Size in bytes of a part other than the body."""
        found = self.checksum(part)
        return found.size if found else 1

    def checksum(self, part: str) -> Checksum | None:
        """The checksum with this name; None for any other part."""
        return next((c for c in self.checksums if c.name == part), None)

    def place(self, part: str) -> int:
        """The offset of a part in the header or in the trailer."""
        parts = self.header if part in self.header else self.trailer
        return sum(self.size_of(other) for other in parts[: parts.index(part)])

"""The parts of a frame."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from sbgcgen.model.values import Availability

# Size of each kind of checksum in bytes.
CHECKSUM_SIZES = {"sum8": 1, "crc16": 2}
# The parts that are not checksums; each but the body has one byte.
START, ID, SIZE, BODY = "start", "id", "size", "body"


@dataclass(frozen=True)
class Crc:
    """The parameters of a cyclic redundancy check of 16 bits, as catalogues list them.

    `reflect_in`: each byte enters with its least significant bit first. `reflect_out`: the bits of
    the result are reversed, before `final_xor`. `check` is the value of the text "123456789"; None
    if the spec does not state it.
    """

    polynomial: int
    initial: int
    reflect_in: bool
    reflect_out: bool
    final_xor: int
    check: int | None = None

    def value(self, data: bytes) -> int:
        """The value of `data`."""
        register = self.initial
        for byte in data:
            register = register << 8 & 0xFFFF ^ self._of_byte[register >> 8 ^ self._entering[byte]]
        return (_reversed(register, 16) if self.reflect_out else register) ^ self.final_xor

    @cached_property
    def _entering(self) -> list[int]:
        """Each byte with its bits in the order in which they enter."""
        return [_reversed(byte, 8) if self.reflect_in else byte for byte in range(256)]

    @cached_property
    def _of_byte(self) -> list[int]:
        """The remainder of each byte, computed bit by bit."""
        table = [byte << 8 for byte in range(256)]
        for _ in range(8):
            table = [(r << 1 ^ (self.polynomial if r >> 15 else 0)) & 0xFFFF for r in table]
        return table


def _reversed(value: int, width: int) -> int:
    """The bits of a number in reverse order."""
    return int(f"{value:0{width}b}"[::-1], 2)


@dataclass(frozen=True)
class Checksum:
    """A checksum of a frame: its name as a part, its kind, and the parts that it covers.

    `crc` has the parameters of the kind "crc16"; None for others.
    """

    name: str
    kind: str
    covers: tuple[str, ...]
    crc: Crc | None = None

    @property
    def size(self) -> int:
        return CHECKSUM_SIZES[self.kind]

    def value(self, data: bytes) -> int:
        """The checksum of the bytes that it covers."""
        return self.crc.value(data) if self.crc else sum(data) % 256


@dataclass(frozen=True)
class Framing:
    """The parts around a body in wire order: `START`, `ID`, `SIZE` and names of checksums."""

    name: str
    since: Availability
    start: int
    header: tuple[str, ...]
    trailer: tuple[str, ...]
    checksums: tuple[Checksum, ...]
    max_body: int
    source: str
    errata: tuple[str, ...]

    def frame_size(self, body_size: int) -> int:
        """Size of a frame in bytes."""
        return self.header_size + body_size + self.trailer_size

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

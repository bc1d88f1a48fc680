"""The parts of a frame."""

from __future__ import annotations

import operator
from dataclasses import dataclass
from functools import cached_property, reduce

from sbgcgen.model.values import Availability

# Size of each kind of checksum in bytes.
CHECKSUM_SIZES = {"sum8": 1, "sum16": 2, "xor8": 1, "crc8": 1, "crc16": 2, "crc32": 4}
# The parts that are not checksums; each but the body has one byte.
START, ID, SIZE, BODY = "start", "id", "size", "body"


@dataclass(frozen=True)
class Crc:
    """The parameters of a cyclic redundancy check of `width` bits, as listed in catalogues.

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
    width: int = 16

    def value(self, data: bytes) -> int:
        """The value of `data`."""
        register = self.initial
        for byte in data:
            top = register >> self.width - 8
            register = register << 8 & self._mask ^ self._of_byte[top ^ self._entering[byte]]
        return (_reversed(register, self.width) if self.reflect_out else register) ^ self.final_xor

    @property
    def _mask(self) -> int:
        return (1 << self.width) - 1

    @cached_property
    def _entering(self) -> list[int]:
        """Each byte with its bits in input order."""
        return [_reversed(byte, 8) if self.reflect_in else byte for byte in range(256)]

    @cached_property
    def _of_byte(self) -> list[int]:
        """The remainder of each byte, computed bit by bit."""
        top = self.width - 1
        table = [byte << self.width - 8 for byte in range(256)]
        for _ in range(8):
            table = [(r << 1 ^ (self.polynomial if r >> top else 0)) & self._mask for r in table]
        return table


def _reversed(value: int, width: int) -> int:
    """The bits of a number in reverse order."""
    return int(f"{value:0{width}b}"[::-1], 2)


@dataclass(frozen=True)
class Checksum:
    """A checksum of a frame: its name as a part, its kind, and the parts that it covers.

    `crc` has the parameters of a cyclic redundancy check; None for other kinds.
    """

    name: str
    kind: str
    covers: tuple[str, ...]
    crc: Crc | None = None

    @property
    def size(self) -> int:
        return CHECKSUM_SIZES[self.kind]

    def value(self, data: bytes) -> int:
        """Compute the checksum of the bytes that it covers."""
        if self.crc:
            return self.crc.value(data)
        if self.kind == "xor8":
            return reduce(operator.xor, data, 0)
        return sum(data) % (1 << 8 * self.size)


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

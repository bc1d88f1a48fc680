"""The messages of a capture as numpy arrays."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterator, Mapping
from datetime import datetime, timedelta, timezone
from functools import partial
from importlib import import_module
from typing import Any, Union

import numpy

from sbgc import _core
from sbgc.codec import Direction, ParserCounters
from sbgc.message import Message, type_named

Array = numpy.ndarray[Any, Any]

# The numpy types for those of the protocol; bytes and texts also have a size. numpy has no 24-bit
# integers.
_TYPES = {
    **{f"{kind}{8 * size}": f"<{kind}{size}" for kind in "iuf" for size in (1, 2, 4, 8)},
    **{"i24": "(3,)u1", "u24": "(3,)u1"},
}


class Table(Mapping[str, "Array"]):
    """All messages of one kind in a capture: a column of numbers in their units for each value.

    "time" has seconds since the start of the first session. Columns are named by the path of the
    value, such as "angle.pitch". A number that a message lacks is NaN, bytes and texts are None.
    """

    def __init__(self, message: type[Message], columns: dict[str, Callable[[], Array]]) -> None:
        self.message = message
        self._columns = columns
        self._made: dict[str, Array] = {}

    @property
    def array(self) -> Array:
        """The raw numbers, as a structured array in the memory of the capture.

        Its fields are "time", "body_size", a field for each value, and the "tail" if there
        is one. Raises TypeError if the messages of this kind have no fixed layout.
        """
        raise TypeError(f"{self.message.__name__} has no fixed layout, only columns")

    def __getitem__(self, name: str) -> Array:
        if name not in self._made:
            if name not in self._columns:
                raise KeyError(self._unknown(name))
            self._made[name] = self._columns[name]()
        return self._made[name]

    def columns(self) -> dict[str, Array]:
        """Return all columns, which is faster than requesting them one by one."""
        return dict(self)

    def _unknown(self, name: str) -> str:
        near = [one for one in self if one.startswith(f"{name}.")]
        near = near or difflib.get_close_matches(name, self)
        hint = f"; it has {', '.join(near)}" if near else ""
        return f"{self.message.__name__} has no column {name}{hint}"

    def __contains__(self, name: object) -> bool:
        return name in self._columns

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        """The number of messages."""
        return len(self["time"])

    def to_pandas(self) -> Any:
        """The columns as a pandas.DataFrame, with the time as its index."""
        try:
            pandas = import_module("pandas")
        except ImportError as error:
            text = "to_pandas() needs pandas: apt-get install python3-pandas, or pip install pandas"
            raise ImportError(text, name="pandas") from error
        return pandas.DataFrame(
            {name: _plain(column) for name, column in self.columns().items()}
        ).set_index("time")

    def __repr__(self) -> str:
        return f"<{self.message.__name__}: {self.rows} rows, {len(self)} columns>"


class _FixedTable(Table):
    """Messages with a fixed layout: columns are made from the array on request."""

    def __init__(self, message: type[Message], bodies: _core.Bodies) -> None:
        layout = _core.layout_of(message.__name__) or []
        fields = [("time", "<f8", 0), ("body_size", "u1", 8)]
        head = end = 9
        for path, kind, size, offset, _, _ in layout:
            type_ = f"S{size}" if kind == "text" else _TYPES.get(kind, f"V{size}")
            fields.append((path, type_, head + offset))
            end = head + offset + size
        if bodies.stride > end:
            fields.append(("tail", f"V{bodies.stride - end}", end))
        dtype = numpy.dtype(
            {
                "names": [name for name, _, _ in fields],
                "formats": [type_ for _, type_, _ in fields],
                "offsets": [place for _, _, place in fields],
                "itemsize": bodies.stride,
            }
        )
        data = numpy.frombuffer(bodies.bytes, numpy.uint8)
        self._array: Array = data.view(dtype) if len(data) else numpy.zeros(0, dtype)
        self._bodies = bodies
        self._numbers: dict[str, str] = {"time": "f8"}
        columns: dict[str, Callable[[], Array]] = {"time": partial(self._number, "time")}
        for path, kind, _, _, has_unit, is_reserved in layout:
            if is_reserved:
                continue
            if kind in ("text", "bytes"):
                columns[path] = partial(self._objects, path, _text if kind == "text" else bytes)
            else:
                wide = {"i24": "i4", "u24": "u4"}.get(kind, _TYPES[kind])
                self._numbers[path] = "f8" if has_unit else wide
                columns[path] = partial(self._number, path)
        super().__init__(message, columns)

    @property
    def array(self) -> Array:
        return self._array

    def columns(self) -> dict[str, Array]:
        missing = {path: type_ for path, type_ in self._numbers.items() if path not in self._made}
        made = {path: numpy.empty(len(self._array), type_) for path, type_ in missing.items()}
        self._bodies.fill(self.message.__name__, made)
        self._made.update(made)
        return dict(self)

    def _number(self, path: str) -> Array:
        column: Array = numpy.empty(len(self._array), self._numbers[path])
        self._bodies.fill(self.message.__name__, {path: column})
        return column

    def _objects(self, path: str, convert: Callable[[Any], object]) -> Array:
        return numpy.array([convert(one) for one in self._array[path].tolist()], object)


def _text(value: bytes) -> str:
    return value.split(b"\0")[0].decode("utf-8", "surrogateescape")


def _varying_table(message: type[Message], content: _core.Columns) -> Table:
    times, columns = content
    time = numpy.frombuffer(times, "<f8")

    def of(kind: str, rows: bytes, values: Union[bytes, list[bytes], list[str]]) -> Array:
        where = numpy.frombuffer(rows, "<u4")
        if isinstance(values, bytes):
            numbers: Array = numpy.frombuffer(values, f"<{kind}8")
            if len(where) == len(time):
                return numbers
            column = numpy.full(len(time), numpy.nan)
            column[where] = numbers
            return column
        others = numpy.full(len(time), None, object)
        others[where] = values
        return others

    made = {path: partial(of, kind, rows, values) for path, kind, rows, values in columns}
    return Table(message, {"time": lambda: time, **made})


def _plain(column: Array) -> Array:
    """Return the column with the byte order and alignment that pandas needs."""
    return column if column.dtype == object else numpy.ascontiguousarray(column)


class Capture(Mapping[type[Message], Table]):
    """The messages of a capture, by their class: `capture[msg.RealtimeData4]["angle.pitch"]`."""

    def __init__(self, reader: _core.CaptureReader) -> None:
        self._tables: dict[type[Message], Table] = {}
        for name, content in reader.kinds():
            message = type_named(name)
            if isinstance(content, _core.Bodies):
                self._tables[message] = _FixedTable(message, content)
            else:
                self._tables[message] = _varying_table(message, content)
        epoch = datetime(1970, 1, 1, tzinfo=timezone.utc)
        self.sessions = [epoch + timedelta(microseconds=start) for start in reader.sessions]
        """The start times of the recordings in the file."""
        self.notes = reader.notes
        """The notes of the recorder: seconds since the start of the first session, and a text."""
        self.damage = [text for _, text in reader.damage]
        """Sentences about parts of the file that are damaged."""
        self.undecoded = reader.undecoded
        """The number of valid frames that do not decode."""
        self.counters = {one: ParserCounters(*reader.counters(bool(one))) for one in Direction}
        """The counters of the parser for each direction, as printed by `sbgc decode`."""

    def __getitem__(self, message: type[Message]) -> Table:
        if message not in self._tables:
            raise KeyError(f"the capture has no {getattr(message, '__name__', message)}")
        return self._tables[message]

    def __iter__(self) -> Iterator[type[Message]]:
        return iter(self._tables)

    def __len__(self) -> int:
        return len(self._tables)

    def __repr__(self) -> str:
        tables = ", ".join(f"{m.__name__}: {table.rows}" for m, table in self._tables.items())
        return f"<Capture {tables}>"

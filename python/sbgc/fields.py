"""Fields of messages as attributes. Their values are stored in a message of the C++ library.

Messages, structures, axes and lists are all places: a message and a path in it. They change when the
message does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, MutableSequence
from enum import Enum
from functools import partial
from itertools import islice
from typing import Any, Generic, Optional, Protocol, SupportsIndex, TypeVar, Union, cast, overload

from sbgc import _core
from sbgc.errors import FieldError
from sbgc.values import UNSET, Packed

T = TypeVar("T")
Get = TypeVar("Get")
Set = TypeVar("Set")
S = TypeVar("S", bound="Structure")


class Kind(Protocol):
    """Reads and writes the value at a path; reading avoids Python functions where possible."""

    @property
    def read(self) -> Callable[[_core.AnyMessage, str], Any]:
        ...

    def write(self, message: _core.AnyMessage, path: str, value: Any) -> None:
        ...


class _Real:
    """A number in its unit."""

    read = staticmethod(_core.AnyMessage.get)

    def write(self, message: _core.AnyMessage, path: str, value: object) -> None:
        message.set_real(path, value)


class _Raw:
    """A raw number."""

    def read(self, message: _core.AnyMessage, path: str) -> Any:
        return message.get(path, True)

    def write(self, message: _core.AnyMessage, path: str, value: object) -> None:
        message.set_raw(path, value)


class _Bytes:
    read = staticmethod(_core.AnyMessage.get)

    def write(self, message: _core.AnyMessage, path: str, value: object) -> None:
        message.set_bytes(path, value)


class _Tail(_Bytes):
    """Bytes that default to empty."""

    @staticmethod
    def read(message: _core.AnyMessage, path: str) -> Any:  # type: ignore[override]
        return message.get(path) or b""


class _Text:
    read = staticmethod(_core.AnyMessage.get)

    def write(self, message: _core.AnyMessage, path: str, value: object) -> None:
        message.set_text(path, value)


REAL, RAW, BYTES, TAIL, TEXT = _Real(), _Raw(), _Bytes(), _Tail(), _Text()


class ValueOf:
    """A value of an enum, of flags, or of a packed integer."""

    def __init__(self, type_: Any) -> None:
        self._type = type_

    def read(self, message: _core.AnyMessage, path: str) -> Any:
        value = message.get(path, True)
        return None if value is None else self._type(value)

    def write(self, message: _core.AnyMessage, path: str, value: object) -> None:
        if isinstance(value, (Enum, Packed)) and not isinstance(value, self._type):
            raise TypeError(f"{path}: {self._type.__name__} is needed, not {value!r}")
        message.set_raw(path, value)


class GroupOf:
    """A structure."""

    def __init__(self, type_: type[Structure]) -> None:
        self._type = type_
        self.read = type_._at

    def write(self, message: _core.AnyMessage, path: str, value: object) -> None:
        if not isinstance(value, self._type):
            raise TypeError(f"{path}: {self._type.__name__} is needed, not {value!r}")
        message.copy_values(path, value._message, value._path)


class AxesOf:
    """A value for each axis of the gimbal, or of space."""

    def __init__(self, kind: Kind, type_: Any = None) -> None:
        self._kind = kind
        self._type = type_ or Axes
        self.read = partial(self._type._at, kind)

    def write(self, message: _core.AnyMessage, path: str, value: object) -> None:
        if not isinstance(value, self._type):
            raise TypeError(f"{path}: {self._type.__name__} is needed, not {value!r}")
        for name in self._type.names:
            element = getattr(value, name)
            if element is not UNSET:
                self._kind.write(message, f"{path}.{name}", element)


MOST_ELEMENTS = 255
"""The maximum number of elements of a list: a body has at most 255 bytes."""


def limited(values: Iterable[Any]) -> list[Any]:
    """Return at most one value more than a message can hold: some iterables are infinite."""
    return list(islice(values, MOST_ELEMENTS + 1))


class ListOf:
    """A list, whose size may be fixed."""

    def __init__(self, kind: Kind) -> None:
        self._kind = kind
        self.read = partial(Elements, kind)

    def write(self, message: _core.AnyMessage, path: str, value: Iterable[object]) -> None:
        if not isinstance(value, Iterable):
            raise TypeError(f"{path}: a list is needed, not {value!r}")
        values = limited(value)
        size = message.count(path)
        is_fixed = not message.remove(path)
        if len(values) > MOST_ELEMENTS or (is_fixed and len(values) != size):
            takes = f"has {size}" if is_fixed else f"takes at most {MOST_ELEMENTS}"
            given = str(len(values)) if len(values) <= MOST_ELEMENTS else f"over {MOST_ELEMENTS}"
            raise FieldError(f"{path}: it {takes} elements, not {given}", path)
        message.add(path)
        for index, element in enumerate(values):
            self._kind.write(message, f"{path}[{index}]", element)


class _Doc:
    """Returns the text below an attribute in the source of its class, for help()."""

    def __get__(self, field: Optional[Field[Any, Any]], owner: type) -> Optional[str]:
        if field is None:
            return "An attribute of a message or a structure."
        import ast  # only for help()
        import inspect

        try:
            (class_,) = ast.parse(inspect.getsource(field._owner)).body
        except (OSError, SyntaxError):
            return None
        body = class_.body if isinstance(class_, ast.ClassDef) else []
        for attribute, text in zip(body, body[1:]):
            if not isinstance(attribute, ast.AnnAssign) or not isinstance(text, ast.Expr):
                continue
            is_it = (
                isinstance(attribute.target, ast.Name) and attribute.target.id == field._attribute
            )
            if is_it and isinstance(text.value, ast.Constant):
                return inspect.cleandoc(str(text.value.value))
        return None


class Field(Generic[Get, Set]):
    __doc__ = _Doc()  # type: ignore[assignment]

    def __init__(self, kind: Kind, optional: bool = False, of: str = "") -> None:
        self._kind = kind
        self._read = kind.read
        self._optional = optional
        # A single value is None if the message lacks it.
        self._has_parts = optional and isinstance(kind, (GroupOf, AxesOf, ListOf))
        self._name = of
        self.is_second = bool(of)

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = self._name or name
        self._attribute = name
        self._owner = owner

    @overload
    def __get__(self, place: None, owner: type) -> Field[Get, Set]:
        ...

    @overload
    def __get__(self, place: Structure, owner: type) -> Get:
        ...

    def __get__(self, place: Union[Structure, None], owner: type) -> Union[Field[Get, Set], Get]:
        if place is None:
            return self
        path = f"{place._path}.{self._name}" if place._path else self._name
        if self._has_parts and not place._message.has(path):
            return cast(Get, None)
        return self._read(place._message, path)  # type: ignore[no-any-return]

    def __set__(self, place: Structure, value: Set) -> None:
        changed = place.__copy__()
        self.write_to(changed, value)
        place._message.take(changed._message)

    def write_to(self, place: Structure, value: object) -> None:
        """Store a value; if it is invalid, perhaps only a part of it."""
        path = place._path_of(self._name)
        if self._optional and value is None:
            place._message.remove(path)
            return
        try:
            self._kind.write(place._message, path, value)
        except (FieldError, TypeError) as error:
            if not place._is_free or not place._path:
                raise
            # Its message is only a container: its name would be meaningless.
            text = str(error).removeprefix(f"{place._path}.")
            if isinstance(error, FieldError):
                raise FieldError(text, error.field.removeprefix(f"{place._path}.")) from None
            raise TypeError(text) from None


class Structure:
    """A group of fields: a place in a message.

    A new structure has its own message, `_home`.
    """

    __slots__ = ("_message", "_path", "_is_free")
    _home: tuple[str, str]
    _message: _core.AnyMessage
    _path: str
    _is_free: bool  # no part of a message

    def _start(self, **values: object) -> None:
        name, self._path = self._home
        self._is_free = True
        self._message = _core.AnyMessage(name)
        if self._path:
            self._message.add(self._path)
        for field, value in values.items():
            if value is ...:
                continue
            if field.endswith("_raw") and values.get(field[:-4], ...) is not ...:
                raise TypeError(f"{field[:-4]} and {field} are the same field: give one of them")
            getattr(type(self), field).write_to(self, value)

    @classmethod
    def _at(cls: type[S], message: _core.AnyMessage, path: str) -> S:
        made = object.__new__(cls)
        made._message = message
        made._path = path
        made._is_free = False
        return made

    def _path_of(self, field: str) -> str:
        return f"{self._path}.{field}" if self._path else field

    def assign(self, path: str, text: str, validates: bool = True) -> None:
        """Set a field from human-readable text: `assign("angle", "-30deg")`.

        Without `validates`, values that the specification does not allow are accepted.
        """
        self._message.assign(self._path_of(path), text, validates)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Structure) or type(other) is not type(self):
            return NotImplemented
        return self._message.is_equal(self._path, other._message, other._path)

    __hash__ = None  # type: ignore[assignment]  # it can change

    def __copy__(self: S) -> S:
        made = self._at(self._message.copy(), self._path)
        made._is_free = self._is_free
        return made

    def __deepcopy__(self: S, memo: object) -> S:
        return self.__copy__()

    def __reduce__(self) -> tuple[Any, ...]:
        return _restore, (
            type(self),
            self._message.name,
            self._message.to_json(secrets=True),
            self._path,
        )

    def __str__(self) -> str:
        return type(self).__name__ + self._message.text(self._path)

    def __repr__(self) -> str:
        said = (f"{name}={value!r}" for name, value in self._arguments())
        return f"{type(self).__name__}({', '.join(said)})"

    def _arguments(self) -> Iterator[tuple[str, Any]]:
        """Return the arguments that construct it, without those that have no effect."""
        for class_ in reversed(type(self).__mro__):
            for name, field in vars(class_).items():
                if not isinstance(field, Field) or name.endswith("_raw"):
                    continue
                value = getattr(self, name)
                is_unused = isinstance(value, bytes) and not any(value)
                if value is not None and not is_unused:
                    yield name, value


def _restore(type_: type[S], name: str, json: str, path: str) -> S:
    message = _core.AnyMessage(name)
    message.read_json(json)
    return type_._at(message, path)


class _Element(Generic[T]):
    """The value for one axis."""

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    @overload
    def __get__(self, place: None, owner: type) -> _Element[T]:
        ...

    @overload
    def __get__(self, place: _ByAxis[T], owner: type) -> T:
        ...

    def __get__(self, place: Union[_ByAxis[T], None], owner: type) -> Union[_Element[T], T]:
        if place is None:
            return self
        if place._message is None:
            return cast(T, place._values[self._name])
        path = f"{place._path}.{self._name}"
        return place._kind.read(place._message, path)  # type: ignore[no-any-return]

    def __set__(self, place: _ByAxis[T], value: T) -> None:
        if place._message is None:
            place._values[self._name] = value
            return
        changed = place._message.copy()
        place._kind.write(changed, f"{place._path}.{self._name}", value)
        place._message.take(changed)


class _ByAxis(Generic[T]):
    """Three values, stored in a message; before that, in an object of their own."""

    __slots__ = ("_message", "_path", "_kind", "_values")
    names: tuple[str, str, str]
    _message: Union[_core.AnyMessage, None]
    _path: str
    _kind: Kind
    _values: dict[str, Any]

    def _start(self, **values: object) -> None:
        self._message = None
        self._values = values

    @classmethod
    def _at(cls, kind: Kind, message: _core.AnyMessage, path: str) -> Any:
        made = object.__new__(cls)
        made._message, made._path, made._kind = message, path, kind
        return made

    def __iter__(self) -> Iterator[T]:
        return iter([getattr(self, name) for name in self.names])

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, _ByAxis) or type(other) is not type(self):
            return NotImplemented
        return [*self] == [*other]

    __hash__ = None  # type: ignore[assignment]  # it can change

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), tuple(self)

    def __str__(self) -> str:
        if self._message is None:
            return repr(self)
        return type(self).__name__ + self._message.text(self._path)

    def __repr__(self) -> str:
        values = ((name, getattr(self, name)) for name in self.names)
        said = (f"{name}={value!r}" for name, value in values if value is not ...)
        return f"{type(self).__name__}({', '.join(said)})"


class Axes(_ByAxis[T]):
    """A value for each axis of the gimbal. Omitted axes keep their values."""

    __slots__ = ()
    names = __match_args__ = ("roll", "pitch", "yaw")
    roll: _Element[T] = _Element()
    pitch: _Element[T] = _Element()
    yaw: _Element[T] = _Element()

    def __init__(self, roll: T = UNSET, pitch: T = UNSET, yaw: T = UNSET) -> None:
        self._start(roll=roll, pitch=pitch, yaw=yaw)


class Xyz(_ByAxis[T]):
    """A value for each axis of space."""

    __slots__ = ()
    names = __match_args__ = ("x", "y", "z")
    x: _Element[T] = _Element()
    y: _Element[T] = _Element()
    z: _Element[T] = _Element()

    def __init__(self, x: T = UNSET, y: T = UNSET, z: T = UNSET) -> None:
        self._start(x=x, y=y, z=z)


class Elements(MutableSequence[T]):
    """A list in a message. A list of fixed size accepts only its number of elements."""

    __slots__ = ("_message", "_path", "_kind")

    def __init__(self, kind: Kind, message: _core.AnyMessage, path: str) -> None:
        self._message, self._path, self._kind = message, path, kind

    def __len__(self) -> int:
        return self._message.count(self._path)

    @overload
    def __getitem__(self, index: SupportsIndex) -> T:
        ...

    @overload
    def __getitem__(self, index: slice) -> list[T]:
        ...

    def __getitem__(self, index: Union[SupportsIndex, slice]) -> Union[T, list[T]]:
        numbers = range(len(self))[index]
        if isinstance(numbers, range):
            return [self._read(number) for number in numbers]
        return self._read(numbers)

    def _read(self, number: int) -> T:
        path = f"{self._path}[{number}]"
        return self._kind.read(self._message, path)  # type: ignore[no-any-return]

    def __setitem__(self, index: Any, value: Any) -> None:
        if not isinstance(index, slice):
            changed = self._message.copy()
            self._kind.write(changed, f"{self._path}[{range(len(self))[index]}]", value)
            self._message.take(changed)
            return
        self._edit(lambda values: values.__setitem__(index, limited(value)))

    def __delitem__(self, index: Any) -> None:
        self._edit(lambda values: values.__delitem__(index))

    def insert(self, index: int, value: T) -> None:
        self._edit(lambda values: values.insert(index, value))

    def extend(self, values: Iterable[T]) -> None:
        self._edit(lambda own: own.extend(limited(values)))

    def _edit(self, edit: Any) -> None:
        # Structures among the values remain places in this message.
        values = list(self)
        edit(values)
        changed = self._message.copy()
        ListOf(self._kind).write(changed, self._path, values)
        self._message.take(changed)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (Elements, list, tuple)):
            return NotImplemented
        return list(self) == list(other)

    def __reduce__(self) -> tuple[Any, ...]:
        return list, (list(self),)

    def __repr__(self) -> str:
        return repr(list(self))

"""Values of fields: enums that keep unknown values, and integers of several parts."""

from __future__ import annotations

from enum import EnumMeta, IntEnum, IntFlag
from typing import Any, Generic, TypeVar, Union, overload

from sbgc import _core

UNSET: Any = ...  # the default of arguments: the field keeps its value

T = TypeVar("T")
P = TypeVar("P", bound="Packed")


class OpenEnum(IntEnum):
    """An enum of the protocol. Unnamed values are members as well: ControlMode(77)."""

    @classmethod
    def _missing_(cls, value: object) -> Any:
        if not isinstance(value, int):
            return None
        member = int.__new__(cls, value)
        member._name_ = str(value)
        member._value_ = value
        return member

    def __reduce_ex__(self, protocol: object) -> Any:
        return type(self), (self._value_,)

    def __repr__(self) -> str:
        name = type(self).__name__
        is_known = self._name_ in type(self).__members__
        return f"{name}.{self._name_}" if is_known else f"{name}({self._value_})"


class _FlagType(EnumMeta):
    """Flags with their own `~`: EnumMeta replaces that of a base class."""

    def __new__(metacls, *arguments: Any, **options: Any) -> Any:
        made: Any = super().__new__(metacls, *arguments, **options)
        setattr(made, "__invert__", lambda flags: made(~int(flags) & ((1 << made._width()) - 1)))
        return made


class OpenFlags(IntFlag, metaclass=_FlagType):
    """A set of flags of the protocol. It keeps unnamed bits, also in `flags & ~FLAG`."""

    def __repr__(self) -> str:
        """Return the names joined by "|", and unnamed bits as a number."""
        name, rest, said = type(self).__name__, int(self), []
        for flag, member in type(self).__members__.items():
            if int(member) and rest & int(member) == int(member):
                said.append(f"{name}.{flag}")
                rest &= ~int(member)
        return " | ".join([*said, *([f"{name}({rest:#x})"] if rest or not said else [])])

    @classmethod
    def _width(cls) -> int:
        raise NotImplementedError


class Flags8(OpenFlags):
    """Flags of one byte."""

    @classmethod
    def _width(cls) -> int:
        return 8


class Flags16(OpenFlags):
    """Flags of two bytes."""

    @classmethod
    def _width(cls) -> int:
        return 16


class Flags32(OpenFlags):
    """Flags of four bytes."""

    @classmethod
    def _width(cls) -> int:
        return 32


class Packed(int):
    """A raw integer with several parts, such as a version. All bits are preserved.

    The arguments replace parts: `ControlMode(old, mode=ControlModeKind.MODE_ANGLE)`.
    """

    def _with(self: P, **parts: object) -> P:
        name, raw = type(self).__name__, int(self)
        for part, value in parts.items():
            if value is ...:
                continue
            if not isinstance(value, (int, float)):
                raise TypeError(f"{name}: {part}: a number is needed, not {value!r}")
            text = repr(float(value)) if isinstance(value, float) else str(int(value))
            raw = _core.with_part(name, raw, part.rstrip("_"), text)
        return int.__new__(type(self), raw)

    def __str__(self) -> str:
        return _core.packed_text(type(self).__name__, int(self)) or int.__repr__(self)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({int(self)})"


class Part(Generic[T]):
    """A part of a packed integer, as an attribute of it."""

    def __init__(self, type_: Any) -> None:
        self._type = type_

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name.rstrip("_")  # in_ is the part "in"

    @overload
    def __get__(self, packed: None, owner: type) -> Part[T]:
        ...

    @overload
    def __get__(self, packed: Packed, owner: type) -> T:
        ...

    def __get__(self, packed: Union[Packed, None], owner: type) -> Union[Part[T], T]:
        if packed is None:
            return self
        value: T = self._type(_core.part_of(type(packed).__name__, int(packed), self._name))
        return value

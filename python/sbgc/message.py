"""Messages, the contents of frames."""

from __future__ import annotations

from typing import Generic, Optional, TypeVar, Union

from sbgc import _core
from sbgc.fields import TAIL, Field, Structure

M = TypeVar("M", bound="Message")
R = TypeVar("R", covariant=True)

_types: dict[str, type[Message]] = {}


class Message(Structure):
    """A message of the protocol. `tail` has the bytes after the documented fields."""

    __slots__ = ()
    tail: Field[bytes, Union[bytes, bytearray, memoryview]] = Field(TAIL)

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        cls._home = (cls.__name__, "")
        _types[cls.__name__] = cls

    @classmethod
    def from_body(
        cls: type[M], body: Union[bytes, bytearray, memoryview], contexts: Optional[Contexts] = None
    ) -> M:
        """Decode the body of a frame as this message, whatever its size. Raises DecodeError."""
        message = _core.AnyMessage(cls.__name__)
        message.decode(memoryview(body), known_by(contexts))
        return cls._at(message, "")

    def to_json(self, *, secrets: bool = False) -> str:
        """Return the fields as JSON, as the command `sbgc decode` prints them: raw values."""
        return self._message.to_json(secrets)

    @classmethod
    def from_json(cls: type[M], text: str) -> M:
        """Parse the result of to_json(). Only optional fields may be missing. Raises FieldError."""
        message = _core.AnyMessage(cls.__name__)
        message.read_json(text)
        return cls._at(message, "")


class Request(Message, Generic[R]):
    """A message to the board whose response has the type R."""

    __slots__ = ()


class Contexts:
    """Facts of earlier messages that later ones need for decoding, such as requested flags."""

    def __init__(self) -> None:
        self._contexts = _core.Contexts()

    def learn(self, message: Message) -> None:
        """Store the facts of a message that later ones need. Most messages have none."""
        self._contexts.learn(of_library(message))


def of_library(message: Message) -> _core.AnyMessage:
    """Return the C++ message. Raises TypeError for anything but a whole message."""
    if not isinstance(message, Message):
        raise TypeError(f"a message is needed, not {message!r}")
    return message._message


def known_by(contexts: Optional[Contexts]) -> Optional[_core.Contexts]:
    if not isinstance(contexts, (Contexts, type(None))):
        raise TypeError(f"contexts: Contexts are needed, not {contexts!r}")
    return None if contexts is None else contexts._contexts


def wrap(message: _core.AnyMessage) -> Message:
    """Return the Python object for a C++ message."""
    return type_named(message.name)._at(message, "")


def type_named(name: str) -> type[Message]:
    """Return the class of a message."""
    return _types[name]

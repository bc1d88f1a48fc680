"""The exceptions of the package. Their texts are those of the C++ library."""

from __future__ import annotations


class Error(Exception):
    """The base of all exceptions of the package."""


class FieldError(Error, ValueError):
    """A value that is invalid for a field, or that the specification does not allow.

    `field` is the path of the field, such as "axes.pitch.angle".
    """

    def __init__(self, text: str, field: str) -> None:
        super().__init__(text)
        self.field = field

    def __reduce__(self) -> tuple[type[FieldError], tuple[str, str]]:
        return type(self), (str(self), self.field)


class CodecError(Error, ValueError):
    """Bytes that are not a message, or a message that cannot be encoded.

    `code` is the name of the reason as in JSON, such as "too_short"; `field` the path of the field
    in error, or ""; `offset` the position in the body.
    """

    def __init__(self, text: str, code: str, field: str, offset: int) -> None:
        super().__init__(text)
        self.code = code
        self.field = field
        self.offset = offset

    def __reduce__(self) -> tuple[type[CodecError], tuple[str, str, str, int]]:
        return type(self), (str(self), self.code, self.field, self.offset)


class DecodeError(CodecError):
    """Bytes that are not a frame, or a body that is not a message."""


class EncodeError(CodecError):
    """An inconsistent message, such as one that lacks a field announced by its flags."""


class GimbalError(Error):
    """An operation of the board, the line or a file has failed.

    `code` is the name of the reason, such as "board_error" or "mismatch"; see ErrorCode of the C++
    library. `detail` is the number that some codes carry, otherwise 0.
    """

    def __init__(self, text: str, code: str, detail: int) -> None:
        super().__init__(text)
        self.code = code
        self.detail = detail

    def __reduce__(self) -> tuple[type[GimbalError], tuple[str, str, int]]:
        return type(self), (str(self), self.code, self.detail)


class GimbalTimeout(GimbalError, TimeoutError):
    """No response, or not in time."""


class GimbalDisconnected(GimbalError, ConnectionError):
    """The line is closed, or was lost."""


class GimbalSuperseded(GimbalError):
    """A later command of this client has stopped the camera or moves it."""


class GimbalInterrupted(GimbalError):
    """Another program, RC or a limit has stopped the camera or moves it."""

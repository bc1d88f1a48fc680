"""The values of a worked example in the syntax of `sbgc send`: axes.pitch.angle=10."""

from __future__ import annotations

import shlex

from sbgcgen.model import Announced, Blob, Enum, Packed, Quantity, Scalar, Type
from sbgcgen.oracle.example import Example, Piece, physical
from sbgcgen.views.code import decimal, flags_of, parts_that_make, value_named


def send_command(example: Example) -> str:
    """The command that sends the message; "" if a secret would be on the command line."""
    if any(piece.field.secret and piece.data for piece in example.pieces):
        return ""
    words = [f"{piece.path}={_text(piece)}" for piece in example.pieces if _is_said(piece)]
    return " ".join(["sbgc send", example.message.name, *map(shlex.quote, words)])


def _is_said(piece: Piece) -> bool:
    """False for the values of a new message, and for values implied by others."""
    field = piece.field
    if field.reserved or field.is_counter:
        return False
    varies = "[" in piece.path or field.dim in ("counted", "rest")
    return any(piece.data) or bool(field.default) or bool(piece.missing) or varies


def _text(piece: Piece) -> str:
    if isinstance(piece.field.type, Announced):
        assert isinstance(piece.type, Scalar)
        return f"{piece.type.name}:{piece.value:g}"
    if piece.field.variable:
        return f"raw:{piece.value}"
    if isinstance(piece.type, Quantity):
        return _quantity(piece, piece.type)
    return _plain(piece.type, piece.value)


def _quantity(piece: Piece, quantity: Quantity) -> str:
    """A number in the unit in effect, or the raw number."""
    other = piece.field.alternative
    is_in_unit = not other or piece.meaning.startswith(physical(piece.value, quantity))
    is_special = any(special.value == piece.value for special in piece.field.special)
    if is_special or not is_in_unit:
        return f"raw:{piece.value}"
    if quantity.scalar.is_float:
        return f"{float(quantity.real(piece.value)):.7g}"
    return decimal(piece.value, quantity)


def _plain(type_: Type, value: object) -> str:
    if isinstance(type_, Enum) and isinstance(value, int):
        if type_.kind == "flags":
            return "|".join(flag.name for flag in flags_of(type_, value)) or str(value)
        named = value_named(type_, value)
        return named.name if named else str(value)
    if isinstance(type_, Packed) and isinstance(value, int):
        return _packed(type_, value)
    if isinstance(type_, Blob):
        return str(value)
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def _packed(type_: Packed, value: int) -> str:
    parts = parts_that_make(type_, value)
    if not parts:
        return str(value)
    said = []
    for part, number in parts:
        text = _plain(part.enum, number) if part.enum else f"{part.name}:{number}"
        if part.quantity:
            text = f"{part.name}:{decimal(number, part.quantity)}"
        is_number = part.enum is not None and text == str(number)
        said.append(f"{part.name}:{number}" if is_number else text.replace("|", ","))
    return ",".join(said)

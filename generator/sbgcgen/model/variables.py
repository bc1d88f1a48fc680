"""The adjustable variables."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import floor, lcm

from sbgcgen.model.bodies import Later
from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.values import Availability, AxisDirection, Quantity, Scalar


@dataclass(frozen=True)
class VariableSetting:
    """A setting that a variable sets; its raw value is the variable's * `scale` + `offset`.

    `special` are the setting's sentinels, to which no other value may be rounded. `later` are
    the meanings that later firmware gives the setting.
    """

    message: str
    path: str
    scalar: Scalar
    scale: Fraction
    offset: Fraction
    special: tuple[int, ...] = ()
    direction: AxisDirection | None = None
    later: tuple[Later, ...] = ()

    @property
    def denominator(self) -> int:
        """The common denominator of `scale` and `offset`."""
        return lcm(self.scale.denominator, self.offset.denominator)

    @property
    def numerator(self) -> int:
        return int(self.scale * self.denominator)

    @property
    def addend(self) -> int:
        return int(self.offset * self.denominator)

    def count(self, value: int) -> int:
        """The raw value of the setting that is nearest to a value of the variable.

        A value that would round to a sentinel without being equal gets the adjacent raw value.
        """
        exact = value * self.scale + self.offset
        count = _nearest(exact)
        if count in self.special and count != exact:
            return count + (1 if exact > count else -1)
        return count

    def value(self, count: int) -> int:
        """The value of the variable that is nearest to a raw value of the setting."""
        return _nearest((count - self.offset) / self.scale)


def _nearest(exact: Fraction) -> int:
    """The nearest integer; halves round away from 0."""
    whole = floor(abs(exact) + Fraction(1, 2))
    return whole if exact >= 0 else -whole


@dataclass(frozen=True)
class Variable:
    """An adjustable variable (Appendix B).

    It sets all `settings` and reads the first. A switch is 1 if the setting is not 0; switching it
    on leaves settings that are not 0 unchanged.
    """

    name: str
    identifier: str
    id: int
    scalar: Scalar
    quantity: Quantity | None
    minimum: int
    maximum: int
    summary: str
    errata: tuple[str, ...]
    settings: tuple[VariableSetting, ...] = ()
    is_switch: bool = False
    since: Availability = Availability()
    unconfirmed: bool = False
    at: Position = field(default=NOWHERE, compare=False, repr=False)

    @property
    def is_directed(self) -> bool:
        """True if its values have a sign convention."""
        return self.quantity is not None and self.quantity.is_directed

    @property
    def direction(self) -> AxisDirection | None:
        """The direction of its values, the same as that of its settings; None if unknown."""
        return self.settings[0].direction if self.settings else None

    @property
    def later(self) -> tuple[Later, ...]:
        """The meanings that later firmware gives its values: those of its settings, in its own range."""
        low, high = Fraction(self.minimum), Fraction(self.maximum)
        return tuple(
            replace(one, minimum=low, maximum=high, summary=one.summary or self.summary)
            for one in (self.settings[0].later if self.settings else ())
        )

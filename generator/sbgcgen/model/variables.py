"""The adjustable variables."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from math import floor, lcm

from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.values import Quantity, Scalar


@dataclass(frozen=True)
class VariableSetting:
    """A setting that a variable stands for: its count is the variable's * `scale` + `offset`.

    `special` are the counts with a meaning of their own that no other value may be rounded to.
    """

    message: str
    path: str
    scalar: Scalar
    scale: Fraction
    offset: Fraction
    special: tuple[int, ...] = ()

    @property
    def denominator(self) -> int:
        """Of both `scale` and `offset`."""
        return lcm(self.scale.denominator, self.offset.denominator)

    @property
    def numerator(self) -> int:
        return int(self.scale * self.denominator)

    @property
    def addend(self) -> int:
        return int(self.offset * self.denominator)

    def count(self, value: int) -> int:
        """The count of the setting that is nearest to a value of the variable.

        A special count is only that of a value that is it exactly: others get the step beside it.
        """
        exact = value * self.scale + self.offset
        count = _nearest(exact)
        if count in self.special and count != exact:
            return count + (1 if exact > count else -1)
        return count

    def value(self, count: int) -> int:
        """The value of the variable that is nearest to a count of the setting."""
        return _nearest((count - self.offset) / self.scale)


def _nearest(exact: Fraction) -> int:
    """The nearest integer; a half goes away from 0."""
    whole = floor(abs(exact) + Fraction(1, 2))
    return whole if exact >= 0 else -whole


@dataclass(frozen=True)
class Variable:
    """An adjustable variable (Appendix B).

    It stands for `settings`, the first of which is the one that is read. A switch tells only
    whether its settings are 0, and leaves what is not 0 as it is when it is switched on.
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
    at: Position = field(default=NOWHERE, compare=False, repr=False)

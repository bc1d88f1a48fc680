"""The Layout model: the protocol fully resolved, frozen, and the only thing that templates see.

Every size, offset, name and reference is decided here, once. Targets print it; none of them
computes a layout again.
"""

from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.values import (
    Availability,
    Deprecation,
    Enum,
    EnumValue,
    Packed,
    Part,
    Quantity,
    SCALARS,
    Scalar,
    Until,
    Versions,
)
from sbgcgen.model.bodies import (
    Alternative,
    Announced,
    Announcement,
    Blob,
    Condition,
    Constant,
    Context,
    Field,
    Identifier,
    Leaf,
    Special,
    Struct,
    Type,
    constants,
    element_of,
    scalar_of,
)
from sbgcgen.model.answers import Answer, AnswerCase, Echo, Growth, Reply, Result, Role
from sbgcgen.model.effects import EFFECTS, Effect, EffectCase
from sbgcgen.model.messages import Command, Family, Message, Settings, conditions, copy_field
from sbgcgen.model.variables import Variable, VariableSetting
from sbgcgen.model.framing import BODY, CHECKSUM_SIZES, ID, SIZE, START, Checksum, Framing
from sbgcgen.model.protocol import Erratum, Layout, Line
from sbgcgen.model.revisions import Addition, Revision

__all__ = [
    "BODY",
    "CHECKSUM_SIZES",
    "Checksum",
    "ID",
    "SIZE",
    "START",
    "Addition",
    "Alternative",
    "Announced",
    "Announcement",
    "Answer",
    "AnswerCase",
    "Availability",
    "Blob",
    "Command",
    "Condition",
    "Constant",
    "Context",
    "Deprecation",
    "EFFECTS",
    "Echo",
    "Effect",
    "EffectCase",
    "Enum",
    "EnumValue",
    "Erratum",
    "Family",
    "Field",
    "Framing",
    "Growth",
    "Identifier",
    "Layout",
    "Leaf",
    "Line",
    "Message",
    "NOWHERE",
    "Packed",
    "Part",
    "Position",
    "Quantity",
    "Reply",
    "Result",
    "Revision",
    "Role",
    "SCALARS",
    "Scalar",
    "Settings",
    "Special",
    "Struct",
    "Type",
    "Until",
    "Variable",
    "VariableSetting",
    "Versions",
    "conditions",
    "constants",
    "copy_field",
    "element_of",
    "scalar_of",
]

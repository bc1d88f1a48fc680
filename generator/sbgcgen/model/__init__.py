"""The Layout model: the fully resolved, immutable protocol, and the only input of the templates.

It holds every size, offset, name and reference. Targets print them and never compute a layout.
"""

from sbgcgen.model.position import NOWHERE, Position
from sbgcgen.model.values import SCALARS, Alias, Availability, AxisDirection, Deprecation, Enum
from sbgcgen.model.values import EnumValue, Feature, Former, Identifier, Packed, Part, Quantity
from sbgcgen.model.values import Scalar, Until, Versions
from sbgcgen.model.bodies import Alternative, Announced, Announcement, Blob, Constant, Context
from sbgcgen.model.bodies import Field, FieldRule, Later, Leaf, Special, Struct, Type, constants
from sbgcgen.model.bodies import all_fields, element_of, field_rules, scalar_of
from sbgcgen.model.conditions import Condition, satisfying, value_at
from sbgcgen.model.answers import Answer, AnswerCase, CorrelationField, OptionalPart, Response
from sbgcgen.model.answers import Result, Role
from sbgcgen.model.effects import READS, UNKNOWN, USUAL_EFFECTS, Effect, EffectCase, EffectKind
from sbgcgen.model.effects import StopPattern, StopValue
from sbgcgen.model.messages import COMMAND_IDS, Command, Family, Message, Settings, conditions
from sbgcgen.model.messages import copy_field, largest_forms
from sbgcgen.model.variables import Variable, VariableSetting
from sbgcgen.model.framing import BODY, CHECKSUM_SIZES, ID, SIZE, START, Checksum, Crc, Framing
from sbgcgen.model.protocol import Addition, Erratum, Layout, Line, Revision, Topic

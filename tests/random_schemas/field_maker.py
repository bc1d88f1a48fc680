"""Makes lists of fields, for structs and messages."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any, Optional

from spec_parts import INTEGERS, MAX_BODY, MAX_MEMORY, SIZES, UNSIGNED, WIDE
from spec_parts import Kind, Node, Scope, blob, scalar
from type_maker import TypeMaker


class FieldMaker(TypeMaker):
    """Makes lists of fields."""

    # Types of fields

    def number_kind(self) -> Kind:
        """Returns a type with a number on the wire."""
        scalars = [scalar(name) for name in (*SIZES, *WIDE)]
        ids = ("CommandToBoard", "CommandFromBoard", "VariableId")
        named = [replace(scalar("u8"), name=name) for name in ids]
        pools = (scalars, self.quantities, self.enums, self.flag_sets, self.packed, named)
        return self.random.choice(self.random.choice([pool for pool in pools if pool]))

    def blob_kind(self) -> Kind:
        """Returns bytes or text of some size."""
        return blob(self.random.choice((1, 2, 3, 7)), self.random.choice(("bytes", "text")))

    def element_kind(self, scope: Scope) -> Kind:
        """Returns any type with a limited size."""
        what = self.random.random()
        if what < 0.5:
            return self.number_kind()
        if what < 0.7:
            return self.blob_kind()
        if what < 0.8:
            return Kind("string", 1, MAX_BODY + 1, fixed=False)
        structs = [k for k in self.structs if self.can_use(scope, k)]
        return self.random.choice(structs) if structs else self.number_kind()

    def can_use(self, scope: Scope, kind: Kind) -> bool:
        """Returns True if a list of fields may hold a struct: it fits and creates no family cycle."""
        order = list(self.families)
        return (
            order.index(kind.needs_family) <= order.index(scope.family)
            and kind.least <= scope.budget // 2
            and kind.memory <= MAX_MEMORY
            and not kind.takes_rest
        )

    # Fields

    def put(self, scope: Scope, kind: Kind, suffix: str = "", count: int = 1, **keys: Any) -> str:
        """Adds a field of a type, perhaps several times; returns its name."""
        name = self.field_name()
        node = self.said({"name": name + suffix, "type": kind.name, **keys})
        scope.add(node, kind.least * count, kind.memory * count, kind.fixed)
        return name

    def make_fields(self, scope: Scope, count: int) -> None:
        """Adds up to `count` fields to a scope."""
        makers: list[tuple[float, Callable[[Scope], None]]] = [
            (6, self.add_number),
            (2, self.add_element),
            (2.5, self.add_conditional),
            (1, self.add_list),
            (0.6, self.add_reserved),
            (0.4, self.add_inline_struct),
            (0.3, self.add_variable_value),
            (0.8, self.add_condition_source),
            (0.7, self.add_bits_list),
            (0.4 * scope.in_message, self.add_group),
        ]
        weights = [weight for weight, _ in makers]
        for _ in range(count):
            if scope.budget >= 8:
                self.random.choices(makers, weights)[0][1](scope)

    def dimension(self, scope: Scope, kind: Kind) -> tuple[str, int]:
        """Returns a suffix for a field's name, and how often the field then occurs."""
        choices = [("", 1)] * 6 + [("[axis]", 3), ("[xyz]", 3), ("[1]", 1), ("[4]", 4)]
        choices += [("_{AXIS}", 3 if scope.in_message else 1), ("{1..3}_END", 3), ("{5..5}", 1)]
        fitting = [
            (text, count)
            for text, count in choices
            if kind.least * count <= scope.budget and kind.memory * count <= MAX_MEMORY
        ]
        return self.random.choice(fitting or [("", 1)])

    def decorate(self, node: Node, kind: Kind, scope: Scope) -> Node:
        """Adds limits and remarks to a field."""
        if kind.number in INTEGERS and self.chance(0.4):
            low, high = sorted(self.random.randint(*INTEGERS[kind.number]) for _ in range(2))
            node["range"] = f"{low}..{high}"
            if self.chance(0.3):
                node["special"] = {str(low): 'Lowest "of" all.'}
                node["special_in_range"] = True
                if low % 2:
                    named = {"as": self.unique("named_special_"), "summary": "Lowest of all."}
                    node["special"][str(low)] = named
        elif kind.number == "f32" and self.chance(0.4):
            node["range"] = self.random.choice(("-0.5..1.25", "0..1", "-1000000000..0.1"))
        if kind.number in INTEGERS and "special" not in node and self.chance(0.2):
            low, high = INTEGERS[kind.number]
            node["special"] = {str(low): "The lowest.", str(high): "The highest."}
            node["special_in_range"] = True
        if kind.number in INTEGERS and self.chance(0.1):
            node["align"] = self.random.choice((2, 64))
        if kind.number in INTEGERS and not kind.is_quantity and "align" not in node:
            lowest = str(node.get("range", INTEGERS[kind.number][1])).partition("..")[0]
            node |= self.perhaps(0.2, typical=int(lowest))
        node |= self.perhaps(0.1, deprecated=self.random.choice((True, {"since": self.since()})))
        self.grow(node, kind)
        alike = [k for k in self.quantities if (k.number, k.unit) == (kind.number, kind.unit)]
        others = [k for k in alike if k != kind]
        if kind.is_quantity and others and scope.flags and scope.in_message and self.chance(0.4):
            of, flag = self.random.choice(scope.flags)
            other = self.random.choice(others).name
            node["alternative"] = {"type": other, "of": of, "flag": flag}
        elif kind.number in SIZES and "constant" not in node and self.chance(0.2):
            node["later"] = self.later(node, kind)
        return self.said(node)

    def later(self, node: Node, kind: Kind) -> list[Node]:
        """Returns what a number means in later firmware."""
        pools = (self.quantities, self.enums, self.flag_sets, self.packed)
        types = [k.name for pool in pools for k in pool if k.number == kind.number != kind.name]
        types = [name for name in types if name != kind.name]
        first: Node = {"firmware": "2.70", "summary": "Another meaning."}
        if types:
            first["type"] = self.random.choice(types)
        second: Node = {"firmware": "2.73", "summary": "Yet another one."}
        if kind.number in INTEGERS and "special" not in node:
            low, high = INTEGERS[kind.number]
            second["range"] = f"{low // 2}..{high // 3}"
        return [first, second][: self.random.choice((1, 2))]

    def grow(self, node: Node, kind: Kind) -> None:
        """Adds what later firmware says about a field: a default, a former name, doubts."""
        if kind.number in INTEGERS and not {"special", "align", "typical"} & set(node):
            known: list[Any] = [name for name, _ in kind.values]
            if kind.name in INTEGERS:
                limits = node.get("range", "%d..%d" % INTEGERS[kind.name])
                known = [int(limit) for limit in limits.split("..")]
            elif "range" in node:
                known = []
            if known and self.chance(0.1):
                node["default"] = self.random.choice(known)
            elif known and self.chance(0.05) and "range" not in node:
                node["constant"] = self.random.choice(known)
        if node["name"].isidentifier():
            node |= self.perhaps(0.1, was=self.unique("FORMER_NAME_"))
        node |= self.perhaps(0.1, unconfirmed=True)
        saved = self.random.choice((None, "saved__name", "saved{n}"))
        node |= self.perhaps(0.1, saved_as=saved, saved_in=self.random.choice(("unit", "raw")))

    def rules(self, fields: list[Node]) -> list[str]:
        """Returns a rule for two fields of the same type and number, if there are such."""
        counters = {f["name"].partition("[")[2].rstrip("]") for f in fields if "name" in f}
        plain = [f for f in fields if f.get("type") in INTEGERS and f["name"].isidentifier()]
        plain = [f for f in plain if not {"when", "since", "constant"} & set(f)]
        names = [(f["name"], f["type"]) for f in plain if f["name"] not in counters]
        pairs = [
            f"{low} {self.random.choice(('<', '<='))} {high}"
            for low, high_type in ((one, type_) for one, type_ in names)
            for high, type_ in names
            if low != high and type_ == high_type
        ]
        return [self.random.choice(pairs)] if pairs and self.chance(0.5) else []

    def add_number(self, scope: Scope) -> None:
        """Adds a number, once or several times."""
        kind = self.number_kind()
        name = self.field_name()
        dim, count = self.dimension(scope, kind)
        node = self.decorate({"name": name + dim, "type": kind.name}, kind, scope)
        used = self.condition(scope) if scope.in_message and self.chance(0.15) else None
        if used is not None and "context" not in used:
            node["used_when"] = used
        scope.add(node, kind.least * count, kind.memory * count, True)
        is_integer = kind.name in (*INTEGERS, "u24", "i24")
        is_integer = is_integer or (kind.is_quantity and kind.number in INTEGERS)
        if dim in ("", "[axis]", "[4]") and (kind.values or kind.parts or is_integer):
            self.depend_on(scope, name + {"": "", "[axis]": ".yaw", "[4]": "[2]"}[dim], kind)
        if kind.name == "VariableId" and not dim:
            scope.variables.append(name)

    def depend_on(self, scope: Scope, name: str, kind: Kind) -> None:
        """Allows later fields to depend on this one."""
        if kind.parts:
            scope.known += [(f"{name}.{part}", inner) for part, inner in kind.parts]
        else:
            scope.known.append((name, kind))
        if kind.is_flags and scope.in_message and name.isidentifier():
            scope.flags += [(name, flag) for flag, mask in kind.values if mask]

    def add_condition_source(self, scope: Scope) -> None:
        """Adds an enum or flag set that other fields may depend on."""
        packed = [kind for kind in self.packed if kind.parts]
        integers = [scalar("u8"), scalar("i16")]
        kind = self.random.choice(self.enums + self.flag_sets + integers + packed)
        self.depend_on(scope, self.put(scope, kind), kind)

    def add_element(self, scope: Scope) -> None:
        """Adds a field of any type."""
        kind = self.element_kind(scope)
        dim, count = self.dimension(scope, kind)
        node = {"name": self.field_name() + dim, "type": kind.name}
        node = self.decorate(node, kind, scope) if kind.number else self.said(node)
        scope.add(node, kind.least * count, kind.memory * count, kind.fixed)

    def add_reserved(self, scope: Scope) -> None:
        """Adds reserved bytes, with or without a name."""
        if self.chance(0.6):
            size = self.random.randint(1, 5)
            scope.add({"reserved": size}, size, size, True)
        else:
            kind = self.blob_kind() if self.chance(0.5) else self.number_kind()
            node = {"name": self.field_name(), "type": kind.name, "reserved": True}
            scope.add(node, kind.least, kind.memory, True)

    def condition(self, scope: Scope) -> Optional[Node]:
        """Returns a condition for fields of this scope, or None."""
        sources = [("field", n, k) for n, k in scope.known]
        sources += [("context", n, k) for n, k in scope.contexts] * 3
        if not sources:
            return None
        joined = self.joined(scope) if self.chance(0.2) else None
        if joined is not None:
            return joined
        key, name, kind = self.random.choice(sources)
        if kind.is_flags:
            flags = [flag for flag, mask in kind.values if mask]
            chosen = self.random.sample(flags, self.random.randint(1, min(2, len(flags))))
            word = self.random.choice(("has", "has", "any"))
            when = {key: name, word: chosen if len(chosen) > 1 else chosen[0]}
            masks = dict(kind.values)
            used = sum(masks[flag] for flag in chosen)  # no two flags share a bit
            others = [flag for flag in flags if not masks[flag] & used]
            if others and self.chance(0.3):
                when["has_not"] = self.random.choice(others)
            return when
        names: list[Any] = [value for value, _ in kind.values]
        if not names:  # an integer
            low, high = kind.limits if kind.limits else INTEGERS.get(kind.number, (0, 255))
            names = [number for number in (0, 1, 2, 100) if low <= number <= high]
            if self.chance(0.4) and high > 2:
                word = self.random.choice(("at_least", "at_most"))
                return {key: name, word: self.random.choice([n for n in names if low < n < high])}
            names = names[: high - low]  # not all of a few values
        chosen = self.random.sample(names, self.random.randint(1, min(3, len(names))))
        word = "is_not" if self.chance(0.2) else "is"
        chosen = chosen[: max(1, len(names) - 1)] if word == "is_not" else chosen
        return {key: name, word: chosen if len(chosen) > 1 else chosen[0]}

    def joined(self, scope: Scope) -> Optional[Node]:
        """Returns a condition on several fields, if there are some."""
        names = list(dict.fromkeys(re.split(r"[.\[]", name)[0] for name, _ in scope.known))
        if len(names) < 2:
            return None
        terms = []
        for wanted in self.random.sample(names, 2):
            known = [one for one in scope.known if re.split(r"[.\[]", one[0])[0] == wanted]
            terms.append(self.condition(replace(scope, known=known, contexts=[])))
        return {self.random.choice(("all", "one_of")): terms}

    def add_conditional(self, scope: Scope) -> None:
        """Adds a field that is present only under a condition on another field."""
        when = self.condition(scope)
        if when is None:
            return self.add_condition_source(scope)
        kind = self.element_kind(scope)
        dim, count = self.dimension(scope, kind)
        name = self.field_name()
        node = self.decorate({"name": name + dim, "type": kind.name, "when": when}, kind, scope)
        if "context" not in when and kind.fixed and self.chance(0.3):
            when["may_be_missing"] = True
        scope.budget -= kind.least * count
        scope.add(node, 0, kind.memory * count + 4, False)
        if kind.values and not dim and self.chance(0.5):
            scope.known.append((name, kind))
        return None

    def add_appended(self, scope: Scope) -> None:
        """Adds fields before which the body of older firmware ends."""
        for _ in range(self.random.randint(1, 3)):
            kind = self.element_kind(scope)
            dim, count = self.dimension(scope, kind)
            node: Node = {"name": self.field_name() + dim, "type": kind.name}
            node["since"] = self.appended()
            scope.budget -= kind.least * count
            scope.add(self.said(node), 0, kind.memory * count + 4, False)
        scope.takes_rest = True

    def appended(self) -> Node:
        """Returns the version of a field before which older bodies end."""
        return {"firmware": self.random.choice(("2.90", "2.91"))}

    def add_grown(self, scope: Scope, is_counted: bool) -> None:
        """Adds a list whose elements are longer in later firmware, perhaps with its counter."""
        name, number = self.field_name(), self.random.choice(UNSIGNED)
        node: Node = {"struct": self.unique("Grown")}
        if is_counted:
            node["name"] = f"{name}[{self.put(scope, scalar(number))}]"
            node |= self.perhaps(0.2, counted_from=1)
            kinds = [blob(3), *(self.number_kind() for _ in range(2))]
            later = [self.number_kind() for _ in range(self.random.randint(1, 3))]
        else:  # the sizes have no common multiple in a body
            node["name"] = f"{name}[]"
            kinds, later = [blob(19)], [blob(2)]
        inner = Scope(scope.family, MAX_BODY, in_message=False)
        for kind in kinds:
            self.put(inner, kind)
        firmware = sorted(self.random.choice(("2.90", "2.91")) for _ in later)
        for kind, version in zip(later, firmware):
            self.put(inner, kind, since={"firmware": version})
        size = sum(kind.least for kind in kinds)
        memory = MAX_BODY // size * sum(kind.memory + 8 for kind in (*kinds, *later))
        least = size if "counted_from" in node else 0
        scope.add(self.said({**node, "fields": inner.fields}), least, memory, False)
        scope.has_lists = scope.takes_rest = True

    def add_list(self, scope: Scope) -> None:
        """Adds a list and the counter before it."""
        kind = self.element_kind(scope)
        if scope.has_region:  # all fields after a counter would lose their fixed offset
            return self.add_number(scope)
        if MAX_BODY // max(1, kind.least) * kind.memory > MAX_MEMORY:
            kind = self.number_kind()
        limits = self.perhaps(0.5, range=f"0..{self.random.choice((1, 2, 3))}")
        counter = self.put(scope, scalar(self.random.choice(UNSIGNED)), **limits)
        if self.chance(0.2):
            self.add_number(scope)
        node = self.said({"name": f"{self.field_name()}[{counter}]", "type": kind.name})
        if kind.fixed and self.chance(0.2):
            node["counted_in"] = "bytes"
        elif self.chance(0.2):
            node["counted_from"] = 1
        least = kind.least if "counted_from" in node else 0
        scope.add(node, least, MAX_BODY // max(1, kind.least) * kind.memory, False)
        scope.has_lists = True
        return None

    def add_bits_list(self, scope: Scope) -> None:
        """Adds a list with an element for each bit of a flag set, perhaps with a condition."""
        here = {f.get("name") for f in scope.fields if "when" not in f}
        known = [name for name, kind in scope.known if kind.is_flags and name in here]
        for name, kind in scope.known:
            if kind.is_count and name.partition(".")[0] in here and name.count(".") == 1:
                known += [name] if "." in name and "yaw" not in name else []
        if not known:
            return self.add_condition_source(scope)
        kind = self.number_kind()
        node: Node = {"name": f"{self.field_name()}[{self.random.choice(known)}]"}
        node["type"] = kind.name
        when = self.condition(scope) if self.chance(0.5) else None
        if when is not None:
            node["when"] = when
        scope.add(self.said(node), 0, 32 * kind.memory, False)
        return None

    def add_inline_struct(self, scope: Scope) -> None:
        """Adds a struct defined in place, which can be used again later."""
        if scope.depth >= 2:
            return self.add_number(scope)
        name = self.unique("Inline")
        kind, node = self.make_struct(name, scope.family, scope.budget // 3, scope.depth + 1)
        dim, count = self.dimension(scope, kind)
        node.update(name=self.field_name() + dim, struct=name)
        scope.add(self.said(node), kind.least * count, kind.memory * count, kind.fixed)
        self.structs.append(kind)
        return None

    def add_group(self, scope: Scope) -> None:
        """Adds a group for each axis whose fields depend on a flag set before it."""
        if scope.has_region or scope.budget < 60:
            return self.add_number(scope)
        words = [self.unique("ASKED_") for _ in range(3)]
        names = [f"{axis}_{word}" for word in words for axis in ("ROLL", "PITCH", "YAW")]
        flags, number = self.unique("Asked"), "u16"
        values = {name: self.said({"value": 1 << bit}) for bit, name in enumerate(names)}
        node = self.sourced({"type": number, "values": values})
        self.section(scope.family, "flags")[flags] = node
        source = self.put(scope, Kind(flags, 2, 2))
        inner: list[Node] = []
        least = 0
        for _ in range(self.random.randint(1, 4)):
            kind = self.number_kind() if self.chance(0.7) else self.blob_kind()
            asked = [f"{{AXIS}}_{word}" for word in self.random.sample(words, 2)]
            when: Node = {"field": source, self.random.choice(("has", "any")): asked}
            if self.chance(0.3):
                when = {"field": source, "has": asked[0], "has_not": asked[1]}
            name = self.field_name() + self.random.choice(("", "", "[2]"))
            field_ = self.said({"name": name, "type": kind.name})
            if self.chance(0.8) or not inner:
                field_["when"] = when
            else:
                least += 3 * kind.least * (2 if "[" in name else 1)
            scope.memory += 8 * kind.memory + 12
            scope.budget -= 6 * kind.least
            inner.append(field_)
        suffix = self.random.choice(("[axis]", "[axis]", "_{AXIS}"))
        group = {"name": self.field_name() + suffix, "struct": self.unique("Group")}
        scope.budget += least
        scope.add(self.said({**group, "fields": inner}), least, 0, False)
        return None

    def make_struct(
        self, name: str, family: str, budget: int, depth: int, rest: bool = False
    ) -> tuple[Kind, Node]:
        """Returns a struct and its entry in the spec."""
        inner = Scope(family, max(8, budget), in_message=False, depth=depth)
        self.make_fields(inner, self.random.randint(1, 5))
        if rest:
            self.add_rest(inner)
        if not inner.fields:
            self.add_number(inner)
        kind = Kind(name, inner.least, inner.memory + 8, inner.fixed, needs_family=family)
        node: Node = {"fields": inner.fields}
        rules = self.rules(inner.fields)
        if rules:
            node["rules"] = rules
        return replace(kind, takes_rest=inner.takes_rest), node

    def add_variable_value(self, scope: Scope) -> None:
        """Adds the value of an adjustable variable."""
        if not scope.variables:
            scope.variables.append(self.put(scope, Kind("VariableId", 1, 1)))
        kind = scalar(self.random.choice(list(INTEGERS)))
        self.put(scope, kind, variable=self.random.choice(scope.variables))

    def add_region(self, scope: Scope) -> None:
        """Adds bytes whose meaning depends on preceding fields."""
        if scope.has_lists or not scope.fixed or scope.budget < 8:
            return
        here = {f.get("name") for f in scope.fields if "when" not in f}
        bases = [re.sub(r"\[.*", "", str(name)) for name in here]
        known = [one for one in scope.known if re.split(r"[.\[]", one[0])[0] in bases]
        if not known:
            self.add_condition_source(scope)
            known = [scope.known[-1]]
        size = self.random.choice((4, 8))
        inner = Scope(scope.family, 99, in_message=False, depth=9, known=known)
        left = size  # several conditions may be true at once
        for _ in range(self.random.randint(1, 3)):
            kind = self.number_kind() if self.chance(0.7) else blob(2)
            if kind.least > left:
                continue
            left -= kind.least
            name = "REST_OF_IT" if (name := self.field_name()) == "REST" else name
            node: Node = {"name": name, "type": kind.name, "when": self.condition(inner)}
            inner.fields.append(self.decorate(node, kind, inner))
        if not inner.fields:
            self.put(inner, scalar("u8"), when=self.condition(inner))
        node = {"name": self.field_name(), "struct": self.unique("Region"), "size": size}
        scope.add(self.said({**node, "fields": inner.fields}), size, 50, True)
        scope.has_region = True

    def add_rest(self, scope: Scope) -> None:
        """Adds a field that takes the remaining body."""
        node: Node = {"name": self.field_name(), "type": "bytes[]"}
        if self.chance(0.15) and scope.budget >= 24:  # fields of which the last may be missing
            least = self.random.randint(1, 3)
            self.put(scope, self.number_kind(), "_{1..3}", least, min_count=least)
            scope.memory += 25
            scope.fixed, scope.takes_rest = False, True
            return
        structs = [k for k in self.structs if k.fixed and k.least and self.can_use(scope, k)]
        what = self.random.random()
        least = 1
        if what < 0.3:
            node["align"] = self.random.choice((1, 2))
        elif what < 0.45 and scope.depth < 2:
            name = self.unique("Tail")
            kind, inner = self.make_struct(name, scope.family, 20, scope.depth + 1, rest=True)
            node = {"name": node["name"], "struct": name, **inner}
            scope.add(self.said(node), kind.least, kind.memory, False)
            scope.takes_rest = True
            return
        else:
            kind = self.number_kind() if self.chance(0.6) else self.blob_kind()
            if self.chance(0.2):
                kind = Kind(self.random.choice(("string[5]", "string")), 1, 50, fixed=False)
            kind = self.random.choice(structs) if structs and self.chance(0.3) else kind
            node = {"name": node["name"] + "[]", "type": kind.name}
            if kind.name.startswith(("string", "text", "bytes")):
                node |= self.perhaps(0.5, secret=True)
            least = kind.least
        if scope.budget >= 3 * least:
            node |= self.perhaps(0.5, max_count=self.random.choice((1, 2, 3)))
        if self.chance(0.3) and "align" not in node and scope.budget >= 3 * least:
            node["min_count"] = self.random.randint(1, node.get("max_count", 3))
        scope.add(self.said(node), node.get("min_count", 0) * least, MAX_BODY, False)
        scope.takes_rest = True

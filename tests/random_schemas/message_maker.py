"""Makes commands and their messages."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Optional

from field_maker import FieldMaker
from spec_parts import INTEGERS, MAX_BODY, MAX_MEMORY, SIZES, UNSIGNED
from spec_parts import Body, Kind, Node, Scope, blob, scalar
from type_maker import TEXTS


class MessageMaker(FieldMaker):
    """Makes commands and their messages."""

    def make_messages(self) -> None:
        """Makes commands of all kinds; those that others depend on come first."""
        for maker in [self.add_flag_source] * 2 + [self.add_announcement] * self.random.randint(
            1, 2
        ):
            maker()
        makers = [self.add_forms, self.add_both_ways, self.add_same, self.add_including]
        makers += [self.add_dependent, self.add_gaps, self.add_records, self.add_settings]
        makers += [self.add_asked]
        for maker in makers:
            maker()
        makers += [self.add_command] * 5 + [self.add_undocumented]
        for _ in range(self.size):
            self.random.choice(makers)()

    def scope(self, family: str, budget: int = 150) -> Scope:
        """Returns an empty list of fields for a message."""
        return Scope(family, budget, in_message=True)

    def random_scope(self, family: str, rest: bool = True, budget: int = 150) -> Scope:
        """Returns a list of fields for a message; the last one may take the remaining body."""
        scope = self.scope(family, budget)
        self.make_fields(scope, self.random.choice((0, 1, 2, 4, 8, 12)))
        if self.chance(0.3):
            self.add_region(scope)
            self.make_fields(scope, self.random.choice((0, 3)))
        if rest and self.chance(0.35):
            self.add_rest(scope)
        elif rest and self.chance(0.3):
            self.add_appended(scope)
        return scope

    def new_command(self, *directions: str, family: str = "") -> tuple[str, str, Node]:
        """Returns the name, family and entry of a command; its family is `family` or a later one."""
        shared = set(self.ids["from_board"]) & set(self.ids["to_board"])
        pool = sorted(shared) if len(directions) > 1 else self.ids[directions[0]]
        identity = self.random.choice(pool)
        for direction in directions:
            self.ids[direction].remove(identity)
        order = list(self.families)
        name = f"CMD_C{self.unique('')}"
        family = self.random.choice(order[order.index(family) if family else 0 :])
        node = self.said({"id": identity})
        deprecated = self.random.choice((True, {"since": self.since()}))
        node |= self.perhaps(0.1, **{"as": self.unique("called_")})
        node |= self.perhaps(0.2, since=self.since()) | self.perhaps(0.2, deprecated=deprecated)
        self.section(family, "commands")[name] = node
        return name, family, node

    def side(self, direction: str, name: str, content: Node, scope: Optional[Scope] = None) -> Node:
        """Returns one direction of a command: a message called `name` with the fields of `scope`."""
        node = self.sourced({**content, "as": name})
        node |= self.perhaps(0.2, description=self.random.choice(TEXTS))
        if direction == "to_board":
            node["effect"] = self.effect(scope)
            node["answer"] = self.answer(scope)
        elif not self.has_reset and self.chance(0.2):
            self.has_reset = True
            node["role"] = {"is": "reset", "delay_ms": 20}
        return node

    def begin(self, budget: int = 150) -> tuple[Node, str, Scope]:
        """Starts a command in one direction, which end() completes."""
        direction = self.either()
        _, family, node = self.new_command(direction)
        return node, direction, self.scope(family, budget)

    def end(self, node: Node, direction: str, word: str, scope: Scope, **content: Any) -> str:
        """Adds the message with the fields of `scope` to a command; returns its name."""
        name = self.unique(word)
        node[direction] = self.side(direction, name, {**content, "fields": scope.fields})
        self.add_body(name, scope, direction, "context" in content)
        return name

    def case(self, scope: Optional[Scope], without: float) -> Optional[Node]:
        """Returns a condition on the fields of a request, or None with this probability."""
        if scope is None or not scope.known or self.chance(without):
            return None
        return self.condition(replace(scope, contexts=[]))

    def effect(self, scope: Optional[Scope] = None) -> Any:
        """Returns the effect of a request, perhaps under a condition on the fields of `scope`."""
        words = ["sets", "stores", "moves", "restarts", "erases", "disconnects"]
        several = self.random.sample(words, self.random.randint(1, 3))
        when = self.case(scope, 0.5)
        if when is None:
            return self.random.choice(("reads", several))
        return [{"when": when, "does": several}, {"does": "reads"}]

    def answer(self, scope: Optional[Scope] = None) -> Any:
        """Returns a response policy, perhaps under a condition on the fields of `scope`."""
        plain, when = self.plain_answer(), self.case(scope, 0.3)
        if when is None:
            return plain
        other = self.plain_answer()
        first = {"confirm": self.uncertain()} if other == "none" else other
        return [{"when": when, **first}, plain]

    def plain_answer(self) -> Any:
        """Returns an unconditional response policy."""
        from_board = [b.name for b in self.bodies if b.direction == "from_board"]
        if from_board and self.chance(0.5):
            return {"message": self.random.choice(from_board), "retry": "safe"}
        if self.chance(0.5):
            return {"confirm": "always", "confirmations": 2, "timeout_ms": 70}
        return {"confirm": self.uncertain()} if self.chance(0.2) else "none"

    def uncertain(self) -> str:
        """Returns the likelihood of an uncertain confirmation."""
        return self.random.choice(("unlikely", "possible"))

    def add_body(self, name: str, scope: Scope, direction: str, has_contexts: bool = False) -> None:
        """Registers a message."""
        self.bodies.append(Body(name, scope.family, scope, direction, has_contexts))

    def either(self) -> str:
        """Returns a direction."""
        return self.random.choice(("from_board", "to_board"))

    def add_command(self) -> None:
        """Adds a command in one direction, or with different bodies in both."""
        both = self.chance(0.3)
        directions = ("from_board", "to_board") if both else (self.either(),)
        command, family, node = self.new_command(*directions)
        for direction in directions:
            scope = self.random_scope(family)
            name = self.unique("Message")
            content: Node = {"fields": scope.fields} if scope.fields else {}
            content |= self.perhaps(0.3, tail=self.random.choice(("keep", "refuse")))
            if not scope.fixed and self.chance(0.2):
                content["max_size"] = MAX_BODY
            if scope.fixed and scope.least and self.chance(0.3):
                self.name_reserved(scope, content)
            rules = self.rules(scope.fields)
            if rules:
                content["rules"] = rules
            content |= self.perhaps(0.1, unconfirmed=True)
            node[direction] = self.side(direction, name, content, scope)
            if self.chance(0.5):  # named after the command
                del node[direction]["as"]
                name = command.removeprefix("CMD_")
                name += "Request" if both and direction == "to_board" else ""
            self.add_body(name, scope, direction)

    def name_reserved(self, scope: Scope, content: Node) -> None:
        """States the size of the body in every firmware: its last fields had no names before."""
        content["size"] = scope.least
        kind = self.number_kind()
        if kind.least <= scope.budget:
            self.put(scope, kind, since=self.appended())
            content["size"] += kind.least

    def add_forms(self) -> None:
        """Adds a command with several forms, distinguished by size."""
        direction = self.either()
        _, family, node = self.new_command(direction)
        count = self.random.randint(2, 4)
        known = ("simple", "extended", "success", "error")
        names = self.random.sample((*known, "wide", "one_byte", "extended_wide", "form_2"), count)
        forms: Node = {}
        size = -1  # the maximum size of the forms so far
        for position, form in enumerate(names):
            last = position == count - 1
            scope = self.scope(family, 60)
            wanted = size + 1
            if wanted:  # larger than all previous forms
                self.put(scope, blob(wanted))
            self.make_fields(scope, self.random.randint(0, 6 if last else 2))
            if last and self.chance(0.4):
                self.add_rest(scope)
            name = self.unique("Form")
            content = self.said({"fields": scope.fields} if scope.fields else {})
            size = scope.least
            if not scope.fixed and not last:
                size = content["max_size"] = max(1, scope.least + self.random.randint(0, 3))
            if direction == "to_board":
                content["effect"] = self.effect(scope)
                content["answer"] = self.answer(scope)
            if (
                self.chance(0.2) and not last
            ):  # of a request, what is longer than all forms is surplus
                content["until"] = {"firmware": self.random.choice(("2.60", "2.68b7"))}
            forms[form] = {**content, "as": name}
            self.add_body(name, scope, direction)
        order = sorted(forms)
        self.random.shuffle(order)
        node[direction] = self.sourced({"forms": {form: forms[form] for form in order}})

    def add_asked(self) -> None:
        """Adds a command with answers of one size, which the request tells apart."""
        _, family, node = self.new_command("from_board", "to_board")
        size = self.random.choice((1, 2, 4))
        types = [name for name in (*INTEGERS, "f32") if SIZES[name] == size]
        forms: dict[str, Node] = {"from_board": {}, "to_board": {}}
        for length, form in enumerate(self.random.sample(("simple", "extended", "success"), 2), 1):
            names = {direction: self.unique("Asked") for direction in forms}
            scopes = {direction: self.scope(family, 60) for direction in forms}
            kinds = {"from_board": scalar(self.random.choice(types)), "to_board": blob(length)}
            for direction, kind in kinds.items():
                self.put(scopes[direction], kind)
                content = self.said({"fields": scopes[direction].fields, "as": names[direction]})
                if direction == "to_board":
                    content["effect"] = "reads"
                    content["answer"] = {"message": names["from_board"], "retry": "safe"}
                forms[direction][form] = content
                self.add_body(names[direction], scopes[direction], direction)
        for direction, known in forms.items():
            node[direction] = self.sourced({"forms": known})

    def add_both_ways(self) -> None:
        """Adds a command with the same body in both directions."""
        _, family, node = self.new_command("from_board", "to_board")
        scope = self.random_scope(family)
        name = self.unique("Both")
        first, second = self.random.sample(("from_board", "to_board"), 2)
        content: Node = {"fields": scope.fields} if scope.fields else {}
        node[first] = self.side(first, name, content)
        node[second] = self.side(second, name, {"same_as": name})
        self.add_body(name, scope, "from_board")

    def add_same(self) -> None:
        """Adds a command with the body of another."""
        body, direction = self.random.choice(self.bodies), self.either()
        _, family, node = self.new_command(direction, family=body.family)
        name = self.unique("Same")
        node[direction] = self.side(direction, name, {"same_as": body.name})
        self.bodies.append(replace(body, name=name, family=family, direction=direction))

    def add_gaps(self) -> None:
        """Adds a message with optional values before bytes that could be mistaken for them."""
        node, direction, scope = self.begin()
        self.add_condition_source(scope)
        for _ in range(self.random.randint(1, 3)):
            when = {**(self.condition(scope) or {}), "may_be_missing": True}
            kind = self.number_kind() if self.chance(0.7) else self.blob_kind()
            gap = self.said({"name": self.field_name(), "type": kind.name, "when": when})
            scope.add(gap, 0, kind.memory + 4, False)
        self.put(scope, Kind("bytes[]", 0, MAX_BODY, fixed=False))
        scope.takes_rest = True
        self.end(node, direction, "Gaps", scope)

    def add_records(self) -> None:
        """Adds messages that end with a list whose elements grew: one with a counter, and one without."""
        for is_counted in (True, False):
            node, direction, scope = self.begin()
            self.make_fields(scope, self.random.randint(0, 3))
            self.add_grown(scope, is_counted)
            self.end(node, direction, "Records", scope)

    def add_including(self) -> None:
        """Adds a message that includes another."""
        direction = self.either()
        _, family, node = self.new_command(direction)
        order = list(self.families)
        fitting = [
            body
            for body in self.bodies
            if not body.scope.takes_rest
            and not body.has_contexts
            and body.scope.fields
            and body.scope.least < 120
            # what was reserved in one message may have no bytes in another
            and not any("firmware" in f.get("since", ()) for f in body.scope.fields)
            and order.index(body.family) <= order.index(family)
        ]
        scope = self.scope(family, 100)
        content: Node = {"fields": scope.fields}
        name = self.unique("Including")
        if fitting:
            body = self.random.choice(fitting)
            scope.has_region = body.scope.has_region
            if self.chance(0.5) and not scope.has_region:
                self.make_fields(scope, 2)
            scope.add({"include": body.name}, body.scope.least, body.scope.memory, body.scope.fixed)
            scope.has_lists = scope.has_lists or body.scope.has_lists
            self.make_fields(scope, 3)
        else:
            self.add_number(scope)
        node[direction] = self.side(direction, name, content)
        included = replace(scope, takes_rest=True)  # no second include of the same names
        self.bodies.append(Body(name, family, included, direction, False))

    def add_flag_source(self) -> None:
        """Adds a message with the flags that other messages depend on."""
        node, direction, scope = self.begin(40)
        kind = self.random.choice(
            self.flag_sets if self.chance(0.7) else self.enums or self.flag_sets
        )
        self.make_fields(scope, self.random.randint(0, 2))
        if self.chance(0.4):
            group, inner = self.field_name(), self.scope(scope.family)
            path = f"{group}.{self.put(inner, kind)}"
            struct = {"name": group, "struct": self.unique("Group"), "fields": inner.fields}
            scope.add(self.said(struct), kind.least, kind.memory, True)
        else:
            path = self.put(scope, kind)
        if self.chance(0.5):
            self.make_fields(scope, 2)
        name = self.end(node, direction, "Source", scope)
        self.sources.append((f"{name}.{path}", kind))

    def add_announcement(self) -> None:
        """Adds a message that announces the types of numbers in others."""
        node, direction, scope = self.begin(40)
        enum_name, list_name = self.unique("Wire"), self.field_name()
        wires = self.random.sample(sorted(SIZES), self.random.choice((3, 7)))
        values: Node = {
            self.unique("WIRE_"): self.said({"value": number, "wire": wire})
            for number, wire in enumerate(wires)
        }
        if self.chance(0.5):
            values[self.unique("WIRE_")] = self.said({"value": 7})
        section = self.section(scope.family, "enums")
        section[enum_name] = self.sourced({"type": "u8", "values": values})
        kind, kind_name = enum_name, self.field_name()
        path = kind_name
        if self.chance(0.5):
            shift = self.random.choice((0, 3, 5))
            part = self.part(bits=f"{shift}..{shift + 2}", type=enum_name)
            kind = self.add_packed("u8", {"type": "u8", "parts": [part]}).name
            path = f"{kind_name}.{part['name']}"
        count = self.field_name()
        fields = [
            self.said({"name": kind_name, "type": kind}),
            self.said({"name": count, "type": self.random.choice(UNSIGNED)}),
            self.said({"name": self.field_name(), "type": self.random.choice(("string", "i16"))}),
        ]
        self.random.shuffle(fields)
        counter = self.put(scope, scalar("u8"))
        entry = {"name": f"{list_name}[{counter}]", "struct": self.unique("Element")}
        scope.add(self.said({**entry, "fields": fields}), 0, MAX_MEMORY, False)
        scope.has_lists = True
        name = self.end(node, direction, "Announcing", scope)
        context = {"announced_by": f"{name}.{list_name}", "kind": path, "count": count}
        self.announced.append(context)

    def add_dependent(self) -> None:
        """Adds a message whose decoding depends on earlier ones."""
        node, direction, scope = self.begin()
        contexts = []
        if self.chance(0.7):
            path, kind = self.random.choice(self.sources)
            same = [other for other, its in self.sources if its == kind and other != path]
            name = self.unique("CONTEXT_")
            told = {"name": name, "type": kind.name, "from": [path, *same]}
            contexts.append(self.said(told, False))
            scope.contexts.append((name, kind))
        self.make_fields(scope, 3)
        if scope.contexts:
            when = self.condition(replace(scope, known=[]))
            self.put(scope, Kind("u16", 0, 4, fixed=False), when=when)
        for _ in range(self.random.randint(0, 4)):
            self.add_conditional(scope)
        if self.announced and (not contexts or self.chance(0.5)):
            context = {"name": self.unique("TYPES_"), **self.random.choice(self.announced)}
            contexts.append(self.said(context, False))
            self.put(scope, Kind(f"announced({context['name']})", 0, 8 * MAX_BODY, False), "[]")
            scope.takes_rest = True
        elif self.chance(0.3):
            self.add_rest(scope)
        self.end(node, direction, "Dependent", scope, context=contexts)

    def add_settings(self) -> None:
        """Adds settings that can be read and stored: of the whole board, or several copies of them."""
        _, family, node = self.new_command("from_board", "to_board")
        roles = ["state"] * 4
        copy: Node = {}
        if self.chance(0.8):
            roles[:2] = ["general"] * 2
            copy = {"type": self.random.choice(list(INTEGERS)), "role": "copy"}
            copy["range"] = f"0..{self.random.choice((1, 4, 126))}"
        self.random.shuffle(roles)
        scope = self.scope(family)
        copied_at = self.random.randint(0, 3)
        for step, role in enumerate(roles):
            self.add_marked(scope, role)
            if copy and step == copied_at:
                self.put(scope, scalar(copy["type"]), **copy)
            self.make_fields(scope, self.random.randint(0, 2))
        if self.chance(0.3):
            self.add_rest(scope)
        tail = self.perhaps(0.3, tail="keep")
        name = self.unique("Settings")
        node["from_board"] = self.side("from_board", name, {**tail, "fields": scope.fields})
        asked = [self.said({"name": self.field_name(), **copy})] if copy else []
        content: Node = {"fields": asked} if asked else {}
        node["to_board"] = self.side("to_board", self.unique("AskingFor"), content)
        node["to_board"]["answer"] = {"message": name, "retry": "safe"}
        for _ in range(self.random.randint(1, 2)):
            _, _, storing = self.new_command("to_board", family=family)
            content = {"same_as": name, "stores": name}
            storing["to_board"] = self.side("to_board", self.unique("Storing"), content)

    def add_marked(self, scope: Scope, role: str) -> None:
        """Adds an integer of that role, if its offset is fixed."""
        kind = self.number_kind()
        if scope.fixed and kind.number in INTEGERS:
            node = {"name": self.field_name(), "type": kind.name, "role": role}
            scope.add(self.decorate(node, kind, scope), kind.least, kind.memory, True)

    def add_undocumented(self) -> None:
        """Adds an undocumented command without an id."""
        name = self.unique("CMD_UNKNOWN_")
        node: Node = self.sourced({"id": None, "undocumented": True})
        self.section(self.any_family(), "commands")[name] = node

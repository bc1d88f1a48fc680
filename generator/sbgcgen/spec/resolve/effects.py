"""Resolves the possible effects of requests, and those of each request."""

from __future__ import annotations


from sbgcgen.model import READS, UNKNOWN, USUAL_EFFECTS, Effect, EffectCase, EffectKind, Field
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map, Spec
from sbgcgen.spec.resolve.references import ReferenceResolver


class EffectResolver:
    """Knows the effects of the protocol, `kinds`; findings go into `found`."""

    def __init__(self, spec: Spec, references: ReferenceResolver, found: Diagnostics) -> None:
        self.references = references
        self.found = found
        self.kinds = USUAL_EFFECTS
        nodes = spec.main.get("effects")
        if isinstance(nodes, Map):
            self.kinds = (READS, *(self._kind(word, nodes) for word in nodes), UNKNOWN)

    def _kind(self, word: str, nodes: Map) -> EffectKind:
        if word in (READS.word, UNKNOWN.word):
            text = f"every protocol has the effect '{word}'"
            self.found.add(nodes.at(word), "SBGC062", text, "leave it out")
        return EffectKind(word, str(nodes[word]["summary"]), str(nodes[word].get("risk", "")))

    def effect(self, owner: Map, fields: tuple[Field, ...]) -> Effect | None:
        """Resolve the value of `effect:`, which is one word, several words, or cases."""
        node = owner.get("effect")
        if node is None:
            return None
        listed = node if isinstance(node, list) else [node]
        if not isinstance(listed[0], Map):
            return Effect((EffectCase(None, self._words(owner, "effect")),), self.kinds)
        cases = []
        for case in listed:
            when = self.references.condition(case, list(fields), ())
            cases.append(EffectCase(when, self._words(case, "does")))
        return Effect(tuple(cases), self.kinds)

    def _words(self, owner: Map, key: str) -> tuple[str, ...]:
        known = [kind.word for kind in self.kinds]
        for word, at in owner.listed(key):
            if word not in known:
                hint = did_you_mean(word, known) or f"one of: {', '.join(known)}"
                self.found.add(at, "SBGC062", f"there is no effect '{word}'", hint)
        return tuple(word for word, _ in owner.listed(key))

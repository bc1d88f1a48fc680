"""Random settings of a protocol, as lines with the results expected of the generated code.

A line has the message that holds the settings ("settings"), the number of copies ("copies"), the
messages that read and store them, the fields of two such messages ("from", "to"), the copy number in
the second ("copy", null if there is only one), and its fields and body after the general settings of
the first have been copied to it ("shared", "hex").
"""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from typing import Any

from random_messages import RandomMessages

from sbgcgen.model import Layout, Settings, copy_field
from sbgcgen.oracle.codec import Fields
from sbgcgen.oracle.encoding import encode
from sbgcgen.oracle.json_values import plain


def lines_of(layout: Layout, seed: int, count: int) -> Iterator[str]:
    """Yields `count` lines for each kind of settings."""
    chosen = random.Random(seed)
    for settings in layout.settings:
        maker = RandomMessages(settings.message, chosen)
        for _ in range(count):
            yield json.dumps(plain(_line(settings, _fields(maker), _fields(maker)))) + "\n"


def _fields(maker: RandomMessages) -> Fields:
    """Returns the fields of a random valid body."""
    while True:
        vector = maker.vector()
        if vector is not None and vector.body is not None and vector.fields is not None:
            return vector.fields


def _line(settings: Settings, source: Fields, target: Fields) -> dict[str, Any]:
    message, copy = settings.message, copy_field(settings.message)
    general = {f.name: source[f.name] for f in message.fields if f.role == "general"}
    shared = {**target, **general}
    return {
        "settings": message.name,
        "copies": settings.copies,
        "readers": [m.name for m in settings.readers],
        "writers": [m.name for m in settings.writers],
        "from": source,
        "to": target,
        "copy": target[copy.name] if copy else None,
        "shared": shared,
        "hex": encode(message, shared).hex(),
    }

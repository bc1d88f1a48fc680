"""The parameters of a board, by the names of their fields."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from difflib import get_close_matches

from sbgc import _core
from sbgc.message import Message, wrap


class Profile(Mapping[str, object]):
    """The parameters of a profile, and those of the whole board.

    A name is the path of a field, or its end if that is unique: "pitch.p". The name of a message may
    precede it. A value is a number in the unit of the field, or human-readable text: "20deg",
    "FOLLOW_MODE_FC"; enums and flags are returned as such text. Values can be set in a block of
    edit_profile().
    """

    def __init__(self, blocks: _core.Blocks) -> None:
        self._blocks = blocks
        self._will_be_written = False

    def _find(self, name: str) -> tuple[_core.AnyMessage, str]:
        of, _, rest = name.partition(".")
        for _, _, message in self._blocks:
            if message.name == of and rest in message.paths():
                return message, rest
        found = [(message, path) for _, _, message in self._blocks for path in message.find(name)]
        exact = [(message, path) for message, path in found if path == name]
        if len(exact) == 1:
            return exact[0]
        if len(found) == 1:
            return found[0]
        if not found:
            near = get_close_matches(name, self)
            hint = f"; near it: {', '.join(near)}" if near else ""
            raise KeyError(f"no parameter of this board is called '{name}'{hint}")
        paths = ", ".join(f"{path} of {message.name}" for message, path in found)
        raise KeyError(f"'{name}' is the name of several parameters: {paths}")

    def __getitem__(self, name: str) -> object:
        message, path = self._find(name)
        return message.said(path)

    def __setitem__(self, name: str, value: object) -> None:
        if not self._will_be_written:
            raise RuntimeError(f"{name}: it is set only in a block of edit_profile()")
        message, path = self._find(name)
        message.put(path, value)

    def __iter__(self) -> Iterator[str]:
        """Return the paths of all parameters, prefixed with the message name if they are ambiguous."""
        count = Counter(path for _, _, message in self._blocks for path in message.paths())
        for _, _, message in self._blocks:
            for path in message.paths():
                yield path if count[path] == 1 else f"{message.name}.{path}"

    def __len__(self) -> int:
        return sum(len(message.paths()) for _, _, message in self._blocks)

    def __repr__(self) -> str:
        return f"<sbgc.Profile, {len(self)} parameters>"

    @property
    def messages(self) -> Iterator[Message]:
        """Iterate over the messages with the parameters; changes to them count, too."""
        return (wrap(message) for _, _, message in self._blocks)


def profile_index(profile: int) -> int:
    """Return the raw number of a profile, which counts from 0."""
    if not isinstance(profile, int) or not 1 <= profile <= 5:
        raise ValueError(f"profile: 1 to 5 are possible, not {profile!r}")
    return profile - 1


def diff(before: str, after: str) -> str:
    """Return the differences of two backups as text; "" if there are none."""
    return _core.diff(before, after)


class Edit:
    """Changes of a profile, which are written at the end."""

    def __init__(self, read: _core.Blocks, index: int) -> None:
        # Parameters that exist once per board are read with every profile.
        kept = {name for name, copy, _ in read if copy == index}
        blocks = [block for block in read if block[1] == index or block[0] not in kept]
        self._before = [message.copy() for _, _, message in blocks]
        self._blocks = blocks
        self.profile = Profile(blocks)

    def begin(self) -> Profile:
        """Return the parameters, which can be set until the end."""
        self.profile._will_be_written = True
        return self.profile

    def end(self) -> _core.Blocks:
        """Return the blocks that differ from those that were read."""
        self.profile._will_be_written = False
        pairs = zip(self._blocks, self._before)
        return [block for block, before in pairs if not block[2] == before]

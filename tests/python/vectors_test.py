"""All vectors of the reference codec, and the inputs of the fuzzers, run through the package."""

from __future__ import annotations

import copy
import json
import pickle
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from sbgc import (
    Contexts,
    DecodeError,
    Direction,
    EncodeError,
    Framing,
    Message,
    Parser,
    decode,
    decode_body,
    encode,
    encode_body,
    msg,
    validate,
)
from sbgc.fields import Axes, Elements, Field, Structure, Xyz

ROOT = Path(__file__).resolve().parents[2]
VECTORS = ROOT / "generated" / "vectors"
DIRECTIONS = {"to_board": Direction.TO_BOARD, "from_board": Direction.FROM_BOARD}


FAMILIES = sorted(path.stem for path in VECTORS.glob("*.jsonl"))


def vectors_of(family: str) -> list[Any]:
    lines = (VECTORS / f"{family}.jsonl").read_text().splitlines()
    return [json.loads(line) for line in lines]


def vectors() -> list[Any]:
    return [vector for family in FAMILIES for vector in vectors_of(family)]


def known_before(vector: Any) -> Contexts:
    """Returns the contexts that the messages before that of the vector provide."""
    contexts = Contexts()
    for earlier in vector.get("after", []):
        body = bytes.fromhex(earlier["hex"])
        contexts.learn(decode_body(earlier["id"], body, DIRECTIONS[earlier["direction"]]))
    return contexts


def raw(value: Any) -> Any:
    """A value of the package as the vectors write it."""
    if isinstance(value, Structure):
        return fields_of(value)
    if isinstance(value, (Axes, Xyz)):
        return {name: raw(getattr(value, name)) for name in value.names}
    if isinstance(value, Elements):
        return [raw(one) for one in value]
    if isinstance(value, bytes):
        return value.hex()
    return value if isinstance(value, (float, str)) else int(value)


def attributes(type_: type[Structure]) -> dict[str, str]:
    """The attributes of a class that are fields, and those with their raw numbers."""
    owners = reversed(type_.__mro__)
    names = [n for t in owners for n, f in vars(t).items() if isinstance(f, Field) and n != "tail"]
    second = {name for name in names if name.endswith("_raw") and name[:-4] in names}
    return {n: f"{n}_raw" if f"{n}_raw" in second else n for n in names if n not in second}


def fields_of(place: Structure) -> dict[str, Any]:
    """The raw values of all attributes, which the generator makes from the same model."""
    found = {}
    for name, beside in attributes(type(place)).items():
        value = getattr(place, beside)
        if value is not None:
            found[name] = raw(value)
    if isinstance(place, Message) and place.tail:
        found["tail"] = place.tail.hex()
    return found


def same(ours: Any, theirs: Any) -> bool:
    """Equality of values. Attributes lack the counters of lists, and do not tell NaNs apart."""
    if isinstance(theirs, dict) and isinstance(ours, dict):
        counters = set(theirs) - set(ours)
        sizes = [len(one) for one in ours.values() if isinstance(one, list)]
        are_counters = all(any(theirs[k] in (n, n - 1) for n in sizes) for k in counters)
        return (
            are_counters
            and set(ours) <= set(theirs)
            and all(same(ours[k], theirs[k]) for k in ours)
        )
    if isinstance(theirs, dict):
        (theirs,) = theirs.values()  # a number with its announced type
    if isinstance(theirs, list):
        return len(ours) == len(theirs) and all(map(same, ours, theirs))
    if isinstance(ours, float) and isinstance(theirs, str):
        return str(ours) == theirs.partition(":")[0]
    if isinstance(ours, str):
        # Bytes that are not UTF-8 are surrogates in Python, and from U+F780 on in JSON.
        codes = [
            bytes([ord(c) - 0xF700]) if 0xF780 <= ord(c) < 0xF800 else c.encode() for c in theirs
        ]
        return ours.encode("utf-8", "surrogateescape") == b"".join(codes)
    return bool(ours == theirs) or str(ours) == theirs


@pytest.mark.parametrize("family", FAMILIES)
def test_vectors_decode_and_encode_as_in_the_reference_codec(family: str) -> None:
    for vector in vectors_of(family):
        if "hex" not in vector:
            continue
        body = bytes.fromhex(vector["hex"])
        direction = DIRECTIONS[vector["direction"]]
        contexts = known_before(vector)
        chosen = vector.get("chosen", vector.get("message"))
        if "message" in vector and chosen is not None:
            # The message that dispatch selects, if it decodes.
            try:
                assert type(decode_body(vector["id"], body, direction, contexts)).__name__ == chosen
            except DecodeError as refused:
                assert chosen in str(refused)

        def decoded() -> Message:
            if "message" not in vector:
                return decode_body(vector["id"], body, direction)
            found: Message = getattr(msg, vector["message"]).from_body(body, contexts)
            return found

        if "error" in vector:
            with pytest.raises(DecodeError) as caught:
                decoded()
            error = caught.value
            found = {"code": error.code, "field": error.field, "offset": error.offset}
            assert found == vector["error"], vector
            continue
        assert same(fields_of(decoded()), vector["fields"]), (vector, fields_of(decoded()))
        assert encode_body(decoded()) == body


def test_every_message_of_the_library_has_a_class_with_its_fields() -> None:
    for name in msg.__dict__:
        type_ = getattr(msg, name)
        if isinstance(type_, type) and issubclass(type_, Message) and type_ is not Message:
            message = type_()
            assert set(fields_of(message)) <= set(json.loads(message.to_json()))


def test_values_survive_being_written_one_by_one() -> None:
    """Every value of every vector, read from one message and written to a new one."""
    tried = 0
    for vector in vectors():
        if "error" in vector or "hex" not in vector:
            continue
        if "types" in vector.get("context", {}):
            continue  # a new message does not know the types that another one announces
        body = bytes.fromhex(vector["hex"])
        message = getattr(msg, vector["message"]).from_body(body, known_before(vector))
        if validate(message) or re.search(r"nan|inf|\\uf7", str(vector["fields"])):
            continue  # an attribute refuses what the specification does not allow, NaN, infinity, and texts that are not UTF-8
        again = type(message)()
        for beside in attributes(type(message)).values():
            setattr(again, beside, getattr(message, beside))
        if message.tail:
            again.tail = message.tail
        assert encode_body(again) == body, vector
        tried += 1
    assert tried > 1000


def test_messages_are_copied_and_pickled() -> None:
    for vector in vectors():
        if "error" in vector or "hex" not in vector:
            continue
        body = bytes.fromhex(vector["hex"])
        message = getattr(msg, vector["message"]).from_body(body, known_before(vector))
        if message != message:
            continue  # a NaN
        assert copy.deepcopy(message) == message
        assert pickle.loads(pickle.dumps(message)) == message


def test_frames_in_every_framing_are_found_and_decoded() -> None:
    parser = Parser()
    for vector in vectors()[::17]:
        if "error" in vector or "hex" not in vector:
            continue
        contexts = known_before(vector)
        direction = DIRECTIONS[vector["direction"]]
        message = decode_body(vector["id"], bytes.fromhex(vector["hex"]), direction, contexts)
        for framing in Framing:
            frame = encode(message, framing)
            assert encode(decode(frame, direction, contexts), framing) == frame
            half = len(frame) // 2
            (found,) = parser.feed(frame[:half]) + parser.feed(frame[half:])
            assert found.framing is framing
            assert encode(found.decode(direction, contexts), framing) == frame


def inputs_of_fuzzers(seeds: Path) -> Iterator[bytes]:
    make = [str(ROOT / "generator/python"), *"-m sbgcgen seeds --root".split(), str(ROOT)]
    subprocess.run([*make, "--output", str(seeds)], check=True)
    for folder in (ROOT / "fuzz" / "regressions", seeds):
        yield from (path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file())
    for corpus in sorted((ROOT / "fuzz" / "corpus").glob("*.txt")):
        yield from map(bytes.fromhex, corpus.read_text().splitlines())


def test_inputs_of_the_fuzzers_decode_or_raise_and_nothing_is_lost(tmp_path: Path) -> None:
    decoded = refused = frames = 0
    for data in inputs_of_fuzzers(tmp_path / "seeds"):
        for frame in Parser().feed(data):
            frames += 1
            try:
                repr(frame.decode())
            except DecodeError:
                pass
        if not 2 <= len(data) <= 257:
            continue
        direction = Direction.FROM_BOARD if data[0] % 2 else Direction.TO_BOARD
        try:
            message = decode_body(data[1], data[2:], direction)
        except DecodeError as error:
            assert error.code and str(error)
            refused += 1
            continue
        assert encode_body(message) == data[2:]
        fields_of(message)
        validate(message)
        assert repr(message).startswith(type(message).__name__)
        decoded += 1
    assert decoded > 100 and refused > 10 and frames > 100


def test_a_message_that_contradicts_itself_is_not_encoded() -> None:
    refused = 0
    for vector in vectors():
        if "error" not in vector or "hex" in vector or "fields" not in vector:
            continue
        message = getattr(msg, vector["message"]).from_json(json.dumps(vector["fields"]))
        with pytest.raises(EncodeError) as caught:
            encode_body(message)
        assert caught.value.code == vector["error"]["code"]
        refused += 1
    assert refused > 50

"""Tests of the words that C++ does not accept as names."""

from __future__ import annotations

from declared import declared, used
from sbgcgen.targets.cpp.lint import TYPES, WORDS, can_be_a_name
from support import project_layout


def test_names_of_cpp() -> None:
    assert can_be_a_name("acc_limiter3")
    assert not any(can_be_a_name(word) for word in WORDS)
    assert not can_be_a_name("a__b")


def test_words_of_cpp20_are_complete() -> None:
    """[lex.key], [lex.digraph] of C++20; a missing word breaks the user's build."""
    for word in ("concept", "requires", "co_await", "char8_t", "char16_t", "char32_t", "consteval"):
        assert word in WORDS
    for word in ("and_eq", "not_eq", "or_eq", "xor_eq", "const_cast"):
        assert word in WORDS
    assert "final" not in WORDS, "it is a keyword only in some contexts"


def test_types_that_messages_use_are_complete() -> None:
    """A message of the same name would hide them."""
    own = {message.name for message in project_layout().messages}
    assert (declared() & used()) - own == TYPES - {"I24"}  # no message has one today

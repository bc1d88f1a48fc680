"""What is deprecated in the protocol warns where a program names it, and nowhere else."""

from __future__ import annotations

from pathlib import Path

import pytest

from compiler import LAST_COMPILER, Compiler

HEADERS = """
#include <sbgc/client/client.hpp>
#include <sbgc/json.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>
#include <sbgc/text.hpp>
#include <sbgc/validate.hpp>
#include <sbgc/visit.hpp>
"""
# All messages through codec, text, JSON, validation and session.
ALL = """
template <class M>
void use(const M& message, sbgc::Session& session) {
  M copy = message;
  std::array<std::uint8_t, sbgc::max_frame_size> frame;
  static_cast<void>(sbgc::encode_frame(copy, frame));
  static_cast<void>(to_string(copy) + sbgc::to_json(copy));
  static_cast<void>(sbgc::is_valid(copy) && copy == message);
  if constexpr (M::direction != sbgc::Direction::from_board) session.send(copy);
}
void use_all(sbgc::Session& session) {
  sbgc::AllMessages::for_each([&]<class M>(sbgc::Type<M>) { use(M{}, session); });
}
"""
NAMED = {
    "sbgc::msg::ReadParams request{}": "use CMD_READ_PARAMS_3",
    "auto pin = sbgc::msg::RcInput::ext_fc_input_pitch_analog": "use adc4",
    "auto command = sbgc::msg::CommandToBoard::sign_message_3": "use sign_message",
}


@pytest.fixture(params=LAST_COMPILER, name="compiler", scope="module")
def with_headers(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Compiler:
    folder = tmp_path_factory.mktemp("headers")
    return Compiler(request.param, HEADERS, folder)


def test_headers_and_code_for_any_message_say_nothing(compiler: Compiler) -> None:
    done = compiler.compile(ALL)
    assert done.returncode == 0 and not done.stderr


@pytest.mark.parametrize("code", NAMED)
def test_a_name_warns(compiler: Compiler, code: str) -> None:
    done = compiler.compile(f"void f() {{ [[maybe_unused]] {code}; }}\n")
    warnings = {line for line in done.stderr.splitlines() if "warning: " in line}
    assert done.returncode == 0
    assert len(warnings) == 1 and NAMED[code] in warnings.pop(), done.stderr

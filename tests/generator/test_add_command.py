"""Adding a command takes only YAML: docs/10-new-commands.md, step by step."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from sbgcgen.cli import main

ROOT = Path(__file__).resolve().parents[2]

PROGRAM = """
#include <sbgc/availability.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/lights.hpp>
#include <sbgc/validate.hpp>
#include <sbgc/visit.hpp>

#include <cstdio>

int main() {
%s
  static_assert(sbgc::msg::SetLights::max_size == 5);
  static_assert(!sbgc::is_supported<sbgc::msg::SetLights>(sbgc::Availability{2690, 30}));
  static_assert(sbgc::is_supported<sbgc::msg::SetLights>(sbgc::Availability{2700, 30}));
  if (!sbgc::is_valid(lights)) return 1;
  std::uint8_t frame[sbgc::max_frame_size];
  const sbgc::WriteResult written = sbgc::encode_frame(lights, frame);
  for (std::size_t i = 0; i < written.size; ++i) std::printf("%%02x", frame[i]);
  bool same = false;
  const auto check = [&](const auto& message) {
    if constexpr (requires { message.period; }) same = message == lights;
  };
  const sbgc::Status status =
      sbgc::visit(140, std::span(frame + 4, written.size - 5), sbgc::Direction::to_board, check);
  lights.period = sbgc::msg::Milliseconds(10);
  return status && same && !sbgc::is_valid(lights) ? 0 : 2;
}
"""


def guide_block(language: str) -> str:
    """Returns the fenced block of the guide in this language."""
    text = (ROOT / "docs/10-new-commands.md").read_text(encoding="utf-8")
    found: list[str] = re.findall(
        rf"^```{re.escape(language)}\n(.*?)^```", text, re.MULTILINE | re.DOTALL
    )
    assert len(found) == 1
    return found[0]


def test_the_steps_of_the_guide(tmp_path: Path) -> None:
    spec = tmp_path / "spec"
    shutil.copytree(ROOT / "spec", spec)
    (spec / "lights.yaml").write_text(guide_block("yaml"), encoding="utf-8")
    main_file = spec / "simplebgc.yaml"
    main_file.write_text(
        main_file.read_text(encoding="utf-8").replace("families:\n", "families:\n  - lights\n"),
        encoding="utf-8",
    )
    assert main(["generate", "--root", str(tmp_path)]) == 0

    compiler = os.environ.get("CXX") or shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        pytest.fail("a C++ compiler is needed")
    source = tmp_path / "lights.cpp"
    source.write_text(PROGRAM % guide_block("c++"), encoding="utf-8")
    program = tmp_path / "lights"
    includes = [f"-I{ROOT / 'runtime/core/include'}", f"-I{tmp_path / 'generated/include'}"]
    subprocess.run(
        [compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror", *includes, source, "-o", program],
        check=True,
    )
    result = subprocess.run([program], capture_output=True, text=True, check=False)
    assert result.returncode == 0
    # Start, id 140, 5 bytes, their sum; roll, pitch, yaw = blink | 31 << 2, 500 ms; the sum.
    assert result.stdout == "3e8c0591" + "00007e" + "f401" + "73"
    assert (tmp_path / "generated/vectors/lights.jsonl").is_file()
    assert list((tmp_path / "generated/fuzz/messages").glob("to_board_set_lights_*"))

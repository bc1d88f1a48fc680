#include "care/readiness.hpp"

#include <functional>
#include <string>

#include <fmt/format.h>

#include "board/connection.hpp"
#include "command/common_options.hpp"
#include "command/remark.hpp"

namespace sbgc::tools {

namespace {

[[noreturn]] void not_ready(const std::string& problem) {
  throw CommandError(problem + ", or add --no-check");
}

}  // namespace

void ReadinessAtTerminal::require() {
  ReadinessOptions options{.conditions = options_.conditions,
                           .of_frame = options_.of_frame,
                           .voltage = options_.voltage,
                           .sides = sides_};
  if (!options_.checks) {
    options.conditions = {.motors_off = options_.conditions.motors_off && options_.motors_off};
  }
  options.ask = [this](const Question& question, const std::function<void(bool)>& answer) {
    ask(question);
    answer(true);
  };
  const Readiness found = value_of(client_.run(tasks::check_readiness(options)));
  if (!found.problem.empty()) not_ready(found.problem);
  if (!found.is_motion_known) {
    remark("The board does not say how the frame moves: see to it that it is still.\n");
  }
  if (found.side) sides_.push_back(*found.side);
}

void ReadinessAtTerminal::ask(const Question& question) const {
  switch (question.kind) {
    case Question::Kind::turn_motors_off:
      if (!options_.motors_off && !options_.can_ask) {
        not_ready(question.reason +
                  ": turn them off with --motors-off, by which the camera drops to its heavy side");
      }
      return arm({.yes = options_.motors_off},
                 "The motors are on. They lose power now, and the camera drops to its heavy side.");
    case Question::Kind::is_still:
      if (!options_.can_ask) not_ready(question.reason + ": leave it alone");
      if (!agrees(fmt::format("Either {}. Is it still? [y/N] ", question.reason))) {
        throw CommandError(
            fmt::format("the {} is not still", options_.of_frame ? "frame" : "camera"));
      }
  }
}

}  // namespace sbgc::tools

/// Questions of tasks that only a person can answer.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <sbgc/client/task.hpp>

namespace sbgc {

/// A question of a task to the user.
struct Question {
  /// The kind of question.
  enum class Kind : std::uint8_t {
    turn_motors_off,  ///< may the motors lose power? The camera drops to its heavy side
    is_still,         ///< is the sensor still, although it reports an even turn?
  };

  Kind kind{};
  std::string reason{};  ///< a clause, such as "the motors are on"
};

/// Takes a question, and a function for the answer, which may be called at once, or later between
/// two steps of the task, as long as it runs.
using AskHandler = std::function<void(const Question&, std::function<void(bool)> answer)>;

namespace tasks {

/// Waits for the answer; without a handler, the answer is no. Errors: `cancelled`.
Task<Result<bool>> ask(AskHandler handler, Question question);

}  // namespace tasks
}  // namespace sbgc

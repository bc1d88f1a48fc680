#include <memory>
#include <optional>

#include <sbgc/client/question.hpp>

namespace sbgc::tasks {

Task<Result<bool>> ask(AskHandler handler, Question question) {
  TaskMachine& task = co_await this_task();
  if (!handler) co_return false;
  const auto answer = std::make_shared<std::optional<bool>>();
  handler(question, [&task, answer](bool is_yes) {
    *answer = is_yes;
    task.wake();
  });
  while (!*answer) {
    const Result<void> waited = co_await wait_for_wake(Instant::never);
    if (!waited) co_return waited.error();
  }
  co_return **answer;
}

}  // namespace sbgc::tasks

/// Reading values that must not be wrong because of an undetected line error.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <sbgc/client/task.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/result.hpp>

namespace sbgc::detail {

/// The maximum number of differing answers before a reading fails.
inline constexpr std::size_t most_answers = 6;

/// Reads a value with `read()`, which returns a Task<Result<T>>. If the framing of the board's
/// answers is only protected by sums, reads until two answers agree: undetected damage is rare, and
/// hardly ever the same twice. `seen` are answers that are known already, and `what` is the
/// operation, for the error.
template <class T, class Read>
Task<Result<T>> read_until_two_agree(Read read, std::string what, std::vector<T> seen = {}) {
  const TaskMachine& task = co_await tasks::this_task();
  std::size_t answers = seen.size();
  while (true) {
    Result<T> answer = co_await read();
    if (!has_only_sums(task.framing())) co_return answer;
    // An answer to another request, or one that cannot be decoded, is damaged, too.
    const bool is_damaged = !answer && (answer.error().code == ErrorCode::mismatch ||
                                        answer.error().code == ErrorCode::bad_response);
    if (!answer && !is_damaged) co_return answer;
    if (answer && std::find(seen.begin(), seen.end(), *answer) != seen.end()) co_return answer;
    if (++answers >= most_answers) {
      if (!answer) co_return answer;
      co_return ClientError{
          ErrorCode::mismatch,
          fmt::format("{}: {} answers, but no two agree; the line damages them", what, answers)};
    }
    if (answer) seen.push_back(*std::move(answer));
  }
}

/// The same for the answer to a request.
template <Message M>
Task<CallResult<M>> call_verified(M request, std::string what, CallOptions options = {}) {
  using Answer = typename CallResult<M>::value_type;
  const auto read = [&]() -> Task<Result<Answer>> {
    co_return co_await tasks::call(request, options);
  };
  co_return co_await read_until_two_agree<Answer>(read, std::move(what));
}

}  // namespace sbgc::detail

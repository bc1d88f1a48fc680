// Calls every asynchronous function with each kind of completion token, as programs write it: with
// options and other temporaries in the co_await expression. The test builds it with the address
// sanitizer. There is no board, so all operations fail.

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <asio/awaitable.hpp>
#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/experimental/deferred.hpp>
#include <asio/io_context.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/use_future.hpp>

#include <sbgc/client/async_client.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/messages/realtime.hpp>

namespace {

using namespace sbgc::literals;
using namespace std::chrono_literals;
using sbgc::AsyncClient;
using sbgc::ErrorCode;
using Angles = sbgc::msg::GetAnglesRequest;
using Live = sbgc::msg::RealtimeData4;
using Interval = sbgc::msg::DataStreamInterval;

int failures = 0;

/// Nothing if the operation has not ended, or has succeeded.
using Error = std::optional<ErrorCode>;

template <class T>
Error error_of(const sbgc::Result<T>& result) {
  return result ? Error() : result.error().code;
}
Error error_of(const sbgc::WriteReport& report) { return error_of(report.outcome); }

/// The handler of all operations: with few types, the program compiles faster.
struct Keep {
  Error* error;

  template <class R>
  void operator()(const R& result) const {
    *error = error_of(result);
  }
};

/// Returns the error with which the operation ends that `start(client, handler)` starts.
template <class Start>
Error run(const Start& start) {
  asio::io_context context;
  AsyncClient client(context.get_executor());
  Error error;
  start(client, Keep{&error});
  context.run();
  return error;
}

template <class Start>
Error run_with_future(const Start& start) {
  asio::io_context context;
  AsyncClient client(context.get_executor());
  auto result = start(client, asio::use_future);
  context.run();
  return error_of(result.get());
}

using Await = asio::awaitable<void> (*)(AsyncClient& client, Keep keep);

Error run_coroutine(Await await) {
  return run([await](AsyncClient& client, Keep keep) {
    asio::co_spawn(client.executor(), await(client, keep), asio::detached);
  });
}

template <class Start>
void check(const char* text, Error expected, Await await, const Start& start) {
  const Error deferred = run([&start](AsyncClient& client, Keep keep) {
    start(client, asio::experimental::deferred)(keep);
  });
  for (const Error& error : {run_coroutine(await), deferred, run(start), run_with_future(start)}) {
    if (error == expected) continue;
    std::printf("%s: %s\n", text, error ? name(*error) : "no error");
    ++failures;
  }
}

#define FAILS_AS(code, ...)                                         \
  check(                                                            \
      #__VA_ARGS__, ErrorCode::code,                                \
      [](AsyncClient& client, Keep keep) -> asio::awaitable<void> { \
        constexpr asio::use_awaitable_t<> token;                    \
        keep(co_await client.__VA_ARGS__);                          \
      },                                                            \
      [](AsyncClient& client, const auto& token) { return client.__VA_ARGS__; })
#define OPERATION(...) FAILS_AS(not_connected, __VA_ARGS__)

const sbgc::TransportFactory nowhere = [](const asio::any_io_executor&) {
  return std::unique_ptr<sbgc::io::Transport>();
};
const sbgc::Backup backup;
const std::vector<std::uint8_t> data{1, 2, 3};
const std::vector<std::string> variables{"LPF_FREQ_ROLL", "LPF_FREQ_PITCH"};
const std::vector<sbgc::VariableValue> values{{"LPF_FREQ_ROLL", 60}};

}  // namespace

int main() {
  FAILS_AS(not_found, async_connect("/dev/no-such-port", token));
  FAILS_AS(not_found, async_connect("/dev/no-such-port", {}, token));
  FAILS_AS(not_found, async_connect("/dev/no-such-port", {.timeout = 9s, .retries = 1}, token));
  FAILS_AS(io, async_connect_over(nowhere, token));
  FAILS_AS(io, async_connect_over(nowhere, {.timeout = 9s}, token));
  OPERATION(async_call(Angles{}, token));
  OPERATION(async_call(Angles{}, {}, token));
  OPERATION(async_call(Angles{}, {.timeout = 9s, .expect_confirmation = true}, token));
  OPERATION(async_transact(Angles{}, token));
  OPERATION(async_transact(Angles{}, {.timeout = 9s}, token));
  OPERATION(async_stream<Live>(
      20ms, [](const Live&) {}, token));
  OPERATION(async_stream<Live>(
      20ms, [](const Live&) {}, {.retries = 1}, token));
  OPERATION(async_stream<Live>(
      Interval{}, [](const Live&) {}, token));
  OPERATION(async_stream<Live>(
      Interval{}, [](const Live&) {}, {}, token));
  OPERATION(async_run(sbgc::tasks::stop({.timeout = 9s}), token));
  OPERATION(async_run(sbgc::tasks::move_to({.pitch = 30_deg}), token));
  OPERATION(async_run(sbgc::tasks::move_to({.pitch = 30_deg}, {.speed = 10_deg_per_s}), token));
  OPERATION(async_run(sbgc::tasks::release(), token));
  OPERATION(
      async_run(sbgc::tasks::run_calibration(sbgc::msg::CalibGyro{}, {.timeout = 9s}), token));
  OPERATION(async_run(sbgc::tasks::read_parameters({.timeout = 9s}), token));
  OPERATION(async_run(sbgc::tasks::write_parameters({}, {.dry_run = true}), token));
  OPERATION(async_run(sbgc::tasks::restore(backup, {.dry_run = true}), token));
  OPERATION(async_run(sbgc::tasks::upload_file(1, data), token));
  OPERATION(
      async_run(sbgc::tasks::rename_profile(1, "A name that does not fit into 15 bytes"), token));
  OPERATION(async_run(sbgc::tasks::get_variables(variables), token));
  OPERATION(async_run(sbgc::tasks::set_variables(values), token));
  return failures == 0 ? 0 : 1;
}

// The client of the module `gimbal`, for a page that passes it what its line receives, and sends
// what it returns; see PassiveClient. Times are microseconds.

#include <optional>
#include <span>

#include "modules/client.hpp"
#include "modules/exchange.hpp"
#include "modules/times.hpp"

namespace sbgc::web {

std::optional<Client>& client() {
  static std::optional<Client> made;
  return made;
}

/// Makes a client, which asks the board for its identity and then watches it. With `searches`, it
/// finds the settings of the line first.
SBGC_EXPORT(client_start) void client_start(double id, double searches) {
  client().emplace().connect(id, searches != 0);
}

/// Takes the input from the line.
SBGC_EXPORT(client_receive) void client_receive(double now) {
  if (client()) client()->passive().receive(tools::exchange().input, at(now));
}

/// Outputs the bytes to send.
SBGC_EXPORT(client_advance) void client_advance(double now) {
  std::string& output = tools::exchange().output;
  output.clear();
  if (!client()) return;
  const auto bytes = client()->passive().advance(at(now));
  output.assign(bytes.begin(), bytes.end());
}

/// Reports that this has been sent.
SBGC_EXPORT(client_written) void client_written(double now) {
  if (client()) client()->passive().written(at(now));
}

/// Returns the latest time to call client_advance().
SBGC_EXPORT(client_deadline) double client_deadline() {
  return in_us(client() ? client()->passive().deadline() : Instant::never);
}

/// Begins the action in the input; see actions.hpp. The output says what is wrong with it.
SBGC_EXPORT(client_act) void client_act(double id, double now) {
  if (client()) tools::exchange().output = client()->act(id, input_text(), at(now));
}

/// Sends the request whose frame is the input. The output says what is wrong with it.
SBGC_EXPORT(client_send) void client_send(double id) {
  if (client()) tools::exchange().output = client()->send(id, tools::exchange().input);
}

/// Measures the gimbal, and judges it.
SBGC_EXPORT(client_diagnose) void client_diagnose(double id) {
  if (client()) client()->diagnose(id);
}

/// The output is a line of JSON for each report since the last time: {"notice": "…"}, {"baud":
/// 115200, "even": false} before the next bytes, {"errors": "names, one a line"}, or {"done": ID,
/// "error": "…"} with what the client was asked for.
SBGC_EXPORT(client_reports) void client_reports() {
  tools::exchange().output = client() ? client()->take_reports() : "";
}

/// Returns the numbers of the last `View`.
SBGC_EXPORT(client_view) const double* client_view() {
  return client() ? &client()->view().seconds : nullptr;
}

}  // namespace sbgc::web

#include "command/option_values.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace sbgc::tools {

namespace {

using std::chrono::milliseconds;

constexpr std::array<std::pair<std::string_view, double>, 5> units{
    {{"ms", 1}, {"s", 1000}, {"", 1000}, {"m", 60'000}, {"h", 3'600'000}}};
constexpr double longest = 1000 * 3.6e6;  // milliseconds

}  // namespace

std::optional<milliseconds> parse_duration(std::string_view text) {
  double number = 0;
  // Without a sign, an exponent, "inf" or "nan".
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  if (error != std::errc() || !(number >= 0) || std::signbit(number)) return std::nullopt;
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  for (const auto& [name, factor] : units) {
    if (unit != name) continue;
    const double whole = std::round(number * factor);
    const bool is_whole = std::abs(whole - number * factor) <= 1e-9 * whole;
    if (!is_whole || whole < 1 || whole > longest) return std::nullopt;
    return milliseconds(static_cast<milliseconds::rep>(whole));
  }
  return std::nullopt;
}

std::string duration_text(milliseconds duration) {
  if (duration < milliseconds(1000)) return fmt::format("{} ms", duration.count());
  return fmt::format("{} s", static_cast<double>(duration.count()) / 1000);
}

CLI::Option* add_duration(CLI::App& command, const std::string& name,
                          std::optional<milliseconds>& into, const std::string& description) {
  const auto take = [&into](const std::string& text) {
    into = parse_duration(text);
    return into.has_value();
  };
  return command
      .add_option(
          name, [take](const CLI::results_t& texts) { return take(texts.front()); }, description)
      ->check([](const std::string& text) {
        return parse_duration(text)
                   ? std::string()
                   : fmt::format("'{}' is not a duration; write 500ms, 1.5s, 2m or 1h", text);
      })
      ->type_name("TIME");
}

}  // namespace sbgc::tools

#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include <sbgc/client/bode.hpp>
#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/parse_real.hpp>

namespace sbgc {
namespace {

constexpr std::string_view csv_mark = "%sbgc_test_data";

ClientError csv_error(std::size_t line, std::string_view what) {
  return {ErrorCode::bad_file, fmt::format("line {}: {}", line, what)};
}

/// Removes the text before the separator, and the separator; returns the text.
std::string_view take_before(std::string_view& text, char separator) {
  const std::size_t at = text.find(separator);
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + 1);
  return part;
}

/// Removes a line and its end, LF or CR LF; returns the line.
std::string_view take_line(std::string_view& text) {
  std::string_view line = take_before(text, '\n');
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

template <class Number>
bool read_number(std::string_view text, Number& number) {
  const auto read = detail::parse_number<Number>(text);
  if (read) number = *read;
  return read.has_value();
}

bool read_number(std::string_view text, double& number) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = detail::parse_real(text.data(), end, number);
  return error == std::errc{} && stop == end;
}

/// Parses a sample with the precision of the board: a number, or "nan" for a lost one. Numbers that
/// are too small for that precision are rounded, possibly to 0.
bool read_sample(std::string_view text, double& sample) {
  if (text == "nan") {
    sample = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  double number = 0;
  constexpr auto highest = static_cast<double>(std::numeric_limits<float>::max());
  if (!read_number(text, number) || !(std::abs(number) <= highest)) return false;
  sample = static_cast<double>(static_cast<float>(number));
  return true;
}

bool read_title(std::string_view line, msg::BodeTestStartStopRequest& request) {
  if (take_before(line, ';') != csv_mark) return false;
  std::array<std::uint16_t, 6> numbers{};
  for (std::uint16_t& number : numbers) {
    if (!read_number(take_before(line, ';'), number)) return false;
  }
  const auto [system, axis, stimulus, gain, from, to] = numbers;
  constexpr std::uint16_t byte = 255;
  if (!line.empty() || system > byte || axis > byte || stimulus > byte) return false;
  request.system = static_cast<msg::BodeSystem>(system);
  request.axis = static_cast<msg::BodeAxis>(axis);
  request.stimulus_type = static_cast<msg::BodeStimulus>(stimulus);
  request.stimulus_gain = gain;
  request.start_freq = msg::Frequency(from);
  request.end_freq = msg::Frequency(to);
  return true;
}

}  // namespace

std::string to_csv(const BodeRecording& recording) {
  const msg::BodeTestStartStopRequest& of = recording.request;
  std::string text;
  const auto to = std::back_inserter(text);
  fmt::format_to(to, "{};{};{};{};{};{};{}\n", csv_mark, static_cast<unsigned>(of.system),
                 static_cast<unsigned>(of.axis), static_cast<unsigned>(of.stimulus_type),
                 of.stimulus_gain, of.start_freq.raw(), of.end_freq.raw());
  const auto add = [&](double value, char end) {
    if (std::isfinite(value)) {
      fmt::format_to(to, "{}{}", static_cast<float>(value), end);
    } else {
      fmt::format_to(to, "nan{}", end);
    }
  };
  for (std::size_t i = 0; i < recording.input.size(); ++i) {
    add(recording.input[i], ';');
    add(recording.output[i], '\n');
  }
  return text;
}

Result<BodeRecording> parse_bode_csv(std::string_view text) {
  if (text.size() > max_bode_csv) return csv_error(1, "the file is too long");
  // Editors and spreadsheets add it.
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  BodeRecording recording;
  if (!read_title(take_line(text), recording.request)) {
    return csv_error(1,
                     "not a frequency response: it begins with "
                     "%sbgc_test_data;SYSTEM;AXIS;STIMULUS_TYPE;STIMULUS_GAIN;START_FREQ;END_FREQ");
  }
  if (recording.request.start_freq.raw() > recording.request.end_freq.raw()) {
    return csv_error(1, "START_FREQ is above END_FREQ");
  }
  for (std::size_t line = 2; !text.empty(); ++line) {
    std::string_view row = take_line(text);
    double input = 0;
    double output = 0;
    const bool is_read = read_sample(take_before(row, ';'), input) && read_sample(row, output);
    if (!is_read) return csv_error(line, "not two numbers, INPUT;OUTPUT");
    // Input and output of a sample are lost together.
    if (std::isnan(input) != std::isnan(output)) return csv_error(line, "half of a lost sample");
    if (std::isnan(input)) ++recording.lost;
    recording.input.push_back(input);
    recording.output.push_back(output);
  }
  if (recording.input.empty()) return csv_error(2, "no samples");
  recording.request.samples_num = static_cast<std::uint32_t>(recording.input.size());
  return recording;
}

}  // namespace sbgc

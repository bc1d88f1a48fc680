#include "serving/faults.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/meta/enums.hpp>

#include "serving/new_board.hpp"

namespace sbgc::serving {

namespace {

using emulator::BoardOptions;

using sbgc::detail::axis_names;

std::vector<std::string> split_at(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.emplace_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

/// The value of a fault, whose trailing parts may be omitted. Without exceptions, for WebAssembly:
/// after a mistake, parts have their default values.
class Value {
 public:
  Value(std::string_view fault, const std::optional<std::string>& text, const char* wanted)
      : fault_(fault), wanted_(wanted) {
    if (text) parts_ = split_at(*text, ':');
  }

  /// Returns the next part as a number from `least` to `most`; its unit may follow.
  double number(double usual, double least, double most, std::string_view unit = {}) {
    const auto part = next();
    if (!part) return usual;
    std::string_view text = *part;
    const bool has_unit = text.size() > unit.size() &&
                          sbgc::detail::is_same_word(text.substr(text.size() - unit.size()), unit);
    if (has_unit) text.remove_suffix(unit.size());
    const auto number = sbgc::detail::parse_number<double>(text);
    if (number && *number >= least && *number <= most) return *number;
    refuse_part(fmt::format("from {} to {}{}{}", least, most, unit.empty() ? "" : " ", unit));
    return usual;
  }
  double share(double usual, double least, double most) {
    const auto part = next();
    if (!part) return usual;
    if (const auto share = read_share(*part, least, most)) return *share;
    refuse_part(fmt::format("from {} to {} ({}% to {}%)", least, most, least * 100, most * 100));
    return usual;
  }
  std::size_t axis(std::size_t usual) {
    const auto part = next();
    if (!part) return usual;
    const auto* const name =
        std::find_if(axis_names.begin(), axis_names.end(),
                     [&](std::string_view one) { return sbgc::detail::is_same_word(*part, one); });
    if (name != axis_names.end()) return static_cast<std::size_t>(name - axis_names.begin());
    refuse_part("roll, pitch or yaw");
    return usual;
  }
  /// Checks that nothing follows. Returns the first mistake, or "".
  std::string end() {
    if (used_ < parts_.size()) refuse();
    return std::move(problem_);
  }
  void refuse(const std::string& detail = {}) {
    if (!problem_.empty()) return;
    problem_ = *wanted_ == '\0' ? fmt::format("the fault '{}' has no value", fault_)
                                : fmt::format("the fault is {}{}{}", fault_, wanted_, detail);
  }
  bool is_given() const { return !parts_.empty(); }

 private:
  std::optional<std::string> next() {
    if (used_ == parts_.size()) return {};
    return parts_[used_++];
  }
  /// Describes the valid range of the part that was read last, under its name in `wanted_`.
  void refuse_part(const std::string& range) {
    constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    const std::string_view form = wanted_;
    std::size_t from = 0;
    std::size_t to = 0;
    for (std::size_t part = 0; part < used_; ++part) {
      from = form.find_first_of(letters, to);
      to = form.find_first_not_of(letters, from);
    }
    refuse(fmt::format(", {} {}", form.substr(from, to - from), range));
  }

  std::string_view fault_;
  const char* wanted_;
  std::vector<std::string> parts_{};
  std::size_t used_ = 0;
  std::string problem_{};
};

struct Fault {
  const char* name{};
  const char* value{};  ///< its form, "" if it has none
  void (*apply)(BoardOptions& board, Value& value){};
};

template <msg::SystemError error>
void report(BoardOptions& board, Value&) {
  board.faults.errors.set(error);
}

constexpr std::array faults{
    Fault{"low-battery", "[=VOLTS]",
          [](BoardOptions& board, Value& value) {
            board.gimbal.battery = value.number(13.8, 0, 100, "V");
            board.gimbal.capacity = 0;  // so that it stays there
          }},
    Fault{"imu", "", report<msg::SystemError::no_sensor>},
    Fault{"missed-steps", "", report<msg::SystemError::miss_steps>},
    Fault{"imbalance", "[=SHARE[:AXIS]]",
          [](BoardOptions& board, Value& value) {
            const double share = value.share(0.3, -1, 1);
            board.gimbal.imbalance[value.axis(1)] = share;
          }},
    Fault{"overload", "[=AXIS]",
          [](BoardOptions& board, Value& value) { board.gimbal.strain[value.axis(2)] = 1; }},
    Fault{"resonance", "=FREQUENCY[:RATE[:AXIS]]",
          [](BoardOptions& board, Value& value) {
            if (!value.is_given()) return value.refuse();
            emulator::Vibration vibration;
            vibration.frequency = value.number(0, 0.1, 1000, "Hz");
            vibration.rate = value.number(vibration.rate, 0, 1000);
            vibration.axis = value.axis(vibration.axis);
            board.gimbal.vibration = vibration;
          }},
    Fault{"drift", "[=RATE]",
          [](BoardOptions& board, Value& value) {
            board.gimbal.gyro_drift.y = value.number(2, -100, 100);
          }},
    Fault{"i2c-errors", "[=RATE]",
          [](BoardOptions& board, Value& value) {
            board.faults.i2c_errors = value.number(20, 0, 10000);
          }},
    Fault{"line", "[=RATE]",
          [](BoardOptions& board, Value& value) {
            board.faults.serial_errors = value.number(20, 0, 10000);
          }},
    Fault{"slow-cycle", "[=US]",
          [](BoardOptions& board, Value& value) {
            board.faults.cycle =
                microseconds(static_cast<std::int64_t>(value.number(2000, 1, 60000, "us")));
          }},
    Fault{"emergency-stop", "",
          [](BoardOptions& board, Value&) {
            board.faults.errors.set(msg::SystemError::emergency_stop);
            board.faults.sub_error = msg::SystemSubError::i2c_errors;
          }},
};

/// Returns the name of an error of the board as the name of a fault: "calib-acc".
std::string fault_name(const ValueInfo& error) {
  std::string name = detail::lower_case(error.name);
  if (name.starts_with("err_")) name.erase(0, 4);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::string add_fault(std::string_view text, BoardOptions& board) {
  const std::size_t equals = text.find('=');
  const std::string name = detail::lower_case(text.substr(0, equals));
  std::optional<std::string> given;
  if (equals != std::string_view::npos) given = text.substr(equals + 1);
  std::vector<std::string> names;
  for (const Fault& fault : faults) {
    names.emplace_back(fault.name);
    if (name != fault.name) continue;
    Value value(fault.name, given, fault.value);
    fault.apply(board, value);
    return value.end();
  }
  for (const ValueInfo& error : EnumMeta<msg::SystemError>::info.values) {
    names.push_back(fault_name(error));
    if (name != names.back()) continue;
    board.faults.errors.set(static_cast<msg::SystemError>(error.value));
    return Value(name, given, "").end();
  }
  return fmt::format(
      "unknown fault '{}'{}", name,
      detail::did_you_mean(detail::nearest(name, names), "there are " + fault_names()));
}

}  // namespace

std::string fault_names() {
  std::string names;
  for (const Fault& fault : faults) {
    names += (names.empty() ? "" : ", ") + std::string(fault.name) + fault.value;
  }
  return names + ", and the names of errors such as calib-acc";
}

std::string add_faults(const std::string& list, BoardOptions& board) {
  for (const std::string& one : split_at(list, ',')) {
    if (std::string problem = add_fault(one, board); !problem.empty()) return problem;
  }
  return "";
}

}  // namespace sbgc::serving

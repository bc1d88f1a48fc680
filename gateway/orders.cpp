#include "gateway/orders.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include <fmt/format.h>

#include <sbgc/client/calibrations.hpp>
#include <sbgc/client/profiles.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/meta/control.hpp>

#include "command/command_error.hpp"
#include "command/wording.hpp"
#include "gateway/payload.hpp"
#include "move/menu_action.hpp"
#include "values/assignments.hpp"
#include "values/axis_values.hpp"
#include "values/complete_message.hpp"
#include "values/effect_text.hpp"
#include "values/message_json.hpp"
#include "values/message_names.hpp"

namespace sbgc::tools {

namespace {

[[noreturn]] void refuse_parameter(const std::string& message) {
  throw Refusal("invalid", clipped(message));
}

/// The parameters of a task; every key must be used.
class TaskParameters {
 public:
  TaskParameters(const Json& object, std::initializer_list<const char*> known) : object_(object) {
    for (const auto& item : object.items()) {
      const std::string& name = item.key();
      const bool is_known =
          std::ranges::any_of(known, [&](const char* one) { return name == one; });
      if (!is_known) refuse_parameter(fmt::format("unknown parameter '{}'", name));
    }
  }

  const Json* find(const char* name) const {
    const auto found = object_.find(name);
    return found == object_.end() ? nullptr : &*found;
  }
  const Json& get(const char* name) const {
    const Json* const found = find(name);
    if (found == nullptr) refuse_parameter(fmt::format("the parameter '{}' is missing", name));
    return *found;
  }
  std::string text(const char* name) const {
    const Json& value = get(name);
    if (!value.is_string()) refuse_parameter(fmt::format("'{}' must be a string", name));
    return value.get<std::string>();
  }
  double number(const char* name, double otherwise, double least, double most) const {
    const Json* const value = find(name);
    if (value == nullptr) return otherwise;
    if (!value->is_number() || !(value->get<double>() >= least && value->get<double>() <= most)) {
      refuse_parameter(fmt::format("'{}' must be a number from {} to {}", name, least, most));
    }
    return value->get<double>();
  }
  /// Parses an object with a number for some of the axes.
  AxisNumbers axes(const char* name) const {
    const Json& value = get(name);
    if (!value.is_object() || value.empty()) {
      refuse_parameter(fmt::format("'{}' must be an object with roll, pitch or yaw", name));
    }
    AxisNumbers result;
    for (const auto& [axis, number] : value.items()) {
      const auto* const known = std::ranges::find(axis_names, axis);
      if (known == axis_names.end()) refuse_parameter(fmt::format("unknown axis '{}'", axis));
      if (!number.is_number() || !std::isfinite(number.get<double>())) {
        refuse_parameter(fmt::format("'{}.{}' must be a number", name, axis));
      }
      result[static_cast<std::size_t>(known - axis_names.begin())] = number.get<double>();
    }
    return result;
  }
  /// Parses an object of names and values, as texts.
  std::vector<Assignment> assignments(const char* name) const {
    std::vector<Assignment> result;
    const Json* const values = find(name);
    if (values == nullptr) return result;
    if (!values->is_object()) refuse_parameter(fmt::format("'{}' must be an object", name));
    for (const auto& [field, value] : values->items()) {
      if (!value.is_string() && !value.is_number()) {
        refuse_parameter(fmt::format("the value of '{}' must be a number or a string", field));
      }
      // 15.0 is 15.
      result.push_back({field, value.is_string()         ? value.get<std::string>()
                               : value.is_number_float() ? fmt::format("{}", value.get<double>())
                                                         : value.dump()});
    }
    return result;
  }
  /// Counted from 1.
  std::optional<std::uint8_t> profile() const {
    const Json* const value = find("profile");
    if (value == nullptr) return {};
    if (!value->is_number_integer() || *value < 1 || *value > profile_count) {
      refuse_parameter(fmt::format("'profile' must be 1 to {}", profile_count));
    }
    return static_cast<std::uint8_t>(value->get<int>() - 1);
  }

 private:
  const Json& object_;
};

Order read_move(const Json& object) {
  constexpr double usual_speed = 10;  // deg/s, as the command
  constexpr double longest_move = 600;
  const TaskParameters parameters(object, {"angles", "speed", "timeout"});
  const AxisNumbers angles = parameters.axes("angles");
  MoveOrder order;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    if (angles[i]) order.target[i] = to_angle(*angles[i], axis_names[i]);
  }
  order.options.speed = to_speed(
      parameters.number("speed", usual_speed, 0, std::numeric_limits<double>::max()), "speed");
  // It would select the speed in the parameters.
  if (order.options.speed.raw() == 0) refuse_parameter("'speed' must be more than 0");
  using Seconds = std::chrono::duration<double>;
  order.options.timeout = std::chrono::round<std::chrono::milliseconds>(
      Seconds(parameters.number("timeout", 30, 0.1, longest_move)));
  return {.what = order, .must_not_wait = true};
}

Order read_speed(const Json& object) {
  const TaskParameters parameters(object, {"speeds"});
  const AxisNumbers speeds = parameters.axes("speeds");
  SpeedOrder order;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    if (speeds[i]) order.speed[i] = to_speed(*speeds[i], axis_names[i]);
  }
  return {.what = order, .must_not_wait = true};
}

/// True for effects that would be unexpected after a while.
bool must_not_wait(Effects effects) {
  return effects.has(Effect::moves) || effects.has(Effect::restarts) ||
         effects.has(Effect::erases) || effects.has(Effect::disconnects) ||
         effects.has(Effect::unknown);
}

/// Throws ValueError.
Order call_of(AnyMessage request) {
  const std::string problems = violations_of(request, newest);
  if (!problems.empty()) throw ValueError(problems);
  const bool is_urgent = request.get_if<msg::MotorsOff>() != nullptr;
  const Effects effects = effects_of(request);
  return {.what = CallOrder{std::move(request)},
          .must_not_wait = must_not_wait(effects),
          .is_urgent = is_urgent};
}

/// Returns the order of a request with values. Throws ValueError.
Order call_of(const MessageType& type, const std::vector<Assignment>& assignments) {
  AnyMessage request = new_message(type);
  assign(request, assignments);
  return call_of(std::move(request));
}

Order read_motors(const Json& object) {
  const TaskParameters parameters(object, {"on"});
  const Json& on = parameters.get("on");
  if (!on.is_boolean()) refuse_parameter("'on' must be true or false");
  const char* const name =
      on.get<bool>() ? Meta<msg::MotorsOn>::info.name : Meta<msg::MotorsOff>::info.name;
  return call_of(*find_message(name), {});
}

Order read_menu(const std::string& action) {
  // Assumption: no action turns the camera for longer.
  constexpr std::chrono::minutes longest_action{1};
  Order order = call_of(*find_message(Meta<msg::ExecuteMenu>::info.name), {{"cmd_id", action}});
  // `allow` also applies to the menu actions of calibrations and motors.
  const auto& request = std::get<CallOrder>(order.what).request;
  const auto words = checked_command(request.get_if<msg::ExecuteMenu>()->cmd_id);
  if (!words.empty()) {
    const bool is_task = words.front() == "calibrate" || words.front() == "motors";
    refuse_parameter(fmt::format("'{}' is no menu action here; use the task '{}'", action,
                                 is_task ? words.front() : "raw"));
  }
  order.goes_on = longest_action;
  return order;
}

Order read_calibrate(const Json& object) {
  const TaskParameters parameters(object, {"calibration", "values"});
  const std::string name = parameters.text("calibration");
  const auto known = std::ranges::find_if(calibrations(),
                                          [&](const Calibration& one) { return name == one.name; });
  if (known == calibrations().end()) {
    refuse_parameter(fmt::format("unknown calibration '{}'", name));
  }
  const std::vector<Assignment> values = parameters.assignments("values");
  if (values.empty() && known->needs_values) refuse_parameter("'values' is missing");
  std::vector<const MessageType*> types;
  for (const CalibrationForm& form : known->forms) types.push_back(find_message(form.info->name));
  std::vector<std::string> names;
  names.reserve(values.size());
  for (const Assignment& one : values) names.push_back(one.name);
  const MessageType& type = form_with(types, names);
  const auto form = std::ranges::find(known->forms, type.info, &CalibrationForm::info);
  std::vector<Assignment> all = values;
  if (form->has_action && std::ranges::find(names, "action") == names.end()) {
    all.push_back({"action", "REGULAR"});
  }
  AnyMessage request = std::get<CallOrder>(call_of(type, all).what).request;
  return {.what = CalibrateOrder{std::move(request)}, .must_not_wait = true};
}

Order read_get(const Json& object) {
  const TaskParameters parameters(object, {"names", "profile"});
  const Json& names = parameters.get("names");
  constexpr std::size_t most_names = 256;
  if (!names.is_array() || names.empty() || names.size() > most_names) {
    refuse_parameter(fmt::format("'names' must be a list of 1 to {} names", most_names));
  }
  GetOrder order;
  for (const Json& name : names) {
    if (!name.is_string()) refuse_parameter("'names' must be strings");
    order.parameters.push_back(find_parameters(name.get_ref<const std::string&>()));
  }
  order.profile = parameters.profile();
  return {.what = std::move(order)};
}

Order read_set(const Json& object) {
  const TaskParameters parameters(object, {"values", "profile"});
  const std::vector<Assignment> values = parameters.assignments("values");
  if (values.empty()) refuse_parameter("'values' is missing");
  // Parameters take effect at once, and the camera can move.
  return {.what = SetOrder{values_of(values, false), parameters.profile()}, .must_not_wait = true};
}

Order read_raw(const Json& object, Effects allowed) {
  const TaskParameters parameters(object, {"message", "fields"});
  const std::string name = parameters.text("message");
  const auto forms = messages_named(name, Direction::to_board);
  if (forms.empty() || !forms.front()->is_sent_to_board()) {
    refuse_parameter(fmt::format("no message to the board is named '{}'", name));
  }
  Json fields = Json::object();
  if (const Json* const given = parameters.find("fields"); given != nullptr) fields = *given;
  if (!fields.is_object()) refuse_parameter("'fields' must be an object");
  std::vector<std::string> names;
  for (const auto& item : fields.items()) names.push_back(item.key());
  const MessageType& type = form_with(forms, names);
  replace_names(type, fields);
  AnyMessage request = message_with_defaults(type, std::move(fields));
  if (request.holds_secret()) throw Refusal("secret", "a broker is no place for passwords");
  static_cast<void>(encoded(request, basic_framing));
  const Effects effects = effects_of(request);
  const Effects granted = allowed | Effect::reads;
  const Effects excess(static_cast<Effects::raw_type>(effects.raw() & ~granted.raw()));
  if (excess != Effects()) {
    throw Refusal("not_allowed", fmt::format("{} {}, which 'raw-effects' does not allow",
                                             type.info->name, effect_words(excess)));
  }
  Order order = call_of(std::move(request));
  const bool moves = effects.has(Effect::moves) || effects.has(Effect::unknown);
  // It may be a speed, which only another request ends.
  if (moves && !order.is_urgent) order.goes_on = Order::forever;
  return order;
}

Order read_without_parameters(const Json& object, Order order) {
  const TaskParameters none(object, {});
  return order;
}

}  // namespace

Order read_order(std::string_view task, const Json& parameters, Effects raw_effects) {
  try {
    if (task == "move") return read_move(parameters);
    if (task == "stop") return read_without_parameters(parameters, {.what = StopOrder()});
    if (task == "speed") return read_speed(parameters);
    if (task == "motors") return read_motors(parameters);
    if (task == "home") return read_without_parameters(parameters, read_menu("HOME_POSITION"));
    if (task == "menu") return read_menu(TaskParameters(parameters, {"action"}).text("action"));
    if (task == "calibrate") return read_calibrate(parameters);
    if (task == "get") return read_get(parameters);
    if (task == "set") return read_set(parameters);
    if (task == "raw") return read_raw(parameters, raw_effects);
  } catch (const Refusal&) {
    throw;
  } catch (const std::runtime_error& error) {  // of values, fields and axes
    refuse_parameter(error.what());
  }
  throw Refusal("unknown_task", fmt::format("there is no task '{}'", clipped(task)));
}

}  // namespace sbgc::tools

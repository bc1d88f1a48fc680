/// Parameters as people read them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/availability.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/reference.hpp>

namespace sbgc::tools {

/// One value for the user.
struct ShownParameter {
  std::string message{};
  std::string path{};
  std::string spec_name{};
  std::string raw{};
  std::string meaning{};
  std::optional<double> value{};  ///< of a number, in its unit
  std::string unit{};
  std::size_t bytes{};  ///< of bytes without a meaning as numbers; 0 for others
  bool is_special{};    ///< the raw value has a meaning of its own
  bool is_general{};
  std::string summary{};
  std::vector<const TopicReference*> topics{};  ///< its own first
  std::string other_default{};  ///< the text of the factory default, if it is known and another

  /// For example "-30 deg", "FOLLOW_MODE_FC" or "12".
  std::string text() const;
  /// The same, with the beginning of many bytes only: "00ff12… (128 bytes)".
  std::string short_text() const;
};

/// Returns the parameters in a block, without reserved ones.
std::vector<ShownParameter> shown_parameters(const Parameters& block, const Availability& versions);

Json to_json(const ShownParameter& parameter);

}  // namespace sbgc::tools

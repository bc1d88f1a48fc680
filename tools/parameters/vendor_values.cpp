#include "parameters/vendor_values.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include <sbgc/client/profiles.hpp>
#include <sbgc/internal/parse_number.hpp>

#include "command/wording.hpp"
#include "parameters/parameter_blocks.hpp"

namespace sbgc::tools {

namespace {

constexpr const char* unknown_name = "no certain counterpart is known";
constexpr const char* unknown_number = "it is not certain how the number counts";
constexpr const char* other_count = "another number of values is expected";
constexpr const char* contradiction = "<board-params> and <profile>, or the profiles, differ";
constexpr const char* later_firmware = "the firmware of the file does not have them yet";

/// The bits of a parameter that a name in a file denotes.
struct SavedPlace {
  const ParameterMessage* message{};
  std::string path{};
  std::uint64_t mask{};  ///< 0: all bits
  SavedIn saved_in{};
  std::optional<UnitInfo> unit{};
  bool is_general{};
  const char* doubt{};
};

/// Returns the letters and digits of a name in lower case, without an index in braces.
std::string plain_name(std::string_view name) {
  std::string result;
  bool is_index = false;
  for (const char c : name) {
    if (c == '{' || c == '}') is_index = c == '{';
    const auto byte = static_cast<unsigned char>(c);
    if (!is_index && std::isalnum(byte) != 0) result += static_cast<char>(std::tolower(byte));
  }
  return result;
}

using SavedPlaces = std::map<std::string, std::vector<SavedPlace>>;

void add_saved_places(SavedPlaces& places, const ParameterMessage& message, const Leaf& leaf,
                      const Availability& versions) {
  const FieldInfo& field = leaf.field;
  const bool is_parameter = field.role == FieldRole::setting || field.role == FieldRole::general;
  if (!is_parameter || field.reserved || field.unconfirmed || field.saved_as == nullptr) return;
  if (leaf.kind != LeafKind::integer) return;
  SavedPlace place{.message = &message,
                   .path = to_string(leaf.path),
                   .saved_in = field.saved_in,
                   .is_general = field.role == FieldRole::general};
  if (leaf.unit != nullptr) place.unit = *leaf.unit;
  const bool is_coarse =
      place.unit && (place.unit->growth != 0 || place.unit->numerator > place.unit->denominator);
  if (is_coarse && field.saved_in == SavedIn::automatic) place.doubt = unknown_number;
  if (!is_available(field.since, versions)) place.doubt = later_firmware;
  bool has_parts = false;
  const auto add_part = [&](const char* name, std::uint64_t mask) {
    if (*name == '\0') return;
    has_parts = true;
    place.mask = mask;
    places[plain_name(name)].push_back(place);
  };
  if (leaf.packed != nullptr) {
    for (const PartInfo& part : leaf.packed->parts) add_part(part.saved_as, part.mask);
  } else if (leaf.names != nullptr && leaf.names->is_flags) {
    for (const ValueInfo& flag : leaf.names->values) {
      add_part(flag.saved_as, static_cast<std::uint64_t>(flag.value));
    }
  }
  if (has_parts) return;
  const std::string_view name = *field.saved_as != '\0' ? field.saved_as : field.spec_name;
  const std::size_t number = name.find("{n}");
  std::string plain = plain_name(name);
  if (number != std::string_view::npos) plain += std::to_string(leaf.path.index + 1);
  places[plain].push_back(std::move(place));
}

/// Returns what the names in files denote for a board with these versions.
SavedPlaces places_of(const Availability& versions) {
  SavedPlaces places;
  for (const ParameterMessage& message : parameter_messages()) {
    if (!is_available(message.type->info->since, versions)) continue;
    auto add = [&](const Leaf& leaf) { add_saved_places(places, message, leaf, versions); };
    message.type->make().for_each_leaf(add, versions);
  }
  return places;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
  if (text == "true" || text == "false") return text == "true" ? 1 : 0;
  return detail::parse_number<std::int64_t>(text);
}

/// Stores the value in the message; returns the reason if it does not fit. Ranges are checked when
/// all values are known, because they depend on each other.
std::string put_value(AnyMessage& message, const SavedPlace& place, std::string_view text) {
  std::int64_t present = 0;
  const bool is_there =
      message.with_leaf(place.path, [&](const Leaf& leaf) { present = leaf.integer; });
  if (!is_there) return "the board does not have it";
  std::int64_t raw = 0;
  if (place.saved_in == SavedIn::unit) {
    const double real = *detail::parse_number<double>(text);
    const double counts = place.unit->raw(real);
    raw = std::abs(counts) < 1e9 ? std::llround(counts) : -1;
    if (place.unit->real(static_cast<double>(raw)) != real) {
      return fmt::format("the board has steps of {} {}", place.unit->real(1.0), place.unit->name);
    }
  } else {
    raw = *whole_number(text);
  }
  if (place.mask != 0) {
    const int shift = std::countr_zero(place.mask);
    const auto most = static_cast<std::int64_t>(place.mask >> static_cast<unsigned>(shift));
    if (raw < 0 || raw > most) return fmt::format("the board takes 0 to {}", most);
    raw = static_cast<std::int64_t>(
        (static_cast<std::uint64_t>(present) & ~place.mask) |
        (static_cast<std::uint64_t>(raw) << static_cast<unsigned>(shift)));
  }
  if (raw == present) return "";
  return message.assign(place.path, fmt::format("raw:{}", raw), false);
}

/// An accepted value.
struct TakenValue {
  const SavedValue* saved{};
  const std::vector<SavedPlace>* places{};
  std::optional<std::size_t> profile{};  ///< of the file; none for all profiles of the board
};

class Taking {
 public:
  Taking(const VendorFile& file, VendorValues& out)
      : file_(file), out_(out), places_(places_of(versions_of(file))) {}

  /// Returns the values; problem() is empty then.
  std::vector<TakenValue> run() {
    for (const SavedValue& value : file_.common) {
      bool is_twice = false;
      bool differs = false;
      for (const SavedSection& profile : file_.profiles) {
        const SavedValue* const own = find(profile, value.name);
        is_twice = is_twice || own != nullptr;
        differs = differs || (own != nullptr && own->values != value.values);
      }
      if (differs) in_doubt_.insert(value.name);
      if (!is_twice || differs || is_general(value.name)) take(value, std::nullopt);
    }
    for (std::size_t i = 0; i < file_.profiles.size(); ++i) {
      for (const SavedValue& value : file_.profiles[i]) {
        if (!is_general(value.name)) {
          if (!in_doubt_.contains(value.name)) take(value, i);
        } else if (find(file_.common, value.name) == nullptr) {
          const auto differs = [&](const SavedSection& other) {
            const SavedValue* const same = find(other, value.name);
            return same == nullptr || same->values != value.values;
          };
          if (std::any_of(file_.profiles.begin(), file_.profiles.end(), differs)) {
            in_doubt_.insert(value.name);
          }
          take(value, std::nullopt);
        }
      }
    }
    return std::move(taken_);
  }
  const std::string& problem() const { return problem_; }

 private:
  static Availability versions_of(const VendorFile& file) {
    const Availability versions = file.board.versions();
    return {versions.firmware, versions.board};
  }

  static const SavedValue* find(const SavedSection& section, const std::string& name) {
    const auto found = std::find_if(section.begin(), section.end(),
                                    [&](const SavedValue& one) { return one.name == name; });
    return found != section.end() ? &*found : nullptr;
  }

  bool is_general(const std::string& name) const {
    const auto found = places_.find(plain_name(name));
    return found != places_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [](const SavedPlace& place) { return place.is_general; });
  }

  void take(const SavedValue& value, std::optional<std::size_t> profile) {
    const auto found = places_.find(plain_name(value.name));
    if (found == places_.end()) return leave_out(value.name, unknown_name);
    const std::vector<SavedPlace>& places = found->second;
    for (const SavedPlace& place : places) {
      if (place.doubt != nullptr) return leave_out(value.name, place.doubt);
      if (place.message != places.front().message) return leave_out(value.name, unknown_name);
      if (place.message->copies == 1 && profile) return leave_out(value.name, unknown_name);
    }
    if (places.size() != value.values.size()) return leave_out(value.name, other_count);
    if (in_doubt_.contains(value.name)) return leave_out(value.name, contradiction);
    for (const std::string& text : value.values) {
      const bool is_number = detail::parse_number<double>(text).has_value();
      if (!is_number && !whole_number(text)) {
        problem_ = fmt::format("{}: '{}' is not a number", printable(value.name), clipped(text));
        return;
      }
      const bool is_whole = whole_number(text).has_value();
      if (places.front().saved_in == SavedIn::unit ? !is_number : !is_whole) {
        return leave_out(value.name, unknown_number);
      }
    }
    taken_.push_back({&value, &places, profile});
  }

  void leave_out(const std::string& name, const char* reason) {
    std::vector<LeftOut>& all = out_.left_out;
    auto at = std::find_if(all.begin(), all.end(),
                           [&](const LeftOut& one) { return one.reason == reason; });
    if (at == all.end()) at = all.insert(at, {reason, {}});
    const auto known = std::find(at->names.begin(), at->names.end(), name);
    if (known == at->names.end()) at->names.push_back(name);
  }

  const VendorFile& file_;
  VendorValues& out_;
  SavedPlaces places_;
  std::set<std::string> in_doubt_{};  ///< names that occur more than once, with different values
  std::vector<TakenValue> taken_{};
  std::string problem_{};
};

ClientError bad_file(std::string message) { return {ErrorCode::bad_file, std::move(message)}; }

}  // namespace

Result<VendorValues> vendor_values(const VendorFile& file, const ParameterSet& present,
                                   std::uint8_t target) {
  const bool is_one = file.profiles.size() == 1;
  if (!is_one && file.profiles.size() != profile_count) {
    return bad_file(
        fmt::format("the file holds {} profiles; it is not certain which of the board's they are",
                    file.profiles.size()));
  }
  VendorValues result;
  Taking taking(file, result);
  const std::vector<TakenValue> taken = taking.run();
  if (!taking.problem().empty()) return bad_file(taking.problem());
  for (const TakenValue& one : taken) {
    const char* const message = one.places->front().message->type->info->name;
    for (const SavedPlace& place : *one.places) result.fields.emplace_back(message, place.path);
    if (present.find({message, 0}) == nullptr) {
      return bad_file(fmt::format("{}: the board does not have {}", one.saved->name, message));
    }
  }
  for (const Parameters& block : present.all()) {
    AnyMessage message = message_in(block);
    bool is_any = false;
    for (const TakenValue& one : taken) {
      const std::vector<SavedPlace>& places = *one.places;
      if (block.id.message != places.front().message->type->info->name) continue;
      if (one.profile && block.id.copy != (is_one ? target : *one.profile)) continue;
      is_any = true;
      for (std::size_t i = 0; i < places.size(); ++i) {
        const std::string& text = one.saved->values[i];
        const std::string problem = put_value(message, places[i], text);
        if (problem.empty()) continue;
        return bad_file(fmt::format("{}: {}: {}", one.saved->name, text, problem));
      }
    }
    if (!is_any) continue;
    if (auto put = put_message(result.parameters, block.id, message); !put) return put.error();
  }
  return result;
}

ParameterSet empty_parameters(const Availability& versions) {
  ParameterSet result;
  for (const ParameterMessage& message : parameter_messages()) {
    const MessageType& type = *message.type;
    if (!is_available(type.info->since, versions)) continue;
    for (std::uint8_t copy = 0; copy < message.copies; ++copy) {
      AnyMessage made = type.make();
      for (const FieldType& field : type.fields()) {
        if (field.info == nullptr || field.info->role != FieldRole::copy) continue;
        static_cast<void>(made.assign(field.name, fmt::format("raw:{}", copy), false));
      }
      static_cast<void>(put_message(result, {type.info->name, copy}, made));
    }
  }
  return result;
}

std::string left_out_text(const VendorValues& values) {
  std::string result;
  for (const auto& [reason, names] : values.left_out) {
    const std::string list = fmt::format("{}", fmt::join(names, ", "));
    result += fmt::format("not taken, because {}: {}\n", reason, printable(list));
  }
  return result;
}

}  // namespace sbgc::tools

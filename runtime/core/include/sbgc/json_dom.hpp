/// Messages as values of nlohmann_json and back: to_dom(message), from_dom(json, message). The JSON
/// is that of <sbgc/json.hpp>, which needs no library and is faster.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <sbgc/internal/characters.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/json/reader.hpp>
#include <sbgc/json/writer.hpp>

namespace sbgc {

/// JSON with its keys in wire order.
using Json = nlohmann::ordered_json;

/// Thrown if JSON does not describe the expected message; what() names the field and the reason.
class JsonError : public std::runtime_error {
 public:
  /// `field` is the path of the invalid value.
  JsonError(std::string field, const std::string& reason)
      : std::runtime_error(field.empty() ? reason : field + ": " + reason),
        field_(std::move(field)) {}

  /// The path of the field, such as "axes.roll.angle"; empty for the whole message.
  const std::string& field() const noexcept { return field_; }

 private:
  std::string field_;
};

namespace detail {

/// A sink of JsonWriter that builds a value.
class JsonDomSink {
 public:
  JsonDomSink() noexcept(false) {}  // NOLINT(modernize-use-equals-default): Json() may throw
  JsonDomSink(const JsonDomSink&) = delete;
  JsonDomSink& operator=(const JsonDomSink&) = delete;
  ~JsonDomSink() = default;

  void begin_object() { open(Json::object()); }
  void end_object() { parents_.pop_back(); }
  void begin_list() { open(Json::array()); }
  void end_list() { parents_.pop_back(); }
  void key(const char* name) { place_ = &(*parents_.back())[name]; }
  void element() { place_ = &parents_.back()->emplace_back(); }

  template <class T>
  void integer(T number) {
    *place_ = number;
  }
  void real(double number) { *place_ = number; }
  template <class T>
  void decimal(T number) {
    *place_ = std::to_string(number);
  }
  void word(std::string_view text) { *place_ = text; }
  void hex(std::span<const std::uint8_t> bytes) { *place_ = to_hex(bytes); }
  void text(std::string_view bytes) { *place_ = to_utf8(bytes); }

  Json take() { return std::move(result_); }

 private:
  void open(Json&& value) {
    *place_ = std::move(value);
    parents_.push_back(place_);
  }

  Json result_{};
  Json* place_ = &result_;        // where the next value goes
  std::vector<Json*> parents_{};  // none grows while a value in it is open
};

/// A source of JsonReader: a value.
class JsonDomSource {
 public:
  explicit JsonDomSource(const Json& json) : at_(&json) {}

  /// The position in an object or list.
  struct Scope {
    Json::const_iterator at;
    Json::const_iterator end;
  };

  bool is_object() const { return at_->is_object(); }
  bool is_list() const { return at_->is_array(); }

  Scope enter() const { return {at_->begin(), at_->end()}; }
  bool next(Scope& scope, JsonString& key) {
    if (scope.at == scope.end) return false;
    key = {scope.at.key(), false};
    return next(scope);
  }
  bool next(Scope& scope) {
    if (scope.at == scope.end) return false;
    at_ = &*scope.at++;
    return true;
  }

  bool integer(JsonInteger& out) {
    if (!at_->is_number_integer()) return false;
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
    const bool is_huge = at_->is_number_unsigned() && at_->get<std::uint64_t>() > most;
    out.value = is_huge ? static_cast<std::int64_t>(most) : at_->get<std::int64_t>();
    digits_ = at_->dump();
    out.text = digits_;
    return true;
  }
  bool real(double& out) const {
    if (!at_->is_number()) return false;
    out = at_->get<double>();
    return true;
  }
  bool string(JsonString& out) const {
    if (!at_->is_string()) return false;
    out = {at_->get_ref<const std::string&>(), false};
    return true;
  }

  static const char* problem() { return nullptr; }

 private:
  const Json* at_;
  std::string digits_{};
};

/// Returns JSON text without terminal controls. Text that is not UTF-8 gets U+FFFD.
inline std::string json_text(const Json& json, int indent = -1) {
  const std::string text = json.dump(indent, ' ', false, Json::error_handler_t::replace);
  std::string result;
  for_each_sequence(text, [&](std::string_view sequence, bool) {
    const char32_t c = code_point(sequence);
    const bool is_layout = c == '\n';  // outside of strings; dump() escapes it inside
    if (is_control(c) && !is_layout) {
      result += escaped(c);
    } else {
      result += sequence;
    }
  });
  return result;
}

}  // namespace detail

/// Returns a JSON object with the fields of a message.
template <class M>
Json to_dom(const M& message, Secrets secrets = Secrets::hidden) {
  detail::JsonDomSink sink;
  detail::JsonWriter<detail::JsonDomSink>(sink, secrets).message(message);
  return sink.take();
}

#if defined(__cpp_exceptions)

/// Reads `message` from `json`, as from_json() does from text. Throws JsonError if `json` does not
/// describe an M.
template <class M>
void from_dom(const Json& json, M& message) {
  detail::JsonDomSource source(json);
  detail::JsonReader<detail::JsonDomSource> reader(source);
  M result{};
  if (!reader.message(result)) throw JsonError(reader.field(), reader.reason());
  message = result;
}

#endif

}  // namespace sbgc

/// Writes JSON, with the commas between its parts.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include <sbgc/text_output.hpp>

#include "frames/json_string.hpp"

namespace sbgc::web {

/// Appends to a string, which is whole when the writer is destroyed.
class JsonWriter {
 public:
  explicit JsonWriter(std::string& text) : out_(text) {}
  JsonWriter(const JsonWriter&) = delete;
  JsonWriter& operator=(const JsonWriter&) = delete;
  ~JsonWriter() { out_.finish(); }

  void put(std::string_view text) { tools::put_json_string(value(), text); }
  void put(const char* text) { put(std::string_view(text)); }
  void put(bool is_true) { value().put(is_true ? "true" : "false"); }
  void put(double number) { detail::put_real(value(), number); }
  template <std::integral Number>
  void put(Number number) {
    value().put(number);
  }

  /// Writes a list or an object with the content that `content()` writes.
  template <class Content>
  void list(Content&& content) {
    open('[');
    content();
    close(']');
  }
  template <class Content>
  void object(Content&& content) {
    open('{');
    content();
    close('}');
  }
  /// Writes a list of values.
  template <class... Values>
  void values(const Values&... all) {
    list([&] { (put(all), ...); });
  }

  /// Begins a member of an object; its value follows.
  JsonWriter& key(const char* name) {
    put(name);
    out_.put(':');
    follows_ = false;
    return *this;
  }
  template <class Value>
  void member(const char* name, const Value& value) {
    key(name).put(value);
  }

  /// Returns the output for a value that is already JSON.
  TextOutput& value() {
    if (follows_) out_.put(',');
    follows_ = true;
    return out_;
  }
  /// Ends a line, and begins another value.
  void end_line() {
    out_.put('\n');
    follows_ = false;
  }

 private:
  void open(char bracket) {
    value().put(bracket);
    follows_ = false;
  }
  void close(char bracket) {
    out_.put(bracket);
    follows_ = true;
  }

  StringOutput out_;
  bool follows_ = false;  // something that needs a comma
};

}  // namespace sbgc::web

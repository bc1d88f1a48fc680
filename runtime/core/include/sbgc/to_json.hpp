/// Messages as JSON text: to_json(message), write_json(message, output).
///
/// The JSON is nested like the C++ struct. Integers are raw values, bytes are lowercase hex, texts
/// are strings, missing optional members are omitted. The conversion is lossless: the message that
/// from_json() reads from it encodes to the same bytes; but unless they are shown, secrets, such as
/// passwords, become "(hidden)", which from_json() rejects. Include the tables of the messages:
/// <sbgc/meta/control.hpp>, for example, or <sbgc/meta/all.hpp>.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <sbgc/internal/table.hpp>
#include <sbgc/json/text_sink.hpp>
#include <sbgc/json/writer.hpp>
#include <sbgc/text_output.hpp>

namespace sbgc {

namespace detail {

inline void put_json(TextOutput& out, const StructTable& table, const void* message,
                     Secrets secrets) {
  JsonTextSink sink(out);
  JsonWriter<JsonTextSink>(sink, secrets).members(table, message);
}

inline std::string json_string(const StructTable& table, const void* message, Secrets secrets) {
  std::string result;
  StringOutput out(result);
  put_json(out, table, message, secrets);
  out.finish();
  return result;
}

inline std::size_t json_in(std::span<char> buffer, const StructTable& table, const void* message) {
  std::size_t size = 0;
  const auto take = [&](std::string_view piece) {
    const std::size_t free = size < buffer.size() ? buffer.size() - size : 0;
    piece.substr(0, free).copy(buffer.data() + (buffer.size() - free), piece.size());
    size += piece.size();
  };
  PiecewiseOutput out(take);
  put_json(out, table, message, Secrets::hidden);
  out.finish();
  return size;
}

}  // namespace detail

/// Writes the JSON of a message.
template <class M>
void write_json(const M& message, TextOutput& out, Secrets secrets = Secrets::hidden) {
  detail::put_json(out, detail::table_of<M>(), &message, secrets);
}

/// Calls `take` with the JSON of a message in pieces: write_json(message, [](std::string_view) {}).
template <class M, std::invocable<std::string_view> Take>
void write_json(const M& message, Take&& take, Secrets secrets = Secrets::hidden) {
  PiecewiseOutput out(take);
  write_json(message, static_cast<TextOutput&>(out), secrets);
  out.finish();
}

/// Returns the JSON of a message.
template <class M>
std::string to_json(const M& message, Secrets secrets = Secrets::hidden) {
  return detail::json_string(detail::table_of<M>(), &message, secrets);
}

/// Writes as much of the JSON of a message as fits into `buffer`, without a final NUL and without
/// heap. Returns the total size.
template <class M>
std::size_t to_json(const M& message, std::span<char> buffer) {
  return detail::json_in(buffer, detail::table_of<M>(), &message);
}

}  // namespace sbgc

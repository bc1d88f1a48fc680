#include <algorithm>
#include <initializer_list>
#include <set>

#include <fmt/format.h>

#include <sbgc/client/backup_tasks.hpp>
#include <sbgc/internal/crc32.hpp>
#include <sbgc/internal/own_json.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/meta/system.hpp>
#include <sbgc/parse_json.hpp>

#include "parameters_kind.hpp"
#include "tasks/tools.hpp"

namespace sbgc {
namespace {

Json fields_json(const Parameters& block) {
  const auto& kind = *detail::find_parameters_kind(block.id.message);
  return Json::parse(kind.message(block.body).to_json());
}

constexpr const char* format_name = "sbgc-backup";
constexpr int format_version = 1;

using ByteVector = std::vector<std::uint8_t>;

template <class M>
ByteVector bytes_of(const M& message) {
  ByteVector bytes(max_body_size);
  bytes.resize(encode(message, bytes).size);
  return bytes;
}

std::string checksum_text(const ByteVector& bytes) {
  return fmt::format("{:08x}", detail::crc32(bytes));
}

void collect_names(const Json& json, const std::string& place, std::set<std::string>& out) {
  for (const auto& item : json.items()) {
    const std::string path = place + '.' + item.key();
    if (json.is_object()) out.insert(path);
    if (item.value().is_structured()) collect_names(item.value(), path, out);
  }
}

/// Returns the checksum of the names of fields, which differ from version to version.
std::string names_checksum(const Json& fields) {
  std::set<std::string> names;
  collect_names(fields, "", names);
  ByteVector bytes;
  for (const std::string& name : names) bytes.insert(bytes.end(), name.begin(), name.end());
  return checksum_text(bytes);
}

template <class M>
Json message_json(const M& message) {
  const Json fields = to_dom(message);
  return {{"message", Meta<M>::info.name},
          {"body", detail::to_hex(bytes_of(message))},
          {"names", names_checksum(fields)},
          {"fields", fields}};
}

/// Returns the readable texts beside the messages with the identity.
Json identity_json(const BoardIdentity& board) {
  Json result = {{"model", board.board_version()}, {"firmware", board.firmware_version()}};
  if (board.details) result["serial_number"] = board.serial_number();
  return result;
}

/// Groups consecutive copies of a message.
Json contents_json(const std::vector<ParametersId>& contents) {
  Json result = Json::array();
  for (const auto& [message, copy] : contents) {
    if (result.empty() || result.back()["message"] != message) {
      result.push_back({{"message", message}, {"copies", Json::array()}});
    }
    result.back()["copies"].push_back(copy);
  }
  return result;
}

/// Returns the checksum of the data that a restore depends on: the identity of the board, and the
/// list of the contents.
std::string checksum(const BoardIdentity& board, const Json& contents) {
  ByteVector bytes = bytes_of(board.info);
  const std::string text =
      (board.details ? detail::to_hex(bytes_of(*board.details)) : "") + contents.dump();
  bytes.insert(bytes.end(), text.begin(), text.end());
  return checksum_text(bytes);
}

/// Reads a document and remembers its first error.
class Reader {
 public:
  Result<Backup> read(const Json& document) {
    if (auto right = check_version(document); !right) return right.error();
    require_known(document, "",
                  {"format", "version", "created", "board", "contents", "checksum", "settings"});
    Backup backup;
    backup.created = text(document, "created", "");
    read_board(member(document, "board", ""), backup.board);
    const Json& settings = member(document, "settings", "");
    if (!settings.is_array()) fail("settings", "expected a list");
    for (std::size_t i = 0; error_.empty() && i < settings.size(); ++i) {
      read_one(settings[i], fmt::format("settings[{}]", i), backup.parameters);
    }
    read_contents(document, backup);
    if (!error_.empty()) return ClientError{ErrorCode::bad_file, error_};
    return backup;
  }

 private:
  static Result<void> check_version(const Json& document) {
    const auto version = document.find("version");
    if (version == document.end() || !version->is_number_unsigned()) {
      return ClientError{ErrorCode::bad_file, "version: expected a number"};
    }
    const auto number = version->get<std::uint64_t>();
    if (number == format_version) return {};
    return ClientError{ErrorCode::incompatible,
                       fmt::format("version {} of the backup format is not supported, only {}",
                                   number, format_version)};
  }

  void read_board(const Json& board, BoardIdentity& out) {
    read_message(member(board, "info", "board"), "board.info", out.info);
    if (board.is_object() && board.contains("details")) {
      read_message(board["details"], "board.details", out.details.emplace());
    }
    if (!error_.empty()) return;
    require_known(board, "board", {"model", "firmware", "serial_number", "info", "details"});
    const Json identity = identity_json(out);
    for (const auto& item : identity.items()) {
      const auto said = board.find(item.key());
      if (said == board.end() || *said == item.value()) continue;
      fail("board." + item.key(),
           fmt::format("differs from the body, which says {}", item.value().dump()));
    }
  }

  /// Compares the list of the contents with the settings. Older files have no such list.
  void read_contents(const Json& document, Backup& out) {
    if (!error_.empty() || !(document.contains("contents") || document.contains("checksum"))) {
      return;
    }
    const Json& contents = member(document, "contents", "");
    if (!contents.is_array()) fail("contents", "expected a list");
    std::vector<ParametersId> listed;
    for (std::size_t i = 0; error_.empty() && i < contents.size(); ++i) {
      read_copies(contents[i], fmt::format("contents[{}]", i), listed);
    }
    const std::string sum = text(document, "checksum", "");
    if (!error_.empty()) return;
    if (sum != checksum(out.board, contents)) {
      return fail("checksum", "the identity of the board, or 'contents', was edited");
    }
    for (const Parameters& block : out.parameters.all()) {
      if (std::erase(listed, block.id) == 0) {
        return fail("contents", fmt::format("{} is not listed", to_text(block.id)));
      }
    }
    out.missing = std::move(listed);
  }

  void read_copies(const Json& json, const std::string& path, std::vector<ParametersId>& out) {
    const std::string message = text(json, "message", path);
    const Json& copies = member(json, "copies", path);
    if (!copies.is_array()) fail(path + ".copies", "expected a list");
    for (std::size_t i = 0; error_.empty() && i < copies.size(); ++i) {
      const std::string place = fmt::format("{}.copies[{}]", path, i);
      out.push_back({message, copy_number(copies[i], place)});
    }
  }

  std::uint8_t copy_number(const Json& json, const std::string& path) {
    if (json.is_number_unsigned() && json.get<std::uint64_t>() <= 255) {
      return json.get<std::uint8_t>();
    }
    fail(path, "expected a number from 0 to 255");
    return 0;
  }

  template <class M>
  void read_message(const Json& json, const std::string& path, M& out) {
    const std::string name = text(json, "message", path);
    const ByteVector body = hex(json, path);
    if (!error_.empty()) return;
    if (name != Meta<M>::info.name) {
      return fail(path + ".message", fmt::format("expected {}", Meta<M>::info.name));
    }
    if (const Status status = decode(std::span(body), out); !status) {
      return fail(path + ".body", sbgc::text(status.code));
    }
    check_fields(json, path, to_dom(out));
  }

  void read_one(const Json& json, const std::string& path, ParameterSet& out) {
    Parameters block{{text(json, "message", path), {}}, hex(json, path)};
    block.id.copy = copy_number(member(json, "copy", path), path + ".copy");
    if (!error_.empty()) return;
    if (out.find(block.id) != nullptr) {
      return fail(path, fmt::format("duplicate {}", to_text(block.id)));
    }
    const ParametersId id = block.id;
    if (auto put = out.put(std::move(block)); !put) return fail(path, put.error().message);
    check_fields(json, path, fields_json(*out.find(id)));
  }

  /// Only the bodies are restored, so a changed field is an error. Fields with names that are
  /// unknown in this version of the library are ignored, unless they were changed.
  void check_fields(const Json& json, const std::string& path, const Json& decoded) {
    require_known(json, path, {"message", "copy", "body", "names", "fields"});
    const auto fields = json.find("fields");
    if (fields == json.end()) return;
    compare(*fields, decoded, path + ".fields");
    // Files of earlier versions have none.
    const bool has_names = error_.empty() && json.contains("names");
    if (has_names && text(json, "names", path) != names_checksum(*fields)) {
      fail(path + ".fields", "a name was edited");
    }
  }

  void compare(const Json& said, const Json& decoded, const std::string& path) {
    if (!error_.empty()) return;
    if (decoded.is_object() && said.is_object()) {
      for (const auto& item : decoded.items()) {
        const auto found = said.find(item.key());
        if (found == said.end() || has_other_size(item.key(), *found, item.value())) continue;
        compare(*found, item.value(), path + "." + item.key());
      }
    } else if (decoded.is_array() && said.is_array() && said.size() == decoded.size()) {
      for (std::size_t i = 0; i < said.size(); ++i) {
        compare(said[i], decoded[i], fmt::format("{}[{}]", path, i));
      }
    } else if (said != decoded) {
      fail(path, "differs from the body; only the body would be restored");
    }
  }

  /// True for reserved bytes some of which had no names when the file was made.
  static bool has_other_size(const std::string& key, const Json& said, const Json& decoded) {
    return key.starts_with("reserved") && said.is_string() && decoded.is_string() &&
           said.get_ref<const std::string&>().size() !=
               decoded.get_ref<const std::string&>().size();
  }

  /// A damaged name must not hide the value that it names.
  void require_known(const Json& object, const std::string& path,
                     std::initializer_list<std::string_view> names) {
    for (const auto& item : object.items()) {
      if (std::find(names.begin(), names.end(), item.key()) == names.end()) {
        fail(join(path, item.key().c_str()), "nothing has this name");
      }
    }
  }

  const Json& member(const Json& object, const char* name, const std::string& path) {
    static const Json nothing;
    const auto found = object.is_object() ? object.find(name) : object.end();
    if (object.is_object() && found != object.end()) return *found;
    fail(join(path, name), "it is missing");
    return nothing;
  }

  std::string text(const Json& object, const char* name, const std::string& path) {
    const Json& value = member(object, name, path);
    if (value.is_string()) return value.get<std::string>();
    fail(join(path, name), "expected a string");
    return "";
  }

  ByteVector hex(const Json& object, const std::string& path) {
    auto bytes = detail::from_hex(text(object, "body", path));
    if (!bytes || bytes->size() > max_body_size) {
      fail(join(path, "body"), "expected hex digits for at most 255 bytes");
      return {};
    }
    return *std::move(bytes);
  }

  static std::string join(const std::string& path, const char* name) {
    return path.empty() ? name : path + "." + name;
  }

  void fail(const std::string& path, const std::string& reason) {
    if (error_.empty()) error_ = fmt::format("{}: {}", path, reason);
  }

  std::string error_{};
};

}  // namespace

std::string to_json_text(const Backup& backup) {
  Json board = identity_json(backup.board);
  board["info"] = message_json(backup.board.info);
  if (backup.board.details) board["details"] = message_json(*backup.board.details);
  std::vector<ParametersId> listed;
  Json settings = Json::array();
  for (const Parameters& block : backup.parameters.all()) {
    listed.push_back(block.id);
    const Json fields = fields_json(block);
    settings.push_back({{"message", block.id.message},
                        {"copy", block.id.copy},
                        {"body", detail::to_hex(block.body)},
                        {"names", names_checksum(fields)},
                        {"fields", fields}});
  }
  listed.insert(listed.end(), backup.missing.begin(), backup.missing.end());
  const Json contents = contents_json(listed);
  const Json document = {
      {"format", format_name},          {"version", format_version},
      {"created", backup.created},      {"board", std::move(board)},
      {"contents", contents},           {"checksum", checksum(backup.board, contents)},
      {"settings", std::move(settings)}};
  return detail::json_text(document, 1) + "\n";
}

Result<Backup> parse_backup(std::string_view text) {
  const Result<Json> document = detail::parse_own_json(text, format_name, "an sbgc backup");
  if (!document) return document.error();
  return Reader().read(*document);
}

}  // namespace sbgc

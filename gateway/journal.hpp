/// The persistent memory of a gateway that survives a kill, in an SQLite file.
///
/// A command is on disk before its first byte is sent. Results and events are on disk until the
/// broker has acknowledged them. A commit is synced (WAL, synchronous=FULL), so it also survives a
/// power failure.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;

namespace sbgc::tools {

/// The destination of the result of a command.
struct ReplyAddress {
  std::string topic{};
  std::string correlation{};  ///< any bytes

  bool operator==(const ReplyAddress&) const = default;
};

/// A command that a gimbal may carry out.
struct JournalCommand {
  std::string gimbal{};
  std::string key{};      ///< the idempotency key; "" if it may be repeated
  std::string request{};  ///< the task and its parameters
  ReplyAddress reply{};
};

/// A command that a gateway has begun and not finished.
struct UnfinishedCommand {
  std::int64_t id{};
  std::string gimbal{};
  std::string key{};
  std::string request{};
};

enum class WaitingKind : std::uint8_t {
  result,  ///< of a command that was carried out; never lost
  notice,  ///< an event or a refusal, which may be dropped if too many wait
};

/// A message that the broker has not acknowledged.
struct WaitingMessage {
  std::int64_t id{};
  WaitingKind kind{};
  std::string topic{};
  std::string payload{};
  std::string correlation{};
};

enum class Recognition : std::uint8_t {
  unknown,   ///< no command has this key
  running,   ///< the same command has begun; its result is sent to this address, too
  finished,  ///< the same command has ended with `result`
  reused,    ///< the key belongs to another command
  full,      ///< the same command has begun, but too many messages wait for another address
};

struct RecognizedCommand {
  Recognition recognition{};
  std::string result{};
  std::int64_t id{};  ///< of a finished command
};

struct JournalLimits {
  std::size_t most_waiting = 10'000;  ///< messages for the broker
  std::size_t history = 10'000;       ///< finished commands whose results are kept
  /// A finished command is remembered for at least this long, so that a duplicate is recognized
  /// until it expires, even if the clock was set back by as much.
  std::chrono::milliseconds keep{60'000};
};

/// Not thread-safe. Every function throws std::runtime_error if the file cannot be read or written.
class Journal {
 public:
  using Time = std::chrono::system_clock::time_point;

  /// Opens or creates the file. Fails if another process has it open, or if it is not a journal.
  Journal(const std::filesystem::path& file, const JournalLimits& limits);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  /// The changes between the two are atomic, and on disk when commit() returns.
  void begin();
  void commit();

  // Within a transaction.

  /// Finds an earlier command with the same key for the same gimbal.
  RecognizedCommand recognize(const JournalCommand& command);
  /// Records an unknown command. Returns its id; nothing if too many messages wait.
  std::optional<std::int64_t> admit(const JournalCommand& command, Time now);
  /// Returns the addresses for the result of a running command, and keeps it for duplicates.
  std::vector<ReplyAddress> finish(std::int64_t id, std::string_view result);
  /// Adds a message for the broker. Without room, the oldest notice is dropped. There is always
  /// room for results: admit() refuses commands before there are too many.
  void put(const WaitingMessage& message);
  void remove(std::int64_t message);
  /// Records that a command may set its gimbal in motion.
  void set_moving(std::string_view gimbal, std::int64_t command);
  /// Records that no command up to this one has left the gimbal in motion.
  void set_at_rest(std::string_view gimbal, std::int64_t command);

  // At any time.

  /// Throws if the first bytes of the file show that it is not a journal of this version.
  static void check_header(const std::filesystem::path& file);
  /// Throws if the file was removed or replaced. So does commit().
  void check_place() const;
  /// Throws because of a damaged row.
  [[noreturn]] void reject_row(const char* table, std::int64_t id) const;

  /// Returns the gimbals that commands may have set in motion, and the last of these commands.
  std::map<std::string, std::int64_t> moving() const;

  /// Commands that were running when the last gateway ended.
  std::vector<UnfinishedCommand> unfinished() const;
  /// Up to `most` waiting messages after the one with id `after`, the oldest first.
  std::vector<WaitingMessage> waiting_after(std::int64_t after, std::size_t most) const;

  std::size_t waiting() const noexcept { return waiting_; }
  /// The number of dropped notices since the file was opened.
  std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  class Statement;

  void run(const char* sql);
  /// Notices do not count: they are dropped in favor of results.
  bool is_full() const noexcept { return results_ + expected_ >= limits_.most_waiting; }
  void add_reply(std::int64_t id, const ReplyAddress& reply);
  void forget(Time now);
  std::int64_t count(const char* sql) const;

  JournalLimits limits_;
  std::shared_ptr<sqlite3> database_;
  std::size_t waiting_ = 0;
  std::size_t results_ = 0;   // of these
  std::size_t expected_ = 0;  // results of running commands
  std::size_t finished_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace sbgc::tools

#include "gateway/journal.hpp"

#include <array>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <sqlite3.h>

#include "gateway/payload.hpp"

namespace sbgc::tools {

namespace {

/// In the header of the file: its type, and the version of its tables.
constexpr std::int64_t journal_mark = 0x53424731;  // "SBG1"
constexpr std::int64_t journal_version = 1;

constexpr const char* journal_tables = R"(
  CREATE TABLE commands (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    gimbal TEXT NOT NULL,
    key TEXT,                  -- null if the command may be repeated
    request TEXT NOT NULL,
    received INTEGER NOT NULL, -- milliseconds of Unix time
    result TEXT,               -- null while it runs
    UNIQUE (gimbal, key)
  );
  CREATE INDEX running ON commands (id) WHERE result IS NULL;
  CREATE TABLE replies (
    command INTEGER NOT NULL REFERENCES commands (id),
    topic TEXT NOT NULL,
    correlation BLOB NOT NULL,
    PRIMARY KEY (command, topic, correlation)
  ) WITHOUT ROWID;
  CREATE TABLE waiting (
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    kind INTEGER NOT NULL,
    topic TEXT NOT NULL,
    payload TEXT NOT NULL,
    correlation BLOB NOT NULL
  );
  CREATE INDEX notices ON waiting (id) WHERE kind = 1;
  CREATE TABLE moving (
    gimbal TEXT PRIMARY KEY,
    command INTEGER NOT NULL   -- the last one that may have set it in motion
  ) WITHOUT ROWID;
)";
static_assert(static_cast<int>(WaitingKind::result) == 0);
static_assert(static_cast<int>(WaitingKind::notice) == 1);

[[noreturn]] void fail_journal(sqlite3& database) {
  throw std::runtime_error(fmt::format("the journal {}: {}", sqlite3_db_filename(&database, "main"),
                                       sqlite3_errmsg(&database)));
}

std::shared_ptr<sqlite3> open_database(const std::filesystem::path& file) {
  sqlite3* opened = nullptr;
  const int status =
      sqlite3_open_v2(file.c_str(), &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  std::shared_ptr<sqlite3> database(opened, sqlite3_close);
  if (status == SQLITE_OK) return database;
  throw std::runtime_error(
      fmt::format("the journal {} cannot be opened: {}", file.string(), sqlite3_errstr(status)));
}

}  // namespace

/// One SQL statement with its values.
class Journal::Statement {
 public:
  /// Statements that read texts name the table, whose first column is the id.
  Statement(const Journal& journal, const char* sql, const char* table = "")
      : journal_(journal), database_(*journal.database_), table_(table) {
    sqlite3_stmt* prepared = nullptr;
    if (sqlite3_prepare_v2(&database_, sql, -1, &prepared, nullptr) != SQLITE_OK) {
      fail_journal(database_);
    }
    statement_.reset(prepared);
  }

  Statement& add(std::int64_t value) {
    return checked(sqlite3_bind_int64(statement_.get(), ++bound_, value));
  }
  Statement& add_text(std::string_view value) {
    return checked(sqlite3_bind_text64(statement_.get(), ++bound_, value.data(), value.size(),
                                       SQLITE_TRANSIENT, SQLITE_UTF8));
  }
  Statement& add_bytes(std::string_view value) {
    // A null pointer would be stored as NULL.
    return checked(sqlite3_bind_blob64(statement_.get(), ++bound_,
                                       value.empty() ? "" : value.data(), value.size(),
                                       SQLITE_TRANSIENT));
  }
  Statement& add_null() { return checked(sqlite3_bind_null(statement_.get(), ++bound_)); }

  /// Returns true if there is another row.
  bool next() {
    const int status = sqlite3_step(statement_.get());
    if (status == SQLITE_ROW) return true;
    if (status != SQLITE_DONE) fail_journal(database_);
    return false;
  }
  void run() {
    while (next()) continue;
  }

  std::int64_t integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  bool is_null(int column) const {
    return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
  }
  std::string text(int column) const {
    std::string result = bytes(column);
    if (!is_utf8(result)) journal_.reject_row(table_, integer(0));
    return result;
  }
  std::string bytes(int column) const {
    const void* const bytes = sqlite3_column_blob(statement_.get(), column);
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return bytes == nullptr
               ? ""
               : std::string(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
  }

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };

  Statement& checked(int status) {
    if (status != SQLITE_OK) fail_journal(database_);
    return *this;
  }

  const Journal& journal_;
  sqlite3& database_;
  const char* table_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_{};
  int bound_ = 0;
};

Journal::Journal(const std::filesystem::path& file, const JournalLimits& limits)
    : limits_(limits), database_(open_database(file)) {
  try {
    // The lock is held during the whole connection, so that no two gateways send the same command.
    run("PRAGMA locking_mode = EXCLUSIVE");
    run("PRAGMA journal_mode = WAL");
    run("PRAGMA synchronous = FULL");
    run("PRAGMA foreign_keys = ON");
    run("PRAGMA cache_size = -512");  // in KiB: a commit touches few pages
    run("BEGIN EXCLUSIVE");
    const std::int64_t mark = count("PRAGMA application_id");
    const bool is_new = mark == 0 && count("SELECT count(*) FROM sqlite_schema") == 0;
    if (is_new) {
      run(journal_tables);
      run(fmt::format("PRAGMA application_id = {}", journal_mark).c_str());
      run(fmt::format("PRAGMA user_version = {}", journal_version).c_str());
    } else if (mark != journal_mark) {
      throw std::runtime_error(fmt::format("{} is no journal of a gateway", file.string()));
    } else if (count("PRAGMA user_version") != journal_version) {
      throw std::runtime_error(
          fmt::format("the journal {} is of another version of sbgc", file.string()));
    }
    run("COMMIT");
  } catch (const std::runtime_error&) {
    if (sqlite3_errcode(database_.get()) != SQLITE_BUSY) throw;
    throw std::runtime_error(fmt::format("another process uses the journal {}", file.string()));
  }
  waiting_ = static_cast<std::size_t>(count("SELECT count(*) FROM waiting"));
  results_ = static_cast<std::size_t>(count("SELECT count(*) FROM waiting WHERE kind = 0"));
  expected_ = static_cast<std::size_t>(count("SELECT count(*) FROM replies"));
  finished_ =
      static_cast<std::size_t>(count("SELECT count(*) FROM commands WHERE result IS NOT NULL"));
}

Journal::~Journal() = default;

void Journal::begin() { run("BEGIN IMMEDIATE"); }

void Journal::commit() {
  check_place();
  run("COMMIT");
}

void Journal::check_header(const std::filesystem::path& file) {
  constexpr std::string_view beginning = "SQLite format 3";
  constexpr std::size_t schema_at = 40;
  constexpr std::size_t version_at = 60;
  constexpr std::size_t mark_at = 68;
  std::array<char, 100> header{};
  std::ifstream(file, std::ios::binary).read(header.data(), header.size());
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = value << 8U | static_cast<std::uint8_t>(header[i]);
    return value;
  };
  // The mark and the tables of a new journal are first in the WAL file.
  const bool is_new = number(mark_at) == 0 && number(schema_at) == 0;
  const bool is_database = std::string_view(header.data(), beginning.size()) == beginning;
  if (std::filesystem::file_size(file) == 0 || (is_database && is_new)) return;
  if (!is_database || number(mark_at) != journal_mark) {
    throw std::runtime_error(fmt::format("{} is no journal of a gateway", file.string()));
  }
  if (number(version_at) > journal_version) {
    throw std::runtime_error(
        fmt::format("the journal {} is of another version of sbgc", file.string()));
  }
}

void Journal::check_place() const {
  int has_moved = 0;
  sqlite3_file_control(database_.get(), "main", SQLITE_FCNTL_HAS_MOVED, &has_moved);
  if (has_moved == 0) return;
  throw std::runtime_error(fmt::format("the journal {} was removed or replaced",
                                       sqlite3_db_filename(database_.get(), "main")));
}

void Journal::reject_row(const char* table, std::int64_t id) const {
  throw std::runtime_error(
      fmt::format("the journal {} is damaged: row {} of the table '{}'; move the file away to "
                  "begin with an empty one",
                  sqlite3_db_filename(database_.get(), "main"), id, table));
}

RecognizedCommand Journal::recognize(const JournalCommand& command) {
  if (command.key.empty()) return {};
  Statement same(*this, "SELECT id, request, result FROM commands WHERE gimbal = ? AND key = ?",
                 "commands");
  same.add_text(command.gimbal).add_text(command.key);
  if (!same.next()) return {};
  if (same.text(1) != command.request) return {Recognition::reused};
  if (!same.is_null(2)) return {Recognition::finished, same.text(2), same.integer(0)};
  if (is_full()) return {Recognition::full};
  add_reply(same.integer(0), command.reply);
  return {Recognition::running};
}

std::optional<std::int64_t> Journal::admit(const JournalCommand& command, Time now) {
  forget(now);
  // The history is at most twice as long as configured.
  if (is_full() || finished_ >= 2 * limits_.history) return {};
  Statement insert(*this,
                   "INSERT INTO commands (gimbal, key, request, received) VALUES (?, ?, ?, ?)");
  insert.add_text(command.gimbal);
  command.key.empty() ? insert.add_null() : insert.add_text(command.key);
  insert.add_text(command.request).add(unix_milliseconds(now)).run();
  const std::int64_t id = sqlite3_last_insert_rowid(database_.get());
  add_reply(id, command.reply);
  return id;
}

std::vector<ReplyAddress> Journal::finish(std::int64_t id, std::string_view result) {
  Statement(*this, "UPDATE commands SET result = ? WHERE id = ? AND result IS NULL")
      .add_text(result)
      .add(id)
      .run();
  if (sqlite3_changes(database_.get()) == 0) return {};
  ++finished_;
  std::vector<ReplyAddress> addresses;
  Statement replies(*this, "SELECT command, topic, correlation FROM replies WHERE command = ?",
                    "replies");
  replies.add(id);
  while (replies.next()) addresses.push_back({replies.text(1), replies.bytes(2)});
  expected_ -= addresses.size();
  Statement(*this, "DELETE FROM replies WHERE command = ?").add(id).run();
  // Duplicates of it are not recognized.
  Statement(*this, "DELETE FROM commands WHERE id = ? AND key IS NULL").add(id).run();
  finished_ -= static_cast<std::size_t>(sqlite3_changes(database_.get()));
  return addresses;
}

void Journal::put(const WaitingMessage& message) {
  if (waiting_ >= limits_.most_waiting) {
    Statement(*this,
              "DELETE FROM waiting WHERE id = (SELECT id FROM waiting WHERE kind = 1 ORDER BY id "
              "LIMIT 1)")
        .run();
    const int removed = sqlite3_changes(database_.get());
    waiting_ -= static_cast<std::size_t>(removed);
    dropped_ += static_cast<std::uint64_t>(removed);
    if (removed == 0 && message.kind == WaitingKind::notice) {
      ++dropped_;
      return;
    }
  }
  Statement(*this, "INSERT INTO waiting (kind, topic, payload, correlation) VALUES (?, ?, ?, ?)")
      .add(static_cast<std::int64_t>(message.kind))
      .add_text(message.topic)
      .add_text(message.payload)
      .add_bytes(message.correlation)
      .run();
  ++waiting_;
  if (message.kind == WaitingKind::result) ++results_;
}

void Journal::remove(std::int64_t message) {
  Statement removed(*this, "DELETE FROM waiting WHERE id = ? RETURNING kind");
  removed.add(message);
  while (removed.next()) {
    --waiting_;
    if (removed.integer(0) == static_cast<int>(WaitingKind::result)) --results_;
  }
}

void Journal::set_moving(std::string_view gimbal, std::int64_t command) {
  Statement(*this, "INSERT OR REPLACE INTO moving VALUES (?, ?)")
      .add_text(gimbal)
      .add(command)
      .run();
}

void Journal::set_at_rest(std::string_view gimbal, std::int64_t command) {
  Statement(*this, "DELETE FROM moving WHERE gimbal = ? AND command <= ?")
      .add_text(gimbal)
      .add(command)
      .run();
}

std::map<std::string, std::int64_t> Journal::moving() const {
  std::map<std::string, std::int64_t> result;
  Statement rows(*this, "SELECT command, gimbal FROM moving", "moving");
  while (rows.next()) result[rows.text(1)] = rows.integer(0);
  return result;
}

std::vector<UnfinishedCommand> Journal::unfinished() const {
  std::vector<UnfinishedCommand> result;
  Statement commands(
      *this, "SELECT id, gimbal, key, request FROM commands WHERE result IS NULL ORDER BY id",
      "commands");
  while (commands.next()) {
    result.push_back({commands.integer(0), commands.text(1), commands.text(2), commands.text(3)});
  }
  return result;
}

std::vector<WaitingMessage> Journal::waiting_after(std::int64_t after, std::size_t most) const {
  std::vector<WaitingMessage> result;
  Statement rows(*this,
                 "SELECT id, kind, topic, payload, correlation FROM waiting WHERE id > ? "
                 "ORDER BY id LIMIT ?",
                 "waiting");
  rows.add(after).add(static_cast<std::int64_t>(most));
  while (rows.next()) {
    result.push_back({rows.integer(0), static_cast<WaitingKind>(rows.integer(1)), rows.text(2),
                      rows.text(3), rows.bytes(4)});
  }
  return result;
}

void Journal::run(const char* sql) {
  if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
    fail_journal(*database_);
  }
}

void Journal::add_reply(std::int64_t id, const ReplyAddress& reply) {
  Statement(*this, "INSERT OR IGNORE INTO replies VALUES (?, ?, ?)")
      .add(id)
      .add_text(reply.topic)
      .add_bytes(reply.correlation)
      .run();
  expected_ += static_cast<std::size_t>(sqlite3_changes(database_.get()));
}

/// Forgets the oldest results beyond the history, unless a duplicate of the command may be valid.
void Journal::forget(Time now) {
  if (finished_ < limits_.history) return;
  Statement(*this,
            "DELETE FROM commands WHERE id IN (SELECT id FROM commands WHERE result IS NOT NULL "
            "AND received NOT BETWEEN ? AND ? ORDER BY id LIMIT ?)")
      .add(unix_milliseconds(now - limits_.keep))
      .add(unix_milliseconds(now + limits_.keep))
      .add(static_cast<std::int64_t>(finished_ - limits_.history + 1))
      .run();
  finished_ -= static_cast<std::size_t>(sqlite3_changes(database_.get()));
}

std::int64_t Journal::count(const char* sql) const {
  Statement statement(*this, sql);
  return statement.next() ? statement.integer(0) : 0;
}

}  // namespace sbgc::tools

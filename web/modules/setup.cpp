// Exports of the module `setup`: the board, its parameters and their files. Profiles count from 1.

#include "modules/setup.hpp"

#include <string>

#include <sbgc/any.hpp>
#include <sbgc/availability.hpp>

#include "modules/exchange.hpp"
#include "modules/lines.hpp"

namespace sbgc::web {

namespace {

Parameters& parameters() {
  static Parameters made;
  return made;
}

std::uint8_t index_of(double profile) { return static_cast<std::uint8_t>(profile - 1); }

void put(const Json& result) { tools::exchange().output = detail::json_text(result); }

template <class E>
void add_missing(Flags<E> flags, Json& names) {
  for (const ValueInfo& value : EnumMeta<E>::info.values) {
    if (!flags.has(static_cast<E>(value.value))) names.push_back(value.name);
  }
}

}  // namespace

/// Begins with a new client, whose moves end when nobody sends commands any more.
SBGC_EXPORT(setup_begin) void setup_begin() {
  client()->bound_moves();
  parameters() = {};
}

/// The output has the versions and the serial number of the board, and the features that it lacks.
SBGC_EXPORT(setup_board) void setup_board() {
  const BoardIdentity& board = client()->passive().identity();
  Json lacks = Json::array();
  add_missing(board.info.board_features, lacks);
  if (!board.firmware_problem().empty()) lacks.push_back("firmware: " + board.firmware_problem());
  put({{"board", board.info.board_ver.raw()},
       {"firmware", board.info.firmware_ver.raw()},
       {"serialNumber", board.serial_number()},
       {"lacks", std::move(lacks)}});
}

/// Reads all parameters; the input is the time, for backups.
SBGC_EXPORT(setup_read) void setup_read(double id) {
  parameters().read(id, std::string(input_text()));
}

/// The output has a topic with its parameters in a profile; null behind the last topic.
SBGC_EXPORT(setup_topic) void setup_topic(double number, double profile) {
  put(parameters().topic(static_cast<std::size_t>(number), index_of(profile)));
}

/// Plans the values in the input, a line MESSAGE.PATH=TEXT each. The output is the plan.
SBGC_EXPORT(setup_plan) void setup_plan(double profile) {
  put(parameters().plan_values(input_text(), index_of(profile)));
}

/// Plans the file in the input.
SBGC_EXPORT(setup_plan_file) void setup_plan_file(double profile) {
  put(parameters().plan_file(input_text(), index_of(profile)));
}

/// Plans what was there before the last writing.
SBGC_EXPORT(setup_plan_undo) void setup_plan_undo() { put(parameters().plan_undo()); }

/// Makes the next undo go back to the parameters that were read last.
SBGC_EXPORT(setup_remember) void setup_remember() { parameters().remember(); }

/// Writes the plan; the input is the time.
SBGC_EXPORT(setup_write) void setup_write(double id) {
  parameters().write(id, std::string(input_text()));
}

/// The output is a backup of the board, or with `of_plan` of the board with the plan.
SBGC_EXPORT(setup_backup) void setup_backup(double of_plan) {
  tools::exchange().output = parameters().backup(of_plan != 0);
}

}  // namespace sbgc::web

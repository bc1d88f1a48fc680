/// The work of a page with the board, except motion: parameters, calibrations, tuning, frequency
/// responses. The results are in src/setup_messages.ts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sbgc/client/backup_tasks.hpp>
#include <sbgc/json_dom.hpp>

#include "modules/client.hpp"

namespace sbgc::web {

/// Writes a report of progress; the share is negative if it is not known.
void report_progress(double id, double share, std::string_view text);
/// Reports the end of a task with a result.
void report_result(double id, const Json& result);

/// The parameters of the board, and the wanted values.
class Parameters {
 public:
  /// Reads all of them; reports the active profile.
  void read(double id, std::string created);
  /// Returns a topic with its parameters in a profile, both from 0; null if there is no such topic.
  Json topic(std::size_t number, std::uint8_t profile) const;
  /// Plans values: lines MESSAGE.PATH=TEXT.
  Json plan_values(std::string_view lines, std::uint8_t profile);
  /// Plans the contents of a file: a backup, or the elements of one of the vendor's program.
  Json plan_file(std::string_view text, std::uint8_t profile);
  /// Plans to restore the parameters from before the last write.
  Json plan_undo();
  /// Writes the plan, line settings last, and reads everything again.
  void write(double id, std::string created);
  /// Remembers the parameters, so that the next undo goes back to them.
  void remember() { before_ = read_.parameters; }
  /// Returns the text of a backup of the board, or of the plan.
  std::string backup(bool of_plan) const;

 private:
  using Problems = std::vector<std::pair<std::string, std::string>>;

  /// Returns the plan for the page.
  Json planned(const Problems& problems, const std::vector<std::string>& remarks);
  Task<WriteReport> write_plan();

  Backup read_{};
  ParameterSet before_{};  // before the last write
  ParameterSet wanted_{};  // the blocks of the plan
  bool validates_ = true;  // false for values that a board has held
};

}  // namespace sbgc::web

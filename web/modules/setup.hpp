/// The work of a page with the board, except motion: parameters and their files, and long tasks
/// that need a person. Profiles count from 1. The results are in src/setup_messages.ts.
#pragma once

#include <string_view>

#include <sbgc/client/task.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/result.hpp>

namespace sbgc::web {

/// Makes JSON the output.
void put(const Json& result);

/// Starts a task. The report of its end is {"done": ID, "result": …}.
void start(double id, Task<Result<Json>> task);

/// Reports {"progress": ID, "of": {"share": 0.5, "text": "…"}}; a negative share is not known.
/// Returns false if the page no longer wants the task.
bool report_progress(double id, double share, std::string_view text);

/// Forgets the parameters of the board, and what was written to it.
void forget_parameters();

}  // namespace sbgc::web

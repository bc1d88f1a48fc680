// sbgc params: the parameters that the board stores.

#include "command/commands.hpp"
#include "parameters/params_commands.hpp"

namespace sbgc::tools {

void add_params(CLI::App& app, CommandContext& context) {
  auto* const params = app.add_subcommand("params", "Show, change, back up and restore parameters");
  params->require_subcommand(1);
  for (AddCommand* const add :
       {add_params_show, add_params_get, add_params_set, add_params_profiles, add_params_rename,
        add_params_backup, add_params_restore, add_params_diff, add_params_reset}) {
    add(*params, context);
  }
  params->footer(
      "You can name a parameter by its path (axes.pitch.p), by the end of the path (pitch.p), or "
      "as in the specification. Some parameters are general: they apply to the whole board, and "
      "are stored and set in every profile.");
}

}  // namespace sbgc::tools

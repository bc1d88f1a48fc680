/// The subcommands of `sbgc params`.
#pragma once

#include "command/commands.hpp"

namespace sbgc::tools {

AddCommand add_params_show, add_params_get, add_params_set, add_params_profiles, add_params_rename,
    add_params_backup, add_params_restore, add_params_diff, add_params_reset;

}  // namespace sbgc::tools

/// All tasks.
#pragma once

#include <sbgc/client/backup_tasks.hpp>
#include <sbgc/client/bode.hpp>
#include <sbgc/client/calibration.hpp>
#include <sbgc/client/memory.hpp>
#include <sbgc/client/modules.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/client/profiles.hpp>
#include <sbgc/client/readiness.hpp>
#include <sbgc/client/sensor_motion.hpp>
#include <sbgc/client/tuning.hpp>
#include <sbgc/client/variables.hpp>

// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of all messages.
#pragma once

#include <sbgc/meta/system.hpp>
#include <sbgc/meta/parameters.hpp>
#include <sbgc/meta/parameters_ext3.hpp>
#include <sbgc/meta/realtime.hpp>
#include <sbgc/meta/control.hpp>
#include <sbgc/meta/external_motors.hpp>
#include <sbgc/meta/calibration.hpp>
#include <sbgc/meta/imu.hpp>
#include <sbgc/meta/peripherals.hpp>
#include <sbgc/meta/modules.hpp>
#include <sbgc/meta/adjustable_variables.hpp>
#include <sbgc/meta/storage.hpp>
#include <sbgc/meta/scripting.hpp>
#include <sbgc/meta/debug.hpp>

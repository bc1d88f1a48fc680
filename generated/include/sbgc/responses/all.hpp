// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of all requests: `response_policy(request)`.
#pragma once

#include <sbgc/responses/system.hpp>
#include <sbgc/responses/parameters.hpp>
#include <sbgc/responses/parameters_ext3.hpp>
#include <sbgc/responses/realtime.hpp>
#include <sbgc/responses/control.hpp>
#include <sbgc/responses/external_motors.hpp>
#include <sbgc/responses/calibration.hpp>
#include <sbgc/responses/imu.hpp>
#include <sbgc/responses/peripherals.hpp>
#include <sbgc/responses/modules.hpp>
#include <sbgc/responses/adjustable_variables.hpp>
#include <sbgc/responses/storage.hpp>
#include <sbgc/responses/scripting.hpp>
#include <sbgc/responses/debug.hpp>

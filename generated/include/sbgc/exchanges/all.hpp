// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// What comes back for every request: `exchange_of(request)`, `AnswerOf<Request>`.
#pragma once

#include <sbgc/exchanges/system.hpp>
#include <sbgc/exchanges/parameters.hpp>
#include <sbgc/exchanges/realtime.hpp>
#include <sbgc/exchanges/control.hpp>
#include <sbgc/exchanges/calibration.hpp>
#include <sbgc/exchanges/imu.hpp>
#include <sbgc/exchanges/peripherals.hpp>
#include <sbgc/exchanges/adjustable_variables.hpp>
#include <sbgc/exchanges/storage.hpp>
#include <sbgc/exchanges/scripting.hpp>
#include <sbgc/exchanges/debug.hpp>

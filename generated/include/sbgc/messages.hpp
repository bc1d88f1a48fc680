// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// All messages of the protocol.
#pragma once

#include <sbgc/messages/system.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/messages/parameters_ext3.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/external_motors.hpp>
#include <sbgc/messages/calibration.hpp>
#include <sbgc/messages/imu.hpp>
#include <sbgc/messages/peripherals.hpp>
#include <sbgc/messages/modules.hpp>
#include <sbgc/messages/adjustable_variables.hpp>
#include <sbgc/messages/storage.hpp>
#include <sbgc/messages/scripting.hpp>
#include <sbgc/messages/debug.hpp>

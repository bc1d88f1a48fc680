#pragma once

#include "sbgc.hpp"

/// Sends a request and feeds the session with its response; returns the outcome.
sbgc::Outcome ask(sbgc::Session& session);

/// Metrics from the fields of a message, as the model describes them.
#pragma once

#include <set>
#include <string>

#include <prometheus/client_metric.h>

#include <sbgc/any.hpp>

#include "gateway/metric_families.hpp"

namespace sbgc::tools {

/// Adds the values of the message that have one of these paths, with this label. Names and helps
/// come from the model, units are the base units of Prometheus: `current` in mA becomes
/// sbgc_current_amperes. Axes become labels, and each flag or value of an enum 0 or 1.
void add_live_metrics(Families& families, const AnyMessage& message,
                      const std::set<std::string>& paths,
                      const prometheus::ClientMetric::Label& label);

}  // namespace sbgc::tools

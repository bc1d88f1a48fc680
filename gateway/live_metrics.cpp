#include "gateway/live_metrics.hpp"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <asio/post.hpp>
#include <fmt/format.h>

#include <sbgc/meta/realtime.hpp>

#include "values/leaf_value.hpp"

namespace sbgc::tools {

namespace {

using Labels = std::vector<prometheus::ClientMetric::Label>;

/// A unit of the specification in base units.
struct BaseUnit {
  std::string_view unit;
  const char* name;
  double factor;
};
constexpr std::array base_units{
    BaseUnit{"V", "volts", 1},
    BaseUnit{"mV", "volts", 1e-3},
    BaseUnit{"A", "amperes", 1},
    BaseUnit{"mA", "amperes", 1e-3},
    BaseUnit{"s", "seconds", 1},
    BaseUnit{"ms", "seconds", 1e-3},
    BaseUnit{"us", "seconds", 1e-6},
    BaseUnit{"degC", "celsius", 1},
    BaseUnit{"%", "ratio", 1e-2},
    BaseUnit{"deg", "degrees", 1},
    BaseUnit{"deg/s", "degrees_per_second", 1},
    BaseUnit{"Hz", "hertz", 1},
};

/// Returns the conversion of the unit of a field: the suffix of the metric's name, and a factor.
std::pair<std::string, double> base_unit_of(const UnitInfo* unit) {
  if (unit == nullptr || *unit->name == '\0') return {"", 1};
  for (const BaseUnit& base : base_units) {
    if (base.unit == unit->name) return {base.name, base.factor};
  }
  std::string name = unit->name;
  for (char& c : name) {
    const bool is_allowed =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!is_allowed) c = '_';
  }
  return {name, 1};
}

/// Splits a path into a metric name and labels: "angle.roll" is "angle" of the axis roll.
std::string name_of_path(const std::string& path, Labels& labels) {
  std::string name;
  for (std::size_t at = 0; at < path.size();) {
    const std::size_t dot = std::min(path.find('.', at), path.size());
    std::string step = path.substr(at, dot - at);
    at = dot + 1;
    if (const std::size_t bracket = step.find('['); bracket != std::string::npos) {
      labels.push_back({"index", step.substr(bracket + 1, step.size() - bracket - 2)});
      step.resize(bracket);
    }
    if (step == "roll" || step == "pitch" || step == "yaw") {
      labels.push_back({"axis", step});
    } else {
      name += '_' + step;
    }
  }
  // Prometheus reserves the suffix _count for histograms.
  for (const std::string_view end : {"_count", "_cnt"}) {
    if (name.ends_with(end)) name.replace(name.size() - end.size(), end.size(), "s");
  }
  return "sbgc" + name;
}

void add_leaf(Families& families, const Leaf& leaf, const std::string& path, Labels labels) {
  const std::string name = name_of_path(path, labels);
  const std::string summary = leaf.field.summary;
  if (leaf.names != nullptr) {
    for (const ValueInfo& value : leaf.names->values) {
      Labels one = labels;
      one.push_back({leaf.names->is_flags ? "flag" : "value", value.name});
      const bool is_set = leaf.names->is_flags
                              ? value.value != 0 && (leaf.integer & value.value) == value.value
                              : leaf.integer == value.value;
      families.add_gauge(name, summary + " 1 if it is so.", std::move(one), is_set ? 1 : 0);
    }
    return;
  }
  const std::optional<double> real = real_value(leaf);
  if (!real) return;
  const auto [unit, factor] = base_unit_of(leaf.unit);
  if (unit.empty()) return families.add_gauge(name, summary, std::move(labels), *real);
  families.add_gauge(name + '_' + unit, fmt::format("{} Unit: {}.", summary, unit),
                     std::move(labels), *real * factor);
}

}  // namespace

void add_live_metrics(Families& families, const AnyMessage& message,
                      const std::set<std::string>& paths,
                      const prometheus::ClientMetric::Label& label) {
  message.for_each_leaf([&](const Leaf& leaf) {
    const std::string path = to_string(leaf.path);
    if (paths.contains(path)) add_leaf(families, leaf, path, {label});
  });
}

namespace {

constexpr int intervals_until_old = 3;

// The range extends from a frame at the highest baud rate to a timeout over a slow radio link.
const prometheus::Histogram::BucketBoundaries latency_limits{
    0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1, 2.5};

/// The newest live data that the board has.
AnyMessage live_data_request(const BoardIdentity& board) {
  const bool has_newest = is_supported<msg::RealtimeData4Request>(board.versions());
  const char* const name = has_newest ? Meta<msg::RealtimeData4Request>::info.name
                                      : Meta<msg::RealtimeData3Request>::info.name;
  return find_message(name)->make();
}

}  // namespace

Probe::Probe(Gimbal& gimbal, std::chrono::milliseconds interval)
    : gimbal_(gimbal), interval_(interval), timer_(gimbal.executor()), latency_(latency_limits) {}

void Probe::start(std::chrono::milliseconds delay) {
  asio::post(gimbal_.executor(), [self = shared_from_this(), delay] { self->wait(delay); });
}

void Probe::close() {
  asio::post(gimbal_.executor(), [self = shared_from_this()] {
    self->is_closing_ = true;
    self->timer_.cancel();
  });
}

void Probe::wait(std::chrono::milliseconds time) {
  timer_.expires_after(time);
  timer_.async_wait([self = shared_from_this()](std::error_code error) {
    if (!error && !self->is_closing_) self->ask();
  });
}

void Probe::ask() {
  if (!gimbal_.client().is_connected()) return wait(interval_);
  const auto start = std::chrono::steady_clock::now();
  const auto done = [self = shared_from_this(), start](const CallResult<AnyMessage>& answer) {
    if (self->is_closing_) return;
    const auto now = std::chrono::steady_clock::now();
    if (answer) self->latency_.Observe(std::chrono::duration<double>(now - start).count());
    {
      const std::lock_guard lock(self->mutex_);
      if (!answer) {
        ++self->failures_[to_string(answer.error().code)];
      } else if (*answer) {
        self->live_data_ = **answer;
        self->received_ = now;
      }
    }
    self->wait(self->interval_);
  };
  // Without a second attempt, the time is that of one answer.
  gimbal_.client().async_call(live_data_request(gimbal_.client().identity()),
                              CallOptions{.retries = 0}, done);
}

std::optional<AnyMessage> Probe::live_data() const {
  const std::lock_guard lock(mutex_);
  const auto age = std::chrono::steady_clock::now() - received_;
  return age < intervals_until_old * interval_ ? live_data_ : std::nullopt;
}

std::map<std::string, std::uint64_t> Probe::failures() const {
  const std::lock_guard lock(mutex_);
  return failures_;
}

}  // namespace sbgc::tools

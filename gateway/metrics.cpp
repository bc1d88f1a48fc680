#include "gateway/metrics.hpp"

#include <array>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <set>
#include <string_view>
#include <utility>

#include <asio/ip/address.hpp>
#include <fmt/format.h>
#include <prometheus/exposer.h>
#include <sys/resource.h>
#include <unistd.h>

#include <sbgc/version.hpp>

#include "command/command_error.hpp"
#include "gateway/live_metrics.hpp"

namespace sbgc::tools {

namespace {

using prometheus::ClientMetric;
using prometheus::MetricType;

/// A counter of a line.
struct LineCounter {
  const char* name{};
  const char* help{};
  std::uint64_t (*value)(const ClientStatistics& line){};
  const char* kind = nullptr;  ///< a label, for several counters of one name
};

constexpr const char* line_errors_help =
    "Damage of the line: false starts of frames, wrong checksums, frames without an end.";

constexpr std::array line_counters{
    LineCounter{"sbgc_received_frames_total", "Frames received from the board.",
                [](const ClientStatistics& line) { return line.session.parser.frames; }},
    LineCounter{"sbgc_skipped_bytes_total", "Bytes received that belong to no frame.",
                [](const ClientStatistics& line) { return line.session.parser.skipped_bytes; }},
    LineCounter{"sbgc_line_errors_total", line_errors_help,
                [](const ClientStatistics& line) { return line.session.parser.header_errors; },
                "header"},
    LineCounter{"sbgc_line_errors_total", line_errors_help,
                [](const ClientStatistics& line) { return line.session.parser.body_errors; },
                "body"},
    LineCounter{"sbgc_line_errors_total", line_errors_help,
                [](const ClientStatistics& line) { return line.session.parser.incomplete; },
                "incomplete"},
    LineCounter{"sbgc_sent_frames_total", "Frames sent to the board, repetitions included.",
                [](const ClientStatistics& line) { return line.session.sent_frames; }},
    LineCounter{"sbgc_sent_bytes_total", "Bytes sent to the board.",
                [](const ClientStatistics& line) { return line.session.sent_bytes; }},
    LineCounter{"sbgc_calls_total", "Requests that were started.",
                [](const ClientStatistics& line) { return line.calls; }},
    LineCounter{"sbgc_failed_calls_total", "Requests that ended with an error.",
                [](const ClientStatistics& line) { return line.failures; }},
    LineCounter{"sbgc_retries_total", "Requests that were sent once more.",
                [](const ClientStatistics& line) { return line.session.retries; }},
    LineCounter{"sbgc_timeouts_total", "Transmissions without an answer in time.",
                [](const ClientStatistics& line) { return line.session.timeouts; }},
    LineCounter{"sbgc_late_replies_total", "Answers to requests that had ended.",
                [](const ClientStatistics& line) { return line.session.late_replies; }},
    LineCounter{"sbgc_board_resets_total", "Restarts that the board has announced.",
                [](const ClientStatistics& line) { return line.session.resets; }},
    LineCounter{"sbgc_unreadable_messages_total", "Messages that could not be decoded.",
                [](const ClientStatistics& line) { return line.unreadable; }},
};

ClientMetric::Label label_of(const char* name, const std::string& value) { return {name, value}; }

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    constexpr double micro = 1e-6;
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * micro;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0;
  double resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Each connection has a thread, which waits for the request. Further ones wait for a free thread.
constexpr unsigned most_scrapes = 128;
/// The timeout for receiving a request, in milliseconds.
constexpr const char* scrape_patience = "2000";

}  // namespace

/// Collects the metrics on request.
class Metrics::Collector : public prometheus::Collectable {
 public:
  Collector(const MetricsSettings& settings, const std::vector<std::unique_ptr<Gimbal>>& gimbals,
            const Broker* broker)
      : broker_(broker), interval_(settings.interval), paths_(settings.paths) {
    for (const auto& gimbal : gimbals) {
      gimbals_.push_back({gimbal.get(), std::make_shared<Probe>(*gimbal, interval_)});
    }
  }
  Collector(const Collector&) = delete;
  Collector& operator=(const Collector&) = delete;
  ~Collector() override {
    for (const Watched& one : gimbals_) one.probe->close();
  }

  void start() {
    const auto count = static_cast<std::int64_t>(gimbals_.size());
    for (std::int64_t i = 0; i < count; ++i) {
      gimbals_[static_cast<std::size_t>(i)].probe->start(interval_ * i / count);
    }
  }

  std::vector<prometheus::MetricFamily> Collect() const override {
    Families families;
    families.add_gauge("sbgc_build_info", "The version of the gateway. Always 1.",
                       {label_of("version", SBGC_VERSION_TEXT)}, 1);
    families.add_counter("process_cpu_seconds_total", "Processor time of the gateway.", {},
                         processor_seconds());
    families.add_gauge("process_resident_memory_bytes", "Memory of the gateway.", {},
                       resident_bytes());
    if (broker_ != nullptr) collect_broker(families, broker_->statistics());
    for (const Watched& one : gimbals_) collect(families, one);
    return families.take();
  }

 private:
  struct Watched {
    Gimbal* gimbal;
    std::shared_ptr<Probe> probe;
  };

  void collect(Families& families, const Watched& one) const {
    const ClientMetric::Label gimbal = label_of("gimbal", one.gimbal->name());
    const GimbalStatus status = one.gimbal->status();
    const bool is_online = status.link == GimbalLink::online;
    families.add_gauge("sbgc_gimbal_up", "1 if the gimbal is connected.", {gimbal},
                       is_online ? 1 : 0);
    families.add_gauge("sbgc_gimbal_stopping",
                       "1 if a stop has not succeeded for seconds: the camera may still turn.",
                       {gimbal}, status.is_stopping ? 1 : 0);
    if (!status.firmware.empty()) {
      families.add_gauge(
          "sbgc_gimbal_info", "What the board says of itself. Always 1.",
          {gimbal, label_of("firmware", status.firmware), label_of("board", status.board),
           label_of("serial_number", status.serial_number)},
          1);
    }
    families.add_counter("sbgc_connections_total", "Connections that were made to the gimbal.",
                         {gimbal}, static_cast<double>(status.connections));
    collect_counters(families, gimbal, one.gimbal->counters());
    ClientMetric& latency =
        families.add("sbgc_response_time_seconds",
                     "Time from a request for live data to its answer. Unit: seconds.",
                     MetricType::Histogram, {gimbal});
    latency.histogram = one.probe->latency().histogram;
    for (const auto& [error, count] : one.probe->failures()) {
      families.add_counter("sbgc_unanswered_requests_total",
                           "Requests for live data that ended with this error.",
                           {gimbal, label_of("error", error)}, static_cast<double>(count));
    }
    if (const auto live_data = one.probe->live_data(); live_data && is_online) {
      add_live_metrics(families, *live_data, paths_, gimbal);
    }
  }

  static void collect_counters(Families& families, const ClientMetric::Label& gimbal,
                               const GimbalCounters& counters) {
    for (const LineCounter& one : line_counters) {
      std::vector<ClientMetric::Label> labels{gimbal};
      if (one.kind != nullptr) labels.push_back(label_of("kind", one.kind));
      families.add_counter(one.name, one.help, std::move(labels),
                           static_cast<double>(one.value(counters.line)));
    }
    for (const auto& [message, count] : counters.telemetry) {
      families.add_counter("sbgc_telemetry_messages_total", "Messages of telemetry received.",
                           {gimbal, label_of("message", message)}, static_cast<double>(count));
    }
    for (const auto& [error, count] : counters.board_errors) {
      families.add_counter("sbgc_board_errors_total",
                           "Errors that the board has reported outside of requests.",
                           {gimbal, label_of("error", error)}, static_cast<double>(count));
    }
    if (const StreamUsage& usage = counters.line.streams; usage.limit != 0) {
      families.add_gauge("sbgc_stream_share_ratio",
                         "Share that data streams use of what they may use of the line.", {gimbal},
                         static_cast<double>(usage.used) / usage.limit);
    }
  }

  static void collect_broker(Families& families, const Broker::Statistics& broker) {
    families.add_gauge("sbgc_broker_up", "1 if the gateway is connected to the broker.", {},
                       broker.is_connected ? 1 : 0);
    families.add_gauge(
        "sbgc_broker_failed",
        "1 if the gateway has given up the broker, such as for a full disk, until it "
        "is started again.",
        {}, broker.has_failed ? 1 : 0);
    families.add_gauge("sbgc_broker_waiting_messages",
                       "Events and results on the disk that the broker has not acknowledged.", {},
                       static_cast<double>(broker.waiting));
    families.add_gauge("sbgc_broker_waiting_limit_messages",
                       "The most events and results that the disk keeps.", {},
                       static_cast<double>(broker.most_waiting));
    families.add_counter(
        "sbgc_broker_thinned_samples_total",
        "Samples of telemetry that newer ones replaced, because the broker is slow.", {},
        static_cast<double>(broker.thinned));
    families.add_counter("sbgc_broker_dropped_messages_total",
                         "Events and refusals for which there was no room.", {},
                         static_cast<double>(broker.dropped));
    families.add_counter("sbgc_broker_acknowledged_messages_total",
                         "Messages that the broker has acknowledged.", {},
                         static_cast<double>(broker.acknowledged));
    const std::array<std::pair<const char*, std::uint64_t>, 4> results{
        {{"done", broker.done},
         {"failed", broker.failed},
         {"refused", broker.refused},
         {"unknown", broker.unknown}}};
    for (const auto& [result, count] : results) {
      families.add_counter("sbgc_commands_total", "Commands from the broker, by their results.",
                           {label_of("result", result)}, static_cast<double>(count));
    }
  }

  const Broker* const broker_;
  const std::chrono::milliseconds interval_;
  const std::set<std::string> paths_;
  std::vector<Watched> gimbals_;
};

class Metrics::Server {
 public:
  explicit Server(const std::string& address)
      : exposer_(std::vector<std::string>{"listening_ports", address, "num_threads",
                                          std::to_string(most_scrapes), "request_timeout_ms",
                                          scrape_patience}) {}

  void add(const std::shared_ptr<Collector>& collector) { exposer_.RegisterCollectable(collector); }
  int port() const { return exposer_.GetListeningPorts().front(); }

 private:
  prometheus::Exposer exposer_;
};

Metrics::Metrics(const MetricsSettings& settings,
                 const std::vector<std::unique_ptr<Gimbal>>& gimbals, const Broker* broker)
    : listen_(settings.listen), collector_(std::make_shared<Collector>(settings, gimbals, broker)) {
  try {
    server_ = std::make_unique<Server>(settings.listen);
  } catch (const std::exception&) {
    throw CommandError(
        fmt::format("cannot serve metrics at {}: it is no address of this machine, or its port is "
                    "in use",
                    settings.listen));
  }
  server_->add(collector_);
}

Metrics::~Metrics() { server_.reset(); }

void Metrics::start() { collector_->start(); }

std::string Metrics::address() const {
  return fmt::format("http://{}:{}/metrics", listen_.substr(0, listen_.rfind(':')),
                     server_->port());
}

bool Metrics::is_open() const {
  return !asio::ip::make_address_v4(listen_.substr(0, listen_.rfind(':'))).is_loopback();
}

}  // namespace sbgc::tools

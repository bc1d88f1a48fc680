// Counts right, wrong and missing answers on a bad line, for each framing: in virtual time, with
// the emulated board, and with the same results in each run.
//
//     line_errors [REQUESTS]
//
// A wrong answer is one that passes all checks but differs from what the board sent. "Agreeing" are
// the wrong ones that remain if a value counts only once two answers agree, as the client does
// where a wrong value would be written to the board.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/client/statistics.hpp>
#include <sbgc/emulator/emulator.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>

namespace {

using sbgc::Duration;
using sbgc::Framing;
using sbgc::Instant;
using Body = std::vector<std::uint8_t>;

/// A line of a certain quality.
struct Quality {
  const char* name;
  sbgc::emulator::Faults faults;
};

const std::array qualities{
    Quality{"no errors", {}},
    Quality{"bit errors 1e-5", {.bit_errors = 1e-5}},
    Quality{"bit errors 1e-4", {.bit_errors = 1e-4}},
    Quality{"bit errors 1e-3", {.bit_errors = 1e-3}},
    Quality{"0.1 % lost", {.lost = 1e-3}},
    Quality{"1 % lost", {.lost = 1e-2}},
    Quality{"1 % lost, 0.5 % doubled", {.lost = 1e-2, .duplicated = 5e-3}},
};

/// The fate of the answers.
struct Counts {
  std::uint64_t right{};
  std::uint64_t wrong{};
  std::uint64_t missing{};
  std::uint64_t agreed{};        ///< values of which two answers agree
  std::uint64_t agreed_wrong{};  ///< of these, wrong ones

  void print(const char* quality, const char* what, Framing framing,
             const sbgc::LineQuality& estimate) const {
    const double all = static_cast<double>(right + wrong + missing);
    const auto percent = [](std::uint64_t part, double whole) {
      return whole == 0 ? 0 : 100 * static_cast<double>(part) / whole;
    };
    std::printf("%-24s %-11s %-3s %9.3f %9.4f %9.3f %9.4f %9.3f %9.4f\n", quality, what,
                framing == Framing::v1 ? "v1" : "v2", percent(right, all), percent(wrong, all),
                percent(missing, all), percent(agreed_wrong, static_cast<double>(agreed)),
                100 * estimate.damaged, 100 * estimate.undetected);
    std::fflush(stdout);
  }
};

/// A host that sends one request after the other to an emulated board.
class Host {
 public:
  Host(const sbgc::emulator::Faults& faults, Framing framing)
      : emulator_(options(faults), {}, now_), port_(emulator_.connect(false, now_).value()) {
    now_ = now_ + sbgc::seconds(5);  // once the board has started
    emulator_.advance(now_);
    emulator_.take(port_, emulator_.to_host(port_).size(), now_);
    while (session_.framing() != framing) {
      static_cast<void>(session_.try_framing(framing, sbgc::msg::BoardInfoRequest{}));
      run();
    }
  }

  /// Returns the body of the answer to one transmission of a request; nothing if there is none.
  template <class M>
  std::optional<Body> ask(const M& request) {
    static_cast<void>(session_.send(request, {.attempts = 1}));
    return run();
  }

  sbgc::LineQuality estimate() const { return sbgc::line_quality(session_.statistics()); }

 private:
  static sbgc::emulator::EmulatorOptions options(const sbgc::emulator::Faults& faults) {
    sbgc::emulator::EmulatorOptions result;
    result.board.firmware = sbgc::msg::FirmwareVersion(2740);  // knows both framings
    result.line.board.baud_rate = 115200;
    result.line.faults = faults;
    return result;
  }

  /// Runs until the request has ended.
  std::optional<Body> run() {
    std::optional<Body> answer;
    bool has_ended = false;
    const auto sink = [&](const sbgc::Event& event) {
      if (event.kind != sbgc::EventKind::completed) return;
      has_ended = true;
      if (event.outcome != sbgc::Outcome::answered) return;
      answer.emplace(event.frame.body.begin(), event.frame.body.end());
    };
    while (!has_ended) {
      const sbgc::Output output = session_.poll(now_, sink);
      if (has_ended) break;
      if (!output.bytes.empty()) {
        emulator_.from_host(port_, output.bytes, now_);
        session_.written(now_);
        continue;
      }
      now_ = sbgc::later(now_ + sbgc::microseconds(1),
                         sbgc::earlier(emulator_.next(), output.deadline));
      emulator_.advance(now_);
      const auto arrived = emulator_.to_host(port_);
      const Body bytes(arrived.begin(), arrived.end());
      emulator_.take(port_, bytes.size(), now_);
      session_.feed(bytes, now_, sink);
    }
    return answer;
  }

  Instant now_{};
  sbgc::emulator::Emulator emulator_;
  std::size_t port_;
  sbgc::Session session_{[] {
    sbgc::SessionOptions session;
    session.line.baud_rate = 115200;
    return session;
  }()};
};

/// Sends the same request repeatedly and compares the answers with that on a line without
/// errors.
template <class M>
void measure(const Quality& quality, const char* what, Framing framing, const M& request,
             unsigned requests) {
  const std::optional<Body> truth = Host({}, framing).ask(request);
  if (!truth) {
    std::fprintf(stderr, "line_errors: the board does not answer\n");
    std::exit(1);
  }
  Host host(quality.faults, framing);
  Counts counts;
  std::vector<Body> unsure;
  for (unsigned i = 0; i < requests; ++i) {
    const std::optional<Body> answer = host.ask(request);
    if (!answer) {
      ++counts.missing;
      continue;
    }
    const bool is_right = *answer == *truth;
    ++(is_right ? counts.right : counts.wrong);
    if (std::ranges::find(unsure, *answer) == unsure.end()) {
      unsure.push_back(*answer);
      continue;
    }
    ++counts.agreed;
    counts.agreed_wrong += is_right ? 0 : 1;
    unsure.clear();
  }
  counts.print(quality.name, what, framing, host.estimate());
}

}  // namespace

int main(int argc, char** argv) {
  const int requests = argc == 2 ? std::atoi(argv[1]) : 20'000;
  if (argc > 2 || requests <= 0) {
    std::fprintf(stderr, "usage: line_errors [REQUESTS]\n");
    return 2;
  }
  std::printf("%-40s %9s %9s %9s %9s %9s %9s\n", "% of answers", "right", "wrong", "missing",
              "agreeing", "damaged", "estimate");
  for (const Quality& quality : qualities) {
    for (const Framing framing : {Framing::v1, Framing::v2}) {
      const auto count = static_cast<unsigned>(requests);
      measure(quality, "18 bytes", framing, sbgc::msg::BoardInfoRequest{}, count);
      measure(quality, "parameters", framing, sbgc::msg::ReadParams3Request{}, count);
    }
  }
}

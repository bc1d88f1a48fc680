#include "modules/client.hpp"

#include <array>
#include <chrono>
#include <optional>
#include <type_traits>

#include <sbgc/any.hpp>
#include <sbgc/availability.hpp>
#include <sbgc/client/tasks.hpp>
#include <sbgc/doctor/findings.hpp>
#include <sbgc/doctor/measure.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/roles.hpp>

#include "calls/pending_calls.hpp"
#include "modules/actions.hpp"
#include "passive_state.hpp"
#include "tasks/hold_speed.hpp"

namespace sbgc::web {

namespace {

/// The board sends its state as often as a screen shows it.
constexpr int view_interval_ms = 16;
/// After a restart of the board, or a lost request, its stream is asked for again.
constexpr Duration longest_silence = milliseconds(700);
constexpr Duration pause = milliseconds(8);

const char* name_of(ReplyKind kind) {
  switch (kind) {
    case ReplyKind::answered: return "answered";
    case ReplyKind::confirmed: return "confirmed";
    case ReplyKind::unconfirmed: return "unconfirmed";
    case ReplyKind::sent: break;
  }
  return "sent";
}

std::string frame_of(const Reply& reply) {
  std::array<std::uint8_t, max_frame_size> frame{};
  const WriteResult written = write_frame(reply.framing, reply.id, reply.body, frame);
  return written ? detail::to_hex(std::span(frame).first(written.size)) : "";
}

Task<Result<Reply>> ask(AnyMessage request) { co_return co_await tasks::transact(request); }

template <Message M>
std::optional<tools::LiveValues> values_in(std::span<const std::uint8_t> body) {
  M message;
  if (!decode(body, message)) return {};
  return tools::values_of(message);
}

}  // namespace

struct Client::Held {
  std::shared_ptr<detail::HeldSpeed> speed;
  TaskMachine* machine = nullptr;
  Duration time{};
  bool is_over = false;
};

Client::Client() {
  notices_ = client_.on_notice([this](const Notice& notice) { report("notice", notice.message); });
}

void Client::connect(double id, bool searches) {
  if (!searches) return identify(id);
  const auto set_line = [this](const LineSettings& line) {
    report([&](JsonWriter& out) {
      out.member("baud", line.baud_rate);
      out.member("even", line.parity == Parity::even);
    });
    return true;
  };
  client_.detect_line(set_line, [this, id](const Result<void>& found) {
    if (found) return identify(id);
    report_end(id, found.error().message);
  });
}

void Client::identify(double id) {
  client_.connect([this, id](const Result<void>& connected) {
    if (!connected) return report_end(id, connected.error().message);
    const BoardIdentity& board = client_.identity();
    report_end(id, "", [&](JsonWriter& out) {
      out.member("identity",
                 "board " + board.board_version() + ", firmware " + board.firmware_version());
    });
    client_.start(watch(), [](const Result<void>&) {});
  });
}

void Client::report(const Members& members) {
  JsonWriter out(reports_);
  out.object([&] { members(out); });
  out.end_line();
}

void Client::report(const char* name, std::string_view text) {
  report([&](JsonWriter& out) { out.member(name, text); });
}

void Client::report_end(double id, std::string_view error, const Members& more) {
  report([&](JsonWriter& out) {
    out.member("done", static_cast<std::int64_t>(id));
    if (!error.empty()) out.member("error", error);
    if (more) more(out);
  });
}

std::string Client::act(double id, std::string_view action, Instant now) {
  return begin_action(*this, id, action, now);
}

void Client::turn(double id, const Axes<msg::ControlSpeed>& speed, Instant now, Duration time) {
  const Result<void> outcome = held_ ? held_->speed->outcome() : Result<void>();
  if (held_ && (held_->time != time || held_->is_over || !outcome)) {
    held_->speed->close();
    if (!held_->is_over) held_->machine->wake();
    held_.reset();
  }
  // Somebody has stopped the camera: its owner must know before it turns again.
  if (!outcome && bounds_moves_) return report_end(id, outcome.error().message);
  if (!held_) {
    detail::MotionOrder& order = client_.state().order();
    held_ = std::make_shared<Held>();
    held_->time = time;
    held_->speed = std::make_shared<detail::HeldSpeed>(
        detail::DeadMansSwitch(time, milliseconds(100)),
        detail::HeldSpeed::Order{
            .begin = [&order] { return order.begin(); },
            .is_superseded = [&order](TaskNumber task) { return order.is_superseded(task); }});
    constexpr std::chrono::milliseconds bound{500};
    held_->machine = &client_.start(
        detail::hold_speed(held_->speed, {MotionBound::automatic, bound}, bounds_moves_),
        [held = held_](const Result<void>&) { held->is_over = true; });
  }
  const Result<void> set = held_->speed->set(speed, now);
  held_->machine->wake();
  report_end(id, set ? "" : set.error().message);
}

std::string Client::send(double id, std::span<const std::uint8_t> bytes) {
  std::string problem = "this is not the frame of a request";
  ParserOfAll parser;
  parser.feed(bytes, [&](const Frame& frame) {
    const MessageType* const type = find_message(Direction::to_board, frame.id, frame.body.size());
    if (type == nullptr) return;
    AnyMessage request = type->make();
    if (!request.decode(frame.body)) return;
    problem.clear();
    client_.start(ask(std::move(request)), [this, id](const Result<Reply>& reply) {
      if (!reply) return report_end(id, reply.error().message);
      report_end(id, "", [&](JsonWriter& out) {
        out.member("kind", name_of(reply->kind));
        if (reply->id != 0) out.member("frame", frame_of(*reply));
      });
    });
  });
  return problem;
}

void Client::diagnose(double id) {
  client_.start(tasks::measure(), [this, id](Result<doctor::Measurements> measured) {
    if (!measured) return report_end(id, measured.error().message);
    measured->add(client_.statistics());
    const auto put = [](JsonWriter& out, const doctor::Finding& one) {
      out.object([&] {
        out.member("id", one.id);
        out.member("axis", one.axis ? static_cast<int>(*one.axis) : -1);
        out.member("sentence", one.sentence);
        out.member("advice", one.advice);
        out.member("command", one.command);
      });
    };
    report_end(id, "", [&](JsonWriter& out) {
      out.key("findings").list([&] {
        for (const doctor::Finding& one : doctor::findings_of(*measured)) put(out, one);
      });
    });
  });
}

void Client::take(const tools::LiveValues& values) {
  const double count = view_.count + 1;
  view_ = {.seconds = view_.seconds,
           .camera = values.angle,
           .targets = values.target,
           .frame = values.frame_angle,
           .joints = values.joint,
           .speeds = values.rate,
           .power = values.power,
           .volts = values.battery,
           .amperes = values.current / 1000,
           .motors_on = values.motors_on ? 1.0 : 0.0,
           .profile = static_cast<double>(values.profile),
           .count = count};
  std::string errors;
  for (const ValueInfo* const error : values.errors) errors += std::string(error->name) + '\n';
  if (errors == std::exchange(errors_, errors)) return;
  report("errors", errors_);
}

Task<Result<void>> Client::watch() {
  TaskMachine& task = co_await tasks::this_task();
  const bool is_new = is_supported<msg::RealtimeData4Request>(task.identity().versions());
  while (true) {
    roles::StreamRequest request{};
    auto& interval = roles::stream_interval(request);
    interval = std::remove_reference_t<decltype(interval)>(view_interval_ms);
    const CallId stream = is_new ? task.begin_stream<msg::RealtimeData4>(request)
                                 : task.begin_stream<msg::RealtimeData3>(request);
    if (auto waited = co_await tasks::wait_for_call(stream, Instant::never); !waited) {
      co_return waited;
    }
    const Result<Reply>* const begun = task.reply(stream);
    const bool has_none = !*begun && begun->error().code == ErrorCode::unsupported;
    Instant heard = task.now();
    while (task.now() - heard < longest_silence) {
      std::optional<tools::LiveValues> values;
      if (has_none) {
        const auto data = co_await tasks::call(msg::RealtimeData3Request{});
        if (data) values = tools::values_of(*data);
      }
      for (const auto& body : task.take_series(stream)) {
        values = is_new ? values_in<msg::RealtimeData4>(body) : values_in<msg::RealtimeData3>(body);
      }
      if (values) {
        heard = task.now();
        view_.seconds = static_cast<double>(heard.us) * 1e-6;
        take(*values);
      }
      if (auto waited = co_await tasks::wait_until(task.now() + pause); !waited) co_return waited;
    }
    task.end(stream);
  }
}

}  // namespace sbgc::web

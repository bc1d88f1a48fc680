#include "task_test.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

#include <sbgc/dispatch.hpp>
#include <sbgc/io/pseudo_terminal.hpp>

#include "scripted_board.hpp"

namespace sbgc::test {

/// The line to the board, and the board's thread.
class TaskTest::Line : public ScriptedBoard {
 public:
  explicit Line(TaskTest& test) : test_(test) {
    AllMessages::for_each([this]<class M>(Type<M>) {
      if constexpr (M::direction != Direction::from_board) {
        on<M>([this](const M& request) { answer(packet(request)); });
      }
    });
  }

 private:
  void answer(const Packet& request) {
    Packets answers;
    {
      const std::scoped_lock lock(test_.mutex_);
      answers = test_.board.answer(request);
    }
    for (const Packet& one : answers) {
      std::array<std::uint8_t, max_frame_size> frame{};
      std::ranges::copy(one.body, frame_body(frame.data()));
      send_bytes(std::span(frame).first(finish_frame(frame.data(), one.id, one.body.size())));
    }
  }

  TaskTest& test_;
};

TaskTest::TaskTest() : line_(std::make_unique<Line>(*this)) {}
TaskTest::~TaskTest() = default;

void TaskTest::connect() {
  client_.reset();
  ConnectOptions options = quick();
  options.retries = 0;
  Result<Client> connected = connect_over(over_memory(*line_), options);
  if (!connected) throw std::runtime_error(connected.error().message);
  client_.emplace(*std::move(connected));
  board.log.clear();
}

void TaskTest::disconnect() {
  client_.reset();
  line_.reset();
}

std::string TaskTest::serve_pty() {
  auto opened = io::open_pseudo_terminal(line_->executor(), {.stays_open = true});
  if (!opened) return {};
  std::string path = opened.transport->path();
  line_->serve(std::move(opened.transport));
  return path;
}

void TaskTest::unplug() { line_->unplug(); }

void TaskTest::send_reset() { line_->send(Reset{}); }

}  // namespace sbgc::test

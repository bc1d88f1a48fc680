#include "board/frame_printer.hpp"

#include <chrono>
#include <cstdio>
#include <string>

#include <fmt/format.h>

#include <sbgc/io/clock.hpp>
#include <sbgc/io/observer.hpp>
#include <sbgc/parser.hpp>

#include "command/remark.hpp"
#include "frames/decoded_frame.hpp"
#include "frames/frame_text.hpp"

namespace sbgc::tools {

namespace {

class FramePrinter final : public io::Observer {
 public:
  void on_read(std::span<const std::uint8_t> bytes) override {
    from_board_.feed(bytes, [this](const Frame& frame) { print(frame, Direction::from_board); });
  }
  void on_written(std::span<const std::uint8_t> bytes) override {
    to_board_.feed(bytes, [this](const Frame& frame) { print(frame, Direction::to_board); });
    to_board_.flush([this](const Frame& frame) { print(frame, Direction::to_board); });
  }
  void on_line_set(const LineSettings& settings) override {
    remark("{}  line: {}\n", time(), io::to_string(settings));
  }

 private:
  std::string time() const {
    const std::chrono::duration<double> passed = io::Clock::now() - start_;
    return fmt::format("{:.6f} s", passed.count());
  }

  void print(const Frame& frame, Direction direction) {
    std::string text = time();
    StringOutput out(text);
    put_text(out, decoder_.decode(frame, direction), colors_);
    out.finish();
    remark("{}", text);
  }

  io::Clock::time_point start_ = io::Clock::now();
  Colors colors_{stderr};
  ParserOfAll from_board_;
  ParserOfAll to_board_;
  FrameDecoder decoder_{{.json = false, .rows = true}};
};

}  // namespace

Wrap with_frame_printer(Wrap inner) {
  return [inner = std::move(inner)](std::unique_ptr<io::Transport> transport) {
    if (inner) transport = inner(std::move(transport));
    return io::observe(std::move(transport), std::make_shared<FramePrinter>());
  };
}

}  // namespace sbgc::tools

// A client and the emulated board in virtual time, as a program and as a WebAssembly module:
// connects, moves the camera, and makes a backup, whose text it reads again. Prints what passes on
// the line, and the results.

#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include <sbgc/client/backup_tasks.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/client/passive_client.hpp>
#include <sbgc/emulator/emulator.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/literals.hpp>

#if !defined(__wasm__)
#include <cstdio>
#endif

namespace {

using namespace sbgc::literals;

class Session {
 public:
  Session() {
    client_.connect([this](const sbgc::Result<void>& connected) {
      if (!end_step("connected", connected)) return;
      client_.start(sbgc::tasks::move_to({.pitch = -30_deg, .yaw = 20_deg}),
                    [this](const sbgc::Result<sbgc::MoveProgress>& moved) {
                      if (end_step("moved", moved)) back_up();
                    });
    });
  }

  std::string run() && {
    while (!is_over_) {
      step();
      now_ = later(next(), now_ + sbgc::microseconds(1));
    }
    return std::move(log_);
  }

 private:
  void back_up() {
    client_.start(sbgc::tasks::make_backup("2024-05-01T12:00:00Z"),
                  [this](const sbgc::Result<sbgc::Backup>& backup) {
                    if (!end_step("read", backup)) return;
                    const std::string text = sbgc::to_json_text(*backup);
                    log_ += text;
                    const auto parsed = sbgc::parse_backup(text);
                    if (!end_step("parsed", parsed)) return;
                    is_over_ = true;
                    log_ += std::to_string(parsed->parameters.all().size()) + " parameters\n";
                  });
  }

  template <class R>
  bool end_step(const char* done, const R& result) {
    is_over_ = !result;
    log_ += (result ? done : result.error().message) + std::string("\n");
    return !is_over_;
  }

  void step() {
    if (const auto bytes = client_.advance(now_); !bytes.empty()) {
      note(" > ", bytes);
      board_.from_host(port_, bytes, now_);
      client_.written(now_);
    }
    board_.advance(now_);
    const auto answers = board_.to_host(port_);
    if (answers.empty()) return;
    note(" < ", answers);
    client_.receive(answers, now_);
    board_.take(port_, answers.size(), now_);
  }
  sbgc::Instant next() const { return earlier(client_.deadline(), board_.next()); }

  void note(const char* way, std::span<const std::uint8_t> bytes) {
    log_ += std::to_string(now_.us) + way + sbgc::detail::to_hex(bytes) + '\n';
  }

  sbgc::Instant now_{};
  std::string log_{};
  bool is_over_ = false;
  sbgc::emulator::Emulator board_{{}, {}, now_};
  std::size_t port_ = board_.connect(true, now_).value_or(0);
  sbgc::PassiveClient client_{};
};

}  // namespace

#if defined(__wasm__)
namespace {

std::string& output() {
  static std::string text;
  return text;
}

}  // namespace

extern "C" {
__attribute__((export_name("run"))) void sbgc_run() { output() = Session().run(); }
__attribute__((export_name("output"))) const char* sbgc_output() { return output().data(); }
__attribute__((export_name("output_size"))) std::size_t sbgc_output_size() {
  return output().size();
}
}
#else
int main() { return std::fputs(Session().run().c_str(), stdout) < 0 ? 1 : 0; }
#endif

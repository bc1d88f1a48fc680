#include <string>
#include <utility>

#include <asio/error.hpp>

#include <sbgc/io/observer.hpp>
#include <sbgc/io/recorder.hpp>

namespace sbgc::io {

namespace {

/// Writes what it observes to a capture.
class Recorder final : public Observer {
 public:
  Recorder(CaptureWriter file, RecorderOptions options)
      : file_(std::move(file)), options_(std::move(options)) {}

  void on_read(std::span<const std::uint8_t> bytes) override {
    add(CaptureKind::from_board, bytes);
  }
  void on_written(std::span<const std::uint8_t> bytes) override {
    add(CaptureKind::to_board, bytes);
  }
  void on_read_failed(std::error_code error) override { note("read: " + text(error)); }
  void on_write_failed(std::error_code error, std::size_t size, std::size_t all) override {
    note("write: " + std::to_string(size) + " of " + std::to_string(all) +
         " bytes, then: " + text(error));
  }
  void on_line_set(const LineSettings& settings) override { note("line: " + to_string(settings)); }

  void note(const std::string& text) {
    if (file_.error()) return;
    report(file_.write_note(text, options_.now()));
  }

 private:
  static std::string text(std::error_code error) {
    return error == asio::error::operation_aborted ? "closed" : error.message();
  }

  void add(CaptureKind kind, std::span<const std::uint8_t> bytes) {
    if (file_.error()) return;
    report(file_.write(kind, bytes, options_.now()));
  }

  void report(const Error& error) const {
    if (error && options_.on_error) options_.on_error(error);
  }

  CaptureWriter file_;
  RecorderOptions options_;
};

}  // namespace

std::unique_ptr<Transport> record(std::unique_ptr<Transport> inner, CaptureWriter file,
                                  RecorderOptions options) {
  auto recorder = std::make_shared<Recorder>(std::move(file), std::move(options));
  recorder->note(inner->description());
  return observe(std::move(inner), std::move(recorder));
}

}  // namespace sbgc::io

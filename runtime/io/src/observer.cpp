#include <string>
#include <utility>

#include <asio/error.hpp>

#include <sbgc/io/observer.hpp>
#include <sbgc/io/recorder.hpp>

namespace sbgc::io {

namespace {

class ObservedLine final : public LineControl {
 public:
  ObservedLine(LineControl& inner, std::shared_ptr<Observer> observer)
      : inner_(inner), observer_(std::move(observer)) {}

  Error set(const LineSettings& settings) override {
    Error error = inner_.set(settings);
    observer_->on_line_set(inner_.current());
    return error;
  }
  LineSettings current() const override { return inner_.current(); }
  Error flush() override { return inner_.flush(); }

 private:
  LineControl& inner_;
  std::shared_ptr<Observer> observer_;
};

class ObservedTransport final : public Transport {
 public:
  ObservedTransport(std::unique_ptr<Transport> inner, std::shared_ptr<Observer> observer)
      : inner_(std::move(inner)), observer_(std::move(observer)) {
    if (LineControl* const line = inner_->line()) {
      line_ = std::make_unique<ObservedLine>(*line, observer_);
    }
  }

  void async_read(std::span<std::uint8_t> into, Handler handler) override {
    inner_->async_read(into, [observer = observer_, into, handler = std::move(handler)](
                                 std::error_code error, std::size_t size) {
      if (size != 0) observer->on_read(into.first(size));
      if (error) observer->on_read_failed(error);
      handler(error, size);
    });
  }

  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    if (!bytes.empty()) observer_->on_written(bytes);
    inner_->async_write(bytes,
                        [observer = observer_, all = bytes.size(), handler = std::move(handler)](
                            std::error_code error, std::size_t size) {
                          if (error) observer->on_write_failed(error, size, all);
                          handler(error, size);
                        });
  }

  void close() override { inner_->close(); }
  asio::any_io_executor executor() override { return inner_->executor(); }
  std::string description() const override { return inner_->description(); }
  LineControl* line() override { return line_.get(); }
  int native_handle() override { return inner_->native_handle(); }
  bool may_repeat() const override { return inner_->may_repeat(); }

 private:
  std::unique_ptr<Transport> inner_;
  std::shared_ptr<Observer> observer_;
  std::unique_ptr<ObservedLine> line_;
};

}  // namespace

std::unique_ptr<Transport> observe(std::unique_ptr<Transport> inner,
                                   std::shared_ptr<Observer> observer) {
  return std::make_unique<ObservedTransport>(std::move(inner), std::move(observer));
}

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

#include <utility>

#include <asio/error.hpp>

#include <sbgc/io/recorder.hpp>

namespace sbgc::io {

namespace {

/// The file and its error handler. Outlives the transport while an operation is pending.
class Log {
 public:
  Log(CaptureWriter file, RecorderOptions options)
      : file_(std::move(file)), options_(std::move(options)) {}

  void add(CaptureKind kind, std::span<const std::uint8_t> bytes) {
    if (file_.error()) return;
    report(file_.write(kind, bytes, options_.now()));
  }

  void note(const std::string& text) {
    if (file_.error()) return;
    report(file_.write_note(text, options_.now()));
  }

 private:
  void report(const Error& error) const {
    if (error && options_.on_error) options_.on_error(error);
  }

  CaptureWriter file_;
  RecorderOptions options_;
};

class RecordedLine final : public LineControl {
 public:
  RecordedLine(LineControl& inner, std::shared_ptr<Log> log)
      : inner_(inner), log_(std::move(log)) {}

  Error set(const LineSettings& settings) override {
    Error error = inner_.set(settings);
    log_->note("line: " + to_string(inner_.current()));
    return error;
  }
  LineSettings current() const override { return inner_.current(); }
  Error flush() override { return inner_.flush(); }

 private:
  LineControl& inner_;
  std::shared_ptr<Log> log_;
};

class Recorder final : public Transport {
 public:
  Recorder(std::unique_ptr<Transport> inner, CaptureWriter file, RecorderOptions options)
      : inner_(std::move(inner)), log_(std::make_shared<Log>(std::move(file), std::move(options))) {
    log_->note(inner_->description());
    if (LineControl* const line = inner_->line()) {
      line_ = std::make_unique<RecordedLine>(*line, log_);
    }
  }

  void async_read(std::span<std::uint8_t> into, Handler handler) override {
    inner_->async_read(into, [log = log_, into, handler = std::move(handler)](std::error_code error,
                                                                              std::size_t size) {
      if (size != 0) log->add(CaptureKind::from_board, into.first(size));
      if (error) log->note("read: " + text(error));
      handler(error, size);
    });
  }

  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    if (!bytes.empty()) log_->add(CaptureKind::to_board, bytes);
    inner_->async_write(bytes, [log = log_, all = bytes.size(), handler = std::move(handler)](
                                   std::error_code error, std::size_t size) {
      if (error) {
        log->note("write: " + std::to_string(size) + " of " + std::to_string(all) +
                  " bytes, then: " + text(error));
      }
      handler(error, size);
    });
  }

  void close() override { inner_->close(); }
  asio::any_io_executor executor() override { return inner_->executor(); }
  std::string description() const override { return inner_->description(); }
  LineControl* line() override { return line_.get(); }

 private:
  static std::string text(std::error_code error) {
    return error == asio::error::operation_aborted ? "closed" : error.message();
  }

  std::unique_ptr<Transport> inner_;
  std::shared_ptr<Log> log_;
  std::unique_ptr<RecordedLine> line_;
};

}  // namespace

std::unique_ptr<Transport> record(std::unique_ptr<Transport> inner, CaptureWriter file,
                                  RecorderOptions options) {
  return std::make_unique<Recorder>(std::move(inner), std::move(file), std::move(options));
}

}  // namespace sbgc::io

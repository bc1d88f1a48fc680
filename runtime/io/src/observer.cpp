#include <utility>

#include <sbgc/io/observer.hpp>

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

}  // namespace sbgc::io

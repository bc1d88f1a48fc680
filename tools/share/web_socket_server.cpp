#include "share/web_socket_server.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "hosts/fewer_reports.hpp"
#include "share/web_access.hpp"

namespace sbgc::tools {

namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
namespace net = boost::asio;
using Tcp = net::ip::tcp;

/// Includes those without a place in the bridge, until they are closed.
constexpr std::size_t max_sessions = 96;
/// The maximum number of connections without a request yet. Beyond it, the oldest is closed.
constexpr std::size_t max_strangers = 64;
constexpr std::size_t max_message = 16384;
constexpr std::size_t max_header = 8192;
constexpr std::chrono::seconds handshake_time{3};
constexpr std::chrono::seconds page_time{30};
/// The pause after a failed accept, for example because of too many open files.
constexpr std::chrono::milliseconds wait_after_failure{200};

std::string place_of(const Tcp::endpoint& endpoint) {
  const std::string host = endpoint.address().to_string();
  return (endpoint.address().is_v6() ? "[" + host + "]" : host) + ":" +
         std::to_string(endpoint.port());
}

std::string_view view(boost::string_view text) { return {text.data(), text.size()}; }

/// Makes untrusted text printable for a log.
std::string printable(std::string_view text) {
  std::string result(text.substr(0, 100));
  std::ranges::replace_if(
      result, [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

WebSocketServer::Events with_fewer_refusals(WebSocketServer::Events events) {
  events.refused = hosts::with_fewer_reports(std::move(events.refused));
  return events;
}

}  // namespace

/// All functions run on the server's thread, unless documented otherwise.
class WebSocketServer::Impl : public std::enable_shared_from_this<WebSocketServer::Impl> {
  class Session;

 public:
  Impl(WebSocketAccess who, Events all_events)
      : access(std::move(who)), events(with_fewer_refusals(std::move(all_events))) {}

  /// Throws std::runtime_error.
  void listen(const std::string& host, std::uint16_t port);
  void run();
  void stop();
  Tcp::endpoint endpoint() const { return acceptor_.local_endpoint(); }

  /// Calls `use(session)` on the server's thread if the session exists. May run on any thread.
  template <class Use>
  void with(SessionId id, Use use);
  void left(SessionId id) { sessions_.erase(id); }

  /// True if another WebSocket may connect.
  bool has_place() const { return accepted() < max_sessions; }

  const WebSocketAccess access;
  const Events events;

 private:
  std::size_t accepted() const;
  void drop_oldest_stranger();
  void accept();
  void welcome(Tcp::socket socket);

  net::io_context context_{1};
  Tcp::acceptor acceptor_{context_};
  net::steady_timer retry_{context_};
  std::map<SessionId, std::shared_ptr<Session>> sessions_;  // the oldest first
  SessionId last_id_ = 0;
  std::thread thread_;
};

/// One connection.
class WebSocketServer::Impl::Session : public std::enable_shared_from_this<Session> {
 public:
  Session(Tcp::socket socket, const std::shared_ptr<Impl>& server, SessionId id, std::string name)
      : events_(server->events),
        access_(server->access),
        server_(server),
        stream_(std::move(socket)),
        id_(id),
        name_(std::move(name)) {
    parser_.header_limit(max_header);
    parser_.body_limit(0);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() = default;

  void begin() {
    stream_.next_layer().expires_after(handshake_time);
    http::async_read(stream_.next_layer(), buffer_, parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                       if (error) return self->finish();
                       self->decide();
                     });
  }

  void read_next() {
    stream_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return self->finish();
      if (self->is_closing_) return;  // the end of the closing handshake ends the session
      if (!self->stream_.got_binary()) return self->close("binary messages only");
      const auto data = self->buffer_.cdata();
      const auto* const begin = static_cast<const std::uint8_t*>(data.data());
      Bytes bytes(begin, begin + data.size());
      self->buffer_.consume(data.size());
      self->events_.received(self->id_, std::move(bytes));
    });
  }

  void write(Bytes bytes) {
    output_ = std::move(bytes);
    stream_.binary(true);
    stream_.async_write(net::buffer(output_),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          if (error) return self->finish();
                          self->events_.written(self->id_);
                        });
  }

  /// True once it is known to be an allowed WebSocket.
  bool is_accepted() const { return is_accepted_; }

  /// Ends a connection that has sent no request yet.
  void drop() { stream_.next_layer().close(); }

  void close(const std::string& reason) {
    if (std::exchange(is_closing_, true)) return;  // the stream allows only one at a time
    stream_.async_close({websocket::close_code::policy_error, reason},
                        [self = shared_from_this()](beast::error_code) { self->finish(); });
  }

 private:
  /// Accepts the request for a WebSocket, or responds with the reason for a refusal.
  void decide() {
    const auto& request = parser_.get();
    if (!websocket::is_upgrade(request)) {
      return access_.pages.empty() ? refuse(http::status::upgrade_required) : serve_file();
    }
    // A client has to wait for the response; earlier bytes would be read without their frame.
    if (buffer_.size() != 0) return refuse(http::status::bad_request);
    if (request.count(http::field::origin) > 1) {
      events_.refused(name_ + " refused: its request has several origins");
      return refuse(http::status::bad_request);
    }
    const auto origin = request.find(http::field::origin);
    if (origin != request.end() && !is_allowed(view(origin->value()))) {
      events_.refused(name_ + " refused: pages of '" + printable(view(origin->value())) +
                      "' are not allowed; see --origin");
      return refuse(http::status::forbidden);
    }
    const auto protocols = request[http::field::sec_websocket_protocol];
    if (!access_.knows_token(view(request.target()), view(protocols))) {
      events_.refused(name_ + " refused: it does not know the token");
      return refuse(http::status::unauthorized);
    }
    // A browser fails if it offers subprotocols and none is selected.
    const bool offers_protocol = http::token_list(protocols).exists("sbgc");
    if (!protocols.empty() && !offers_protocol) {
      events_.refused(name_ + " refused: it does not offer the subprotocol 'sbgc'");
      return refuse(http::status::bad_request);
    }
    const auto server = server_.lock();
    if (server == nullptr || !server->has_place()) {
      events_.refused(name_ + " refused: all places for WebSockets are in use");
      return refuse(http::status::service_unavailable);
    }
    stream_.next_layer().expires_never();
    is_accepted_ = true;
    stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    stream_.set_option(
        websocket::stream_base::decorator([offers_protocol](websocket::response_type& response) {
          if (offers_protocol) response.set(http::field::sec_websocket_protocol, "sbgc");
        }));
    stream_.read_message_max(max_message);
    stream_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
      if (error) return self->finish();
      self->is_open_ = true;
      self->events_.opened(self->id_, self->name_);
      self->read_next();
    });
  }

  /// True for pages of the allowed sites, and for pages of this server.
  bool is_allowed(std::string_view origin) const {
    const std::string host(view(parser_.get()[http::field::host]));
    return access_.allows_origin(origin) ||
           (!access_.pages.empty() && is_loopback_host(host) && origin == "http://" + host);
  }

  /// Sends a file of the pages.
  void serve_file() {
    const auto& request = parser_.get();
    if (!is_loopback_host(view(request[http::field::host]))) return refuse(http::status::forbidden);
    if (request.method() != http::verb::get) return refuse(http::status::method_not_allowed);
    const auto file = page_file(access_.pages, view(request.target()));
    if (!file) return refuse(http::status::not_found);
    beast::error_code error;
    http::file_body::value_type body;
    body.open(file->path.c_str(), beast::file_mode::scan, error);
    if (error) return refuse(http::status::not_found);
    file_.emplace(std::piecewise_construct, std::make_tuple(std::move(body)),
                  std::make_tuple(http::status::ok, 11U));
    file_->set(http::field::content_type, file->type);
    file_->set(http::field::cache_control, "no-cache");
    file_->set("X-Content-Type-Options", "nosniff");
    file_->set("Content-Security-Policy", "frame-ancestors 'none'");
    file_->set(http::field::connection, "close");
    file_->prepare_payload();
    stream_.next_layer().expires_after(page_time);
    http::async_write(
        stream_.next_layer(), *file_,
        [self = shared_from_this()](beast::error_code, std::size_t) { self->finish(); });
  }

  void refuse(http::status status) {
    response_ = {status, 11};
    response_.set(http::field::connection, "close");
    response_.prepare_payload();
    http::async_write(
        stream_.next_layer(), response_,
        [self = shared_from_this()](beast::error_code, std::size_t) { self->finish(); });
  }

  /// Ends all operations, and the session with the last of them.
  void finish() {
    beast::error_code ignored;
    stream_.next_layer().socket().shutdown(Tcp::socket::shutdown_both, ignored);
    stream_.next_layer().close();
    const auto server = server_.lock();  // null while it is being destroyed
    if (server == nullptr || std::exchange(is_finished_, true)) return;
    server->left(id_);
    if (is_open_) events_.closed(id_);
  }

  const Events& events_;
  const WebSocketAccess& access_;
  const std::weak_ptr<Impl> server_;
  websocket::stream<beast::tcp_stream, false> stream_;  // without compression
  SessionId id_;
  std::string name_;
  bool is_accepted_ = false;
  bool is_open_ = false;
  bool is_closing_ = false;
  bool is_finished_ = false;
  http::request_parser<http::empty_body> parser_;
  http::response<http::empty_body> response_;
  std::optional<http::response<http::file_body>> file_{};
  beast::flat_buffer buffer_{max_message + max_header};
  Bytes output_;
};

template <class Use>
void WebSocketServer::Impl::with(SessionId id, Use use) {
  net::post(context_, [this, id, use = std::move(use)]() mutable {
    const auto place = sessions_.find(id);
    if (place != sessions_.end()) use(*place->second);
  });
}

void WebSocketServer::Impl::listen(const std::string& host, std::uint16_t port) {
  beast::error_code error;
  const net::ip::address place = net::ip::make_address(host, error);
  const Tcp::endpoint endpoint(place, port);
  if (!error) acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(net::socket_base::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(net::socket_base::max_listen_connections, error);
  if (error) {
    throw std::runtime_error("cannot listen on ws://" + host + ":" + std::to_string(port) + ": " +
                             error.message());
  }
}

void WebSocketServer::Impl::run() {
  accept();
  thread_ = std::thread([this] { context_.run(); });
}

void WebSocketServer::Impl::stop() {
  context_.stop();
  if (thread_.joinable()) thread_.join();
}

void WebSocketServer::Impl::accept() {
  acceptor_.async_accept([this](beast::error_code error, Tcp::socket socket) {
    if (error == net::error::operation_aborted) return;
    if (!error) {
      welcome(std::move(socket));
      return accept();
    }
    events.refused("ws: " + error.message());
    retry_.expires_after(wait_after_failure);
    retry_.async_wait([this](beast::error_code aborted) {
      if (!aborted) accept();
    });
  });
}

std::size_t WebSocketServer::Impl::accepted() const {
  const auto is_accepted = [](const auto& one) { return one.second->is_accepted(); };
  return static_cast<std::size_t>(std::ranges::count_if(sessions_, is_accepted));
}

void WebSocketServer::Impl::drop_oldest_stranger() {
  const auto oldest =
      std::ranges::find_if(sessions_, [](const auto& one) { return !one.second->is_accepted(); });
  if (oldest == sessions_.end()) return;
  oldest->second->drop();
  sessions_.erase(oldest);
}

void WebSocketServer::Impl::welcome(Tcp::socket socket) {
  beast::error_code error;
  const Tcp::endpoint peer = socket.remote_endpoint(error);
  if (error) return;  // it has left
  socket.set_option(Tcp::no_delay(true), error);
  const std::string name = "ws:" + place_of(peer);
  if (sessions_.size() - accepted() >= max_strangers) drop_oldest_stranger();
  const SessionId id = ++last_id_;
  const auto session =
      std::make_shared<Session>(std::move(socket), this->shared_from_this(), id, name);
  sessions_[id] = session;
  session->begin();
}

WebSocketServer::WebSocketServer(const std::string& host, std::uint16_t port,
                                 WebSocketAccess access, Events events)
    : impl_(std::make_shared<Impl>(std::move(access), std::move(events))) {
  impl_->listen(host, port);
  impl_->run();
}

WebSocketServer::~WebSocketServer() { impl_->stop(); }

std::string WebSocketServer::address() const { return "ws://" + place_of(impl_->endpoint()); }

bool WebSocketServer::is_loopback() const { return impl_->endpoint().address().is_loopback(); }

void WebSocketServer::read_next(SessionId session) {
  impl_->with(session, [](auto& one) { one.read_next(); });
}

void WebSocketServer::write(SessionId session, Bytes bytes) {
  impl_->with(session,
              [bytes = std::move(bytes)](auto& one) mutable { one.write(std::move(bytes)); });
}

void WebSocketServer::close(SessionId session, const std::string& reason) {
  impl_->with(session, [reason](auto& one) { one.close(reason); });
}

}  // namespace sbgc::tools

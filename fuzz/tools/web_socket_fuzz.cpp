// Fuzzes the WebSockets of the bridge: HTTP requests and frames of any bytes, sent over the
// loopback interface. The input starts with the kind of the request, followed by the bytes behind
// it; see Stranger.
//
// The server also has files of pages.
//
// Invariants: a client that does not know the token is refused; no message is longer than allowed;
// the messages of a host with a good request arrive complete and in order; every connection that
// has ended its input is closed; and another host is served meanwhile.

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "input.hpp"
#include "share/web_access.hpp"
#include "share/web_socket_server.hpp"

namespace {

using sbgc::fuzz::Input;
using sbgc::fuzz::require;
using sbgc::tools::WebSocketAccess;
using sbgc::tools::WebSocketServer;

using Bytes = WebSocketServer::Bytes;
using SessionId = WebSocketServer::SessionId;

constexpr std::string_view token = "0123456789abcdef";
constexpr std::size_t max_message = 16384;
/// The timeout for another thread; a busy machine needs a small part of it.
constexpr std::chrono::seconds patience{20};

constexpr const char* pages = "/usr/share/doc";

/// A server that sends every message back.
class Echo {
 public:
  Echo()
      : server_("127.0.0.1", 0, {std::string(token), {"http://localhost:8000"}, pages}, events()) {
    const std::string address = server_.address();
    port_ = static_cast<std::uint16_t>(std::atoi(address.c_str() + address.rfind(':') + 1));
  }

  std::uint16_t port() const { return port_; }

  /// Waits until no session but the `others` is open; returns what the last one has sent.
  Bytes last_when_closed(std::size_t others) {
    std::unique_lock lock(mutex_);
    require(changed_.wait_for(lock, patience, [&] { return open_.size() == others; }));
    return std::exchange(last_, {});
  }

 private:
  WebSocketServer::Events events() {
    return {
        .opened =
            [this](SessionId id, const std::string&) {
              const std::lock_guard lock(mutex_);
              require(open_.try_emplace(id).second);
            },
        .received =
            [this](SessionId id, Bytes bytes) {
              require(bytes.size() <= max_message);
              {
                const std::lock_guard lock(mutex_);
                Bytes& all = open_.at(id);
                all.insert(all.end(), bytes.begin(), bytes.end());
              }
              server_.write(id, std::move(bytes));
            },
        .written = [this](SessionId id) { server_.read_next(id); },
        .closed =
            [this](SessionId id) {
              const std::lock_guard lock(mutex_);
              const auto session = open_.find(id);
              require(session != open_.end());
              last_ = std::move(session->second);
              open_.erase(session);
              changed_.notify_all();
            },
        .refused = [](const std::string& reason) { require(!reason.empty()); },
    };
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<SessionId, Bytes> open_;  // what each has sent
  Bytes last_;                       // what the one that was closed last has sent
  std::uint16_t port_ = 0;
  WebSocketServer server_;  // last: its thread ends first
};

/// A connection.
class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    require(socket_ >= 0 &&
            ::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0);
    const int on = 1;
    ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  ~Client() { ::close(socket_); }

  /// The server may have closed the connection.
  void send(std::span<const std::uint8_t> bytes) const {
    while (!bytes.empty()) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) return;
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
  }
  void send(std::string_view text) const {
    send(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  }
  /// Sends a request and returns the head of the response.
  std::string ask(std::string_view request) const {
    send(request);
    std::string response;
    while (!response.ends_with("\r\n\r\n")) response += receive();
    return response;
  }
  void end_input() const { ::shutdown(socket_, SHUT_WR); }

  /// Returns the next bytes; none after the end.
  std::string receive() const {
    pollfd waiting{socket_, POLLIN, 0};
    constexpr auto ms = std::chrono::milliseconds(patience).count();
    int ready = -1;
    do {  // libFuzzer checks the time in a signal
      ready = ::poll(&waiting, 1, static_cast<int>(ms));
    } while (ready < 0 && errno == EINTR);
    require(ready == 1);
    std::array<char, 4096> buffer{};
    const ssize_t size = ::recv(socket_, buffer.data(), buffer.size(), 0);
    return {buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
  }
  std::string receive_all() const {
    std::string all;
    for (std::string part = receive(); !part.empty(); part = receive()) all += part;
    return all;
  }

 private:
  int socket_;
};

std::string good_request() {
  return "GET /?token=" + std::string(token) +
         " HTTP/1.1\r\nHost: x\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
         "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n";
}

/// A frame whose mask is 0, so that its payload is seen as it is.
Bytes frame_of(std::uint8_t first, std::span<const std::uint8_t> payload) {
  Bytes frame{first};
  if (payload.size() < 126) {
    frame.push_back(static_cast<std::uint8_t>(0x80 | payload.size()));
  } else {
    frame.insert(frame.end(), {0xFE, static_cast<std::uint8_t>(payload.size() >> 8),
                               static_cast<std::uint8_t>(payload.size() & 0xFF)});
  }
  frame.insert(frame.end(), 4, 0);
  frame.insert(frame.end(), payload.begin(), payload.end());
  return frame;
}

/// A host that behaves, for as long as the fuzzer runs.
class Regular {
 public:
  explicit Regular(std::uint16_t port) : client_(port) {
    require(client_.ask(good_request()).starts_with("HTTP/1.1 101 "));
  }

  void check() {
    const std::uint8_t number = ++number_;
    client_.send(frame_of(0x82, std::array{number}));
    std::string echo;
    while (echo.size() < 3) echo += client_.receive();
    require(echo == std::string("\x82\x01") + static_cast<char>(number));
  }

 private:
  Client client_;
  std::uint8_t number_ = 0;
};

/// The bytes that a stranger sends.
class Stranger {
 public:
  explicit Stranger(Input& input) : input_(input) {
    const std::uint8_t kind = input_.byte();
    switch (kind % 4) {
      case 0: frames(); break;
      case 1: {  // a good request, then any bytes
        request_ = good_request();
        add(input_.bytes(SIZE_MAX));
        break;
      }
      case 2: any_request(); break;
      default: add(input_.bytes(SIZE_MAX)); break;
    }
  }

  /// The bytes that it sends first; it waits for a response before it sends the text, unless this
  /// is empty.
  const std::string& request() const { return request_; }
  const std::string& text() const { return text_; }
  bool is_good() const { return is_good_; }
  const Bytes& expected() const { return expected_; }

 private:
  void add(std::span<const std::uint8_t> bytes) {
    text_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }

  /// A good request and good frames: binary messages in one or more pieces, and pings.
  void frames() {
    is_good_ = true;
    request_ = good_request();
    while (!input_.empty()) {
      const std::uint8_t code = input_.byte();
      Bytes payload;
      for (int pieces = 1 + code % 3; pieces > 0; --pieces) {
        const auto part = input_.bytes(input_.byte());
        const bool is_first = payload.empty() && pieces == 1 + code % 3;
        const int first = (pieces == 1 ? 0x80 : 0) | (is_first ? 2 : 0);
        add(frame_of(static_cast<std::uint8_t>(first), part));
        if (code >= 192) add(frame_of(0x89, part.first(std::min<std::size_t>(part.size(), 125))));
        payload.insert(payload.end(), part.begin(), part.end());
      }
      expected_.insert(expected_.end(), payload.begin(), payload.end());
    }
  }

  /// A request of which lines are replaced or missing.
  void any_request() {
    std::string request = good_request();
    for (std::size_t begin = 0; begin < request.size();) {
      const std::size_t end = request.find("\r\n", begin);
      const std::uint8_t code = input_.byte();
      if (code % 8 == 1) {
        add(input_.bytes(input_.byte()));
      } else if (code % 8 != 2) {
        text_ += request.substr(begin, end - begin);
      }
      if (code % 8 == 3) text_ += "\r\nSec-WebSocket-Protocol: sbgc, token." + std::string(token);
      if (code % 8 == 4) text_ += "\r\nOrigin: http://localhost:8000";
      text_ += "\r\n";
      begin = end + 2;
    }
    add(input_.bytes(SIZE_MAX));
  }

  Input& input_;
  std::string request_{};
  std::string text_{};
  Bytes expected_{};
  bool is_good_ = false;
};

void check_access(std::string_view text) {
  const WebSocketAccess access{std::string(token), {"http://localhost:8000"}};
  const std::string_view target = text.substr(0, text.size() / 2);
  const std::string_view protocols = text.substr(text.size() / 2);
  const bool is_there = text.find(token) != std::string_view::npos;
  require(!access.knows_token(target, protocols) || is_there);
  require(!access.allows_origin(text) || text == access.origins[0]);
  if (const auto file = sbgc::tools::page_file(pages, text)) {
    require(file->path.starts_with(pages) && file->path.find("/.") == std::string::npos);
  }
  static_cast<void>(sbgc::tools::is_loopback_host(text));
  static_cast<void>(sbgc::tools::token_problem(text));
  static_cast<void>(sbgc::tools::origin_problem(text));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Echo server;
  static Regular regular(server.port());
  Input input({data, size});
  const Stranger stranger(input);
  check_access(stranger.text());
  {
    const Client client(server.port());
    std::string response;
    if (!stranger.request().empty()) response = client.ask(stranger.request());
    client.send(stranger.text());
    client.end_input();
    regular.check();
    response += client.receive_all();
    const bool is_open = response.starts_with("HTTP/1.1 101 ");
    require(is_open == !stranger.request().empty() ||
            (is_open && stranger.text().find(token) != std::string::npos));
  }
  const Bytes received = server.last_when_closed(1);
  require(!stranger.is_good() || received == stranger.expected());
  return 0;
}

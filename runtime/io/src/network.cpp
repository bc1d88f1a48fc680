#include <algorithm>
#include <array>
#include <cerrno>
#include <future>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include <asio/ip/address.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/ip/udp.hpp>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>

#include <sbgc/internal/compiler.hpp>
#include <sbgc/io/internal/descriptor.hpp>
#include <sbgc/io/internal/stream_transport.hpp>
#include <sbgc/io/network.hpp>

namespace sbgc::io {

namespace {

using asio::ip::tcp;
using asio::ip::udp;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

std::string place_of(const std::string& host, std::uint16_t port) {
  const bool bracketed = host.find(':') != std::string::npos;
  return (bracketed ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

std::error_code translate_network(std::error_code error) {
  if (error == asio::error::eof || error == asio::error::connection_reset ||
      error == asio::error::broken_pipe) {
    return Errc::end_of_stream;
  }
  if (error == asio::error::connection_refused) return Errc::refused;
  if (error == asio::error::host_unreachable || error == asio::error::network_unreachable) {
    return Errc::unreachable;
  }
  if (error == asio::error::timed_out) return Errc::timed_out;
  return error;
}

struct Lookup {
  std::vector<asio::ip::address> addresses{};
  int status = 0;  // of getaddrinfo
};

Lookup look_up(const std::string& host) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* list = nullptr;
  Lookup result;
  result.status = getaddrinfo(host.c_str(), nullptr, &hints, &list);
  if (result.status != 0) return result;
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(list, freeaddrinfo);
  for (const addrinfo* entry = list; entry != nullptr; entry = entry->ai_next) {
    tcp::endpoint endpoint;
    if (entry->ai_addrlen > endpoint.capacity()) continue;
    sbgc::detail::copy_memory(endpoint.data(), entry->ai_addr, entry->ai_addrlen);
    endpoint.resize(entry->ai_addrlen);
    result.addresses.push_back(endpoint.address());
  }
  return result;
}

/// Looks up the addresses of a host. The name service supports no deadline, so the lookup runs on a
/// thread that is abandoned at the deadline.
Error resolve(const std::string& host, Clock::time_point deadline,
              std::vector<asio::ip::address>& addresses) {
  std::error_code not_numeric;
  const asio::ip::address numeric = asio::ip::make_address(host, not_numeric);
  if (!not_numeric) {
    addresses = {numeric};
    return {};
  }
  std::promise<Lookup> promise;
  std::future<Lookup> future = promise.get_future();
  std::thread([host, promise = std::move(promise)]() mutable {
    promise.set_value(look_up(host));
  }).detach();
  if (future.wait_until(deadline) != std::future_status::ready) {
    return {Errc::timed_out, "The name service did not find the host " + host + " in time."};
  }
  Lookup lookup = future.get();
  if (lookup.status == EAI_AGAIN) {
    return {Errc::host_not_found,
            "The host " + host + " cannot be looked up now: the name service does not answer."};
  }
  if (lookup.addresses.empty()) {
    return {Errc::host_not_found, "There is no host " + host + ": check the spelling of the name."};
  }
  addresses = std::move(lookup.addresses);
  return {};
}

/// Waits until a non-blocking socket has connected or failed to.
std::error_code wait_connected(int fd, Clock::time_point deadline) {
  pollfd waiting{fd, POLLOUT, 0};
  for (;;) {
    const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
    const int timeout = static_cast<int>(std::clamp<milliseconds::rep>(left.count(), 0, 1'000'000));
    const int ready = poll(&waiting, 1, timeout);
    if (ready > 0) break;
    if (ready == 0) return Errc::timed_out;
    if (errno != EINTR) return {errno, std::generic_category()};
  }
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size);
  return {error, asio::error::get_system_category()};
}

std::error_code connect(tcp::socket& socket, const tcp::endpoint& endpoint,
                        Clock::time_point deadline) {
  std::error_code error;
  socket.close(error);
  socket.open(endpoint.protocol(), error);
  if (!error) socket.non_blocking(true, error);
  if (error) return error;
  if (::connect(socket.native_handle(), endpoint.data(), static_cast<socklen_t>(endpoint.size())) ==
      0) {
    return {};
  }
  if (errno != EINPROGRESS && errno != EINTR) return {errno, asio::error::get_system_category()};
  return wait_connected(socket.native_handle(), deadline);
}

Error connect_error(const std::string& place, std::error_code error) {
  const std::error_code code = translate_network(error);
  if (code == Errc::refused) {
    return {code, place +
                      " refused the connection: the machine is reachable, but nothing listens on "
                      "this port."};
  }
  if (code == Errc::timed_out) return {code, place + " did not answer in time."};
  if (code == Errc::unreachable) return {code, "There is no network route to " + place + "."};
  return {code, "No connection to " + place + ": " + error.message() + "."};
}

class TcpTransport final : public detail::StreamTransport<tcp::socket> {
 public:
  TcpTransport(tcp::socket socket, std::string place)
      : StreamTransport(std::move(socket), translate_network), place_(std::move(place)) {}

  std::string description() const override { return "TCP connection to " + place_; }
  int native_handle() override { return stream().native_handle(); }

 private:
  std::string place_;
};

/// A byte stream over datagrams: reads keep the bytes that did not fit, and writes are split into
/// datagrams that no network needs to fragment.
class DatagramStream {
 public:
  explicit DatagramStream(udp::socket socket)
      : socket_(std::move(socket)), datagram_(std::make_unique<Datagram>()) {}

  using executor_type = udp::socket::executor_type;
  executor_type get_executor() { return socket_.get_executor(); }

  template <class Handler>
  void async_read_some(const asio::mutable_buffer& into, Handler&& handler) {
    if (datagram_->begin < datagram_->end) {
      asio::post(socket_.get_executor(),
                 [size = take(into), handler = std::forward<Handler>(handler)]() mutable {
                   handler(std::error_code(), size);
                 });
      return;
    }
    socket_.async_receive(asio::buffer(datagram_->bytes),
                          [this, into, handler = std::forward<Handler>(handler)](
                              std::error_code error, std::size_t size) mutable {
                            datagram_->begin = 0;
                            datagram_->end = error ? 0 : size;
                            if (!error && size == 0)
                              return async_read_some(into, std::move(handler));
                            handler(error, error ? 0 : take(into));
                          });
  }

  template <class Buffers, class Handler>
  void async_write_some(const Buffers& buffers, Handler&& handler) {
    const asio::const_buffer first = *asio::buffer_sequence_begin(buffers);
    socket_.async_send(asio::buffer(first, max_datagram), std::forward<Handler>(handler));
  }

  void close(std::error_code& error) { socket_.close(error); }
  int native_handle() { return socket_.native_handle(); }

 private:
  static constexpr std::size_t max_datagram = 1200;

  struct Datagram {
    std::array<std::uint8_t, 65536> bytes{};
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  std::size_t take(const asio::mutable_buffer& into) {
    const std::size_t size = std::min(into.size(), datagram_->end - datagram_->begin);
    sbgc::detail::copy_memory(into.data(), datagram_->bytes.data() + datagram_->begin, size);
    datagram_->begin += size;
    return size;
  }

  udp::socket socket_;
  std::unique_ptr<Datagram> datagram_;
};

class UdpTransport final : public detail::StreamTransport<DatagramStream> {
 public:
  UdpTransport(udp::socket socket, std::string place)
      : StreamTransport(DatagramStream(std::move(socket)), translate_network),
        place_(std::move(place)) {}

  std::string description() const override { return "UDP to " + place_; }
  int native_handle() override { return stream().native_handle(); }
  bool may_repeat() const override { return true; }

 private:
  std::string place_;
};

/// Takes over a socket; returns nothing if it has another protocol or is not connected.
template <class Transport, class Socket>
std::unique_ptr<Transport> take_over(const asio::any_io_executor& executor, int descriptor) {
  typename Socket::endpoint_type peer;
  auto size = static_cast<socklen_t>(peer.capacity());
  if (getpeername(descriptor, peer.data(), &size) != 0) return nullptr;
  const int family = peer.data()->sa_family;
  if (family != AF_INET && family != AF_INET6) return nullptr;
  peer.resize(size);
  Socket socket(executor);
  std::error_code error;
  socket.assign(peer.protocol(), descriptor, error);
  if (error) return nullptr;
  return std::make_unique<Transport>(std::move(socket),
                                     place_of(peer.address().to_string(), peer.port()));
}

}  // namespace

OpenResult open_tcp(const asio::any_io_executor& executor, const std::string& host,
                    std::uint16_t port, milliseconds timeout) {
  const Clock::time_point deadline = Clock::now() + timeout;
  std::vector<asio::ip::address> addresses;
  if (Error error = resolve(host, deadline, addresses)) return {nullptr, std::move(error)};
  tcp::socket socket(executor);
  std::error_code error;
  for (std::size_t left = addresses.size(); left > 0; --left) {
    // An unresponsive address must not use up the time of the remaining ones.
    const auto now = Clock::now();
    const auto share = now + (deadline - now) / static_cast<Clock::rep>(left);
    error = connect(socket, {addresses[addresses.size() - left], port}, share);
    if (!error) break;
  }
  const std::string place = place_of(host, port);
  if (error) return {nullptr, connect_error(place, error)};
  std::error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  socket.set_option(asio::socket_base::keep_alive(true), ignored);
  return {std::make_unique<TcpTransport>(std::move(socket), place), {}};
}

OpenResult open_udp(const asio::any_io_executor& executor, const std::string& host,
                    std::uint16_t port, milliseconds timeout) {
  std::vector<asio::ip::address> addresses;
  if (Error error = resolve(host, Clock::now() + timeout, addresses)) {
    return {nullptr, std::move(error)};
  }
  const std::string place = place_of(host, port);
  const udp::endpoint endpoint(addresses.front(), port);
  udp::socket socket(executor);
  std::error_code error;
  socket.open(endpoint.protocol(), error);
  if (!error) socket.connect(endpoint, error);
  if (error) return {nullptr, connect_error(place, error)};
  return {std::make_unique<UdpTransport>(std::move(socket), place), {}};
}

OpenResult adopt_socket(const asio::any_io_executor& executor, int descriptor) {
  detail::Descriptor fd(descriptor);
  int type = 0;
  socklen_t size = sizeof type;
  std::unique_ptr<Transport> transport;
  if (getsockopt(fd.get(), SOL_SOCKET, SO_TYPE, &type, &size) == 0) {
    if (type == SOCK_STREAM) transport = take_over<TcpTransport, tcp::socket>(executor, fd.get());
    if (type == SOCK_DGRAM) transport = take_over<UdpTransport, udp::socket>(executor, fd.get());
  }
  if (!transport) return {nullptr, {Errc::end_of_stream, "This socket has no connection."}};
  std::ignore = fd.release();
  return {std::move(transport), {}};
}

}  // namespace sbgc::io

// Tests of TCP and UDP on the loopback interface, with plain Asio sockets as peers.

#include <asio/ip/tcp.hpp>
#include <asio/ip/udp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <netdb.h>
#include <sys/socket.h>

#include "support.hpp"

namespace sbgc::io::test {
namespace {

using asio::ip::tcp;
using asio::ip::udp;

const asio::ip::address_v4 here = asio::ip::address_v4::loopback();

class Tcp : public Line {
 protected:
  void connect(const std::string& host = "127.0.0.1") {
    port = opened(open_tcp(context.get_executor(), host, acceptor.local_endpoint().port()));
    board = acceptor.accept();
  }

  tcp::acceptor acceptor{context, {here, 0}};
  tcp::socket board{context};
};

TEST_F(Tcp, BytesArriveUnchangedBothWays) {
  connect();
  const Bytes bytes = every_byte(16);
  EXPECT_EQ(write(context, *port, bytes).size, bytes.size());
  Bytes got(bytes.size());
  asio::read(board, asio::buffer(got));
  EXPECT_EQ(got, bytes);
  asio::write(board, asio::buffer(bytes));
  EXPECT_EQ(read_all(context, *port, bytes.size()), bytes);
  EXPECT_EQ(port->description(),
            "TCP connection to 127.0.0.1:" + std::to_string(acceptor.local_endpoint().port()));
  EXPECT_EQ(port->line(), nullptr);
}

// The system's own lookup is the reference: a plain chroot has no /etc/hosts, and so no localhost.
TEST_F(Tcp, NamesAreLookedUp) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  addrinfo* list = nullptr;
  if (getaddrinfo("localhost", nullptr, &hints, &list) != 0) {
    const OpenResult result = open_tcp(context.get_executor(), "localhost", 1);
    EXPECT_EQ(result.error.code, Errc::host_not_found) << result.error.message;
    return;
  }
  freeaddrinfo(list);
  connect("localhost");
  asio::write(board, asio::buffer("x", 1));
  EXPECT_EQ(read_all(context, *port, 1), Bytes{'x'});
}

TEST_F(Tcp, OtherSideClosesDuringRead) {
  connect();
  Pending reading(context, *port);
  board.close();
  EXPECT_EQ(reading.end().error, Errc::end_of_stream);
}

/// More than a connection takes if nobody reads.
const Bytes too_much(64 << 20);

TEST_F(Tcp, OtherSideResetsDuringReadAndWrite) {
  connect();
  Pending reading(context, *port);
  Pending writing(context, *port, too_much);
  board.set_option(asio::socket_base::linger(true, 0));
  board.close();
  EXPECT_EQ(reading.end().error, Errc::end_of_stream);
  EXPECT_EQ(writing.end().error, Errc::end_of_stream);
}

TEST_F(Tcp, CloseDuringReadAndWrite) {
  connect();
  Pending reading(context, *port);
  Pending writing(context, *port, too_much);
  port->close();
  EXPECT_EQ(reading.end().error, asio::error::operation_aborted);
  EXPECT_EQ(writing.end().error, asio::error::operation_aborted);
  Bytes into(8);
  EXPECT_EQ(read(context, *port, into).error, asio::error::operation_aborted);
}

TEST_F(Tcp, RefusedIsSaid) {
  // Binds the port without listening, so that no other program listens on it.
  board.open(tcp::v4());
  board.bind({here, 0});
  const std::uint16_t taken = board.local_endpoint().port();
  const OpenResult result = open_tcp(context.get_executor(), "127.0.0.1", taken);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error.code, Errc::refused);
  EXPECT_THAT(result.error.message, HasSubstr("127.0.0.1:" + std::to_string(taken) + " refused"));
}

TEST_F(Tcp, SilentHostIsGivenUpInTime) {
  // A listener with a full queue keeps further connections waiting.
  tcp::acceptor busy(context);
  busy.open(tcp::v4());
  busy.bind({here, 0});
  busy.listen(0);
  std::vector<tcp::socket> waiting;
  for (int i = 0; i < 8; ++i) {
    tcp::socket& socket = waiting.emplace_back(context);
    socket.open(tcp::v4());
    socket.non_blocking(true);
    const tcp::endpoint place = busy.local_endpoint();
    std::ignore =
        ::connect(socket.native_handle(), place.data(), static_cast<socklen_t>(place.size()));
  }
  const auto begin = std::chrono::steady_clock::now();
  const OpenResult result = open_tcp(context.get_executor(), "127.0.0.1",
                                     busy.local_endpoint().port(), std::chrono::milliseconds(50));
  const auto elapsed = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(result.error.code, Errc::timed_out) << result.error.message;
  EXPECT_GE(elapsed, std::chrono::milliseconds(50));
  EXPECT_LT(elapsed, patience / 2);
}

TEST_F(Tcp, UnknownHostIsSaid) {
  // "invalid" is a reserved domain that never resolves, and the empty label is illegal.
  const OpenResult result = open_tcp(context.get_executor(), "gimbal..invalid", 1);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error.code, Errc::host_not_found) << result.error.message;
  EXPECT_THAT(result.error.message, HasSubstr("gimbal..invalid"));
}

class Udp : public Line {
 protected:
  void connect() {
    port = opened(open_udp(context.get_executor(), "127.0.0.1", board.local_endpoint().port()));
    // The board learns the host's address from its first datagram.
    write(context, *port, Bytes{'?'});
    Bytes got(8);
    EXPECT_EQ(board.receive_from(asio::buffer(got), host), 1U);
  }

  void send(const Bytes& bytes) { board.send_to(asio::buffer(bytes), host); }

  udp::socket board{context, {here, 0}};
  udp::endpoint host;
};

TEST_F(Udp, DatagramsAreAStream) {
  connect();
  send({1, 2, 3});
  send({});
  send({4, 5});
  Bytes into(2);
  EXPECT_EQ(read(context, *port, into).size, 2U);
  EXPECT_EQ(into, (Bytes{1, 2}));
  EXPECT_EQ(read(context, *port, into).size, 1U);
  EXPECT_EQ(into[0], 3);
  EXPECT_EQ(read(context, *port, into).size, 2U);
  EXPECT_EQ(into, (Bytes{4, 5}));
}

TEST_F(Udp, LargeDatagramsArriveWhole) {
  connect();
  send(every_byte(200));
  EXPECT_EQ(read_all(context, *port, 256U * 200), every_byte(200));
}

TEST_F(Udp, LongWritesBecomeSeveralDatagrams) {
  connect();
  const Bytes bytes = every_byte(10);
  EXPECT_EQ(write(context, *port, bytes).size, bytes.size());
  Bytes all;
  while (all.size() < bytes.size()) {
    Bytes got(65536);
    got.resize(board.receive(asio::buffer(got)));
    EXPECT_LE(got.size(), 1200U);
    all.insert(all.end(), got.begin(), got.end());
  }
  EXPECT_EQ(all, bytes);
}

TEST_F(Udp, StrangersAreNotHeard) {
  connect();
  udp::socket stranger(context, {here, 0});
  stranger.send_to(asio::buffer("x", 1), host);
  send({7});
  EXPECT_EQ(read_all(context, *port, 1), Bytes{7});
}

TEST_F(Udp, NobodyThereIsSaid) {
  connect();
  board.connect(board.local_endpoint());  // keeps the port, but receives only from itself
  Pending reading(context, *port);
  write(context, *port, Bytes{1});
  EXPECT_EQ(reading.end().error, Errc::refused);
}

TEST_F(Udp, CloseDuringRead) {
  connect();
  Pending reading(context, *port);
  port.reset();
  EXPECT_EQ(reading.end().error, asio::error::operation_aborted);
}

}  // namespace
}  // namespace sbgc::io::test

// Tests of transports over lines that another transport has opened.

#include <asio/ip/tcp.hpp>
#include <asio/ip/udp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "support.hpp"

namespace sbgc::io::test {
namespace {

using asio::ip::tcp;
using asio::ip::udp;

class Adopt : public Line {
 protected:
  /// Opens the line, adopts a duplicate of its descriptor, and destroys the first transport.
  std::unique_ptr<Transport> inherited(std::unique_ptr<Transport> line) {
    const std::string description = line->description();
    const int copy = fcntl(line->native_handle(), F_DUPFD_CLOEXEC, 0);
    EXPECT_GE(copy, 0);
    line.reset();
    context.poll();
    auto adopted = opened(adopt(context.get_executor(), copy));
    EXPECT_EQ(adopted->description(), description);
    EXPECT_EQ(adopted->native_handle(), copy);
    return adopted;
  }
};

TEST_F(Adopt, ASerialPortKeepsItsSettingsAndItsLock) {
  const auto board = opened(open_pseudo_terminal(context.get_executor(), {}));
  const LineSettings settings{57600};
  port = inherited(opened(open_serial(context.get_executor(), board->path(), settings)));
  EXPECT_EQ(board->other_line(), settings);
  ASSERT_NE(port->line(), nullptr);
  EXPECT_EQ(port->line()->current(), settings);
  expect_arrival(context, *port, *board, every_byte());
  expect_arrival(context, *board, *port, every_byte());
  EXPECT_EQ(open_serial(context.get_executor(), board->path()).error.code, Errc::busy);
  port.reset();
  context.poll();
  EXPECT_TRUE(open_serial(context.get_executor(), board->path()));
}

TEST_F(Adopt, ATcpConnectionStaysOpen) {
  tcp::acceptor acceptor{context, {asio::ip::address_v4::loopback(), 0}};
  port = inherited(
      opened(open_tcp(context.get_executor(), "127.0.0.1", acceptor.local_endpoint().port())));
  tcp::socket board = acceptor.accept();
  write(context, *port, every_byte());
  Bytes got(256);
  asio::read(board, asio::buffer(got));
  EXPECT_EQ(got, every_byte());
  asio::write(board, asio::buffer(got));
  EXPECT_EQ(read_all(context, *port, got.size()), got);
}

TEST_F(Adopt, UdpKeepsBothAddresses) {
  udp::socket board{context, {asio::ip::address_v4::loopback(), 0}};
  port = opened(open_udp(context.get_executor(), "127.0.0.1", board.local_endpoint().port()));
  write(context, *port, Bytes{1});
  Bytes got(1);
  udp::endpoint first;
  board.receive_from(asio::buffer(got), first);
  port = inherited(std::move(port));
  write(context, *port, Bytes{2});
  udp::endpoint second;
  board.receive_from(asio::buffer(got), second);
  EXPECT_EQ(got, Bytes{2});
  EXPECT_EQ(second, first);
  board.send_to(asio::buffer("x", 1), second);
  EXPECT_EQ(read_all(context, *port, 1), Bytes{'x'});
}

TEST_F(Adopt, WhatIsNoLineIsClosed) {
  const int file = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  EXPECT_EQ(adopt(context.get_executor(), file).error.code, Errc::not_a_port);
  EXPECT_EQ(fcntl(file, F_GETFD), -1);
  const int lonely = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  EXPECT_EQ(adopt(context.get_executor(), lonely).error.code, Errc::end_of_stream);
  EXPECT_EQ(fcntl(lonely, F_GETFD), -1);
  EXPECT_EQ(adopt(context.get_executor(), -1).error.code, Errc::not_a_port);
}

TEST_F(Adopt, ALineWithoutADescriptorSaysSo) {
  make_pair();
  EXPECT_EQ(port->native_handle(), -1);
}

}  // namespace
}  // namespace sbgc::io::test

// Tests of transports over lines that another transport has opened.

#include <stdexcept>
#include <string>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/ip/udp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include <sbgc/io/memory.hpp>
#include <sbgc/io/network.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/io/pseudo_terminal.hpp>
#include <sbgc/io/serial.hpp>

#include "support.hpp"

namespace sbgc::io::test {
namespace {

using asio::ip::tcp;
using asio::ip::udp;

class Adopt : public testing::Test {
 protected:
  /// Opens the line, adopts a duplicate of its descriptor, and destroys the first transport.
  std::unique_ptr<Transport> inherited(OpenResult opened) {
    if (!opened) throw std::runtime_error(opened.error.message);
    const std::string description = opened.transport->description();
    const int copy = fcntl(opened.transport->native_handle(), F_DUPFD_CLOEXEC, 0);
    EXPECT_GE(copy, 0);
    opened.transport.reset();
    context.poll();
    OpenResult adopted = adopt(context.get_executor(), copy);
    if (!adopted) throw std::runtime_error(adopted.error.message);
    EXPECT_EQ(adopted.transport->description(), description);
    EXPECT_EQ(adopted.transport->native_handle(), copy);
    return std::move(adopted.transport);
  }

  asio::io_context context;
};

TEST_F(Adopt, ASerialPortKeepsItsSettingsAndItsLock) {
  PseudoTerminalResult board = open_pseudo_terminal(context.get_executor(), {});
  ASSERT_TRUE(board);
  const std::string path = board.transport->path();
  const LineSettings settings{57600};
  {
    const auto port = inherited(open_serial(context.get_executor(), path, settings));
    EXPECT_EQ(board.transport->other_line(), settings);
    ASSERT_NE(port->line(), nullptr);
    EXPECT_EQ(port->line()->current(), settings);
    write(context, *port, every_byte());
    EXPECT_EQ(read_all(context, *board.transport, 256), every_byte());
    write(context, *board.transport, every_byte());
    EXPECT_EQ(read_all(context, *port, 256), every_byte());
    EXPECT_EQ(open_serial(context.get_executor(), path).error.code, Errc::busy);
  }
  context.poll();
  EXPECT_TRUE(open_serial(context.get_executor(), path));
}

TEST_F(Adopt, ATcpConnectionStaysOpen) {
  tcp::acceptor acceptor{context, {asio::ip::address_v4::loopback(), 0}};
  const auto port =
      inherited(open_tcp(context.get_executor(), "127.0.0.1", acceptor.local_endpoint().port()));
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
  OpenResult opened = open_udp(context.get_executor(), "127.0.0.1", board.local_endpoint().port());
  ASSERT_TRUE(opened);
  write(context, *opened.transport, Bytes{1});
  Bytes got(1);
  udp::endpoint first;
  board.receive_from(asio::buffer(got), first);
  const auto port = inherited(std::move(opened));
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
  const MemoryPair pair = make_memory_pair(context.get_executor());
  EXPECT_EQ(pair.first->native_handle(), -1);
}

}  // namespace
}  // namespace sbgc::io::test

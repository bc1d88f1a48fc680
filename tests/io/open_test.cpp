// Tests of address strings: their meaning, and the errors for malformed ones; and of transports
// over lines that another transport has opened.

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

Address parsed(std::string_view text) {
  const AddressResult result = parse_address(text);
  EXPECT_TRUE(result) << result.error.message;
  return result.address;
}

std::string complaint(std::string_view text) {
  const AddressResult result = parse_address(text);
  EXPECT_EQ(result.error.code, Errc::bad_address) << text;
  const std::string begin = "The address '" + std::string(text) + "' is malformed: ";
  EXPECT_EQ(result.error.message.substr(0, begin.size()), begin);
  return result.error.message.substr(std::min(begin.size(), result.error.message.size()));
}

TEST(Address, Serial) {
  EXPECT_EQ(parsed("/dev/ttyUSB0"), Address(SerialAddress{"/dev/ttyUSB0"}));
  EXPECT_EQ(parsed("./link"), Address(SerialAddress{"./link"}));
  EXPECT_EQ(parsed("serial:link"), Address(SerialAddress{"link"}));
  EXPECT_EQ(parsed("/dev/serial/by-id/usb-Silicon_Labs_CP2102:1.0-port0"),
            Address(SerialAddress{"/dev/serial/by-id/usb-Silicon_Labs_CP2102:1.0-port0"}));
  EXPECT_EQ(parsed("serial:/dev/ttyUSB0?baud=57600&parity=even"),
            Address(SerialAddress{"/dev/ttyUSB0", {57600, Parity::even}}));
  EXPECT_EQ(parsed("/dev/ttyS1?parity=none"), Address(SerialAddress{"/dev/ttyS1"}));
}

TEST(Address, Network) {
  EXPECT_EQ(parsed("tcp:gimbal.local:5000"), Address(TcpAddress{"gimbal.local", 5000}));
  EXPECT_EQ(parsed("tcp:[fe80::1%eth0]:65535"), Address(TcpAddress{"fe80::1%eth0", 65535}));
  EXPECT_EQ(parsed("udp:10.0.0.1:1"), Address(UdpAddress{"10.0.0.1", 1}));
}

TEST(Address, Others) {
  EXPECT_EQ(parsed("pty:"), Address(PtyAddress{}));
  EXPECT_EQ(parsed("capture:a.sbgc"), Address(CaptureAddress{"a.sbgc"}));
  EXPECT_EQ(parsed("capture:a?b.sbgc?timing=fast"),
            Address(CaptureAddress{"a?b.sbgc", ReplayTiming::fast}));
  EXPECT_EQ(parsed("capture:/x:y?timing=original"), Address(CaptureAddress{"/x:y"}));
}

TEST(Address, MalformedOnesAreExplained) {
  EXPECT_EQ(complaint(""), "it is empty.");
  EXPECT_EQ(complaint("ttyUSB0"), "a port is written with its path, such as /dev/ttyUSB0.");
  EXPECT_EQ(complaint("tpc:host:1"),
            "unknown kind 'tpc'; kinds are serial, tcp, udp, pty and capture.");
  EXPECT_EQ(complaint("serial:"), "the path is missing.");
  EXPECT_EQ(complaint("serial:?baud=1"), "the path is missing.");
  EXPECT_EQ(complaint("/dev/x?baud=fast"), "'fast' is not a baud rate.");
  EXPECT_EQ(complaint("/dev/x?baud=0"), "'0' is not a baud rate.");
  EXPECT_EQ(complaint("/dev/x?baud=-1"), "'-1' is not a baud rate.");
  EXPECT_EQ(complaint("/dev/x?baud=4294967296"), "'4294967296' is not a baud rate.");
  EXPECT_EQ(complaint("/dev/x?baud=9600 "), "'9600 ' is not a baud rate.");
  EXPECT_EQ(complaint("/dev/x?parity=odd"), "'odd' is not a parity; parities are none and even.");
  EXPECT_EQ(complaint("/dev/x?speed=9600"),
            "unknown option 'speed'; options are baud=NUMBER and parity=none|even.");
  EXPECT_EQ(complaint("/dev/x?"),
            "'' is not an option; options are baud=NUMBER and parity=none|even.");
  EXPECT_EQ(complaint("/dev/x?baud=9600&baud=9600"), "'baud' occurs twice.");
  EXPECT_EQ(complaint("tcp:host"), "the port is missing; write HOST:PORT.");
  EXPECT_EQ(complaint("tcp:[::1]"), "the port is missing; write HOST:PORT.");
  EXPECT_EQ(complaint("tcp::5000"), "the host is missing; write HOST:PORT.");
  EXPECT_EQ(complaint("tcp:[::1:5000"), "the ']' after the IPv6 address is missing.");
  EXPECT_EQ(complaint("udp:fe80::1:5000"), "an IPv6 address needs brackets; write [ADDRESS]:PORT.");
  EXPECT_EQ(complaint("tcp://host:1"), "slashes before the host are not allowed.");
  for (const std::string port : {"", "0", "65536", "http", "1x", "+1"}) {
    EXPECT_EQ(complaint("tcp:host:" + port), "'" + port + "' is not a port; ports are 1 to 65535.");
  }
  EXPECT_EQ(complaint("pty:/dev/pts/1"), "nothing may follow 'pty:'.");
  EXPECT_EQ(complaint("capture:x?timing=slow"),
            "'slow' is not a timing; timings are original and fast.");
}

TEST(Address, WithoutItsKindItIsCompletedInTheMessage) {
  for (const std::string text :
       {"127.0.0.1:5055", "localhost:1", "gimbal.local:5000", "[::1]:5055"}) {
    EXPECT_EQ(complaint(text), "the kind is missing; write tcp:" + text + " or udp:" + text + ".");
    EXPECT_TRUE(parse_address("tcp:" + text)) << "what it says works";
    EXPECT_TRUE(parse_address("udp:" + text));
  }
  for (const std::string text : {"5055", ":5055"}) {
    EXPECT_EQ(complaint(text), "the host is missing; write tcp:HOST:5055.");
  }
  for (const std::string text : {"::1:5055", "fe80::1"}) {
    EXPECT_EQ(complaint(text), "an IPv6 address needs brackets; write [ADDRESS]:PORT.");
  }
  EXPECT_EQ(complaint("[::1]"), "the port is missing; write HOST:PORT.");
  EXPECT_EQ(complaint("host:65536"), "'65536' is not a port; ports are 1 to 65535.");
  for (const std::string text : {"192.168.1.5", "gimbal.local", "flight.sbgc"}) {
    EXPECT_EQ(complaint(text),
              "write tcp:" + text + ":PORT for a host, capture:" + text + " for a file.");
  }
  EXPECT_EQ(complaint("pty"), "write pty:.");
  EXPECT_THAT(complaint("http://host:1"), HasSubstr("unknown kind 'http'"));
}

TEST(Address, PortsOfWindowsAreExplained) {
  for (const std::string text :
       {"COM3", "com12", "COM3:", "\\\\.\\COM10", "serial:COM3", "serial:COM3?baud=9600"}) {
    EXPECT_THAT(complaint(text), HasSubstr("it is a port of Windows, where sbgc only")) << text;
  }
  EXPECT_EQ(complaint("COMA"), "a port is written with its path, such as /dev/COMA.");
  EXPECT_EQ(complaint("COM"), "a port is written with its path, such as /dev/COM.");
}

TEST(Address, WordsAreOfAnyCase) {
  EXPECT_EQ(parsed("TCP:Host:1"), Address(TcpAddress{"Host", 1}));
  EXPECT_EQ(parsed("Serial:/dev/ttyS1?parity=Even"),
            Address(SerialAddress{"/dev/ttyS1", {default_line.baud_rate, Parity::even}}));
  EXPECT_EQ(parsed("Capture:X?timing=FAST"), Address(CaptureAddress{"X", ReplayTiming::fast}));
}

TEST(Open, PassesTheSettingsOn) {
  asio::io_context context;
  const OpenResult board = open(context.get_executor(), "pty:");
  ASSERT_TRUE(board);
  const std::string description = board.transport->description();
  const std::string path = description.substr(description.find('/'));
  const OpenResult port = open(context.get_executor(), path + "?baud=38400");
  ASSERT_TRUE(port) << port.error.message;
  EXPECT_EQ(port.transport->line()->current(), LineSettings{38400});
  write(context, *port.transport, Bytes{1, 2});
  EXPECT_EQ(read_all(context, *board.transport, 2), (Bytes{1, 2}));
}

TEST(Open, NoSuchCapture) {
  asio::io_context context;
  const OpenResult result = open(context.get_executor(), "capture:/nowhere/x.sbgc");
  EXPECT_EQ(result.error.code, Errc::no_such_port);
  EXPECT_THAT(result.error.message, HasSubstr("/nowhere/x.sbgc"));
}

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

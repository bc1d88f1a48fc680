// Tests of serial ports, simulated by real pseudo-terminals.

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "../client/temporary_folder.hpp"
#include "support.hpp"

namespace sbgc::io::test {
namespace {

/// A serial port and the pseudo-terminal behind it.
class Serial : public Line {
 protected:
  void play(const PseudoTerminalOptions& options = {}) {
    board = opened(open_pseudo_terminal(context.get_executor(), options));
  }

  void open(const LineSettings& settings = default_line) {
    if (!board) play();
    port = opened(open_serial(context.get_executor(), board->path(), settings));
  }

  /// Returns the settings as seen by another program.
  termios seen() const {
    termios result{};
    const int fd = ::open(board->path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    EXPECT_GE(fd, 0);
    EXPECT_EQ(tcgetattr(fd, &result), 0);
    ::close(fd);
    return result;
  }

  std::unique_ptr<PseudoTerminal> board;
};

TEST_F(Serial, EveryByteArrivesUnchangedBothWays) {
  open();
  const Bytes bytes = every_byte(8);
  Operation to_board;
  Operation to_host;
  port->async_write(bytes, to_board.handler());
  board->async_write(bytes, to_host.handler());
  EXPECT_EQ(read_all(context, *board, bytes.size()), bytes);
  EXPECT_EQ(read_all(context, *port, bytes.size()), bytes);
  EXPECT_EQ(finish(context, to_board).size, bytes.size());
  EXPECT_EQ(finish(context, to_host).size, bytes.size());
}

TEST_F(Serial, NothingIsEchoed) {
  open();
  expect_arrival(context, *board, *port, every_byte());
  expect_arrival(context, *port, *board, {42});  // an echo would precede this
}

TEST_F(Serial, LeavesNothingOfWhatATerminalDoes) {
  play();
  {
    // The worst settings that another program can leave behind.
    const int fd = ::open(board->path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios bad{};
    tcgetattr(fd, &bad);
    bad.c_iflag = ICRNL | INLCR | IGNCR | IXON | IXOFF | IXANY | ISTRIP | INPCK | PARMRK | BRKINT;
    bad.c_oflag = OPOST | ONLCR;
    bad.c_lflag = ECHO | ECHONL | ICANON | ISIG | IEXTEN;
    bad.c_cflag = CS7 | CRTSCTS | HUPCL | CSTOPB;
    bad.c_cc[VMIN] = 0;
    bad.c_cc[VTIME] = 5;
    ASSERT_EQ(tcsetattr(fd, TCSANOW, &bad), 0);
    ::close(fd);
  }
  open();
  const termios now = seen();
  EXPECT_EQ(now.c_iflag & (ICRNL | INLCR | IGNCR | IXON | IXOFF | IXANY | ISTRIP | INPCK | PARMRK |
                           BRKINT | IGNBRK),
            0U);
  EXPECT_EQ(now.c_oflag & OPOST, 0U);
  EXPECT_EQ(now.c_lflag & (ECHO | ECHONL | ICANON | ISIG | IEXTEN), 0U);
  EXPECT_EQ(now.c_cflag & (CSIZE | CRTSCTS | HUPCL | CSTOPB | PARENB | CREAD | CLOCAL),
            tcflag_t{CS8 | CREAD | CLOCAL});
  EXPECT_EQ(now.c_cc[VMIN], 1);
  EXPECT_EQ(now.c_cc[VTIME], 0);
  expect_arrival(context, *port, *board, every_byte());
}

TEST_F(Serial, StandardRateHasItsConstant) {
  open({57600});
  const termios now = seen();
  EXPECT_EQ(cfgetospeed(&now), speed_t{B57600});
  EXPECT_EQ(cfgetispeed(&now), speed_t{B57600});
  EXPECT_EQ(board->other_line(), LineSettings{57600});
}

TEST_F(Serial, AnyRate) {
  open({250000});
  EXPECT_EQ(board->other_line(), LineSettings{250000});
  ASSERT_NE(port->line(), nullptr);
  for (const std::uint32_t rate : {1U, 12345U, 115200U, 256000U, 3333333U, 12000000U}) {
    EXPECT_FALSE(port->line()->set({rate})) << rate;
    EXPECT_EQ(board->other_line(), LineSettings{rate});
    EXPECT_EQ(port->line()->current(), LineSettings{rate});
    EXPECT_EQ(port->description(),
              "serial port " + board->path() + ", " + std::to_string(rate) + " 8N1");
  }
}

TEST_F(Serial, RateZeroIsRefused) {
  open();
  EXPECT_EQ(port->line()->set({0}).code, Errc::line_refused);
  EXPECT_EQ(port->line()->current(), default_line);
}

TEST_F(Serial, WhatTheDriverDoesNotDoIsNoticed) {
  // A pseudo-terminal silently ignores parity, which only reading the settings back reveals.
  open();
  const Error error = port->line()->set({19200, Parity::even});
  EXPECT_EQ(error.code, Errc::line_refused);
  EXPECT_THAT(error.message, HasSubstr("does not support 19200 8E1"));
  EXPECT_THAT(error.message, HasSubstr("set 19200 8N1 instead."));
  EXPECT_EQ(port->line()->current(), LineSettings{19200});
  // The port still works.
  expect_arrival(context, *port, *board, Bytes{1});
  port.reset();
  const OpenResult opened =
      open_serial(context.get_executor(), board->path(), {9600, Parity::even});
  EXPECT_FALSE(opened);
  EXPECT_EQ(opened.error.code, Errc::line_refused);
}

TEST_F(Serial, OpeningDiscardsWhatCameBefore) {
  play({.stays_open = true});
  write(context, *board, Bytes{1, 2, 3});
  // The bytes have arrived once the kernel has passed on the first one.
  const int fd = ::open(board->path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  std::uint8_t byte = 0;
  ASSERT_EQ(::read(fd, &byte, 1), 1);
  ::close(fd);
  open();
  expect_arrival(context, *board, *port, Bytes{9});
}

TEST_F(Serial, FlushDiscards) {
  open();
  write(context, *board, Bytes{1, 2, 3});
  EXPECT_EQ(read_all(context, *port, 1), Bytes{1});  // so the others have arrived, too
  EXPECT_FALSE(port->line()->flush());
  expect_arrival(context, *board, *port, Bytes{9});
}

TEST_F(Serial, OtherSideGoesAwayDuringRead) {
  open();
  Pending reading(context, *port);
  board.reset();
  EXPECT_EQ(reading.end().error, Errc::device_lost);
  Bytes into(16);  // the error persists
  EXPECT_EQ(read(context, *port, into).error, Errc::device_lost);
  EXPECT_EQ(write(context, *port, into).error, Errc::device_lost);
}

/// More than a line takes if nobody reads.
const Bytes much(1 << 20);

TEST_F(Serial, OtherSideGoesAwayDuringWrite) {
  open();
  Pending writing(context, *port, much);
  board->close();
  const Outcome outcome = writing.end();
  EXPECT_EQ(outcome.error, Errc::device_lost);
  EXPECT_LT(outcome.size, much.size());
}

TEST_F(Serial, ClosedOrDestroyedDuringReadAndWrite) {
  for (const bool is_destroyed : {false, true}) {
    open();
    Pending reading(context, *port);
    Pending writing(context, *port, much);
    if (is_destroyed) {
      port.reset();
    } else {
      port->close();
      port->close();
    }
    EXPECT_EQ(reading.end().error, asio::error::operation_aborted);
    EXPECT_EQ(writing.end().error, asio::error::operation_aborted);
    if (is_destroyed) return;
    Bytes into(16);
    EXPECT_EQ(read(context, *port, into).error, asio::error::operation_aborted);
    EXPECT_EQ(write(context, *port, into).error, asio::error::operation_aborted);
    EXPECT_TRUE(port->line()->set({9600}));
    EXPECT_TRUE(port->line()->flush());
    board.reset();
  }
}

TEST_F(Serial, DestroyedWhileAWriteIsHalfDone) {
  // Part of the data has been written and the completion is queued when the port is destroyed.
  open();
  Pending writing(context, *port, much);
  Bytes into(4096);
  for (int i = 0; i < 20; ++i) read(context, *board, into);
  port.reset();
  EXPECT_EQ(writing.end().error, asio::error::operation_aborted);
}

TEST_F(Serial, IsExclusive) {
  open();
  const OpenResult second = open_serial(context.get_executor(), board->path());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error.code, Errc::busy);
  EXPECT_THAT(second.error.message, HasSubstr(board->path() + " is in use"));
  // The first one is not affected.
  expect_arrival(context, *board, *port, Bytes{1});
  port.reset();
  open();
}

TEST_F(Serial, BusyTellsWho) {
  open();
  // A child holds the port; this process no longer does.
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    ::close(pipe[1]);
    char byte = 0;
    _exit(::read(pipe[0], &byte, 1) == 0 ? 0 : 1);  // until the parent closes its end
  }
  ::close(pipe[0]);
  port.reset();
  const OpenResult second = open_serial(context.get_executor(), board->path());
  EXPECT_FALSE(second);
  EXPECT_EQ(second.error.code, Errc::busy);
  EXPECT_THAT(second.error.message, HasSubstr("(process " + std::to_string(child) + ")"));
  ::close(pipe[1]);
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  open();
}

TEST_F(Serial, CanBeOpenedAgainAfterClosing) {
  play({.stays_open = true});
  for (const std::uint8_t value : Bytes{1, 2, 3}) {
    open();
    expect_arrival(context, *port, *board, Bytes{value});
    port->close();
  }
}

TEST(SerialErrors, NoSuchPort) {
  asio::io_context context;
  const OpenResult result = open_serial(context.get_executor(), "/dev/ttyNONE7");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error.code, Errc::no_such_port);
  EXPECT_THAT(result.error.message, StartsWith("There is no port /dev/ttyNONE7. "));
  EXPECT_THAT(result.error.message,
              AnyOf(HasSubstr("Available ports:\n  /dev/"), HasSubstr("plugged in?")));
}

TEST(SerialErrors, NotASerialPort) {
  asio::io_context context;
  const auto complaint = [&](const std::string& path) {
    const OpenResult result = open_serial(context.get_executor(), path);
    EXPECT_EQ(result.error.code, Errc::not_a_port) << path;
    return result.error.message;
  };
  EXPECT_EQ(complaint("/dev"), "/dev is not a serial port.");
  EXPECT_EQ(complaint("/dev/null"), "/dev/null is not a serial port.");
  EXPECT_EQ(complaint("/etc/passwd"),
            "/etc/passwd is not a serial port; write capture:/etc/passwd for a capture.");
}

TEST(SerialErrors, APipeDoesNotBlock) {
  const sbgc::test::TemporaryFolder folder;
  const std::string path = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  asio::io_context context;
  EXPECT_EQ(open_serial(context.get_executor(), path).error.code, Errc::not_a_port);
}

TEST(SerialErrors, PermissionSaysWhatToDo) {
  const auto message = [](const DeviceOwner& owner) {
    const Error error = permission_error("/dev/ttyUSB0", owner);
    EXPECT_EQ(error.code, Errc::permission_denied);
    return error.message;
  };
  EXPECT_EQ(message({"dialout", true, false}),
            "You do not have permission to open /dev/ttyUSB0. Add yourself to the group dialout: "
            "sudo usermod -aG dialout $USER, then log in again.");
  EXPECT_THAT(message({"dialout", true, true}), HasSubstr("log out and in again"));
  EXPECT_THAT(message({"dialout", false, false}), HasSubstr("udev rule"));
  EXPECT_THAT(message({"root", true, false}), HasSubstr("udev rule"));
}

TEST(SerialErrors, PermissionDeniedIsRecognised) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root to become another user";
  asio::io_context context;
  const PseudoTerminalResult board = open_pseudo_terminal(context.get_executor());
  ASSERT_TRUE(board);
  ASSERT_EQ(chmod(board.transport->path().c_str(), 0600), 0);
  if (seteuid(65534) != 0) GTEST_SKIP() << "the user nobody does not exist";
  const OpenResult result = open_serial(context.get_executor(), board.transport->path());
  ASSERT_EQ(seteuid(0), 0);
  EXPECT_EQ(result.error.code, Errc::permission_denied);
  EXPECT_THAT(result.error.message, HasSubstr("You do not have permission to open /dev/pts/"));
}

using PseudoTerminals = Serial;

TEST_F(PseudoTerminals, LoseWhatNobodyReadsIfTheyStayOpen) {
  play({.stays_open = true});
  const Outcome outcome = write(context, *board, much);
  EXPECT_FALSE(outcome.error);
  EXPECT_EQ(outcome.size, much.size());
}

TEST_F(PseudoTerminals, StayOpen) {
  play({.stays_open = true});
  Pending reading(context, *board);
  open();
  port.reset();
  reading.expect_waiting();
  open();
  write(context, *port, Bytes{5});
  EXPECT_EQ(reading.end().size, 1U);
  EXPECT_EQ(reading.bytes()[0], 5);
}

TEST_F(PseudoTerminals, OtherSideCloses) {
  open();
  Pending reading(context, *board);
  port.reset();
  EXPECT_EQ(reading.end().error, Errc::device_lost);
}

TEST_F(PseudoTerminals, Describe) {
  play();
  EXPECT_EQ(board->description(), "pseudo-terminal " + board->path());
  EXPECT_THAT(board->path(), StartsWith("/dev/pts/"));
  EXPECT_EQ(board->other_line(), default_line);
  board->close();
  EXPECT_EQ(board->other_line(), std::nullopt);
}

}  // namespace
}  // namespace sbgc::io::test

#include <cstdio>

#include <asio/io_context.hpp>

#include <sbgc/io/open.hpp>
#include <sbgc/io/ports.hpp>

int main() {
  asio::io_context context;
  const sbgc::io::OpenResult board = sbgc::io::open(context.get_executor(), "pty:");
  if (!board) std::puts(board.error.message.c_str());
  return board && !sbgc::io::list_ports().error ? 0 : 1;
}

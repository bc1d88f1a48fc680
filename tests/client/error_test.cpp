// Tests of printing errors.

#include <sstream>

#include <gtest/gtest.h>

#include <sbgc/error.hpp>
#include <sbgc/io/error.hpp>
#include <sbgc/ostream.hpp>

namespace sbgc {
namespace {

TEST(Error, PrintsItsMessage) {
  std::ostringstream text;
  text << ClientError{ErrorCode::timeout, "no answer"} << '|' << ErrorCode::link_lost << '|'
       << io::Error{io::Errc::busy, "ttyUSB0 is in use."};
  EXPECT_EQ(text.str(), "no answer|link_lost|ttyUSB0 is in use.");
}

}  // namespace
}  // namespace sbgc

#include <sbgc/client/board_identity.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/meta/system.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>
#include <sbgc/text/leaves.hpp>

namespace sbgc {

std::string BoardIdentity::firmware_version() const {
  return to_string(msg::FirmwareVersion(versions().firmware));
}

std::string BoardIdentity::board_version() const {
  return to_string(msg::BoardVersion(versions().board));
}

std::string BoardIdentity::firmware_problem() const {
  std::string problem;
  for_each_leaf(info, [&](const Leaf& leaf) {
    const char* const meaning = special_meaning(leaf);
    if (meaning != nullptr && leaf.integer == versions().firmware) problem = meaning;
  });
  return problem;
}

std::string BoardIdentity::serial_number() const {
  return details ? detail::to_hex(roles::serial_number(*details)) : "";
}

}  // namespace sbgc

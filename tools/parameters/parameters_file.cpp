#include "parameters/parameters_file.hpp"

#include <fmt/format.h>

#include <sbgc/internal/foreign_kind.hpp>
#include <sbgc/io/internal/atomic_file.hpp>
#include <sbgc/io/internal/own_file.hpp>
#include <sbgc/parse_json.hpp>

#include "board/connection.hpp"
#include "command/remark.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

VendorValues ParametersFile::values(const ParameterSet& present, std::uint8_t target) {
  if (!vendor) return {backup.parameters, {}, {}};
  Result<VendorValues> result = vendor_values(*vendor, present, target);
  if (!result) {
    throw CommandError(fmt::format("{}: {}", printable(name), result.error().message));
  }
  const std::string text = has_told ? "" : left_out_text(*result);
  has_told = true;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    remark("{}\n", wrapped(fmt::format("note: {}", text.substr(at, end - at)), line_width(), 2, 2));
    at = end + 1;
  }
  return *std::move(result);
}

bool is_parameters_file(const std::string& word) {
  return word.ends_with(".json") || word.ends_with(".profile");
}

ParametersFile load_parameters_file(const std::string& name) {
  const std::string content = value_of(detail::read_whole_file(name, JsonLimits{}.size));
  ParametersFile result{.name = name};
  const auto fail_with = [&](const ClientError& error) {
    ClientError named = error;
    named.message = fmt::format("{}: {}", name, error.message);
    fail(named);
  };
  if (detail::foreign_kind(content) == detail::vendor_xml) {
    Result<VendorFile> vendor = parse_vendor_file(content);
    if (!vendor) {
      fail_with(
          {vendor.error().code, fmt::format("{}: {}", detail::vendor_xml, vendor.error().message)});
    }
    result.backup.board = vendor->board;
    result.vendor = *std::move(vendor);
  } else {
    Result<Backup> backup = parse_backup(content);
    if (!backup) fail_with(backup.error());
    result.backup = *std::move(backup);
  }
  return result;
}

}  // namespace sbgc::tools

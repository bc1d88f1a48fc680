// Fuzzes the reader of files of the vendor's program, with bombs (see hostile_text.hpp). Every text
// is refused with a message, or changes only the fields that it is said to hold; in time in
// proportion to its size.

#include <sbgc/client/parameters.hpp>

#include "hostile_text.hpp"
#include "input.hpp"
#include "parameters/vendor_values.hpp"

namespace {

using namespace sbgc::tools;  // NOLINT(google-build-using-namespace): a fuzzer of them
using sbgc::fuzz::require;

void check(const std::string& text) {
  static const sbgc::ParameterSet present = empty_parameters({0xFFFF, 0xFF});
  const sbgc::Result<VendorFile> file = parse_vendor_file(text);
  if (!file) return require(!file.error().message.empty());
  require(!file->profiles.empty() && file->profiles.size() <= 5);
  const sbgc::Result<VendorValues> values = vendor_values(*file, present, 2);
  if (!values) return require(!values.error().message.empty());
  for (const sbgc::ParametersChange& block : diff(present, values->parameters)) {
    if (block.kind != sbgc::ParametersChange::Kind::changed) continue;
    for (const sbgc::FieldChange& field : block.fields) {
      require(std::ranges::find(values->fields, std::pair{block.id.message, field.path}) !=
              values->fields.end());
    }
  }
  require(left_out_text(*values).empty() == values->left_out.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = sbgc::fuzz::text_with_bombs({data, size});
  sbgc::fuzz::require_linear_time(text.size(), std::chrono::microseconds(20), [&] { check(text); });
  return 0;
}

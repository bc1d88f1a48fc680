#include "parameters/vendor_file.hpp"

#include <memory>
#include <type_traits>

#include <expat.h>
#include <fmt/format.h>

namespace sbgc::tools {

namespace {

// At least three times the size of a file with five profiles.
constexpr std::size_t longest_text = std::size_t{1} << 20U;

/// The elements, and the parser that reports lines.
struct XmlReading {
  VendorElements elements{};
  XML_Parser parser{};

  /// Calls `take(elements)`. A problem ends parsing, and names its line.
  template <class Take>
  static void pass(void* user, Take take) {
    XmlReading& self = *static_cast<XmlReading*>(user);
    if (self.elements.has_failed()) return;
    take(self.elements);
    if (self.elements.has_failed()) XML_StopParser(self.parser, XML_FALSE);
  }
};

}  // namespace

Result<VendorFile> parse_vendor_file(std::string_view text) {
  if (text.size() > longest_text) {
    return ClientError{ErrorCode::bad_file, fmt::format("more than {} bytes", longest_text)};
  }
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser(
      XML_ParserCreate(nullptr), XML_ParserFree);
  XmlReading reading{.parser = parser.get()};
  XML_SetUserData(reading.parser, &reading);
  XML_SetElementHandler(
      reading.parser,
      [](void* user, const char* name, const char** /*attributes*/) {
        XmlReading::pass(user, [name](VendorElements& elements) { elements.open(name); });
      },
      [](void* user, const char* /*name*/) {
        XmlReading::pass(user, [](VendorElements& elements) { elements.close(); });
      });
  XML_SetCharacterDataHandler(reading.parser, [](void* user, const char* characters, int size) {
    XmlReading::pass(user, [&](VendorElements& elements) {
      elements.text({characters, static_cast<std::size_t>(size)});
    });
  });
  XML_SetStartDoctypeDeclHandler(reading.parser, [](void* user, const char* /*name*/,
                                                    const char* /*system*/, const char* /*id*/,
                                                    int /*internal*/) {
    XmlReading::pass(
        user, [](VendorElements& elements) { elements.fail("a document type is not allowed"); });
  });
  const auto status =
      XML_Parse(reading.parser, text.data(), static_cast<int>(text.size()), XML_TRUE);
  if (status != XML_STATUS_OK)
    reading.elements.fail(XML_ErrorString(XML_GetErrorCode(reading.parser)));
  const auto line = XML_GetCurrentLineNumber(reading.parser);
  const bool is_of_line = reading.elements.has_failed();
  Result<VendorFile> file = reading.elements.finish();
  if (is_of_line) {
    return ClientError{file.error().code, fmt::format("{} (line {})", file.error().message, line)};
  }
  return file;
}

}  // namespace sbgc::tools

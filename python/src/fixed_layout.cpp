#include "fixed_layout.hpp"

namespace sbgc::python {

namespace {

class Layout {
 public:
  /// Returns false if the layout is not fixed.
  bool add(const FieldType& type, const std::string& path) {
    if (type.is_optional) return false;
    switch (type.shape) {
      case FieldShape::group: return add_members(type.members, path + '.');
      case FieldShape::axes:
        for (const char* const axis : type.axes) {
          if (!add(type.members.front(), path + '.' + axis)) return false;
        }
        return true;
      case FieldShape::list:
        for (std::size_t i = 0; type.has_count && i < type.count; ++i) {
          if (!add(type.members.front(), path + '[' + std::to_string(i) + ']')) return false;
        }
        return type.has_count;
      case FieldShape::announced: return false;
      default: break;
    }
    const bool has_fixed_unit = type.info->alternative == nullptr && !type.info->is_variable_value;
    const bool has_fixed_size = type.is_number() || type.has_count;
    if (!has_fixed_size || !has_fixed_unit || type.is_counter) return false;
    values.push_back({path, &type, size_});
    size_ += type.size;
    return true;
  }
  bool add_members(const std::vector<FieldType>& members, const std::string& before) {
    for (const FieldType& member : members) {
      if (!member.is_tail() && !add(member, before + member.name)) return false;
    }
    return true;
  }

  std::vector<FixedValue> values{};

 private:
  std::size_t size_ = 0;
};

}  // namespace

std::optional<std::vector<FixedValue>> fixed_layout(const MessageType& type) {
  Layout layout;
  if (!layout.add_members(type.fields(), "")) return std::nullopt;
  return std::move(layout.values);
}

}  // namespace sbgc::python

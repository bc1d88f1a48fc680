
#include "device/features.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <sbgc/internal/meta_limits.hpp>
#include <sbgc/internal/table_access.hpp>
#include <sbgc/messages/imu.hpp>
#include <sbgc/meta/system.hpp>

namespace sbgc::emulator {

Availability versions_of(const BoardOptions& options) {
  return {options.firmware.raw(), options.board.raw()};
}

msg::BoardFeatures features_of(const BoardOptions& options) {
  msg::BoardFeatures features = options.features;
  // Assumption: boards since 3.6 have a CAN bus.
  constexpr std::uint8_t first_with_can = 36;
  if (options.board.raw() >= first_with_can) features.set(msg::BoardFeature::can_port);
  return features;
}

/// A feature is only reported if the firmware has its commands.
msg::BoardFeaturesExt features_ext_of(const BoardOptions& options) {
  using enum msg::BoardFeaturesExtBit;
  const Availability versions = versions_of(options);
  msg::BoardFeaturesExt features = options.features_ext;
  if (!is_supported<msg::ExtImuDebugInfoRequest>(versions)) features.set(ext_imu, false);
  if (!is_supported<msg::ReadStateVarsRequest>(versions)) features.set(state_vars, false);
  return features;
}

msg::BoardFeaturesExt2 features_ext2_of(const BoardOptions& options) {
  constexpr Availability since =
      sbgc::detail::field_info<msg::BoardInfo3>("board_features_ext2").since;
  return is_available(since, versions_of(options)) ? options.features_ext2
                                                   : msg::BoardFeaturesExt2{};
}

namespace {

using sbgc::detail::element_at;
using sbgc::detail::moved;
using sbgc::detail::StructTable;
using sbgc::detail::ValueType;
using ValueKind = sbgc::detail::Kind;

class FirmwareLimiter {
 public:
  explicit FirmwareLimiter(const Availability& versions) : versions_(versions) {}

  void members(const StructTable& table, void* object) {
    for (std::size_t i = 0; i < table.slots.size(); ++i) {
      const auto& [offset, type] = table.slots[i];
      // A counter is not stored.
      if (table.limits[i] == sbgc::detail::Limited::never || type->kind == ValueKind::counter)
        continue;
      void* const member = moved(object, offset);
      if (is_available(table.fields[i].since, versions_)) {
        value(*type, member);
      } else {
        std::memset(member, 0, type->memory);
      }
    }
  }

  bool has_unknown_values() const { return has_unknown_values_; }

 private:
  void value(const ValueType& type, void* at) {
    switch (type.kind) {
      case ValueKind::scalar: return scalar(type, at);
      case ValueKind::group: return members(*type.group, at);
      case ValueKind::optional:
        if (sbgc::detail::is_present(type, at)) value(*type.element, at);
        return;
      case ValueKind::axes:
      case ValueKind::array:
      case ValueKind::list: {
        const std::size_t size =
            type.kind == ValueKind::list ? sbgc::detail::size_at(type, at) : type.count;
        for (std::size_t i = 0; i < size; ++i) value(*type.element, element_at(type, at, i));
        return;
      }
      case ValueKind::number:
      case ValueKind::counter:
      case ValueKind::bytes:
      case ValueKind::text: return;
    }
  }

  void scalar(const ValueType& type, void* at) {
    if (!type.has_versions) return;
    const std::int64_t raw = sbgc::detail::load_integer(type.raw, at);
    std::int64_t known = raw;
    if (type.meaning.names != nullptr) {
      known = known_value(*type.meaning.names, raw, 0);
    } else {
      for (const PartInfo& part : type.meaning.packed->parts) {
        const auto mask = static_cast<std::int64_t>(part.mask);
        if (part.values == nullptr) continue;
        const unsigned shift = part.values->is_flags ? 0 : part.shift;
        known = (known & ~mask) | known_value(*part.values, known & mask, shift);
      }
    }
    if (known != raw) sbgc::detail::store_number(type.raw, at, known);
  }

  /// Returns the value without the flags that do not exist yet. The names refer to the value after
  /// the shift.
  std::int64_t known_value(const EnumInfo& names, std::int64_t value, unsigned shift) {
    std::int64_t known = value;
    for (const ValueInfo& one : names.values) {
      if (is_available(one.since, versions_)) continue;
      if (!names.is_flags) {
        has_unknown_values_ = has_unknown_values_ || one.value == value >> shift;
      } else if (one.value != 0 && (known & one.value) == one.value) {
        known &= ~one.value;
      }
    }
    return known;
  }

  Availability versions_;
  bool has_unknown_values_ = false;
};

}  // namespace

bool limit_to(const Availability& versions, const sbgc::detail::StructTable& table, void* message) {
  FirmwareLimiter limiter(versions);
  limiter.members(table, message);
  return limiter.has_unknown_values();
}

}  // namespace sbgc::emulator

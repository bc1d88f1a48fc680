/// Messages whose type is known only at run time, for loggers, gateways and script engines.
///
///     const MessageType* const type = find_message("GetAngles");
///     AnyMessage message = type->make();
///     if (message.decode(body)) std::puts(message.to_json().c_str());
///
/// This needs the compiled library sbgc::any, which has no I/O, no threads and no exceptions.
/// An AnyMessage has the size of two pointers. It holds the message on the heap: one allocation of
/// MessageType::memory bytes when it is made or copied. Besides that, only functions that return
/// text allocate.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <sbgc/dispatch.hpp>
#include <sbgc/field_type.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/from_json.hpp>
#include <sbgc/internal/message_type.hpp>
#include <sbgc/internal/table.hpp>
#include <sbgc/internal/violations.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/surplus.hpp>
#include <sbgc/text/leaves.hpp>
#include <sbgc/text_output.hpp>
#include <sbgc/value_text.hpp>

namespace sbgc {

class AnyMessage;

namespace detail {

/// The most memory of a message that takes surplus.
inline constexpr std::size_t largest_with_surplus = 1024;

/// Numbers of one type that are contiguous in a body and in memory.
struct Run {
  std::uint16_t wire{};  ///< the offset in the body
  std::uint16_t memory{};
  std::uint16_t count{};
  RawType raw{};
};

/// The functions that depend on the type of a message. Everything else uses the table of the
/// Received<M>.
struct AnyOperations {
  void (*construct)(void* message);
  Status (*decode)(const AnyOperations& of, std::span<const std::uint8_t> body, void* message,
                   const Contexts& contexts);
  WriteResult (*encode)(const AnyOperations& of, const void* message, std::span<std::uint8_t> out);
  void (*teach)(const void* message, Contexts& contexts);  ///< null if it has no such facts
  const StructTable* table;
  std::span<const Run> runs;  ///< of a message with only fixed members
  std::size_t size;           ///< of an M in memory, without the surplus
  std::size_t min_size;       ///< of a body
  bool takes_surplus;         ///< the tail of the table is surplus
};

/// The fields of a message, made when they are first needed; null before.
using FieldTypes = std::atomic<const std::vector<FieldType>*>;

}  // namespace detail

/// The type of a message: one body layout of a command. There is one object for each.
struct MessageType {
  const MessageInfo* info = nullptr;  ///< name, fields, sizes
  Form form{};                        ///< distinguishes it from others with its id
  std::size_t memory{};  ///< the size of the message in memory, with the surplus it may have

  const detail::AnyOperations* operations = nullptr;  ///< for the library itself
  detail::FieldTypes* field_types = nullptr;          ///< for the library itself

  /// Returns the fields in wire order.
  const std::vector<FieldType>& fields() const;
  /// True if hosts send it.
  bool is_sent_to_board() const noexcept { return info->direction != Direction::from_board; }
  /// Returns a message whose fields are 0, empty or absent, unless the specification has a default.
  AnyMessage make() const;
};

/// Returns all types, in the order of the specification's families.
std::span<const MessageType* const> message_types() noexcept;

/// Returns the type with this name, such as "GetAnglesRequest"; null if there is none.
const MessageType* find_message(std::string_view name) noexcept;

/// Returns the type of a body of `size` bytes, as select_received(); null if there is none.
const MessageType* find_message(Direction direction, std::uint8_t id, std::size_t size,
                                const Contexts& contexts = {}) noexcept;

/// A message of any type, and the surplus if it is a request (see <sbgc/surplus.hpp>). A moved-from
/// message can only be assigned to or destroyed.
class AnyMessage {
 public:
  /// A message of this type with its default values.
  explicit AnyMessage(const MessageType& type);
  /// Copies a message of this type, without surplus.
  AnyMessage(const MessageType& type, const void* message);
  AnyMessage(const AnyMessage& other);
  AnyMessage(AnyMessage&&) noexcept = default;
  /// Becomes a copy.
  AnyMessage& operator=(const AnyMessage& other) { return *this = AnyMessage(other); }
  AnyMessage& operator=(AnyMessage&&) noexcept = default;
  ~AnyMessage() = default;

  /// Returns the type, which never changes.
  const MessageType& type() const noexcept { return *type_; }

  /// Like the functions for a message of known type; after an error, the values are unspecified.
  [[nodiscard]] Status decode(std::span<const std::uint8_t> body,
                              const Contexts& contexts = {}) noexcept;
  /// Writes the body. Fails as encode() of a typed message.
  [[nodiscard]] WriteResult encode(std::span<std::uint8_t> out) const noexcept;
  /// Writes a whole frame. Fails as encode_frame() of a typed message.
  [[nodiscard]] WriteResult encode_frame(Framing framing,
                                         std::span<std::uint8_t> out) const noexcept;
  /// Stores the facts of the message that decoding later ones needs.
  void teach(Contexts& contexts) const noexcept {
    if (type_->operations->teach != nullptr) type_->operations->teach(memory_.get(), contexts);
  }

  /// Calls `use(const Leaf&)` for every value, in wire order, as for_each_leaf().
  template <class Use>
  void for_each_leaf(Use&& use, const Availability& versions = {}) const {
    detail::LeafWalk walk(detail::call_user<std::remove_reference_t<Use>>, &use, versions);
    walk.members(table(), memory_.get());
  }
  /// Calls `report(const Violation&)` for every value that a board with these versions does not
  /// allow; returns true if there is none.
  template <class Report>
  bool validate(const Availability& versions, Report&& report) const {
    auto* const user = const_cast<std::remove_cvref_t<Report>*>(&report);
    return validate(versions, detail::call_report<std::remove_reference_t<Report>>, user);
  }

  /// Calls `use(const Leaf&)` for the value at a path, such as "params[3].param_id", without its
  /// offset. Returns false if the message has none.
  template <class Use>
  bool with_leaf(std::string_view path, Use&& use, const Availability& versions = {}) const {
    auto* const user = const_cast<std::remove_cvref_t<Use>*>(&use);
    return find_leaf(path, versions, detail::call_user<std::remove_reference_t<Use>>, user);
  }
  /// Sets the field at a path to a value as people write it: "-30deg", "MODE_ANGLE", "raw:-1365";
  /// see <sbgc/value_text.hpp>. Axes and lists take elements separated by commas; axes also take
  /// one value for all. Adds the field, or the elements of a list, if they are missing. Returns ""
  /// on success; otherwise the reason why the specification or the field does not allow it, and
  /// leaves the message unchanged. With `validates` false, also sets what the specification does
  /// not allow. The value means what it does on a board with these versions, or the usual without
  /// them. Pointers that get_if() has returned become invalid.
  std::string assign(std::string_view path, std::string_view text, bool validates = true,
                     const Availability& versions = {});

  /// True if the message has a secret, such as a password, that is not empty.
  bool holds_secret() const;

  /// True if the message has the field, or the element of a list, at a path.
  bool has(std::string_view path) const;

  /// Returns the number of elements of the list at a path; 0 if the message does not have it.
  std::size_t count(std::string_view path) const;

  /// Adds the field at a path, or the elements of a list, if they are missing. Returns false if the
  /// message has no such field.
  bool add(std::string_view path) { return set(path, nullptr); }
  /// Removes the optional field, or the elements of the list, at a path. Returns false if there is
  /// nothing optional at the path.
  bool remove(std::string_view path);
  /// Sets the field at a path to a raw value without validation; the value of a list is its size.
  /// Adds missing fields on the way. Returns false if the field cannot hold the value.
  bool set(std::string_view path, const AnyValue& value) { return set(path, &value); }

  /// Writes the message as JSON, as write_json() of a typed message.
  void write_json(TextOutput& out, Secrets secrets = Secrets::hidden) const;
  /// Returns the message as JSON.
  std::string to_json(Secrets secrets = Secrets::hidden) const;
  /// Reads the message from `text`, as from_json(). A problem leaves the message unchanged.
  JsonResult from_json(std::string_view text);

  /// Returns the message if its type is M, or WithSurplus<M> for one that takes surplus; otherwise
  /// null.
  template <Message M>
  const Received<M>* get_if() const noexcept {
    return type_->info == &Meta<M>::info ? static_cast<const Received<M>*>(address()) : nullptr;
  }
  template <Message M>
  Received<M>* get_if() noexcept {
    return type_->info == &Meta<M>::info
               ? static_cast<Received<M>*>(static_cast<void*>(memory_.get()))
               : nullptr;
  }

  /// Returns the address of the message, a Received<M>.
  const void* address() const noexcept { return memory_.get(); }

  friend bool operator==(const AnyMessage& a, const AnyMessage& b) noexcept;

 private:
  const detail::StructTable& table() const noexcept { return *type_->operations->table; }
  bool validate(const Availability& versions, detail::Violations::Report report, void* user) const;
  bool set(std::string_view path, const AnyValue* value);
  bool find_leaf(std::string_view path, const Availability& versions, detail::LeafWalk::Use use,
                 void* user) const;
  std::string assign(const FieldType& type, const std::string& path, std::string_view text,
                     const Availability& versions);

  const MessageType* type_;
  std::unique_ptr<std::byte[]> memory_;
};

inline AnyMessage MessageType::make() const { return AnyMessage(*this); }

/// Returns true if a body holds a secret, or does not decode and may hold one.
bool holds_secret(Direction direction, std::uint8_t id, std::span<const std::uint8_t> body);

/// Returns the text of a message, such as "GetAngles{axes.roll.imu_angle = -30 deg, …}".
std::string to_string(const AnyMessage& message);

}  // namespace sbgc

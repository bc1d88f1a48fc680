// sbgc send: any message to the board, with values from the command line.

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/frame.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/validate.hpp>

#include "board/connection.hpp"
#include "board/password.hpp"
#include "bytes/secret_words.hpp"
#include "command/command_error.hpp"
#include "command/common_options.hpp"
#include "command/input_output.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"
#include "frames/decoded_frame.hpp"
#include "frames/frame_text.hpp"
#include "frames/value_rows.hpp"
#include "parameters/parameter_messages.hpp"
#include "values/assignments.hpp"
#include "values/complete_message.hpp"
#include "values/effect_text.hpp"
#include "values/field_text.hpp"
#include "values/message_json.hpp"
#include "values/message_names.hpp"

namespace sbgc::tools {

namespace {

struct SendOptions {
  std::string name{};
  std::optional<unsigned> id{};  ///< instead of a name
  std::string body{};            ///< in hex, with `id`
  std::vector<std::string> values{};
  std::string format = "text";
  bool dry_run = false;
  std::string firmware{};  ///< of the board, for a dry run
  bool no_validate = false;
  bool no_way_back = false;
  Arming arming{};
};

/// A message that the user wants to send, and the values of its fields.
struct Wanted {
  const MessageType& type;
  std::vector<Assignment> assignments{};
};

/// A message with its values.
struct Outgoing {
  AnyMessage message;
  std::string values{};  ///< for the user
};

/// Returns the number of values that the user can set.
std::size_t number_of_values(const AnyMessage& message) {
  std::size_t number = 0;
  message.for_each_leaf([&](const Leaf& leaf) {
    if (!leaf.field.reserved && leaf.kind != LeafKind::counter) ++number;
  });
  return number;
}

/// Returns the values as given, and the defaults of the others. A profile is also shown as users
/// count it, from 1: "profile_id = 1 (profile 2)".
std::string values_text(const AnyMessage& message, const std::vector<Assignment>& assignments) {
  std::vector<std::string> shown;
  message.for_each_leaf([&](const Leaf& leaf) {
    if (!is_profile_index(leaf.field)) return;
    const char* const special = special_meaning(leaf);
    shown.push_back(
        fmt::format("{} = {} ({})", to_string(leaf.path), leaf.integer,
                    special != nullptr ? special : fmt::format("profile {}", leaf.integer + 1)));
  });
  for (const Assignment& one : assignments) {
    const FieldInfo* const info = find_fields(message.type().fields(), one.name).front().type->info;
    if (info != nullptr && is_profile_index(*info)) continue;
    const bool is_secret = info != nullptr && info->secret && !one.value.empty();
    shown.push_back(fmt::format("{} = {}", one.name, is_secret ? hidden_text : one.value));
  }
  std::string text;
  for (const std::string& one : shown) text += (text.empty() ? "" : ", ") + one;
  if (!shown.empty() && number_of_values(message) > shown.size()) {
    text += "; every other field is 0, empty or its default";
  }
  return text;
}

/// Replaces the name of the file with a secret by the secret.
void read_secrets(const MessageType& type, std::vector<Assignment>& assignments) {
  for (Assignment& one : assignments) {
    const auto found = find_fields(type.fields(), one.name);
    const bool is_secret =
        !found.empty() && found.front().type->info != nullptr && found.front().type->info->secret;
    if (!is_secret || one.value.empty()) continue;
    if (one.value.front() != '@') refuse_secret(one.name);
    one.value = read_password(one.value.substr(1), one.name);
  }
}

Wanted wanted_by(const SendOptions& options) {
  const auto forms = messages_named(options.name, Direction::to_board);
  if (forms.empty()) {
    throw CommandError(fmt::format("unknown message '{}'{}", clipped(options.name),
                                   similar_messages(options.name)),
                       wrong_usage);
  }
  if (!forms.front()->is_sent_to_board()) {
    const MessageInfo& info = *forms.front()->info;
    const auto requests = messages_named(info.command, Direction::to_board);
    std::string hint;
    if (!requests.empty() && requests.front()->is_sent_to_board()) {
      hint = fmt::format("; the request is {}", requests.front()->info->name);
    }
    throw CommandError(fmt::format("only the board sends {}{}", info.name, hint), wrong_usage);
  }
  try {
    std::vector<Assignment> assignments = parse_assignments(options.values);
    std::vector<std::string> names;
    names.reserve(assignments.size());
    for (const Assignment& one : assignments) names.push_back(one.name);
    const MessageType& type = form_with(forms, names);
    read_secrets(type, assignments);
    return {type, std::move(assignments)};
  } catch (const CommandError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw CommandError(clipped(error.what()), wrong_usage);
  }
}

/// Returns the message for a board with these versions.
Outgoing message_for(const Availability& versions, const Wanted& wanted,
                     const SendOptions& options) {
  try {
    AnyMessage message = new_message(wanted.type);
    assign(message, wanted.assignments, versions);
    add_demanded(message);
    std::string values = values_text(message, wanted.assignments);
    const std::string problems = options.no_validate ? "" : violations_of(message, newest);
    if (!problems.empty()) throw ValueError(problems);
    static_cast<void>(encoded(message, basic_framing));
    return {std::move(message), std::move(values)};
  } catch (const std::runtime_error& error) {
    throw CommandError(clipped(error.what()), wrong_usage);
  }
}

/// Returns the message for a board that is not known yet: with the usual meaning of its values, or
/// with the newest if the usual one does not allow them.
Outgoing message_for_any(const Wanted& wanted, const SendOptions& options) {
  try {
    return message_for({}, wanted, options);
  } catch (const CommandError& problem) {
    try {
      return message_for(newest, wanted, options);
    } catch (const CommandError&) {
      throw problem;
    }
  }
}

/// Warns of unnamed enum values, which the board may not know either.
void warn_of_unnamed(const AnyMessage& message) {
  for_each_unnamed(message, [](const std::string& path, const std::string& sentence) {
    remark_warning(fmt::format("{}: {}", path, sentence));
  });
}

/// Prints frames as `sbgc decode` does.
class FramePrinting {
 public:
  /// Values are interpreted as on a board with these versions.
  explicit FramePrinting(bool is_json, const Availability& versions = {}) : is_json_(is_json) {
    decoder_.learn(versions);
  }

  /// Updates the context for decoding later frames.
  void learn(const Frame& frame, Direction direction) { decoder_.decode(frame, direction); }

  /// `more` is appended to the members of a JSON object. Throws CommandError, after printing, if
  /// the frame cannot be decoded.
  void print(const Frame& frame, Direction direction, const std::string& more = {}) {
    const DecodedFrame decoded = show(frame, direction, more);
    if (decoded.status) return;
    throw CommandError(
        fmt::format("{} cannot be decoded: {}", decoded.command, decoded.explanation));
  }

  /// Prints a frame, whose message may be unknown.
  void print_raw(const Frame& frame, Direction direction) { show(frame, direction, {}); }

 private:
  DecodedFrame show(const Frame& frame, Direction direction, const std::string& more) {
    DecodedFrame decoded = decoder_.decode(frame, direction);
    if (is_json_) {
      put_json(out_, decoded, nullptr, more);
      out_.put('\n');
    } else {
      put_text(out_, decoded, Colors(stdout));
    }
    out_.flush();
    return decoded;
  }

  bool is_json_;
  FrameDecoder decoder_{{.json = true, .rows = true}};
  StandardOutput out_{};
};

/// Returns the frame of `bytes`, which hold exactly one.
Frame frame_of(std::span<const std::uint8_t> bytes, std::uint8_t id) {
  constexpr std::size_t header = 4;
  return {.id = id, .body = bytes.subspan(header, bytes[2]), .framing = basic_framing};
}

int dry_run(const SendOptions& options, const Wanted& wanted) {
  Availability versions;
  if (!options.firmware.empty()) versions.firmware = parse_firmware(options.firmware)->raw();
  const Outgoing out = message_for(versions, wanted, options);
  warn_of_unnamed(out.message);
  const std::vector<std::uint8_t> bytes = encoded(out.message, basic_framing);
  const Frame frame = frame_of(bytes, out.message.type().info->id);
  const std::string hex = out.message.holds_secret() ? hidden_text : detail::to_hex(bytes);
  const Effects effects = effects_of(out.message);
  if (options.format == "jsonl") {
    FramePrinting(true, versions)
        .print(frame, Direction::to_board,
               fmt::format(R"(,"frame":"{}","effect":"{}")", hex, effect_words(effects)));
    return success;
  }
  fmt::print("{}\n", hex);
  std::fflush(stdout);
  FramePrinting(false, versions).print(frame, Direction::to_board);
  fmt::print("{}\n", wrapped(effect_text(effects), line_width()));
  return success;
}

RawRequest raw_request_of(const SendOptions& options) {
  const auto body = detail::from_hex(options.body);
  if (!body) throw CommandError("--body wants pairs of hex digits, such as 0e45", wrong_usage);
  Result<RawRequest> request = raw_request(static_cast<std::uint8_t>(*options.id), *body);
  if (!request) throw CommandError(request.error().message, wrong_usage);
  return *std::move(request);
}

/// Returns the known effects of a body under any id.
Effects known_effects(const RawRequest& request) {
  const MessageType* const type =
      find_message(Direction::to_board, request.id, request.body.size());
  return type == nullptr ? Effects() : type->info->effects;
}

/// Throws CommandError for a request that makes the line unusable, unless that is allowed.
void require_way_back(const SendOptions& options, Effects effects) {
  if (options.no_way_back || options.dry_run || !effects.has(Effect::disconnects)) return;
  throw CommandError(
      "after this command, the line no longer carries the protocol, and how to end that is not "
      "known; --no-way-back sends it nevertheless",
      wrong_usage);
}

/// Sends a body under any id, including commands that this version does not know.
int send_raw(const SendOptions& options, const CommandContext& context) {
  const RawRequest request = raw_request_of(options);
  if (holds_secret(Direction::to_board, request.id, request.body)) {
    throw CommandError(
        "--body holds a password, but others on this machine see the command line; send the "
        "message by its name, with FIELD=@FILE",
        wrong_usage);
  }
  const Effects effects = known_effects(request);
  require_way_back(options, effects);
  const Frame frame{.id = request.id, .body = request.body, .framing = basic_framing};
  FramePrinting printing(options.format == "jsonl");
  if (options.dry_run) return printing.print_raw(frame, Direction::to_board), success;
  Client client = connect(context.gimbal);
  arm(options.arming,
      fmt::format("Sends command {} with {}. Its effect is not checked: it may "
                  "move the camera or change what is stored.",
                  request.id, options.body.empty() ? "no body" : "the body " + options.body));
  printing.learn(frame, Direction::to_board);
  CallOptions call = call_options(context.gimbal);
  call.expect_confirmation = true;
  const Reply reply = value_of(client.call_raw(request, call));
  if (reply.id == 0) return remark("command {} is sent\n", request.id), success;
  printing.print_raw({.id = reply.id, .body = reply.body, .framing = reply.framing},
                     Direction::from_board);
  return success;
}

int send(const SendOptions& options, const CommandContext& context) {
  if (options.name.empty() != options.id.has_value()) {
    throw CommandError("give either a message or --id", wrong_usage);
  }
  if (options.id) return send_raw(options, context);
  const Wanted wanted = wanted_by(options);
  if (options.dry_run) return dry_run(options, wanted);
  Outgoing out = message_for_any(wanted, options);
  const MessageInfo& info = *out.message.type().info;
  const Effects effects = effects_of(out.message);
  require_way_back(options, effects);
  if (out.message.holds_secret() && !context.gimbal.capture.empty()) {
    warn_of_password_in(context.gimbal.capture);
  }
  Client client = connect(context.gimbal);
  const Availability versions = client.identity().versions();
  out = message_for(versions, wanted, options);
  require_possible(client, out.message, !options.no_validate);
  warn_of_unnamed(out.message);
  if (needs_arming(info, effects)) {
    arm(options.arming,
        fmt::format("Sends {}{}{}. {}", info.command, out.values.empty() ? "" : " with ",
                    out.values, effect_text(effects)));
  }
  FramePrinting printing(options.format == "jsonl", versions);
  const std::vector<std::uint8_t> bytes = encoded(out.message, basic_framing);
  printing.learn(frame_of(bytes, info.id), Direction::to_board);
  CallOptions call = call_options(context.gimbal);
  call.expect_confirmation = true;
  call.validate = !options.no_validate;
  const Reply reply = value_of(client.transact(out.message, call));
  switch (reply.kind) {
    case ReplyKind::answered:
    case ReplyKind::confirmed: {
      const Frame frame{.id = reply.id,
                        .body = {reply.body.data(), reply.body.size()},
                        .framing = client.statistics().session.framing};
      printing.print(frame, Direction::from_board);
      break;
    }
    case ReplyKind::unconfirmed:
      remark("{} is sent; the board did not confirm it\n", info.command);
      break;
    case ReplyKind::sent:
      remark("{} is sent; the protocol has no response to it\n", info.command);
      break;
  }
  return success;
}

}  // namespace

void add_send(CLI::App& app, CommandContext& context) {
  const Subcommand<SendOptions> command(app, context, "send",
                                        "Send any message and print the response");
  auto& options = command.options();
  command
      ->add_option("name", options.name,
                   "Name of the message (GetAnglesRequest) or of its command (CMD_GET_ANGLES, "
                   "get_angles). If a command has several forms, the first with these fields")
      ->type_name("MESSAGE");
  command->add_option("values", options.values, "Values of fields; others are 0 or empty")
      ->type_name("FIELD=VALUE");
  auto* const id = command->add_option("--id", options.id,
                                       "Send the bytes of --body as this command, which may be "
                                       "unknown, instead of a message");
  id->type_name("NUMBER")->check(CLI::Range(1, 255));
  command->add_option("--body", options.body, "The body of --id; without it, the body is empty")
      ->type_name("HEX")
      ->needs(id);
  add_format(*command, options.format, {"text", "jsonl"}, "Output format, as in `sbgc decode`");
  auto* const dry_run = command->add_flag("--dry-run", options.dry_run,
                                          "Print the frame and its effect; send nothing");
  command
      ->add_option("--firmware", options.firmware,
                   "For --dry-run: firmware of the board, because some values have another scale "
                   "in later firmware")
      ->type_name("VERSION")
      ->check(firmware_problem)
      ->needs(dry_run);
  command->add_flag("--no-way-back", options.no_way_back,
                    "Also send requests that make the line useless, with no known way back");
  command->add_flag("--no-validate", options.no_validate,
                    "Also send values that the specification does not allow");
  command->footer(
      "You can name a field by its path, by the end of the path (pitch.angle), or as in the "
      "specification (ANGLE_PITCH); a name without an axis means all axes. Numbers have the unit "
      "of the field, with or without its name; raw:NUMBER is the number on the wire. Enums and "
      "flags take names, with | between flags. Bytes are hex. Separate the values of a list with "
      "commas, or set them one by one. FIELD=@FILE reads a password from a file of mode 0600, "
      "and FIELD=@- asks for it.\n"
      "\n"
      "Examples:\n"
      "  sbgc send get_angles\n"
      "  sbgc send CMD_CONTROL control_mode=MODE_ANGLE pitch.angle=-30deg --dry-run\n"
      "  sbgc send CMD_SET_ADJ_VARS_VAL params[0].param_id=LPF_FREQ_ROLL "
      "params[0].param_value=30Hz\n"
      "  sbgc send --id 200 --body 0e45 --dry-run\n"
      "\n"
      "The exit status is 0 if the board answered as specified, 1 if not or if the request was "
      "not confirmed, 2 for wrong usage.");
  command.runs(send);
}

}  // namespace sbgc::tools

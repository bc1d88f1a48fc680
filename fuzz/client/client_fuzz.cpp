// Fuzzes the client against the emulated board over a hostile line, in virtual time. The input
// starts with the options, followed by the tasks of the client; while one runs, the input says what
// happens to each frame. See Player::step() and HostileLine.
//
// Invariants: everything ends in time. On a fair line no request gets the response to another one,
// each frame of the board is delivered once, reports about written parameters are true, and every
// block of parameters is the old or the new one, also after a power cycle. After any line, a good
// one works again, and delivers each sample of a data stream once.

#include <chrono>
#include <map>
#include <memory>

#include <sbgc/any.hpp>
#include <sbgc/client/calibrations.hpp>
#include <sbgc/client/tasks.hpp>

#include "hostile_line.hpp"
#include "tasks/hold_speed.hpp"

namespace {

using sbgc::Duration;
using sbgc::Instant;
using sbgc::ParameterSet;
using sbgc::ParametersId;
using sbgc::ParametersState;
using sbgc::Result;
using sbgc::Task;
using sbgc::WriteReport;
using sbgc::fuzz::HostileLine;
using sbgc::fuzz::Input;
using sbgc::fuzz::require;
using sbgc::test::VirtualClient;

namespace msg = sbgc::msg;
namespace tasks = sbgc::tasks;

using Bytes = std::vector<std::uint8_t>;

/// The longest time that a task may need, unless it has a timeout of its own.
constexpr Duration longest_task = sbgc::seconds(400);
/// The time after which a good line must work: the bootloader of a board waits for 5 seconds, and a
/// client expects late responses for as long as their requests may take.
constexpr Duration recovery_time = sbgc::seconds(60);

/// Three registers whose values differ, in responses that do not say which one they are.
constexpr std::uint8_t magnetometer = 0x1E;
constexpr std::uint8_t first_register = 10;
constexpr std::array<std::uint8_t, 3> register_values{'H', '4', '3'};

/// The results of several calls.
struct Readings {
  bool all_answered = true;
  bool all_right = true;
  bool in_time = true;
};

/// Reads registers with calls that run concurrently. Each has a longer timeout than the one before,
/// so that it may be waiting when that one ends.
Task<Readings> read_registers(Bytes choices, std::chrono::milliseconds timeout, unsigned retries) {
  struct Reading {
    sbgc::CallId call{};
    std::uint8_t value{};
  };
  sbgc::TaskMachine& task = co_await tasks::this_task();
  const Instant start = task.now();
  std::chrono::milliseconds longest{};
  std::vector<Reading> readings;
  for (const std::uint8_t choice : choices) {
    const std::size_t index = choice % register_values.size();
    msg::I2cReadRegBufRequest request;
    static_cast<void>(request.device_addr.set_address(magnetometer));
    request.reg_addr = static_cast<std::uint8_t>(first_register + index);
    request.data_len = msg::SmallByteCount(1);
    longest += timeout;
    readings.push_back(
        {task.begin(request, {.timeout = longest, .retries = retries}), register_values[index]});
  }
  Readings result;
  for (const Reading& one : readings) {
    if (!co_await tasks::wait_for_call(one.call, Instant::never)) break;  // cancelled
    const Result<sbgc::Reply>* const reply = task.reply(one.call);
    if (reply == nullptr) continue;
    const auto answer = sbgc::detail::read_response<msg::I2cReadRegBufRequest>(*reply);
    result.all_answered = result.all_answered && answer;
    if (answer) {
      const bool is_right = answer->data.size() == 1 && answer->data[0] == one.value;
      result.all_right = result.all_right && is_right;
    }
  }
  result.in_time = task.now() - start <= sbgc::milliseconds(longest.count());
  for (const Reading& one : readings) task.end(one.call);
  co_return result;
}

Task<Result<void>> wait_for(Duration time) {
  const sbgc::TaskMachine& task = co_await tasks::this_task();
  co_return co_await tasks::wait_until(task.now() + time);
}

/// Receives a data stream, for a while also at another interval, and waits until the board has been
/// asked to end it.
Task<std::size_t> stream(msg::DataStreamInterval request, msg::DataStreamInterval other,
                         Duration time) {
  sbgc::TaskMachine& task = co_await tasks::this_task();
  const sbgc::CallId id = task.begin_stream<msg::RealtimeData3>(request);
  static_cast<void>(co_await tasks::wait_until(task.now() + time));
  const sbgc::CallId second = task.begin_stream<msg::RealtimeData3>(other);
  static_cast<void>(co_await tasks::wait_until(task.now() + time));
  const std::size_t samples = task.take_series(id).size();
  task.end(id);
  static_cast<void>(co_await tasks::wait_until(task.now() + time));
  task.end(second);
  for (const Instant end = task.now() + sbgc::seconds(60); task.now() < end;) {
    static_cast<void>(co_await tasks::wait_until(end));
  }
  co_return samples;
}

template <class M>
Task<bool> answer_of(M request, sbgc::CallOptions options = {}) {
  co_return static_cast<bool>(co_await tasks::call(request, options));
}

sbgc::emulator::EmulatorOptions board_options(std::uint8_t choice) {
  sbgc::emulator::EmulatorOptions options;
  options.board.gimbal.noise = 0;
  if ((choice & 32) != 0) options.board.firmware = msg::FirmwareVersion(2439);
  if ((choice & 1) != 0) {
    options.board.firmware = msg::FirmwareVersion(sbgc::newest_firmware);
    options.board.board = msg::BoardVersion(36);
  }
  return options;
}

sbgc::ConnectOptions client_options(std::uint8_t choice) {
  sbgc::ConnectOptions options;
  options.pacing = (choice & 2) != 0;
  if ((choice & 4) != 0) options.duplicate_window = std::chrono::milliseconds(200);
  if ((choice & 64) != 0) options.password = "password";
  options.retries = (choice >> 3) % 4;
  return options;
}

class Player {
 public:
  explicit Player(std::span<const std::uint8_t> input)
      : input_(input),
        choice_(input_.byte()),
        is_foul_(choice_ >= 128),
        client_(board_options(choice_), {}, &line_, client_options(choice_)) {
    notices_ = client_.client().on_notice(
        [](const sbgc::Notice& notice) { require(!notice.message.empty()); });
    frames_ = client_.client().on_frame([this](const sbgc::BoardFrame& shown) {
      if (is_foul_) return;
      shown_.push_back({shown.frame.id, {shown.frame.body.begin(), shown.frame.body.end()}});
    });
    angles_ = client_.client().subscribe<msg::GetAngles>([](const msg::GetAngles&) {});
    original_ = *client_.run(tasks::read_parameters(reading()));
    for (const sbgc::Parameters& block : original_.all()) possible_[key(block.id)] = {block.body};
    shown_.clear();
    line_.take_delivered();
    line_.on_power_cut = [this] { is_power_cut_ = true; };
  }

  void play() {
    for (int steps = 0; !input_.empty() && steps < 6; ++steps) {
      line_.follow(&input_, is_foul_);
      step();
      line_.follow(nullptr, is_foul_);
      if (!is_foul_) require(shown_ == line_.take_delivered());
      shown_.clear();
    }
    recover();
    check_streams();
    check_parameters();
  }

 private:
  static std::string key(const ParametersId& id) { return to_text(id); }

  /// Reads the parameters that this fuzzer writes.
  static sbgc::ReadOptions reading(std::chrono::milliseconds timeout = std::chrono::seconds(60)) {
    sbgc::ReadOptions options{.timeout = timeout};
    options.wanted = [](const ParametersId& id) { return id.message == "ReadParams3"; };
    return options;
  }

  /// Runs a task that ends in time; the input may cancel it.
  template <class R>
  R run(Task<R> task, Duration most = longest_task) {
    const Instant start = client_.now();
    unsigned until_cancelled = cancel_after_;
    R result = client_.run(std::move(task), [&](sbgc::TaskMachine& machine) {
      require(client_.now() - start <= most);
      if (std::exchange(is_power_cut_, false)) client_.emulator().restart(client_.now());
      if (until_cancelled != 0 && --until_cancelled == 0) machine.cancel();
    });
    require(client_.now() - start <= most);
    require(is_beside_ || client_.pending() == 0);
    cancel_after_ = 0;
    return result;
  }

  /// Starts a task that supersedes the motion of the one that runs.
  void stop_beside() {
    client_.start(tasks::stop(), [](const Result<void>&) {});
    is_beside_ = true;
  }

  void step() {
    take_step();
    if (std::exchange(is_beside_, false)) static_cast<void>(run(wait_for(recovery_time)));
  }

  void take_step() {
    const std::uint8_t code = input_.byte();
    if (code >= 128) cancel_after_ = input_.byte() * 2U + 1;
    switch (code % 21) {
      case 0:
      case 1: write(false); break;
      case 2: write(true); break;
      case 3: registers(); break;
      case 4: file(); break;
      case 5: read(); break;
      case 6: static_cast<void>(run(tasks::get_variables({"P_ROLL", "P_PITCH"}))); break;
      case 7:
        may_hold_anything_ = true;
        static_cast<void>(run(tasks::set_variable("P_ROLL", input_.byte())));
        break;
      case 8: move(); break;
      case 9: calibrate(); break;
      case 10: static_cast<void>(run(wait_for(sbgc::milliseconds(20) * input_.byte()))); break;
      case 11: eeprom(); break;
      case 12: user_data(); break;
      case 13: profile_names(); break;
      case 14: variables(); break;
      case 15: hold_speed(); break;
      case 16: motion(); break;
      case 17: files(); break;
      case 18: write_others(); break;
      case 19: refused(); break;
      default: rare(); break;
    }
  }

  void rare() {
    switch (input_.byte() % 6) {
      case 0: static_cast<void>(run(tasks::active_profile())); break;
      case 1: record(); break;
      case 2: flash(); break;
      case 3: receive_stream(); break;
      case 4: connect(); break;
      default: calibrate_otherwise(); break;
    }
  }

  void registers() {
    const Bytes choices = some_bytes(input_.byte() % 8);
    const std::chrono::milliseconds timeout(20 + 10 * input_.byte());
    const Readings done = run(read_registers(choices, timeout, input_.byte() % 3));
    require(done.in_time);
    if (!is_foul_) require(done.all_right);
  }

  void file() {
    Bytes data = some_bytes(1 + input_.byte() % 32);
    data.resize(1 + data.size() * 9);
    for (std::size_t i = 0; i < data.size(); ++i) {
      data[i] = static_cast<std::uint8_t>(data[i] + i / 7);
    }
    const std::chrono::milliseconds timeout(20 * (1 + input_.byte()));
    const Duration most = sbgc::milliseconds(timeout.count());
    const Result<void> sent = run(tasks::upload_file(1, data, {.timeout = timeout}), most);
    if (!sent || is_foul_) return;
    const Result<Bytes> read = run(tasks::download_file(1, {.timeout = timeout}), most);
    if (read) require(*read == data);
  }

  /// Tasks that change a memory return success only if it holds what they have written.
  template <class Read, class T>
  void require_kept(const Result<void>& written, Read read, const T& expected) {
    if (!written || is_foul_) return;
    const auto present = run(read());
    if (present) require(*present == expected);
  }

  void eeprom() {
    may_hold_anything_ = true;
    const std::uint8_t place = input_.byte();
    const std::uint32_t address = place == 255 ? 0xFFFF'FFFFU : place * 150U;
    const Bytes data = some_bytes(1 + input_.byte() % 100);
    const bool is_verified = !data.empty() && data[0] % 2 != 0;
    const auto written = run(tasks::upload_eeprom(address, data, {.verify = is_verified}));
    if (!is_verified) return;
    require_kept(
        written, [&] { return tasks::download_eeprom(address, data.size()); }, data);
  }

  void user_data() {
    const std::size_t offset = input_.byte();
    const Bytes data = some_bytes(1 + input_.byte() % 32);
    const auto written = run(tasks::upload_user_data(offset, data));
    if (!written || is_foul_) return;
    const auto present = run(tasks::download_user_data());
    if (!present) return;
    require(std::ranges::equal(data, std::span(*present).subspan(offset, data.size())));
  }

  void profile_names() {
    const std::size_t profile = input_.byte() % 7;
    const Bytes bytes = some_bytes(input_.byte() % 52);
    const std::string name(bytes.begin(), bytes.end());
    if (profile == 6) {
      static_cast<void>(run(tasks::rename_profiles({name, "", "3", name, "5"})));
    } else {
      static_cast<void>(run(tasks::rename_profile(profile, name)));
    }
    static_cast<void>(run(tasks::profile_names()));
  }

  void variables() {
    may_hold_anything_ = true;
    const std::array names{"P_ROLL", "LPF_FREQ_PITCH", "FOLLOW_SPEED_YAW", "none"};
    std::vector<sbgc::VariableValue> values;
    std::vector<std::string> wanted;
    const double scale = input_.byte() - 1.0;
    for (int left = input_.byte() % 50; left > 0; --left) {
      wanted.emplace_back(names[static_cast<std::size_t>(left) % (scale == 0 ? 4 : 3)]);
      values.push_back({wanted.back(), left * scale});
    }
    static_cast<void>(run(tasks::get_variable(names[0])));
    static_cast<void>(run(tasks::set_variables(std::move(values))));
    static_cast<void>(run(tasks::get_variables(std::move(wanted))));
    static_cast<void>(run(tasks::save_variables()));
  }

  /// The owner of a speed changes it, falls silent, or stops; then it closes the control.
  void hold_speed() {
    const auto bound = static_cast<sbgc::MotionBound>(input_.byte() % 4);
    const auto speed = client_.held_speed();
    const bool yields = input_.byte() % 2 != 0;
    const Bytes changes = some_bytes(input_.byte() % 32);
    std::size_t at = 0;
    Instant next = client_.now();  // a task that waits for its owner may let it sleep longer
    Instant end = Instant::never;
    const auto owner = [&](sbgc::TaskMachine& machine) {
      if (std::exchange(is_power_cut_, false)) client_.emulator().restart(client_.now());
      if (end != Instant::never) return require(client_.now() - end <= longest_task);
      if (client_.now() < next) return;
      machine.wake();
      if (at == changes.size()) {
        end = client_.now();
        return speed->close();
      }
      const std::uint8_t change = changes[at++];
      next = client_.now() + sbgc::milliseconds(10) * change;
      if (change == 255) return stop_beside();
      static_cast<void>(change % 5 == 1 ? speed->refresh(client_.now())
                        : change % 5 == 0
                            ? speed->stop()
                            : speed->set({.yaw = msg::ControlSpeed(change)}, client_.now()));
    };
    static_cast<void>(client_.run(
        sbgc::detail::hold_speed(
            speed, sbgc::detail::BoundedTurn(bound, std::chrono::milliseconds(500)), yields),
        owner));
    require(is_beside_ || client_.pending() == 0);
  }

  void move() {
    const std::uint8_t choice = input_.byte();
    const std::uint8_t refuse_after = input_.byte();
    sbgc::MoveOptions options;
    options.speed = msg::ControlSpeed(static_cast<std::int16_t>(choice * 100 - 1000));
    options.timeout = std::chrono::milliseconds(input_.byte() * 100);
    options.tolerance = choice % 16;
    options.stop_on_failure = choice % 2 == 0;
    int looks = 0;
    options.progress = [&](const sbgc::MoveProgress&) {
      if (++looks + 127 == refuse_after) stop_beside();
      return looks != refuse_after;
    };
    sbgc::MoveTarget target;
    if (choice != 255) target.yaw = msg::Angle14(900);
    static_cast<void>(run(tasks::move_to(target, options)));
  }

  void calibrate() {
    const std::uint8_t choice = input_.byte();
    const std::uint8_t refuse_after = input_.byte();
    sbgc::CalibrationOptions options;
    options.imu = static_cast<msg::CalibImu>(choice % 4);
    options.action = static_cast<msg::CalibAction>(choice / 4 % 5);
    if (choice >= 128) options.timeout = std::chrono::milliseconds(10 * (choice - 128));
    int looks = 0;
    if (refuse_after != 0) {
      options.progress = [&](const sbgc::CalibrationProgress&) { return ++looks != refuse_after; };
    }
    const auto sensor = choice % 2 == 0 ? sbgc::Sensor::gyroscope : sbgc::Sensor::accelerometer;
    static_cast<void>(run(tasks::calibrate(sensor, options)));
  }

  void calibrate_otherwise() {
    may_hold_anything_ = true;
    const auto& all = sbgc::calibrations();
    const auto& forms = all[input_.byte() % all.size()].forms;
    const auto& form = forms[input_.byte() % forms.size()];
    const sbgc::AnyMessage request = sbgc::find_message(form.info->name)->make();
    static_cast<void>(run(tasks::run_calibration(request, {})));
  }

  void record() {
    msg::BodeTestStartStopRequest request;
    const std::uint8_t choice = input_.byte();
    request.axis = static_cast<msg::BodeAxis>(choice % 4);
    request.stimulus_type = static_cast<msg::BodeStimulus>(choice / 4 % 4);
    request.system = static_cast<msg::BodeSystem>(choice / 16);
    request.stimulus_gain = 10;
    request.samples_num = input_.byte() * 8U;
    const std::uint8_t refuse_after = input_.byte();
    int looks = 0;
    sbgc::BodeOptions options;
    options.progress = [&](const sbgc::BodeProgress&) { return ++looks != refuse_after; };
    const Result<sbgc::BodeRecording> recorded = run(tasks::record_bode(request, options));
    if (recorded) require(recorded->input.size() == recorded->output.size());
  }

  void flash() {
    const auto module = static_cast<msg::ModuleId>(input_.byte());
    const std::size_t size = input_.byte() * 4U + (input_.byte() == 255 ? 1 : 0);
    const std::uint8_t refuse_after = input_.byte();
    int looks = 0;
    const auto progress = [&](const sbgc::Progress&) { return ++looks != refuse_after; };
    const auto loaded = run(tasks::flash_module(module, Bytes(size, 0xA5), progress));
    if (!loaded || is_foul_) return;
    require(client_.emulator().board().module_firmware().at(module) == Bytes(size, 0xA5));
  }

  void receive_stream() {
    client_.client().set_line({.baud_rate = 115'200});  // which limits the streams
    const std::chrono::milliseconds interval(input_.byte());
    const auto request = sbgc::detail::stream_request<msg::DataStreamInterval>(interval);
    const auto other = sbgc::detail::stream_request<msg::DataStreamInterval>(interval / 2);
    const Duration time = sbgc::milliseconds(10) * input_.byte();
    if (request && other) static_cast<void>(run(stream(*request, *other, time)));
  }

  /// Searches for the line settings, and connects, as at the beginning.
  void connect() {
    if (is_foul_) return;  // a forged identity is not that of the board
    sbgc::PassiveClient& client = client_.client();
    const auto before = client.identity().info;
    std::optional<Result<void>> found;
    std::optional<Result<void>> connected;
    const auto set_line = [](const sbgc::LineSettings& line) { return line.baud_rate == 115'200; };
    client.detect_line(set_line, [&](const Result<void>& result) { found = result; });
    static_cast<void>(run(wait_for(recovery_time)));
    line_.take_delivered();  // not all was delivered to the client
    shown_.clear();
    client.connect([&](const Result<void>& result) { connected = result; });
    static_cast<void>(run(wait_for(recovery_time)));
    require(found && connected && client.identity().info == before);
    static_cast<void>(client.statistics());
    static_cast<void>(client.identity().firmware_problem());
  }

  void motion() {
    const std::uint8_t choice = input_.byte();
    const auto angle = msg::Angle14(static_cast<std::int16_t>(input_.byte() * 8));
    switch (choice % 4) {
      case 0: static_cast<void>(run(tasks::begin_move({.pitch = angle}, {.settle = {}}))); break;
      case 1: static_cast<void>(run(tasks::stop())); break;
      case 2: static_cast<void>(run(tasks::release())); break;
      default:
        static_cast<void>(run(tasks::set_control_timeout(std::chrono::milliseconds(choice * 300))));
    }
  }

  void files() {
    const std::uint8_t choice = input_.byte();
    const std::size_t too_many = 100'000;
    switch (choice % 5) {
      case 4:
        static_cast<void>(run(tasks::upload_file(2, Bytes(choice < 128 ? 0 : too_many))));
        break;
      case 0: static_cast<void>(run(tasks::file_size(choice / 4))); break;
      case 1: static_cast<void>(run(tasks::delete_file(choice / 4))); break;
      case 2: static_cast<void>(run(tasks::delete_all_files())); break;
      default: static_cast<void>(run(tasks::download_file(choice / 4)));
    }
  }

  /// Sends requests that the client must refuse.
  void refused() {
    msg::BeepSound sound;
    sound.decay_factor = 200;
    require(!run(answer_of(sound)));
    require(!run(answer_of(msg::SetAdjVarsVal{})));
    require(!run(answer_of(msg::MotorsOn{}, {.timeout = std::chrono::hours(24)})));
    const bool is_recent = (choice_ & 1) != 0;
    require(is_recent || !run(answer_of(msg::CalibInfoRequest{})));
  }

  /// Writes blocks of any kind, some of which the board may lack, and values of any kind.
  void write_others() {
    may_hold_anything_ = true;
    const std::array names{"ReadParams3", "ReadParamsExt", "ReadParamsExt2", "ReadParamsExt3",
                           "ReadProfileNames"};
    const std::uint8_t choice = input_.byte();
    ParameterSet wanted;
    for (int blocks = 1 + choice % 3; blocks > 0; --blocks) {
      const std::uint8_t kind = input_.byte();
      const sbgc::ParametersId id{names[kind % names.size()], static_cast<std::uint8_t>(kind / 51)};
      Bytes body(input_.byte() * std::size_t{2}, id.copy);
      const Bytes start = some_bytes(16);
      if (body.size() >= start.size() + 1) std::ranges::copy(start, body.begin() + 1);
      static_cast<void>(wanted.put({id, std::move(body)}));
    }
    for (int profile = choice % 32 / 8; profile > 0; --profile) {
      auto block = *original_.get<msg::ReadParams3>(static_cast<std::uint8_t>(profile));
      block.general_flags1 = msg::GeneralFlags(input_.byte());
      block.rc.pitch.rc_min_angle = msg::Degrees(static_cast<std::int16_t>(input_.byte() * 8));
      static_cast<void>(wanted.set(block));
    }
    static_cast<void>(to_text(diff(wanted, original_)));
    static_cast<void>(to_text(diff(original_, wanted)));
    const sbgc::WriteOptions options{.dry_run = (choice & 64) != 0,
                                     .validate = (choice & 128) != 0};
    const WriteReport report = run(tasks::write_parameters(wanted, options));
    static_cast<void>(to_text(report));
  }

  void read() {
    const std::chrono::milliseconds timeout(20 * (1 + input_.byte()));
    const Result<ParameterSet> set =
        run(tasks::read_parameters(reading(timeout)), sbgc::milliseconds(timeout.count()));
    if (!set || is_foul_ || may_hold_anything_) return;
    for (const sbgc::Parameters& block : set->all()) require(is_possible(block));
  }

  /// Writes parameters in which every byte that changes depends on the input.
  void write(bool as_backup) {
    ParameterSet wanted = as_backup ? original_ : ParameterSet();
    for (int profiles = 1 + input_.byte() % 3; profiles > 0; --profiles) {
      const std::uint8_t value = input_.byte();
      auto block = *original_.get<msg::ReadParams3>(value % 5);
      block.axes.roll.p = block.axes.pitch.p = block.axes.yaw.p = value;
      block.gyro_trust = value;
      require(static_cast<bool>(wanted.set(block)));
    }
    const std::chrono::milliseconds timeout(20 * (1 + input_.byte()));
    const Duration most = sbgc::milliseconds(timeout.count());
    const WriteReport report = [&] {
      if (!as_backup) {
        return run(tasks::write_parameters(wanted, {.timeout = timeout, .validate = false}), most);
      }
      sbgc::Backup backup{board_of_backup(), wanted, ""};
      sbgc::RestoreOptions options;
      options.save_current = [](const sbgc::Backup&) { return Result<void>(); };
      options.timeout = timeout;
      const std::vector<ParametersId> rest = left_alone(client_.identity(), backup);
      require(rest.empty() || !to_text(rest).empty());
      if (is_incomplete_) backup.missing = rest;
      return run(tasks::restore(std::move(backup), std::move(options)), most);
    }();
    if (!is_foul_ && !may_hold_anything_) learn(wanted, report);
  }

  /// Returns the identity of the board, rarely that of another one.
  sbgc::BoardIdentity board_of_backup() {
    sbgc::BoardIdentity board = client_.identity();
    const std::uint8_t choice = input_.byte();
    is_incomplete_ = choice == 252;
    if (choice == 255) board.info.board_ver = msg::BoardVersion(31);
    if (choice == 254) board.info.firmware_ver = msg::FirmwareVersion(2560);
    if (choice == 253) board.info.frw_extra_id = 1;
    if (choice >= 253) require(!mismatches(client_.identity(), board).empty());
    return board;
  }

  /// Narrows or widens what the board may hold.
  void learn(const ParameterSet& wanted, const WriteReport& report) {
    for (const sbgc::ParametersReport& one : report.parameters) {
      const Bytes& written = wanted.find(one.id)->body;
      std::vector<Bytes>& bodies = possible_[key(one.id)];
      switch (one.state) {
        case ParametersState::equal:
        case ParametersState::written: bodies = {written}; break;
        case ParametersState::unwritten: break;
        case ParametersState::different: require(false); break;
        case ParametersState::unknown: bodies.push_back(written); break;
      }
      require(!report || one.state == ParametersState::equal ||
              one.state == ParametersState::written);
    }
  }

  bool is_possible(const sbgc::Parameters& block) const {
    const auto& bodies = possible_.at(key(block.id));
    return std::ranges::any_of(bodies, [&](const Bytes& body) {
      if (body == block.body) return true;
      ParameterSet one;
      ParameterSet other;
      require(one.put(block) && other.put({block.id, body}));
      return diff(one, other).empty();
    });
  }

  /// After a bounded time on a good line, requests are answered at the first attempt.
  void recover() {
    static_cast<void>(run(wait_for(recovery_time)));
    const Instant start = client_.now();
    require(run(answer_of(msg::BoardInfoRequest{})));
    require(run(answer_of(msg::GetAnglesRequest{})));
    const Readings done = run(read_registers({0, 1, 2, 1}, std::chrono::seconds(10), 0));
    require(done.all_answered && done.all_right);
    require(client_.now() - start < sbgc::seconds(12));
  }

  /// Each sample that the board sends is delivered once, beside the responses to requests.
  void check_streams() {
    using sbgc::is_supported;
    if (!is_supported<msg::DataStreamInterval>(client_.identity().versions())) return;
    std::size_t sent = 0;
    std::size_t received = 0;
    client_.emulator().board().on_traffic = [&](const sbgc::emulator::Board::Traffic& traffic) {
      const auto id = static_cast<std::uint8_t>(msg::RealtimeData3::command);
      if (!traffic.reaction && traffic.frame.id == id) ++sent;
    };
    const auto samples = client_.client().subscribe<msg::RealtimeData3>(
        [&](const msg::RealtimeData3&) { ++received; });
    msg::DataStreamInterval request;
    request.cmd_id = msg::RealtimeData3::command;
    request.interval_ms = msg::Milliseconds(20);
    require(run(answer_of(request)));
    for (int i = 0; i < 3; ++i) {
      static_cast<void>(run(wait_for(sbgc::milliseconds(200))));
      require(run(answer_of(msg::GetAnglesRequest{})));
    }
    require(received == sent);
    require(sent >= 28);
    request.interval_ms = msg::Milliseconds(0);
    require(run(answer_of(request)));
    static_cast<void>(run(wait_for(sbgc::seconds(1))));
    const std::size_t end = sent;
    static_cast<void>(run(wait_for(sbgc::seconds(1))));
    require(sent == end && received == sent);
    client_.emulator().board().on_traffic = {};
  }

  /// The board holds what it may hold, also after a power cycle.
  void check_parameters() {
    const Result<ParameterSet> present = client_.run(tasks::read_parameters(reading()));
    require(static_cast<bool>(present));
    VirtualClient later(board_options(choice_), client_.emulator().board().memory());
    const Result<ParameterSet> stored = later.run(tasks::read_parameters(reading()));
    require(static_cast<bool>(stored));
    if (is_foul_ || may_hold_anything_) return;
    require(*present == *stored || diff(*present, *stored).empty());
    for (const sbgc::Parameters& block : stored->all()) require(is_possible(block));
  }

  Bytes some_bytes(std::size_t count) {
    const auto bytes = input_.bytes(count);
    return {bytes.begin(), bytes.end()};
  }

  Input input_;
  std::uint8_t choice_;
  bool is_foul_;
  HostileLine line_;
  VirtualClient client_;
  sbgc::Subscription notices_{};
  sbgc::Subscription frames_{};
  sbgc::Subscription angles_{};
  std::vector<HostileLine::Delivered> shown_{};
  ParameterSet original_{};
  std::map<std::string, std::vector<Bytes>> possible_{};  // the bodies that the board may hold
  bool is_power_cut_ = false;
  bool is_incomplete_ = false;      // the backup
  bool is_beside_ = false;          // a task that stop_beside() has started
  bool may_hold_anything_ = false;  // after tasks that write parameters in other ways
  unsigned cancel_after_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Player({data, size}).play();
  return 0;
}

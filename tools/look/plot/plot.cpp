// sbgc plot: draws values over time, or their spectrum.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <sbgc/analysis/frequencies.hpp>
#include <sbgc/analysis/spectrum.hpp>
#include <sbgc/doctor/frequency_text.hpp>
#include <sbgc/io/internal/atomic_file.hpp>

#include "board/connection.hpp"
#include "board/progress_bar.hpp"
#include "command/input_output.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"
#include "frames/sample_writer.hpp"
#include "frames/stream_type.hpp"
#include "look/plot/drawing.hpp"
#include "look/plot/table.hpp"
#include "values/field_patterns.hpp"

namespace sbgc::tools {

namespace {

struct PlotOptions {
  std::string source{};
  std::string fields{};
  std::string stream{};
  std::string with{};
  double rate = 50;
  std::optional<std::chrono::milliseconds> time{};
  bool spectrum = false;
  bool ascii = false;
  std::size_t height = 8;
  std::string svg{};
  std::vector<const CLI::Option*> of_live{};  ///< without effect on a table
};

std::vector<Series> table_in(const std::string& file, const std::string& fields) {
  constexpr std::size_t largest_table = 64U << 20U;
  constexpr std::size_t longest_line = 1U << 20U;
  Input input(file, "the lines of a table");
  TableReader reader(fields);
  std::string line;
  std::size_t size = 0;
  while (input.read_line(line, longest_line)) {
    size += line.size() + 1;
    if (line.size() > longest_line || size > largest_table) {
      throw CommandError("the table is too large: over 64 MiB, or a line over 1 MiB");
    }
    reader.add_line(line);
  }
  return reader.finish();
}

/// Reads samples of a stream as rows of a table.
std::vector<Series> live_table(const PlotOptions& options, const CommandContext& context) {
  using Clock = std::chrono::steady_clock;
  StreamType stream = StreamType::find(options.stream);
  stream.configure(options.with);
  if (options.with.empty()) stream.configure_for(options.fields);
  const std::vector<StreamField> all = stream.fields();
  std::vector<std::string> paths;
  paths.reserve(all.size());
  for (const StreamField& field : all) paths.push_back(field.path);
  const std::vector<bool> chosen =
      chosen_fields(options.fields, *find_message(stream.info().name), paths);
  std::vector<StreamField> fields;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (chosen[i] || all[i].path == clock_path) fields.push_back(all[i]);
  }
  const auto writer = SampleWriter::make(OutputFormat::csv, stream.info().name, fields, 0);
  const auto interval = interval_of(options.rate);
  Client client = connect_for_long(context.gimbal);
  const Interruption interruption;
  const bool ends = is_replay(context.gimbal);
  std::atomic<bool> has_ended = false;
  const Subscription changes = ends ? client.on_change([&](const LinkChange&) { has_ended = true; })
                                    : report_changes(client);
  std::mutex mutex;
  TableReader reader;
  const auto add = [&](std::string text) {
    if (text.ends_with('\n')) text.pop_back();
    reader.add_line(text);
  };
  add(writer->header());
  const auto start = Clock::now();
  const auto take = [&](const Sample& sample) {
    const double time = std::chrono::duration<double>(Clock::now() - start).count();
    const std::lock_guard lock(mutex);
    add(writer->line(time, sample));
  };
  Subscription samples =
      ends ? stream.listen(client, take) : value_of(stream.start(client, interval, take));
  const auto end = start + options.time.value_or(std::chrono::seconds(5));
  const ProgressBar bar;
  while (!was_interrupted() && !has_ended && Clock::now() < end &&
         client.state() != LinkState::given_up) {
    bar.show(fmt::format("recording for {:.0f} s",
                         std::chrono::duration<double>(Clock::now() - start).count()));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  bar.clear();
  samples.cancel();
  const std::lock_guard lock(mutex);
  return reader.finish();
}

Curve over_time(const std::vector<double>& times, const Series& series) {
  return {series.path, series.unit, "s", times, series.values, ""};
}

std::string peaks_text(const analysis::Vibration& vibration, const std::string& unit) {
  constexpr std::size_t most = 3;
  std::vector<analysis::Frequency> strong = frequencies_of(vibration);
  std::erase_if(strong, [](const analysis::Frequency& one) {
    return one.peak.contrast < analysis::least_contrast;
  });
  if (strong.empty()) return "no frequency is strong";
  std::string text = "strongest: ";
  for (std::size_t i = 0; i < std::min(strong.size(), most); ++i) {
    const analysis::Peak& peak = strong[i].peak;
    text += fmt::format("{}{:.1f} Hz with {:.3g}{}{}", i == 0 ? "" : ", ", peak.frequency,
                        peak.amplitude, unit.empty() ? "" : " ", unit);
  }
  if (strong.front().others.empty()) return text;
  return text + fmt::format("; {:.1f} Hz may be an alias of {}", strong.front().peak.frequency,
                            doctor::others_text(strong.front()));
}

Curve spectrum_of(const std::vector<Series>& columns, const Series& series) {
  const auto clock = std::ranges::find(columns, clock_path, &Series::path);
  const UniformSeries samples =
      uniform(columns.front().values,
              clock == columns.end() ? std::vector<double>{} : clock->values, series.values);
  if (!(samples.rate > 0)) {
    throw CommandError(
        fmt::format("no spectrum of {}: its samples have no distance in time", series.path));
  }
  if (samples.values.empty()) {
    throw CommandError(
        fmt::format("no spectrum of {}: {:.1f} % of its samples are lost, more than "
                    "1 %",
                    series.path, 100 * samples.lost_share));
  }
  const std::size_t length = analysis::segment_length(samples.values.size() / 2);
  const analysis::PowerSpectrum spectrum =
      analysis::power_spectrum(samples.values, samples.rate, length);
  const auto last = static_cast<std::size_t>(analysis::highest_share * samples.rate /
                                             std::max(spectrum.resolution, 1e-12));
  if (spectrum.segments == 0 || last < 2) {
    throw CommandError(fmt::format("no spectrum of {}: {} samples are too few", series.path,
                                   samples.values.size()));
  }
  Curve curve{
      series.path, series.unit.empty() ? "1/sqrt(Hz)" : series.unit + "/sqrt(Hz)",
      "Hz",        {},
      {},          peaks_text(analysis::vibration_of(samples.values, samples.rate), series.unit)};
  for (std::size_t bin = 0; bin <= last; ++bin) {
    curve.places.push_back(static_cast<double>(bin) * spectrum.resolution);
    curve.values.push_back(std::sqrt(spectrum.density[bin]));
  }
  return curve;
}

int plot(PlotOptions options, const CommandContext& context) {
  const bool is_live = options.source == "live";
  for (const CLI::Option* const option : options.of_live) {
    if (is_live || option->count() == 0) continue;
    throw CommandError(option->get_name() + " is for `sbgc plot live`, not for a table",
                       wrong_usage);
  }
  if (options.stream.empty()) options.stream = "RealtimeData3";
  if (is_live && options.fields.empty()) options.fields = "angle.*";
  const std::vector<Series> columns =
      is_live ? live_table(options, context) : table_in(options.source, options.fields);
  std::vector<Series> shown = chosen_series(columns, options.fields);
  std::erase_if(shown, [&](const Series& one) {
    return one.path == clock_path && options.fields.find(clock_path) == std::string::npos;
  });
  if (shown.empty()) throw CommandError("the columns hold no numbers");
  std::vector<Curve> curves;
  curves.reserve(shown.size());
  for (const Series& series : shown) {
    curves.push_back(options.spectrum ? spectrum_of(columns, series)
                                      : over_time(columns.front().values, series));
  }
  if (!options.svg.empty()) {
    value_of(detail::write_file_atomically(options.svg, draw_svg(curves), Existing::replace));
    remark("The picture is in {}.\n", options.svg);
    return success;
  }
  const ChartStyle style = options.ascii ? ChartStyle::ascii : ChartStyle::braille;
  fmt::print("{}", printable(draw_text(curves, line_width(), options.height, style)));
  return success;
}

}  // namespace

void add_plot(CLI::App& app, CommandContext& context) {
  const Subcommand<PlotOptions> command(app, context, "plot",
                                        "Draw values over time, or their spectrum");
  auto& options = command.options();
  command
      ->add_option("source", options.source,
                   "A table in CSV, as `sbgc stream` and `sbgc decode` write it; - is standard "
                   "input, and live is the gimbal")
      ->required()
      ->type_name("FILE|live");
  command
      ->add_option("fields", options.fields,
                   "Only these fields, separated by commas: paths, their ends, or patterns with *")
      ->type_name("FIELDS");
  command->add_flag("--spectrum", options.spectrum,
                    "Draw the strength of each frequency, up to 45 % of the sample rate");
  command->add_option("--svg", options.svg, "Write a picture to this file instead")
      ->type_name("FILE");
  options.of_live = {
      command->add_option("--stream", options.stream, "For live: the message [RealtimeData3]")
          ->type_name("STREAM"),
      command->add_option("--with", options.with, "For live: as in `sbgc stream`")
          ->type_name("FLAGS"),
      add_rate(*command, options.rate),
      add_duration(*command, "--for", options.time,
                   "For live: record for this time; 5 s without it")};
  command->add_option("--height", options.height, "Lines of each chart")
      ->check(CLI::Range(2, 100))
      ->type_name("LINES")
      ->capture_default_str();
  command->add_flag("--ascii", options.ascii, "Draw with stars instead of Braille dots");
  command->footer(
      "It only reads. Ctrl-C ends a recording early. Curves have gaps where samples are missing. "
      "A spectrum needs samples at equal intervals: it interpolates up to 1 % of lost samples. "
      "It names the strongest frequencies from 1 Hz on and their possible aliases; to "
      "distinguish these, record at another rate, as `sbgc doctor` does.\n"
      "\n"
      "Examples:\n"
      "  sbgc plot live --for 2s\n"
      "  sbgc plot live \"gyro_data.*\" --stream RealtimeDataCustom --rate 250 --spectrum\n"
      "  sbgc stream --for 2s --format csv | sbgc plot - --svg angles.svg\n"
      "\n"
      "The exit status is 0 if it has drawn, 1 if not, 2 for wrong usage.");
  command.runs(plot);
}

}  // namespace sbgc::tools

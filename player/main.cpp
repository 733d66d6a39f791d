#include "base/settings/setting_options.hpp"
#include "base/settings/settings_file.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"
#include "player/display/mesa_options.hpp"
#include "player/plan_command.hpp"
#include "player/playback/reader/host_process.hpp"
#include "player/playback/reader/reader_host.hpp"
#include "player/player.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <exception>
#include <map>
#include <memory>
#include <string>
#include <string_view>

// vitrine-player: shows the catalogue on a screen, or plans a wall without one.

/// Options of jemalloc, which the player is linked with: freed memory is returned after a second. The heap of
/// the C library grows for hours, as its free pages lie between blocks that are in use.
extern "C" const char* const malloc_conf = "narenas:2,dirty_decay_ms:1000,muzzy_decay_ms:0";

namespace {

using namespace vitrine;
using namespace vitrine::player;

constexpr const char* reader_host_word = "reader-host";  // not for persons: it is not in the help

/// Reads "20s", "1500ms", "2m" or "20", which are seconds.
std::chrono::nanoseconds duration_of(const std::string& text) {
    std::size_t end = 0;
    const double number = std::stod(text, &end);
    const std::map<std::string, double> seconds{{"", 1}, {"s", 1}, {"ms", 0.001}, {"m", 60}, {"h", 3600}};
    const auto unit = seconds.find(text.substr(end));
    if (unit == seconds.end() || !(number > 0) || number * unit->second > 1e6)
        throw std::invalid_argument(text);
    return std::chrono::nanoseconds(static_cast<std::int64_t>(number * unit->second * 1e9));
}

void check_duration(const std::string& text) {
    try {
        (void)duration_of(text);
    } catch (const std::logic_error&) {
        throw CLI::ValidationError("--duration",
                                   "'" + text + "' is not allowed; it must be a time like 20s or 2m");
    }
}

void parse_size(const std::string& text, PlanOptions& options) {
    const std::size_t cross = text.find('x');
    try {
        if (cross == std::string::npos) throw std::invalid_argument(text);
        options.width = std::stoi(text.substr(0, cross));
        options.height = std::stoi(text.substr(cross + 1));
        if (options.width < 16 || options.height < 16 || options.width > 16384 || options.height > 16384)
            throw std::out_of_range(text);
    } catch (const std::logic_error&) {
        throw CLI::ValidationError("--size",
                                   "'" + text + "' is not allowed; it must be WIDTHxHEIGHT, like 1920x1080");
    }
}

Rehearsal read_rehearsal(const std::string& path) {
    try {
        return Rehearsal(read_file(path));
    } catch (const std::runtime_error& error) {
        throw CLI::ValidationError("--rehearse", error.what());
    }
}

struct CommandLine {
    CLI::App app{"Plays the photos and films of the catalogue together on one canvas"};
    SettingOptions settings;
    PlayOptions play;
    PlanOptions plan;
    CLI::App* plan_command = nullptr;
    SettingOptions plan_settings;
};

void add_play_options(CommandLine& line) {
    line.settings.add_to(line.app);
    line.settings.add_alias(line.app, "screen", "output.screen");
    line.settings.add_alias(line.app, "slots", "layout.slots");
    line.settings.add_alias(line.app, "seed", "layout.seed");
    line.app.add_option_function<std::string>(
        "--duration",
        [&line](const std::string& text) {
            check_duration(text);
            line.play.duration = duration_of(text);
        },
        "Time to play, like 20s (default: until stopped)");
    line.app.add_option("--film", line.play.film, "Off screen: writes the frames that are shown as an MP4");
    line.app.add_option("--snapshot", line.play.snapshot, "Off screen: writes the last frame as a PNG");
    line.app
        .add_option("--tapestry", line.play.tapestry,
                    "Shows the tapestry in this directory in place of the wall")
        ->check(CLI::ExistingDirectory);
    line.app
        .add_option_function<std::string>(
            "--rehearse", [&line](const std::string& path) { line.play.rehearsal = read_rehearsal(path); },
            "Plays a script of events: files come and go, a visitor touches (docs/technician.md)")
        ->check(CLI::ExistingFile);
    line.app
        .add_option_function<std::string>(
            "--pace", [&line](const std::string& pace) { line.play.is_realtime = pace == "realtime"; },
            "Off screen: 'exact' waits for every picture, 'realtime' leaves out late ones (default: "
            "exact)")
        ->check(CLI::IsMember({"exact", "realtime"}));
}

void add_plan_options(CommandLine& line) {
    line.plan_command = line.app.add_subcommand("plan", "Lays out a wall without a display");
    line.plan_settings.add_to(*line.plan_command);
    line.plan_settings.add_alias(*line.plan_command, "slots", "layout.slots");
    line.plan_settings.add_alias(*line.plan_command, "seed", "layout.seed");
    line.plan_command->add_option("--catalogue", line.plan.catalogue, "The directory of records")->required();
    line.plan_command
        ->add_option_function<std::string>(
            "--size", [&line](const std::string& text) { parse_size(text, line.plan); },
            "The canvas in pixels, like 1920x1080")
        ->required();
    line.plan_command
        ->add_option(
            "--wall-width", line.plan.wall_width,
            "Plans a panning wall of this length in pixels, with --slots items on each screen's width")
        ->check(CLI::Range(16, 65536));
    line.plan_command->add_option("--film", line.plan.film, "Writes the steps of the packing as an MP4");
    line.plan_command->add_option("--svg", line.plan.svg, "Writes a drawing of the plan");
    line.plan_command->add_option("--json", line.plan.json,
                                  "Writes the plan (default: to the standard output)");
}

void run(const CommandLine& line) {
    const bool is_plan = line.plan_command->parsed();
    const Settings settings = (is_plan ? line.plan_settings : line.settings).settings();
    log::set_level(settings.log.level);
    if (is_plan) return write_plan(settings, line.plan);
    PlayOptions play = line.play;
    play.readers = std::make_shared<ReaderHost>(std::vector<std::string>{"/proc/self/exe", reader_host_word});
    play.read_settings = [&line] { return line.settings.settings(); };
    Player(settings, play).run();
}

/// Runs this program as the reader host, and ends it.
[[noreturn]] void run_reader_host() {
    int code = 0;
    try {
        serve_orders();
    } catch (const std::exception& error) {
        log::error("reader host: {}", error.what());
        code = 1;
    }
    ::_exit(code);  // without the ends of libraries, which nobody needs
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == reader_host_word) run_reader_host();
    set_mesa_options();
    CommandLine line;
    add_play_options(line);
    add_plan_options(line);
    CLI11_PARSE(line.app, argc, argv);
    try {
        run(line);
        return 0;
    } catch (const std::exception& error) {
        vitrine::log::error("{}", error.what());
        return 1;
    }
}

#include "analyzer/one_file/file_analysis.hpp"
#include "analyzer/tapestry/tapestry_state.hpp"
#include "analyzer/tapestry/weave_file.hpp"
#include "analyzer/watch/daemon.hpp"
#include "base/settings/setting_options.hpp"
#include "base/settings/settings_file.hpp"
#include "base/settings/settings_snapshot.hpp"
#include "base/state/media_error.hpp"
#include "base/state/record_json.hpp"
#include "base/system/error.hpp"
#include "base/system/log.hpp"
#include "base/system/service.hpp"

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>

namespace vitrine::analyzer {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool memory_can_be_limited = false;  // sanitizers reserve terabytes
#else
constexpr bool memory_can_be_limited = true;
#endif

struct CommandLine {
    SettingOptions options;
    std::string file;
    std::string sheet = "sheet.png";
    bool is_once = false;
    bool is_growing = false;
    Keeping keeping;
    WeaveRequest weave;
};

/// Decoded frames come and go by the megabyte: their memory is kept, for each return to the kernel costs it
/// clearing every page again.
void keep_freed_memory() {
    constexpr int most_kept = 64 << 20;
    constexpr int largest_on_heap = 32 << 20;  // what glibc allows
    ::mallopt(M_TRIM_THRESHOLD, most_kept);
    ::mallopt(M_MMAP_THRESHOLD, largest_on_heap);
}

/// The face model to use. The default one stands in share/vitrine beside the folder of this program, in a
/// build and where it is installed; where it does not stand there, "" is returned, and faces are found by the
/// cascade.
std::string face_model_at_hand(const std::string& wanted) {
    if (wanted != Settings{}.analyzer.face_model) return wanted;
    namespace fs = std::filesystem;
    const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "share/vitrine" /
                            fs::path(wanted).filename();
    return fs::exists(beside) ? beside.string() : std::string();
}

Settings settings_of(const CommandLine& line) {
    Settings settings = line.options.settings();
    settings.analyzer.face_model = face_model_at_hand(settings.analyzer.face_model);
    return settings;
}

/// The record is all that reaches the standard output: libraries that print go to the standard error.
int analyze_command(const CommandLine& line, const Settings& settings) {
    keep_freed_memory();
    const UniqueFd output(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3));
    if (!output.is_open() || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
        throw_errno("redirect the standard output");
    const auto say = [&](const MediaRecord& record) {
        const std::string json = to_json(record) + "\n";
        for (std::string_view text = json; !text.empty();) {
            const ssize_t n = ::write(output.get(), text.data(), text.size());
            if (n < 0) throw_errno("write the record");
            text.remove_prefix(static_cast<std::size_t>(n));
        }
    };
    if (line.is_growing)
        say(record_of_file(line.file, settings, line.keeping, say));
    else
        say(record_of_file(line.file, settings, line.keeping));
    return EXIT_SUCCESS;
}

int explain_command(const CommandLine& line, const Settings& settings) {
    const MediaRecord record = explain_file(line.file, line.sheet, settings);
    log::info("'{}': {} shots, explained in '{}'", line.file, record.shots.size(), line.sheet);
    return EXIT_SUCCESS;
}

int weave_command(const CommandLine& line, const Settings& settings) {
    keep_freed_memory();
    WeaveRequest request = line.weave;
    if (request.result().empty()) request.directory = request.file.filename().string() + ".tapestry";
    const std::string made = weave_file(request, settings);
    log::info("'{}': {}, woven into '{}'", request.file.string(), made, request.result().string());
    return EXIT_SUCCESS;
}

WatchOptions watch_options(const CommandLine& line, const Settings& settings,
                           const SettingsSnapshot& snapshot) {
    constexpr int mebibyte_bits = 20;
    const Settings::Analyzer& analyzer = settings.analyzer;
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t children =
        analyzer.children > 0 ? static_cast<std::size_t>(analyzer.children) : (cores + 1) / 2;
    WatchOptions options;
    options.root = std::filesystem::absolute(settings.media.root).lexically_normal();
    options.catalogue = std::filesystem::path(settings.state.directory) / "catalogue";
    options.child = {"/proc/self/exe", "--config=" + snapshot.path(), "analyze"};
    options.child.emplace_back("--grow");
    if (settings.store.max_bytes > 0) options.child.emplace_back("--keep");
    if (!settings.status.folder.empty()) {
        options.child.emplace_back("--thumbnail");
        options.thumbnail_child = {options.child[0], options.child[1], "thumbnail"};
    }
    options.tapestries.max_bytes = static_cast<std::uint64_t>(settings.tapestry.max_bytes);
    if (settings.tapestry.max_bytes > 0 && !line.is_once) options.child.emplace_back("--frames");
    options.weave = {"/proc/self/exe",
                     "--config=" + snapshot.path(),
                     "weave",
                     "--resume",
                     fmt::format("--threads={}", (cores + 1) / 2),
                     fmt::format("--most-bytes={}", tapestry_share(options.tapestries.max_bytes))};
    options.state = settings.state.directory;
    options.store = std::filesystem::path(settings.state.directory) / "store";
    options.bounds.max_bytes = static_cast<std::uint64_t>(settings.store.max_bytes);
    options.bounds.clip_side = clip_side(settings);
    options.status_folder = settings.status.folder;
    options.limits.deadline = analyzer.deadline;
    if (memory_can_be_limited)
        options.limits.memory_bytes = static_cast<std::uint64_t>(analyzer.memory) << mebibyte_bits;
    options.deadline_per_mebibyte = analyzer.deadline_per_mebibyte;
    constexpr std::uint64_t small_file = 16U << 20;  // most photos, and hardly a film that takes long
    options.pace = {.children = children, .small_bytes = small_file, .quiet = analyzer.quiet};
    if (line.is_once) options.pace.first_retry = std::chrono::hours(24);  // what waits is left to the daemon
    options.rescan = analyzer.rescan;
    options.is_once = line.is_once;
    return options;
}

/// Children that are started from now on analyse by the new settings. With a mistake in them the old ones
/// stay.
void read_settings_again(const CommandLine& line, SettingsSnapshot& snapshot) {
    try {
        const Settings settings = settings_of(line);
        log::set_level(settings.log.level);
        snapshot.replace(settings);
        log::info("settings read again: files are analysed by them from now on; folders, store and pace "
                  "after a restart");
    } catch (const SettingsError& error) {
        log::error("settings: {}; the old ones stay", error.what());
    }
}

int watch_command(const CommandLine& line, const Settings& settings) {
    SettingsSnapshot snapshot(settings);
    EventLoop loop;
    const EventLoop::Source hangup = loop.signal(SIGHUP, [&] { read_settings_again(line, snapshot); });
    bool is_interrupted = false;
    const auto quit = [&] {
        is_interrupted = true;
        loop.quit();
    };
    const EventLoop::Source terminate = loop.signal(SIGTERM, quit);
    const EventLoop::Source interrupt = loop.signal(SIGINT, quit);
    const Daemon daemon(loop, watch_options(line, settings, snapshot));
    service::ready(daemon.status());
    log::info("watching '{}': {}", settings.media.root, daemon.status());
    loop.run();
    service::stopping();
    if (!line.is_once) return EXIT_SUCCESS;
    return daemon.is_up_to_date() && !is_interrupted ? EXIT_SUCCESS : EXIT_FAILURE;
}

int run(int argc, char** argv) {
    CommandLine line;
    CLI::App app("Looks at the photos and films of the media folder and says what matters in them.",
                 "vitrine-analyzer");
    app.require_subcommand(1)->fallthrough();
    line.options.add_to(app);
    CLI::App* analyze = app.add_subcommand("analyze", "Print the record of one file as JSON");
    analyze->add_option("FILE", line.file)->required();
    analyze->add_flag("--grow", line.is_growing, "Print each shot as it is found, the whole record last");
    analyze->add_flag("--keep", line.keeping.stores, "Put it into the store, for the player to play from");
    analyze->add_flag("--frames", line.keeping.has_frames, "Keep a film's frames for its tapestry");
    analyze->add_flag("--sound", line.keeping.has_sound, "Put the sound of a film into the store, too");
    analyze->add_flag("--thumbnail", line.keeping.has_thumbnail, "Leave a thumbnail for the status folder");
    analyze->add_flag("--as-it-is", line.keeping.takes_cut_streams,
                      "Do not wait for the rest of a stream that breaks off");
    CLI::App* thumbnail =
        app.add_subcommand("thumbnail", "Leave the thumbnail of a file that was analysed before");
    thumbnail->add_option("FILE", line.file)->required();
    CLI::App* explain = app.add_subcommand("explain", "Draw how the regions of one file came about");
    explain->add_option("FILE", line.file)->required();
    explain->add_option("-o,--output", line.sheet, "The sheet, a PNG")->capture_default_str();
    CLI::App* weave = app.add_subcommand("weave", "Weave the tapestry of one film");
    weave->add_option("FILE", line.weave.file)->required();
    CLI::Option* folder = weave->add_option("-o,--output", line.weave.directory,
                                            "A folder for tiles and index [FILE.tapestry]");
    weave->add_option("--sheet", line.weave.sheet, "A PNG of all levels below each other");
    weave->add_option("--zoom", line.weave.zoom,
                      "A PNG of the zoom between the two coarsest levels: faded, bent, synthesised");
    weave->add_option("--levels", line.weave.levels, "How many levels at most, the coarsest first")
        ->check(CLI::Range(1, 32))
        ->capture_default_str();
    weave->add_option("--times", line.weave.times,
                      "A file with the coarsest level's times, seconds, one a line");
    weave->add_flag("--uniform", line.weave.is_uniform,
                    "Keyframes at equal distances, not by what they show");
    weave->add_flag("--resume", line.weave.resumes, "Go on where an earlier weaving into the folder ended")
        ->needs(folder);
    weave->add_option("--most-bytes", line.weave.most_bytes, "Bytes of the tapestry at most, about [any]");
    weave->add_option("--threads", line.weave.threads, "At the same time [one a core]")
        ->check(CLI::Range(0, 256));
    CLI::App* watch = app.add_subcommand("watch", "Keep the catalogue equal to the media folder");
    watch->add_flag("--once", line.is_once, "End as soon as the catalogue is up to date");
    for (CLI::App* command : {analyze, thumbnail, explain, weave, watch})
        command->fallthrough();
    CLI11_PARSE(app, argc, argv);

    const Settings settings = settings_of(line);
    log::set_level(settings.log.level);
    if (*analyze) return analyze_command(line, settings);
    if (*thumbnail) return leave_thumbnail(line.file, settings) ? EXIT_SUCCESS : EXIT_FAILURE;
    if (*explain) return explain_command(line, settings);
    if (*weave) return weave_command(line, settings);
    return watch_command(line, settings);
}

}  // namespace

}  // namespace vitrine::analyzer

int main(int argc, char** argv) {
    try {
        return vitrine::analyzer::run(argc, argv);
    } catch (const std::exception& error) {
        vitrine::log::error("{}", error.what());
        return EXIT_FAILURE;
    }
}

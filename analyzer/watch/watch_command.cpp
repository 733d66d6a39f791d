#include "analyzer/watch/watch_command.hpp"

#include "analyzer/one_file/analysed_file.hpp"
#include "analyzer/store/store_place.hpp"
#include "analyzer/tapestry/tapestry_state.hpp"
#include "analyzer/watch/daemon.hpp"
#include "base/settings/settings_file.hpp"
#include "base/settings/settings_snapshot.hpp"
#include "base/settings/share_address.hpp"
#include "base/system/log.hpp"
#include "base/system/sandbox.hpp"
#include "base/system/service.hpp"
#include "base/system/stop_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <thread>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool can_limit_memory = false;  // sanitizers reserve terabytes
#else
constexpr bool can_limit_memory = true;
#endif

constexpr auto stop_patience = std::chrono::seconds(5);  // half of TimeoutStopSec= of the unit

/// Half of the cores, rounded up.
std::size_t usual_parallelism() {
    return (std::max(1U, std::thread::hardware_concurrency()) + 1) / 2;
}

AnalysisCommand analysis_command(const Settings::Analyzer& settings, const std::string& config) {
    constexpr int mebibyte_bits = 20;
    AnalysisCommand command{.words = {"/proc/self/exe", config, "analyze"},
                            .limits = {},
                            .seconds_per_mebibyte = settings.deadline_per_mebibyte};
    command.limits.patience = {.computing = settings.deadline, .idling = settings.deadline};
    if (can_limit_memory)
        command.limits.memory_bytes = static_cast<std::uint64_t>(settings.memory) << mebibyte_bits;
    return command;
}

/// The by-products of each analysis; sound and cut streams are up to the single file.
AnalysisOutputs analysis_outputs(const Settings& settings) {
    return {.growth = true,
            .stored = settings.store.max_bytes > 0,
            .frames = settings.tapestry.max_bytes > 0,
            .thumbnail = !settings.status.folder.empty()};
}

Pace pace(const Settings::Analyzer& settings, bool is_once) {
    constexpr std::uint64_t small_file = 16U << 20;  // most photos, and hardly a film that takes long
    Pace pace{.children =
                  settings.children > 0 ? static_cast<std::size_t>(settings.children) : usual_parallelism(),
              .small_bytes = small_file,
              .quiet = settings.quiet};
    if (is_once) pace.first_retry = std::chrono::hours(24);  // waiting files are left to the daemon
    return pace;
}

WordSettings word_settings(const Settings& settings) {
    return {.captions = settings.show.captions,
            .wall_code = settings.show.qr,
            .share_address = share_address(settings),
            .tells_years = settings.show.on_this_day};
}

/// @param snapshot  the file of settings that children read
WatchOptions watch_options(const Settings& settings, const std::string& snapshot, WatchEnd end) {
    const bool is_once = end != WatchEnd::never;
    const std::string config = "--config=" + snapshot;
    const fs::path state = settings.state.directory;
    WatchOptions options;
    options.root = fs::absolute(settings.media.root).lexically_normal();
    options.state = state;
    options.catalogue = state / "catalogue";
    options.store = state / "store";
    options.bounds.max_bytes = static_cast<std::uint64_t>(settings.store.max_bytes);
    options.bounds.clip_side = clip_side(settings);
    options.analysis = analysis_command(settings.analyzer, config);
    options.outputs = analysis_outputs(settings);
    options.status_folder = settings.status.folder;
    if (options.outputs.thumbnail) options.thumbnail_child = {"/proc/self/exe", config, "thumbnail"};
    options.words = word_settings(settings);
    options.words_child = {"/proc/self/exe", config, "set-words", "--"};
    options.tapestries.max_bytes = static_cast<std::uint64_t>(settings.tapestry.max_bytes);
    options.weave = {"/proc/self/exe",
                     config,
                     "weave",
                     "--resume",
                     fmt::format("--threads={}", usual_parallelism()),
                     fmt::format("--most-bytes={}", tapestry_share(options.tapestries.max_bytes))};
    const AnalysisSettings analysis = analysis_settings(settings.analyzer);
    if (!analysis.saliency_model.empty() && !analysis.is_student)
        options.refine = {"/proc/self/exe", config, "analyze", "--network"};
    options.pace = pace(settings.analyzer, is_once);
    options.rescan = settings.analyzer.rescan;
    options.is_once = is_once;
    options.weaves = end != WatchEnd::analysed;
    return options;
}

/// Reads the settings anew; those before stay where the new ones have a mistake.
void read_again(const ReadSettings& read_settings, SettingsSnapshot& snapshot, Daemon& daemon) {
    try {
        const Settings settings = read_settings();
        log::set_level(settings.log.level);
        snapshot.replace(settings);
        daemon.change_words(word_settings(settings));
        log::info("settings read again: new analyses and words follow them; folders, store and pace after a "
                  "restart");
    } catch (const SettingsError& error) {
        log::error("settings: {}; the old ones stay", error.what());
    }
}

/// Says at the start how far the children that read strangers' files are locked in.
void tell_sandbox() {
    const Sandbox sandbox = available_sandbox();
    if (sandbox.limits_files && sandbox.limits_calls)
        log::info("{}", in_words(sandbox));
    else
        log::warning("{}", in_words(sandbox));
}

}  // namespace

int watch_media(const Settings& settings, const ReadSettings& read_settings, WatchEnd end) {
    const bool is_once = end != WatchEnd::never;
    SettingsSnapshot snapshot(settings);
    EventLoop loop;
    std::optional<Daemon> daemon;
    const EventLoop::Source hangup =
        loop.signal(SIGHUP, [&] { read_again(read_settings, snapshot, *daemon); });
    bool is_interrupted = false;
    const StopRequest stop(
        loop, {.patience = stop_patience, .exit_code = is_once ? EXIT_FAILURE : EXIT_SUCCESS}, [&] {
            is_interrupted = true;
            loop.quit();
        });
    daemon.emplace(loop, watch_options(settings, snapshot.path(), end));
    service::ready(daemon->status());
    log::info("watching '{}': {}", settings.media.root, daemon->status());
    tell_sandbox();
    loop.run();
    service::stopping();
    if (!is_once) return EXIT_SUCCESS;
    return daemon->is_up_to_date() && !is_interrupted ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace vitrine::analyzer

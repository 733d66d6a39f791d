#include "analyzer/lettering/set_words.hpp"
#include "analyzer/one_file/file_analysis.hpp"
#include "analyzer/tapestry/weave_file.hpp"
#include "analyzer/watch/watch_command.hpp"
#include "base/settings/setting_options.hpp"
#include "base/system/log.hpp"

#include <CLI/CLI.hpp>
#include <malloc.h>

#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace vitrine::analyzer {

namespace {

struct CommandLine {
    SettingOptions options;
    std::string file;
    std::string sheet = "sheet.png";
    bool is_once = false;
    bool leaves_tapestries = false;
    AnalysisOutputs outputs;
    WeaveRequest weave;
    std::vector<std::string> words;
};

/// Keeps freed blocks, as this process decodes many frames of megabytes: after each return to the kernel
/// every page would be cleared again. Call it before any thread starts.
void keep_freed_memory() {
    constexpr int max_kept = 64 << 20;
    constexpr int max_on_heap = 32 << 20;  // the largest value that glibc allows
    ::mallopt(M_TRIM_THRESHOLD, max_kept);
    ::mallopt(M_MMAP_THRESHOLD, max_on_heap);
}

int run_analyze(const CommandLine& line, const Settings& settings) {
    keep_freed_memory();
    print_analysis(line.file, settings, line.outputs);
    return EXIT_SUCCESS;
}

int run_thumbnail(const CommandLine& line, const Settings& settings) {
    return write_thumbnail(line.file, settings) ? EXIT_SUCCESS : EXIT_FAILURE;
}

int run_explain(const CommandLine& line, const Settings& settings) {
    const MediaRecord record = explain_file(line.file, line.sheet, settings);
    log::info("'{}': {} shots, explained in '{}'", line.file, record.shots.size(), line.sheet);
    return EXIT_SUCCESS;
}

int run_weave(const CommandLine& line, const Settings& settings) {
    keep_freed_memory();
    WeaveRequest request = line.weave;
    request.is_alone = true;
    if (request.result().empty()) request.directory = request.file.filename().string() + ".tapestry";
    const std::string made = weave_file(request, settings);
    log::info("'{}': {}, woven into '{}'", request.file.string(), made, request.result().string());
    return EXIT_SUCCESS;
}

int run_watch(const CommandLine& line, const Settings& settings) {
    const WatchEnd once = line.leaves_tapestries ? WatchEnd::analysed : WatchEnd::woven;
    return watch_media(
        settings, [&line] { return line.options.settings(); }, line.is_once ? once : WatchEnd::never);
}

int run_set_words(const CommandLine& line, const Settings& settings) {
    set_words(line.words, settings);
    return EXIT_SUCCESS;
}

void add_analyze(CLI::App& command, CommandLine& line) {
    command.add_option("FILE", line.file)->required();
    for (const OutputFlag& flag : output_flags)
        command.add_flag(flag.name, line.outputs.*flag.value, flag.help);
}

void add_thumbnail(CLI::App& command, CommandLine& line) {
    command.add_option("FILE", line.file)->required();
}

void add_explain(CLI::App& command, CommandLine& line) {
    command.add_option("FILE", line.file)->required();
    command.add_option("-o,--output", line.sheet, "The sheet, a PNG")->capture_default_str();
}

void add_weave(CLI::App& command, CommandLine& line) {
    WeaveRequest& weave = line.weave;
    command.add_option("FILE", weave.file)->required();
    CLI::Option* folder = command.add_option("-o,--output", weave.directory,
                                             "The folder for tiles and index (default: FILE.tapestry)");
    command.add_option("--sheet", weave.sheet, "Draws all levels below each other, as a PNG");
    command.add_option("--zoom", weave.zoom,
                       "Draws the zoom between the two coarsest levels in three ways, as a PNG");
    CLI::Option* page = command.add_option(
        "--html", weave.html, "A folder for a page that any browser shows: tiles, zoom, a small silent film");
    CLI::Option* poster =
        command.add_option("--poster", weave.poster, "Draws the coarsest level to be printed, as a PNG");
    command
        .add_option("--height", weave.poster_height,
                    "Height of the poster in pixels; a smaller film is enlarged, and the log says how much")
        ->check(CLI::Range(100, 6000))
        ->capture_default_str()
        ->needs(poster);
    command.add_option("--levels", weave.levels, "Limit of the levels; the coarsest are woven first")
        ->check(CLI::Range(1, 32))
        ->capture_default_str();
    command.add_option("--times", weave.times,
                       "A file with the times of the coarsest keyframes: seconds, one a line");
    command.add_option("--keyframes", weave.keyframes,
                       "A file that chooses keyframes, as FILE.tapestry.toml beside a film does");
    command.add_flag("--uniform", weave.is_uniform, "Takes keyframes at equal distances, not by content");
    command.add_flag("--resume", weave.resumes, "Resumes an interrupted weaving into the folder")
        ->needs(folder)
        ->excludes(page)
        ->excludes(poster);
    command.add_option("--most-bytes", weave.max_bytes,
                       "Approximate limit of the tapestry in bytes (default: none)");
    command.add_option("--threads", weave.threads, "Number of threads (default: one for each core)")
        ->check(CLI::Range(0, 256));
}

void add_set_words(CLI::App& command, CommandLine& line) {
    command.add_option("TEXT", line.words, "A line each")->required();
}

void add_watch(CLI::App& command, CommandLine& line) {
    CLI::Option* once = command.add_flag(
        "--once", line.is_once, "Ends as soon as the catalogue is up to date and all tapestries are woven");
    command.add_flag("--without-tapestries", line.leaves_tapestries, "Leaves tapestries to a later run")
        ->needs(once);
}

struct Command {
    const char* name;
    const char* help;
    void (*add)(CLI::App&, CommandLine&);
    int (*run)(const CommandLine&, const Settings&);
};

constexpr std::array commands{
    Command{"analyze", "Prints the record of one file as JSON", add_analyze, run_analyze},
    Command{"thumbnail", "Writes the thumbnail of a file that was analysed before", add_thumbnail,
            run_thumbnail},
    Command{"explain", "Draws how the regions of one file came about", add_explain, run_explain},
    Command{"weave", "Weaves the tapestry of one film", add_weave, run_weave},
    Command{"set-words", "Sets words as pictures, which the wall shows", add_set_words, run_set_words},
    Command{"watch", "Keeps the catalogue up to date with the media folder", add_watch, run_watch},
};

int run(int argc, char** argv) {
    CommandLine line;
    CLI::App app("Analyses photos and films: finds in each the region that must stay visible.",
                 "vitrine-analyzer");
    app.require_subcommand(1)->fallthrough();
    line.options.add_to(app);
    for (const Command& command : commands) {
        CLI::App* subcommand = app.add_subcommand(command.name, command.help);
        subcommand->fallthrough();
        command.add(*subcommand, line);
    }
    CLI11_PARSE(app, argc, argv);

    const Settings settings = line.options.settings();
    log::set_level(settings.log.level);
    for (const Command& command : commands)
        if (app.got_subcommand(command.name)) return command.run(line, settings);
    return EXIT_FAILURE;
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

#include "analyzer/one_file/file_analysis.hpp"
#include "analyzer/tapestry/weave_file.hpp"
#include "analyzer/watch/watch_command.hpp"
#include "base/settings/setting_options.hpp"
#include "base/system/log.hpp"
#include "base/system/memory.hpp"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <exception>
#include <string>

namespace vitrine::analyzer {

namespace {

struct CommandLine {
    SettingOptions options;
    std::string file;
    std::string sheet = "sheet.png";
    bool is_once = false;
    AnalysisOutputs outputs;
    WeaveRequest weave;
};

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
    if (request.result().empty()) request.directory = request.file.filename().string() + ".tapestry";
    const std::string made = weave_file(request, settings);
    log::info("'{}': {}, woven into '{}'", request.file.string(), made, request.result().string());
    return EXIT_SUCCESS;
}

int run_watch(const CommandLine& line, const Settings& settings) {
    return watch_media(
        settings, [&line] { return line.options.settings(); }, line.is_once);
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
    CLI::Option* folder =
        command.add_option("-o,--output", weave.directory, "A folder for tiles and index [FILE.tapestry]");
    command.add_option("--sheet", weave.sheet, "A PNG of all levels below each other");
    command.add_option("--zoom", weave.zoom,
                       "A PNG of the zoom between the two coarsest levels: faded, bent, synthesised");
    command.add_option("--levels", weave.levels, "Number of levels at most, the coarsest first")
        ->check(CLI::Range(1, 32))
        ->capture_default_str();
    command.add_option("--times", weave.times, "A file with the coarsest level's times, seconds, one a line");
    command.add_flag("--uniform", weave.is_uniform, "Keyframes at equal distances, not chosen by content");
    command.add_flag("--resume", weave.resumes, "Go on where an earlier weaving into the folder ended")
        ->needs(folder);
    command.add_option("--most-bytes", weave.max_bytes, "Bytes of the tapestry at most, approximately [any]");
    command.add_option("--threads", weave.threads, "Number of threads [one a core]")
        ->check(CLI::Range(0, 256));
}

void add_watch(CLI::App& command, CommandLine& line) {
    command.add_flag("--once", line.is_once, "End as soon as the catalogue is up to date");
}

struct Command {
    const char* name;
    const char* help;
    void (*add)(CLI::App&, CommandLine&);
    int (*run)(const CommandLine&, const Settings&);
};

constexpr std::array commands{
    Command{"analyze", "Print the record of one file as JSON", add_analyze, run_analyze},
    Command{"thumbnail", "Write the thumbnail of a file that was analysed before", add_thumbnail,
            run_thumbnail},
    Command{"explain", "Draw how the regions of one file came about", add_explain, run_explain},
    Command{"weave", "Weave the tapestry of one film", add_weave, run_weave},
    Command{"watch", "Keep the catalogue equal to the media folder", add_watch, run_watch},
};

int run(int argc, char** argv) {
    CommandLine line;
    CLI::App app("Looks at the photos and films of the media folder and says what matters in them.",
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

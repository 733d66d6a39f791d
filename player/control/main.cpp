#include "base/system/error.hpp"
#include "player/control/commands.hpp"
#include "player/control/control_client.hpp"
#include "player/display/picture.hpp"

#include <CLI/CLI.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// vitrinectl: asks the running player, or changes what it shows. The commands are in commands.cpp.

namespace vitrine::player {

namespace {

using Json = nlohmann::ordered_json;

constexpr int exit_failed = 1;
constexpr int exit_unknown_file = 2;
constexpr int exit_not_allowed = 3;
constexpr int exit_not_running = 4;

/// Replaces control characters: in a name from outside they would change the terminal.
std::string printable(const std::string& text) {
    std::string made;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        made += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
    }
    return made;
}

void print(const std::string& line) {
    fmt::print("{}\n", printable(line));
}

void print_json(const std::string& json) {
    fmt::print("{}\n", json);
}

void print_cells(const Json& status) {
    for (const Json& cell : status.at("cells"))
        print(
            fmt::format("  slot {:<3} {}{}{}", cell.value("slot", 0), cell.value("file", ""),
                        cell.value("shot", 0) > 0 ? fmt::format(", shot {}", cell.value("shot", 0) + 1) : "",
                        cell.value("pinned", false) ? " (pinned)" : ""));
}

/// The analyzer's count of files: "8 ready, 1 waiting".
std::string files_in_words(const Json& analyzer) {
    std::string words;
    const Json states = analyzer.value("states", Json::object());
    for (const auto& [state, count] : states.items())
        words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count.get<std::size_t>(), state);
    if (words.empty()) words = "no files";
    return words + (analyzer.value("online", true) ? "" : "; the media folder is not there");
}

/// The analyzer's entry of one file: "waiting since 2026-11-22 17:57: the copy is not complete".
std::string entry_in_words(const Json& entry) {
    std::string words = entry.value("state", "");
    if (entry.contains("since"))
        words +=
            fmt::format(" since {:%Y-%m-%d %H:%M}", fmt::localtime(entry.value("since", std::time_t{0})));
    if (entry.contains("reason")) words += ": " + entry.value("reason", "");
    if (entry.contains("shown")) words += "; shown " + entry.value("shown", "");
    return words;
}

/// "6 photos, 2 films with all pictures, 1 film with key pictures".
std::string sources_in_words(const Json& sources) {
    std::size_t photos = 0;
    std::map<std::string, std::size_t> films;
    for (const Json& source : sources) {
        const std::string tier = source.value("pictures", "");
        ++(tier == "photo" ? photos : films[tier]);
    }
    std::string words = fmt::format("{} {}", photos, photos == 1 ? "photo" : "photos");
    for (const auto& [tier, count] : films)
        words += fmt::format(", {} {} with {} pictures", count, count == 1 ? "film" : "films", tier);
    return words;
}

void print_outputs(const Json& outputs) {
    for (const Json& output : outputs) {
        const double hertz = output.value("hertz", 0.0);
        print(fmt::format("output    {}, {}x{} px{}, {} flips", output.value("name", ""),
                          output.value("width", 0), output.value("height", 0),
                          hertz > 0 ? fmt::format(", {:.2f} Hz", hertz) : "", output.value("flips", 0U)));
    }
}

void print_wall(const Json& wall) {
    print(fmt::format("boxes     '{}', here is '{}'; {}", wall.value("name", ""), wall.value("this", ""),
                      wall.value("link", "")));
    for (const Json& box : wall.at("boxes")) {
        print(fmt::format("  {:<8} {}", box.value("name", ""), box.value("says", "")));
        for (const Json& path : box.at("lacks"))
            print(fmt::format("          lacks {}", path.get<std::string>()));
        if (const std::string why = box.value("fetch_fault", ""); !why.empty())
            print("          cannot fetch files: " + why);
    }
}

void print_status(const Json& status) {
    print(fmt::format("state     {}{}", status.value("state", ""),
                      status.value("paused", false) ? ", paused" : ""));
    print("display   " + status.value("display", ""));
    print_outputs(status.at("outputs"));
    for (const Json& fault : status.value("faults", Json::array()))
        print("fault     " + fault.get<std::string>());
    print(fmt::format("pictures  {} shown, {} left out as too late, {:.1f} a second, the last {:.1f} s ago",
                      status.value("pictures", 0), status.value("late", 0),
                      status.value("pictures_per_second", 0.0), status.value("seconds_since_flip", 0.0)));
    print(fmt::format("sources   {}; {} without a picture so far; {} pictures of films were late",
                      sources_in_words(status.at("sources")), status.value("queue", 0),
                      status.value("film_pictures_late", 0)));
    if (status.contains("analyzer")) print("analyzer  " + files_in_words(status.at("analyzer")));
    for (const auto& [key, word] : {std::pair("pinned", "pinned"), std::pair("removed", "removed")})
        for (const Json& file : status.at(key))
            print(fmt::format("{:<9} {}", word, file.get<std::string>()));
    if (status.contains("wall")) print_wall(status.at("wall"));
    print(fmt::format("wall      {} items of {} files", status.at("cells").size(), status.value("files", 0)));
    print_cells(status);
}

void print_why(const Json& report) {
    const std::string state = report.value("state", "");
    print(fmt::format("{}: {}", report.value("file", ""), state));
    print("  " + report.value("says", ""));
    if (state == "ready")
        print(fmt::format("  {}, {}x{} px, shots: {}", report.value("kind", ""), report.value("width", 0),
                          report.value("height", 0), report.value("shots", 0)));
    if (state == "ready" && !report.value("reason", "").empty()) print("  " + report.value("reason", ""));
    if (report.contains("analyzer")) print("  analyzer: " + entry_in_words(report.at("analyzer")));
}

/// Saves the first output's picture in the file; the others' go beside it, under the outputs' names.
Json save_pictures(const std::vector<OutputPicture>& pictures, const std::filesystem::path& path) {
    if (pictures.empty()) throw ControlError(ControlError::Kind::failed, "no display shows a picture");
    Json saved = Json::array();
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        std::filesystem::path file = path;
        if (i > 0)
            file.replace_filename(path.stem().string() + "-" + pictures[i].output +
                                  path.extension().string());
        save_png(pictures[i].picture, file);
        saved.push_back({{"output", pictures[i].output}, {"file", file.string()}});
    }
    return saved;
}

bool is_number(const std::string& text) {
    return !text.empty() && text.size() < 4 && text.find_first_not_of("0123456789") == std::string::npos;
}

/// The words of one command line.
struct Words {
    std::string command;
    std::string operand;
    std::string off;      // "off", or empty
    bool is_all = false;  // --all, in place of an operand
    bool is_json = false;
};

/// The command that the words name. If several have the same name, the one with a fitting operand.
const Command& command_of(const Words& words) {
    const Command* found = nullptr;
    for (const Command& command : commands())
        if (words.command == command.name && (found == nullptr || is_number(words.operand))) found = &command;
    return *found;
}

CommandCall call_of(const Command& command, const Words& words) {
    CommandCall call{.folder = std::filesystem::current_path().string(), .is_on = command.is_on};
    if (command.operand == Operand::slot)
        call.slot = std::stoi(words.operand);
    else
        call.file = words.operand;
    if (!words.off.empty()) call.is_on = false;
    return call;
}

/// Tells whether a file without a record is in the media folder. This process looks, and not the player: a
/// share that hangs keeps nobody else waiting.
/// @param report  the player's answer to `why`
CommandAnswer look_for_unknown(CommandAnswer report) {
    Json json = Json::parse(report.text);
    if (json.value("state", "") != "unknown") return report;
    bool is_there = false, may_look = true;
    for (const std::string& place : json.value("places", std::vector<std::string>{})) {
        is_there |= ::access(place.c_str(), F_OK) == 0;
        may_look &= is_there || errno != EACCES;
    }
    if (is_there) {
        json["state"] = "new";
        if (json.value("reason", "").empty())
            json["says"] = "It is in the media folder and has not been looked at yet.";
    } else if (may_look) {
        json["says"] = "There is no such file in the media folder.";
    }
    report.text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return report;
}

/// Prints the answer: as JSON, by the command's own printer, or as a line.
int print_answer(const Command& command, const Words& words, const CommandAnswer& answer) {
    const std::string_view name = command.name;
    if (command.operand == Operand::picture) {
        const Json saved = save_pictures(answer.pictures, words.operand);
        if (words.is_json) print_json(saved.dump(-1, ' ', false, Json::error_handler_t::replace));
        for (const Json& one : words.is_json ? Json::array() : saved)
            print(one.value("output", "") + ": " + one.value("file", ""));
        return 0;
    }
    if (words.is_json && std::string_view(command.result) == "s") {
        print_json(answer.text);
    } else if (name == "status") {
        print_status(Json::parse(answer.text));
    } else if (name == "why") {
        print_why(Json::parse(answer.text));
    } else if (name == "layout list") {
        for (const Json& layout : Json::parse(answer.text))
            print(layout.get<std::string>());
    } else if (const std::string line = answer_line(command, !words.off.empty(), answer); !line.empty()) {
        print(line);
    }
    const bool is_unknown = name == "why" && Json::parse(answer.text).value("state", "") == "unknown";
    return is_unknown ? exit_unknown_file : 0;
}

const char* in_help(Operand operand) {
    switch (operand) {
    case Operand::file:
    case Operand::file_or_all:
        return "FILE";
    case Operand::slot:
        return "SLOT";
    case Operand::picture:
        return "OUT.png";
    case Operand::layout:
        return "NAME";
    case Operand::none:
        break;
    }
    return "";
}

/// The operands that a command's name may have, "FILE|SLOT".
std::string operands_of(const std::string& name) {
    std::string operands;
    for (const Command& command : commands())
        if (name == command.name && command.operand != Operand::none)
            operands += (operands.empty() ? "" : "|") + std::string(in_help(command.operand));
    return operands;
}

/// For the shell's completion: prints a line for each command, with its operands.
void print_commands() {
    std::string last;
    for (const Command& command : commands()) {
        if (std::exchange(last, command.name) == command.name) continue;
        print(fmt::format("{} {}{}", command.name, operands_of(command.name),
                          takes_off(command) ? " off" : ""));
    }
}

std::string footer() {
    std::string restricted;
    for (const Command& command : commands())
        if (!command.is_for_all && *command.help != '\0')
            restricted += (restricted.empty() ? "" : ", ") + std::string(command.name);
    return fmt::format(
        "FILE is a path on this machine, a path in the media folder, or the share's path on another "
        "machine.\n"
        "`vitrinectl wall --help` tells how several boxes show one wall.\n"
        "Anyone may ask; {} are for members of the group vitrine-admin.\n"
        "\n"
        "Exit status: 0 done; 1 failed; 2 there is no such file in the media folder; 3 not allowed; 4 the "
        "player\n"
        "is not running; above 100 a wrong command line.",
        restricted);
}

/// The group of a command whose name has two words, such as `layout`; the program itself for others.
CLI::App& group_of(CLI::App& app, const std::string& name) {
    const std::size_t end = name.find(' ');
    if (end == std::string::npos) return app;
    const std::string group = name.substr(0, end);
    const auto is_group = [&](const CLI::App* known) { return known->get_name() == group; };
    if (const auto known = app.get_subcommands(is_group); !known.empty()) return *known.front();
    CLI::App* made = app.add_subcommand(group, "Saves, loads, forgets or lists layouts of the wall");
    made->require_subcommand(1)->fallthrough();
    return *made;
}

void add_commands(CLI::App& app, Words& words) {
    std::string last;
    for (const Command& command : commands()) {
        if (std::exchange(last, command.name) == command.name) continue;
        const std::string name = command.name;
        CLI::App* made = group_of(app, name).add_subcommand(name.substr(name.find(' ') + 1), command.help);
        made->fallthrough();
        made->callback([&words, name] { words.command = name; });
        if (command.operand == Operand::none) continue;
        CLI::Option* operand = made->add_option(operands_of(command.name), words.operand);
        if (command.operand == Operand::file_or_all)
            made->add_flag("--all", words.is_all, "All files")->excludes(operand);
        else
            operand->required();
        if (takes_off(command))
            made->add_option("off", words.off, "Ends the pin")->check(CLI::IsMember({"off"}));
    }
}

/// `vitrinectl wall` changes this machine and not what a player shows: a script of another package does it.
[[noreturn]] void run_wall(char** words) {
    ::execv(VITRINE_WALL_COMMAND, words);
    if (errno == ENOENT) throw std::runtime_error("walls of several boxes need the package vitrine-wall");
    throw_errno("run '{}'", VITRINE_WALL_COMMAND);
}

int run(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "wall") run_wall(argv + 1);
    CLI::App app("Asks the running player of Vitrine, or changes what it shows.", "vitrinectl");
    app.require_subcommand(0, 1)->fallthrough()->footer(footer());
    Words words;
    bool wants_commands = false;
    app.add_flag("--json", words.is_json, "Prints the answer as JSON: status, why, screenshot, layout list");
    app.add_flag("--commands", wants_commands, "Lists the commands and their arguments, for shells");
    add_commands(app, words);
    CLI11_PARSE(app, argc, argv);
    if (wants_commands) {
        print_commands();
        return 0;
    }
    if (words.command.empty()) return app.exit(CLI::RequiredError("A command"));
    const Command& command = command_of(words);
    if (command.operand == Operand::file_or_all && words.operand.empty() && !words.is_all)
        return app.exit(CLI::RequiredError("FILE or --all"));
    CommandAnswer answer = ControlClient().call(command, call_of(command, words));
    if (words.command == "why") answer = look_for_unknown(std::move(answer));
    return print_answer(command, words, answer);
}

}  // namespace

}  // namespace vitrine::player

int main(int argc, char** argv) {
    using Kind = vitrine::player::ControlError::Kind;
    try {
        return vitrine::player::run(argc, argv);
    } catch (const vitrine::player::ControlError& error) {
        fmt::print(stderr, "vitrinectl: {}\n", vitrine::player::printable(error.what()));
        if (error.kind() == Kind::not_running) return vitrine::player::exit_not_running;
        return error.kind() == Kind::not_allowed ? vitrine::player::exit_not_allowed
                                                 : vitrine::player::exit_failed;
    } catch (const std::exception& error) {
        fmt::print(stderr, "vitrinectl: {}\n", vitrine::player::printable(error.what()));
        return vitrine::player::exit_failed;
    }
}

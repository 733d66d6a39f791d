#include "player/control/control_client.hpp"
#include "player/display/picture.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>

// vitrinectl: asks the running player, and has it change what it shows.

namespace vitrine::player {

namespace {

using Json = nlohmann::ordered_json;

constexpr int exit_failed = 1;
constexpr int exit_unknown_file = 2;
constexpr int exit_not_allowed = 3;
constexpr int exit_not_running = 4;

constexpr const char* footer =
    "FILE is a path on this machine, from the media folder on, or as the share shows it elsewhere.\n"
    "Anyone may ask; next, pause, resume, pin, remove and reload are for members of the group "
    "vitrine-admin.\n"
    "\n"
    "Exit status: 0 done; 1 it failed; 2 there is no such file in the media folder; 3 not allowed; 4 the "
    "player\n"
    "is not running; above 100 a wrong command line.";

/// Control characters of names from outside would change the terminal.
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

void print_status(const Json& status) {
    print(fmt::format("state     {}{}", status.value("state", ""),
                      status.value("paused", false) ? ", paused" : ""));
    print("display   " + status.value("display", ""));
    for (const Json& output : status.at("outputs"))
        print(fmt::format("output    {} {}x{}, {:.2f} Hz, {} flips", output.value("name", ""),
                          output.value("width", 0), output.value("height", 0), output.value("hertz", 0.0),
                          output.value("flips", 0U)));
    print(fmt::format("pictures  {} shown, {} late, {:.1f} a second, last flip {:.1f} s ago",
                      status.value("pictures", 0), status.value("late", 0),
                      status.value("pictures_per_second", 0.0), status.value("seconds_since_flip", 0.0)));
    std::size_t photos = 0;
    std::map<std::string, std::size_t> films;
    for (const Json& source : status.at("sources")) {
        const std::string tier = source.value("pictures", "");
        ++(tier == "photo" ? photos : films[tier]);
    }
    std::string tiers;
    for (const auto& [tier, count] : films)
        tiers += fmt::format(", {} with {} pictures", count, tier);
    print(fmt::format("sources   {} photos, films:{}; {} to come; pictures of films late: {}", photos,
                      tiers.empty() ? " none" : tiers.substr(1), status.value("queue", 0),
                      status.value("film_pictures_late", 0)));
    if (status.contains("analyzer")) print("analyzer  " + status.at("analyzer").dump());
    for (const auto& [key, word] : {std::pair("pinned", "pinned"), std::pair("removed", "removed")})
        for (const Json& file : status.at(key))
            print(fmt::format("{:<9} {}", word, file.get<std::string>()));
    print(fmt::format("wall      {} items of {} files", status.at("cells").size(), status.value("files", 0)));
    print_cells(status);
}

int status(bool is_json) {
    const std::string said = ControlClient().status();
    if (is_json)
        print_json(said);
    else
        print_status(Json::parse(said));
    return 0;
}

int why(const std::string& file, bool is_json) {
    const std::string said = ControlClient().why(file);
    const Json report = Json::parse(said);
    const std::string state = report.value("state", "");
    if (is_json) {
        print_json(said);
    } else {
        print(fmt::format("{}: {}", report.value("file", file), state));
        print("  " + report.value("says", ""));
        if (state == "ready")
            print(fmt::format("  {}, {}x{} px, shots: {}", report.value("kind", ""), report.value("width", 0),
                              report.value("height", 0), report.value("shots", 0)));
        if (state == "ready" && !report.value("reason", "").empty()) print("  " + report.value("reason", ""));
        if (report.contains("analyzer")) print("  analyzer: " + report.at("analyzer").dump());
    }
    return state == "unknown" ? exit_unknown_file : 0;
}

/// The first output's picture into the file, the others' beside it under their names.
int screenshot(const std::filesystem::path& path, bool is_json) {
    const auto shots = ControlClient().screenshot();
    if (shots.empty()) throw ControlError(ControlError::Kind::failed, "no display shows anything");
    Json written = Json::array();
    for (std::size_t i = 0; i < shots.size(); ++i) {
        std::filesystem::path file = path;
        if (i > 0)
            file.replace_filename(path.stem().string() + "-" + shots[i].output + path.extension().string());
        save_png(shots[i].picture, file);
        written.push_back({{"output", shots[i].output}, {"file", file.string()}});
        if (!is_json) print(fmt::format("{}: {}", shots[i].output, file.string()));
    }
    if (is_json) print_json(written.dump(-1, ' ', false, Json::error_handler_t::replace));
    return 0;
}

bool is_number(const std::string& text) {
    return !text.empty() && text.size() < 4 && text.find_first_not_of("0123456789") == std::string::npos;
}

int pin(const std::string& what, bool is_on) {
    if (is_number(what)) {
        ControlClient().pin_slot(static_cast<unsigned>(std::stoul(what)), is_on);
        return 0;
    }
    print(fmt::format("{}: {}", is_on ? "pinned" : "not pinned any more", ControlClient().pin(what, is_on)));
    return 0;
}

int remove_file(const std::string& file) {
    print(fmt::format("off the wall until the player starts anew or it changes: {}",
                      ControlClient().remove(file)));
    return 0;
}

int done(const std::function<void(ControlClient&)>& deed) {
    ControlClient client;
    deed(client);
    return 0;
}

int run(int argc, char** argv) {
    CLI::App app("Asks the running player of Vitrine, and changes what it shows.", "vitrinectl");
    app.require_subcommand(1)->fallthrough()->footer(footer);
    bool is_json = false;
    app.add_flag("--json", is_json, "Answers for programs: status, why, screenshot");
    std::string name;
    std::string off;
    std::map<const CLI::App*, std::function<int()>> deeds;
    const auto command = [&](const char* word, const char* help, const std::function<int()>& deed) {
        CLI::App* made = app.add_subcommand(word, help);
        made->fallthrough();
        deeds[made] = deed;
        return made;
    };
    command("status", "What is shown, where and how well", [&] { return status(is_json); });
    command("why", "Why a file is on the wall, or is not", [&] { return why(name, is_json); })
        ->add_option("FILE", name)
        ->required();
    command("next", "One shot gives way to the next, at once",
            [] { return done([](ControlClient& c) { c.next(); }); });
    command("pause", "The wall keeps what it shows; films play on",
            [] { return done([](ControlClient& c) { c.pause(true); }); });
    command("resume", "It goes on", [] { return done([](ControlClient& c) { c.pause(false); }); });
    CLI::App* pinned =
        command("pin", "A file comes onto the wall and stays; a slot (see status) keeps its shot",
                [&] { return pin(name, off.empty()); });
    pinned->add_option("FILE|SLOT", name)->required();
    pinned->add_option("off", off, "Ends that")->check(CLI::IsMember({"off"}));
    command("remove",
            "A file leaves the wall until the player starts anew or the file changes; nothing is deleted",
            [&] { return remove_file(name); })
        ->add_option("FILE", name)
        ->required();
    command("screenshot", "What the displays show, as PNG", [&] { return screenshot(name, is_json); })
        ->add_option("OUT.png", name)
        ->required();
    command("reload", "The player reads its settings again",
            [] { return done([](ControlClient& c) { c.reload(); }); });
    CLI11_PARSE(app, argc, argv);
    return deeds.at(app.get_subcommands().front())();
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

#include "player/control/commands.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace vitrine::player {

namespace {

constexpr std::array table{
    Command{.name = "status",
            .help = "Tells what is shown, on which outputs and at which rate",
            .method = "Status",
            .arguments = "",
            .result = "s",
            .is_for_all = true},
    Command{.name = "why",
            .help = "Tells if a file is on the wall, and if not, why",
            .operand = Operand::file,
            .method = "Why",
            .arguments = "ayay",
            .result = "s",
            .is_for_all = true},
    Command{.name = "next",
            .help = "Replaces one shot by the next at once",
            .method = "Next",
            .arguments = "",
            .result = "",
            .is_for_leader = true},
    Command{.name = "pause",
            .help = "Pauses the wall: its shots stay, films play on",
            .method = "Pause",
            .arguments = "b",
            .result = "",
            .is_for_leader = true},
    Command{.name = "resume",
            .help = "Ends the pause",
            .method = "Pause",
            .arguments = "b",
            .result = "",
            .is_for_leader = true,
            .is_on = false},
    Command{
        .name = "pin",
        .help =
            "Pins a file, which comes onto the wall and stays, or a slot (see status), which keeps its shot",
        .operand = Operand::file,
        .method = "Pin",
        .arguments = "ayayb",
        .result = "ay",
        .is_for_leader = true,
        .done = "pinned",
        .undone = "not pinned any more"},
    Command{.name = "pin",
            .help = "",
            .operand = Operand::slot,
            .method = "PinSlot",
            .arguments = "ub",
            .result = "",
            .is_for_leader = true},
    Command{.name = "remove",
            .help =
                "Takes a file off the wall until the player restarts or the file changes; deletes nothing",
            .operand = Operand::file,
            .method = "Remove",
            .arguments = "ayay",
            .result = "ay",
            .is_for_leader = true,
            .done = "off the wall until the player restarts or the file changes"},
    Command{.name = "acquit",
            .help = "Ends the quarantine of a file: it is tried again within a minute",
            .operand = Operand::file_or_all,
            .method = "Acquit",
            .arguments = "ayay",
            .result = "ay",
            .done = "will be tried again"},
    Command{.name = "screenshot",
            .help = "Saves a picture of each display as PNG",
            .operand = Operand::picture,
            .method = "Screenshot",
            .arguments = "",
            .result = "a(suuh)",
            .is_for_all = true},
    Command{
        .name = "canvas",
        .help =
            "Draws rulers, names and diagonals on all displays for ten minutes, to place them; or ends that",
        .method = "Canvas",
        .arguments = "",
        .result = "s"},
    Command{.name = "layout save",
            .help = "Saves the wall as it is, with pins and removals, under a name",
            .operand = Operand::layout,
            .method = "SaveLayout",
            .arguments = "ay",
            .result = "ay",
            .is_for_leader = true,
            .done = "saved"},
    Command{.name = "layout load",
            .help = "Makes the wall as it was when it was saved; files that are gone are left out",
            .operand = Operand::layout,
            .method = "LoadLayout",
            .arguments = "ay",
            .result = "ay",
            .is_for_leader = true,
            .done = "loaded"},
    Command{.name = "layout forget",
            .help = "Deletes a saved layout",
            .operand = Operand::layout,
            .method = "ForgetLayout",
            .arguments = "ay",
            .result = "ay",
            .done = "forgotten"},
    Command{.name = "layout list",
            .help = "Lists the saved layouts",
            .method = "Layouts",
            .arguments = "",
            .result = "s",
            .is_for_all = true},
    Command{.name = "reload",
            .help = "Makes the player read its settings again",
            .method = "Reload",
            .arguments = "",
            .result = ""}};

}  // namespace

std::span<const Command> commands() {
    return table;
}

bool takes_off(const Command& command) {
    return command.operand != Operand::none && std::string_view(command.arguments).ends_with('b');
}

std::string answer_line(const Command& command, bool is_off, const CommandAnswer& answer) {
    if (answer.text.empty() || std::string_view(command.result) == "s") return answer.text;
    return fmt::format("{}: {}", is_off ? command.undone : command.done, answer.text);
}

}  // namespace vitrine::player

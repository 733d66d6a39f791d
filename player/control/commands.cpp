#include "player/control/commands.hpp"

#include <array>

namespace vitrine::player {

namespace {

constexpr std::array table{
    Command{.name = "status",
            .help = "Tells what is shown, where and how well",
            .method = "Status",
            .arguments = "",
            .result = "s",
            .is_for_all = true},
    Command{.name = "why",
            .help = "Tells why a file is on the wall, or is not",
            .operand = Operand::file,
            .method = "Why",
            .arguments = "ayay",
            .result = "s",
            .is_for_all = true},
    Command{.name = "next",
            .help = "One shot gives way to the next, at once",
            .method = "Next",
            .arguments = "",
            .result = ""},
    Command{.name = "pause",
            .help = "The wall keeps the shots that it shows; films play on",
            .method = "Pause",
            .arguments = "b",
            .result = ""},
    Command{.name = "resume",
            .help = "Ends the pause",
            .method = "Pause",
            .arguments = "b",
            .result = "",
            .is_on = false},
    Command{.name = "pin",
            .help = "A file comes onto the wall and stays; a slot (see status) keeps its shot",
            .operand = Operand::file,
            .method = "Pin",
            .arguments = "ayayb",
            .result = "ay",
            .done = "pinned",
            .undone = "not pinned any more"},
    Command{.name = "pin",
            .help = "",
            .operand = Operand::slot,
            .method = "PinSlot",
            .arguments = "ub",
            .result = ""},
    Command{.name = "remove",
            .help =
                "A file leaves the wall until the player starts anew or the file changes; nothing is deleted",
            .operand = Operand::file,
            .method = "Remove",
            .arguments = "ayay",
            .result = "ay",
            .done = "off the wall until the player starts anew or it changes"},
    Command{.name = "screenshot",
            .help = "Saves what the displays show, as PNG",
            .operand = Operand::picture,
            .method = "Screenshot",
            .arguments = "",
            .result = "a(suuh)",
            .is_for_all = true},
    Command{.name = "reload",
            .help = "The player reads its settings again",
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

}  // namespace vitrine::player

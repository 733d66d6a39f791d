#pragma once

#include "player/display/picture.hpp"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::player {

/// The argument that a command takes on the command line of vitrinectl.
enum class Operand { none, file, file_or_all, slot, picture, layout };

/// A command of vitrinectl with the D-Bus method that it calls: a line of commands(). A signature consists of
/// `ay ay` (a file, and the folder in which it was typed), `ay` (the name of a layout), `u` (a slot) and `b`
/// (on or off).
struct Command {
    const char* name;  // of one word, or of a group and a verb: "layout save"
    const char* help;
    Operand operand = Operand::none;
    const char* method;       // several commands may use the same one
    const char* arguments;    // D-Bus signature
    const char* result;       // "s": JSON; "ay": a file or a layout; "a(suuh)": pictures; "": nothing
    bool is_for_all = false;  // true: anyone may call it; false: polkit decides
    bool is_for_leader =
        false;                // true: of several boxes with one wall, only the one that leads carries it out
    bool is_on = true;        // value of the flag `b`
    const char* done = "";    // printed by vitrinectl before the path of the file
    const char* undone = "";  // the same if the flag is off
};

/// All commands, in the order of the help.
std::span<const Command> commands();

/// True: `off` may follow the operand on the command line.
bool takes_off(const Command& command);

/// The arguments of a call.
struct CommandCall {
    std::string file;    // the typed name of a file or a layout, any bytes
    std::string folder;  // absolute, the folder in which it was typed
    int slot = 0;
    bool is_on = true;
};

/// The picture of one output.
struct OutputPicture {
    std::string output;
    Picture picture;
};

/// The answer to a call. Command::result says which member is used.
struct CommandAnswer {
    std::string text;                     // JSON, or a path with any bytes
    std::vector<OutputPicture> pictures;  // as the client gets them
    /// Makes `pictures`; a handler returns this in their place. Called in another thread, as it takes long.
    std::function<std::vector<OutputPicture>()> make_pictures = {};
};

/// The line that vitrinectl prints for an answer, if the command has no printer of its own: a string as it
/// is, a path after `done` or `undone`. Empty: nothing is printed.
/// @param is_off  the command line ended with `off`
std::string answer_line(const Command& command, bool is_off, const CommandAnswer& answer);

/// Carries out a call. @throws std::runtime_error with a text for the caller
using CommandHandler = std::function<CommandAnswer(const CommandCall&)>;

/// The handlers by D-Bus method.
using CommandHandlers = std::map<std::string, CommandHandler, std::less<>>;

}  // namespace vitrine::player

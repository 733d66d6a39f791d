#include "base/state/screen_note.hpp"

#include "base/system/atomic_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <system_error>

namespace vitrine {

namespace {

constexpr const char* file_name = "screen";  // below the state directory; only the player writes it
constexpr std::size_t max_bytes = 32;
constexpr int max_side = 16384;  // px

}  // namespace

int noted_screen_side(const std::filesystem::path& state) {
    std::string text;
    try {
        text = read_file(state / file_name, max_bytes);
    } catch (const std::system_error&) {
        return 0;
    }
    int side = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    const bool is_whole = error == std::errc() && std::string_view(end, text.data() + text.size()) == "\n";
    return is_whole && side > 0 && side <= max_side ? side : 0;
}

void note_screen_side(const std::filesystem::path& state, int side) {
    replace_file(state / file_name, fmt::format("{}\n", side));
}

}  // namespace vitrine

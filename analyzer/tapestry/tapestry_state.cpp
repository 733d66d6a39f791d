#include "analyzer/tapestry/tapestry_state.hpp"

#include "base/state/tapestry.hpp"
#include "base/system/atomic_file.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <system_error>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr const char* dropped_name = "dropped";

std::string note_of(std::uint64_t bytes, std::int64_t mtime_ns) {
    return fmt::format("{} {}\n", bytes, mtime_ns);
}

bool is_dropped(const fs::path& folder, std::uint64_t bytes, std::int64_t mtime_ns) {
    std::error_code error;
    return fs::exists(folder / dropped_name, error) &&
           read_file(folder / dropped_name) == note_of(bytes, mtime_ns);
}

TapestryState state_of(const fs::path& folder, const FilmVersion& film, bool has_choice) {
    try {
        if (is_dropped(folder, film.bytes, film.mtime_ns)) return TapestryState::dropped;
        const Tapestry index = read_tapestry(folder);
        const bool is_its = index.bytes == film.bytes && index.mtime_ns == film.mtime_ns &&
                            (!has_choice || index.choice == film.choice);
        return is_its && index.is_complete ? TapestryState::complete : TapestryState::lacking;
    } catch (const std::runtime_error&) {  // loading one record: there is none, or it is woven anew
        return TapestryState::lacking;
    }
}

}  // namespace

TapestryState tapestry_state(const fs::path& folder, const FilmVersion& film) {
    return state_of(folder, film, true);
}

TapestryState tapestry_state(const fs::path& folder, std::uint64_t bytes, std::int64_t mtime_ns) {
    return state_of(folder, {.bytes = bytes, .mtime_ns = mtime_ns}, false);
}

void note_dropped(const fs::path& folder, std::uint64_t bytes, std::int64_t mtime_ns) {
    fs::create_directories(folder);
    replace_file(folder / dropped_name, note_of(bytes, mtime_ns));
}

void forget_drop(const fs::path& folder) {
    std::error_code gone;
    fs::remove(folder / dropped_name, gone);
}

}  // namespace vitrine::analyzer

#include "base/calendar/day_times.hpp"
#include "base/hints/folder_hints.hpp"
#include "base/hints/hint_file.hpp"
#include "base/hints/hint_words.hpp"
#include "base/hints/keyframe_choice.hpp"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

using namespace vitrine;

namespace {

void require(bool is_so) {
    if (!is_so) std::abort();
}

/// Values that are read are within their limits, and survive writing and reading again.
void require_sound(const Hints& hints) {
    using namespace std::chrono_literals;
    if (hints.dwell) require(*hints.dwell >= 1s && *hints.dwell <= std::chrono::seconds(max_dwell_seconds));
    if (hints.repeat) require(*hints.repeat >= 1 && *hints.repeat <= max_repeats);
    if (hints.period) require(period_named(to_text(*hints.period)) == hints.period);
    if (hints.hours) {
        require(hours_named(to_text(*hints.hours)) == hints.hours);
        require(hints.hours->from >= 0min && hints.hours->from < 24h && hints.hours->to <= 24h);
    }
    require(in_words(hints).empty() == (hints == Hints{}));
    require(is_open(hints, std::nullopt) == !hints.is_scheduled());
}

void names(std::string_view text) {
    require_sound(hints_in_name(text, NamePart::folder));
    require_sound(hints_in_name(text, NamePart::file));
    const FolderHints folders{{"", {.repeat = 2}}, {"trips", {.sound = true}}};
    require_sound(hints_of(text, folders));
    require(hints_of(text, folders).repeat.has_value());
}

void files(std::string_view text) {
    const HintFile file = read_hints(text, "fuzz");
    require_sound(file.hints);
    for (const std::string& fault : file.faults)
        require(fault.starts_with("fuzz:"));
    const FolderHints told{{std::string(text.substr(0, text.find('\n'))), file.hints}};
    require(folder_hints_from_json(to_json(told)) == told);
}

void chosen(std::string_view text) {
    const KeyframeFile file = read_keyframe_choice(text, "fuzz");
    for (const std::string& fault : file.faults)
        require(fault.starts_with("fuzz:"));
    require(read_keyframe_choice(to_toml(file.choice), "again").choice == file.choice);
    require(key_of(file.choice).empty() == file.choice.is_empty());
}

void told(std::string_view text) {
    FolderHints folders;
    try {
        folders = folder_hints_from_json(text);
    } catch (const std::runtime_error&) {
        return;
    }
    for (const auto& [folder, hints] : folders)
        require_sound(hints);
    require(folder_hints_from_json(to_json(folders)) == folders);
}

}  // namespace

/// Whatever names, files of hints and what the analyzer tells of them are, they are hints within their limits
/// or none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);  // NOLINT: bytes are characters
    names(text);
    files(text);
    chosen(text);
    told(text);
    return 0;
}

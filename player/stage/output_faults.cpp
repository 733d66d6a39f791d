#include "player/stage/output_faults.hpp"

#include "base/settings/output_words.hpp"
#include "base/settings/settings.hpp"
#include "base/system/log.hpp"
#include "player/display/screen.hpp"
#include "player/scene/files/show_files.hpp"
#include "player/stage/output_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace vitrine::player {

namespace {

using Names = std::vector<std::string>;

/// A pair of outputs whose parts overlap, in words; empty: there is none.
std::string overlap_of(const SharedCanvas& shared) {
    for (auto one = shared.parts.begin(); one != shared.parts.end(); ++one)
        for (auto other = std::next(one); other != shared.parts.end(); ++other) {
            const Box both = intersection(one->second.box, other->second.box);
            if (std::min(both.width(), both.height()) >= 1)
                return fmt::format("'{}' and '{}' overlap, with the modes that they have", one->first,
                                   other->first);
        }
    return {};
}

bool has(const Names& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

/// The first name that the other names lack. Empty: there is none.
std::string first_beside(const Names& names, const Names& others) {
    const auto found =
        std::ranges::find_if(names, [&](const std::string& name) { return !has(others, name); });
    return found == names.end() ? std::string() : *found;
}

/// @param named    outputs in the settings
/// @param present  outputs that are there
/// @param unnamed  what one does that is not named: "which has no place, shows the whole wall"
std::string misnamed(const Names& named, const Names& present, const std::string& unnamed) {
    const std::string missing = first_beside(named, present);
    const std::string other = first_beside(present, named);
    if (missing.empty() || other.empty()) return {};
    return fmt::format("'{}' is not there, and '{}', {}", missing, other, unnamed);
}

/// The outputs that have a folder of their own.
Names names_in_folders(const Settings& settings) {
    Names names;
    const auto folders = output_folders_named(settings.output.folders).value();
    for (const auto& [output, folder] : folders)
        names.push_back(output);
    return names;
}

Names names_on_canvas(const CanvasWords& words) {
    Names names;
    std::ranges::transform(words.places, std::back_inserter(names), &OutputPlace::output);
    return names;
}

std::string canvas_fault(const Settings& settings, std::span<Screen* const> screens,
                         const OtherOutputs& others) {
    if (settings.wall.role == WallRole::follow) return {};  // the leader decides
    const Names elsewhere = names_in_folders(settings);
    std::vector<KnownOutput> outputs = others.outputs;
    for (const Screen* screen : screens)
        if (!has(elsewhere, screen->name())) outputs.push_back(known_output(settings, *screen));
    const CanvasWords words = own_canvas_words(settings);
    if (std::string overlap = overlap_of(shared_canvas(words, outputs)); !overlap.empty()) return overlap;
    const Names named = names_on_canvas(words);
    Names present;
    std::ranges::transform(outputs, std::back_inserter(present), &KnownOutput::name);
    if (screens.empty())  // they may be off
        std::ranges::copy_if(named, std::back_inserter(present),
                             [](const std::string& name) { return name.find('/') == std::string::npos; });
    return misnamed(named, present, "which has no place, shows the whole wall");
}

std::string folders_fault(const Settings& settings, std::span<Screen* const> screens) {
    const Names elsewhere = names_on_canvas(own_canvas_words(settings));
    Names present;
    for (const Screen* screen : screens)
        if (!has(elsewhere, screen->name())) present.push_back(screen->name());
    return misnamed(names_in_folders(settings), present, "which has no folder, shows the whole media folder");
}

/// A screen whose folder has no files, while others have some.
std::string empty_folder(const Settings& settings, std::span<Screen* const> screens,
                         const RecordList& files) {
    if (files.size() == 0) return {};
    const auto folders = output_folders_named(settings.output.folders).value();
    for (const Screen* screen : screens)
        if (const auto own = folders.find(screen->name());
            own != folders.end() && files.in_folder(own->second).size() == 0)
            return fmt::format("'{}' shows nothing: its folder '{}' has no files", screen->name(),
                               own->second);
    return {};
}

}  // namespace

void OutputFaults::look(const Settings& settings, std::span<Screen* const> screens,
                        const OtherOutputs& others, const RecordList& files) {
    if (screens.empty() && others.outputs.empty()) return;
    const Names before = std::exchange(faults_, {});
    const auto add = [&](const char* key, const std::string& fault) {
        if (!fault.empty()) faults_.push_back(fmt::format("{}: {}", key, fault));
    };
    add("output.canvas", canvas_fault(settings, screens, others));
    add("output.folders", folders_fault(settings, screens));
    add("output.folders", empty_folder(settings, screens, files));
    for (const std::string& fault : faults_)
        if (!has(before, fault)) log::warning("{}", fault);
}

}  // namespace vitrine::player

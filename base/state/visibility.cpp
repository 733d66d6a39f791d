#include "base/state/visibility.hpp"

#include "base/state/path_text.hpp"
#include "base/system/atomic_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace vitrine {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr int version = 1;

struct Words {
    Visibility visibility;
    const char* name;
    const char* in_short;
    const char* sentence;
    const char* before_detail;  // between the sentence and the detail
};

constexpr std::array words{
    Words{Visibility::not_analysed, "not_analysed", "not analysed yet", "It has not been analysed yet", ": "},
    Words{Visibility::unsupported, "unsupported", "unsupported", "It cannot be shown", ": "},
    Words{Visibility::not_rehearsed, "not_rehearsed", "not in the rehearsal",
          "The rehearsal says that it is not there", ": "},
    Words{Visibility::held_back, "held_back", "held back after a crash",
          "It is held back after a crash of the player", ": "},
    Words{Visibility::dismissed, "dismissed", "removed by vitrinectl",
          "It was removed from the wall by vitrinectl, until the player restarts or the file changes", ": "},
    Words{Visibility::no_clock, "no_clock", "waiting for a plausible clock",
          "It has days or hours, and the machine's clock is not plausible yet", ": it is shown "},
    Words{Visibility::out_of_hours, "out_of_hours", "out of hours", "It is out of its hours",
          ": it is shown "},
    Words{Visibility::notice_over, "notice_over", "of notices that are over",
          "Its notice is over; rename its folder to show it again", ": "},
    Words{Visibility::covered, "covered", "covered by a notice", "A notice is shown in place of everything",
          ": "},
    Words{Visibility::other_folder, "other_folder", "in the folder of another screen",
          "No connected screen shows its folder", ": "},
    Words{Visibility::screens_off, "screens_off", "ready while the displays are off",
          "It may be shown, but the displays are off at this hour, or another program has them", ": "},
    Words{Visibility::closed_folder, "closed_folder", "in a folder that is closed",
          "A visitor looks into another folder", ": "},
    Words{Visibility::avoided, "avoided", "left out for a minute",
          "The wall leaves it out for a minute: it could not be played, or a visitor flicked it away", "; "},
    Words{Visibility::in_group, "in_group", "one with a file on the wall",
          "Another picture of the same take hangs, and it takes its place in turn", ": "},
    Words{Visibility::waits_for_turn, "waits_for_turn", "waiting for their turn",
          "It is ready and waits for its turn", "; "},
    Words{Visibility::on_wall, "on_wall", "on the wall", "It is on the wall", "; "}};

const Words& words_of(Visibility visibility) {
    return *std::ranges::find(words, visibility, &Words::visibility);
}

FileVisibility file_of(const Json& json) {
    FileVisibility file{.path = json.contains("path_hex") ? from_hex(json["path_hex"].get<std::string>())
                                                          : json.at("path").get<std::string>(),
                        .detail = json.value("detail", "")};
    const std::string state = json.at("state").get<std::string>();
    const auto found = std::ranges::find(words, state, &Words::name);
    if (found == words.end()) throw std::runtime_error(fmt::format("unknown state '{}'", state));
    file.visibility = found->visibility;
    return file;
}

}  // namespace

bool may_be_shown(Visibility visibility) {
    return visibility == Visibility::waits_for_turn || visibility == Visibility::in_group ||
           visibility == Visibility::on_wall;
}

const char* name_of(Visibility visibility) {
    return words_of(visibility).name;
}

const char* in_short(Visibility visibility) {
    return words_of(visibility).in_short;
}

std::string sentence(const FileVisibility& file) {
    const Words& said = words_of(file.visibility);
    std::string text = said.sentence;
    if (!file.detail.empty()) text += said.before_detail + file.detail;
    return text + ".";
}

std::string visible_json(std::span<const FileVisibility> files) {
    Json list = Json::array();
    for (const FileVisibility& file : files) {
        Json json{{"path", file.path}, {"state", name_of(file.visibility)}};
        if (!is_utf8(file.path)) json["path_hex"] = to_hex(file.path);
        if (!file.detail.empty()) json["detail"] = file.detail;
        list.push_back(std::move(json));
    }
    return Json{{"version", version}, {"files", std::move(list)}}.dump(-1, ' ', false,
                                                                       Json::error_handler_t::replace) +
           "\n";
}

VisibleByPath visible_from_json(std::string_view text) {
    try {
        const Json json = Json::parse(text);
        if (json.at("version") != version) throw std::runtime_error("unknown version");
        VisibleByPath files;
        for (const Json& one : json.at("files")) {
            FileVisibility file = file_of(one);
            files.emplace(file.path, file);
        }
        return files;
    } catch (const Json::exception& error) {
        throw std::runtime_error(error.what());
    }
}

bool VisibleReader::look(fs::file_time_type now) {
    const bool was_running = is_running_;
    std::error_code missing;
    const fs::file_time_type written = fs::last_write_time(file_, missing);
    // If the clock was set back, the file is from the future: that proves nothing either.
    is_running_ = !missing && std::chrono::abs(now - written) < max_visible_age;
    if (!is_running_) {
        written_.reset();
        text_.clear();
        files_.clear();
        return was_running;
    }
    if (written_ == written) return !was_running;
    written_ = written;
    try {
        std::string text = read_file(file_);
        if (text == text_) return !was_running;
        text_ = std::move(text);
        files_ = visible_from_json(text_);
    } catch (const std::runtime_error&) {  // damaged or just removed; the next file is read again
        files_.clear();
    }
    return true;
}

}  // namespace vitrine

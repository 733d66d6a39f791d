#include "analyzer/watch/hint_files.hpp"

#include "base/hints/caption.hpp"
#include "base/hints/hint_file.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace vitrine::analyzer {

namespace {

constexpr auto write_time = std::chrono::milliseconds(300);  // enough to write a .vitrine.toml to its end

/// All folders of these files, the media folder itself included.
std::set<std::string> folders_of(const std::vector<std::string>& paths) {
    std::set<std::string> folders{""};
    for (const std::string& path : paths)
        for (std::size_t slash = path.rfind('/'); slash != std::string::npos && slash > 0;
             slash = path.rfind('/', slash - 1))
            if (!folders.insert(path.substr(0, slash)).second) break;
    return folders;
}

}  // namespace

HintFiles::HintFiles(EventLoop& loop, const MediaFolder& folder, std::filesystem::path hand_over,
                     std::function<void()> due)
    : folder_(folder), hand_over_(std::move(hand_over)), due_(loop.timer(std::move(due))) {}

void HintFiles::read_soon() {
    due_.arm(write_time);
}

void HintFiles::read(const std::vector<std::string>& paths, const std::set<std::string>& sidecars) {
    hints_.clear();
    faults_.clear();
    for (const std::string& folder : folders_of(paths))
        read_folder(folder);
    KeyframeChoices choices;
    for (const std::string& path : sidecars) {
        if (is_caption_file(path) || is_code_file(path)) {
            read_words(path, paths);
            continue;
        }
        const std::string film = path.substr(0, path.size() - keyframe_file_ending.size());
        if (std::ranges::binary_search(paths, film))
            read_keyframes(path, film, choices);
        else if (folder_.content(path, 1))
            faults_.push_back(path + ": there is no such film beside it");
    }
    choices_ = std::move(choices);
    for (const std::string& fault : faults_)
        if (!logged_.contains(fault)) log::warning("hints: {}", fault);
    logged_ = {faults_.begin(), faults_.end()};
    write_hand_over();
}

void HintFiles::read_folder(const std::string& folder) {
    const std::string path = (folder.empty() ? "" : folder + "/") + std::string(hint_file_name);
    const std::optional<std::string> text = folder_.content(path, max_bytes + 1);
    if (!text) return;
    if (text->size() > max_bytes) {
        faults_.push_back(path + ": it is larger than 64 KiB");
        return;
    }
    const HintFile file = read_hints(*text, path);
    faults_.insert(faults_.end(), file.faults.begin(), file.faults.end());
    if (file.hints != Hints{}) hints_[folder] = file.hints;
}

/// A file that cannot be read has gone if its film is there; else its share may be off, and its choice stays.
void HintFiles::read_keyframes(const std::string& path, const std::string& film, KeyframeChoices& choices) {
    const std::optional<std::string> text = folder_.content(path, max_bytes + 1);
    if (!text) {
        const auto known = choices_.find(film);
        if (known != choices_.end() && folder_.look_at(film).presence != MediaFolder::Presence::there)
            choices.insert(*known);
        return;
    }
    if (text->size() > max_bytes) {
        faults_.push_back(path + ": it is larger than 64 KiB");
        return;
    }
    KeyframeFile file = read_keyframe_choice(*text, path);
    faults_.insert(faults_.end(), file.faults.begin(), file.faults.end());
    if (!file.choice.is_empty()) choices[film] = std::move(file.choice);
}

/// A caption or the text of a QR code.
void HintFiles::read_words(const std::string& path, const std::vector<std::string>& paths) {
    const bool is_code = is_code_file(path);
    const std::size_t ending = is_code ? code_file_ending.size() : caption_file_ending.size();
    const std::string medium = path.substr(0, path.size() - ending);
    const bool is_beside = std::ranges::binary_search(paths, medium);
    const std::optional<std::string> text = folder_.content(path, is_beside ? max_bytes + 1 : 1);
    if (!text) return;
    if (!is_beside) {
        faults_.push_back(path + ": there is no such photo or film beside it");
        return;
    }
    const CaptionText read = is_code ? code_text(*text) : caption_text(*text);
    if (!read.fault.empty()) faults_.push_back(path + ": " + read.fault);
    if (read.text.empty()) return;
    Hints& hints = hints_[medium];
    (is_code ? hints.code : hints.caption) = read.text;
}

/// A full disk is no reason to stop: it is tried again the next time.
void HintFiles::write_hand_over() {
    std::string json = to_json(hints_);
    json += "\n";
    if (json == written_) return;
    try {
        replace_file(hand_over_, json);
        written_ = json;
    } catch (const std::system_error& error) {
        log::error("'{}' not written, trying again: {}", hand_over_.string(), error.what());
    }
}

}  // namespace vitrine::analyzer

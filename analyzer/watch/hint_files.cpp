#include "analyzer/watch/hint_files.hpp"

#include "base/hints/hint_file.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <system_error>

namespace vitrine::analyzer {

namespace {

/// Of all files, from the media folder itself on.
std::set<std::string> folders_of(const std::vector<std::string>& paths) {
    std::set<std::string> folders{""};
    for (const std::string& path : paths)
        for (std::size_t slash = path.rfind('/'); slash != std::string::npos && slash > 0;
             slash = path.rfind('/', slash - 1))
            if (!folders.insert(path.substr(0, slash)).second) break;
    return folders;
}

}  // namespace

void HintFiles::read(const std::vector<std::string>& paths) {
    hints_.clear();
    faults_.clear();
    for (const std::string& folder : folders_of(paths))
        read_one(folder);
    for (const std::string& fault : faults_)
        if (!complaints_.contains(fault)) log::warning("hints: {}", fault);
    complaints_ = {faults_.begin(), faults_.end()};
    tell();
}

void HintFiles::read_one(const std::string& folder) {
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

/// A full disk is no reason to stop: it is tried again the next time.
void HintFiles::tell() {
    std::string json = to_json(hints_);
    json += "\n";
    if (json == written_) return;
    try {
        replace_file(told_, json);
        written_ = json;
    } catch (const std::system_error& error) {
        log::error("what folders say is not stored, trying again: {}", error.what());
    }
}

}  // namespace vitrine::analyzer

#include "player/scene/files/folder_level.hpp"

#include <algorithm>
#include <string_view>

namespace vitrine::player {

namespace {

/// The deepest folder that holds two files; empty: the media folder.
std::string folder_of_both(const std::string& first, const std::string& last) {
    const auto parted = std::ranges::mismatch(first, last).in1;
    const std::string common(first.begin(), parted);
    const std::size_t slash = common.rfind('/');
    return slash == std::string::npos ? "" : common.substr(0, slash);
}

}  // namespace

std::string common_folder(const RecordList& files) {
    if (files.is_empty()) return "";
    const std::string& first = (*files.begin())->path;
    const std::string& last = files.last()->path;
    if (first != last) return folder_of_both(first, last);
    const std::size_t slash = first.rfind('/');
    return slash == std::string::npos ? "" : first.substr(0, slash);
}

std::vector<FolderEntry> level_entries(const RecordList& files) {
    std::vector<FolderEntry> entries;
    const std::string folder = common_folder(files);
    const std::size_t begin = folder.empty() ? 0 : folder.size() + 1;
    std::string_view sub_folder;  // of the last entry, with its '/'; empty: that is a file
    const std::string* first = nullptr;
    for (const RecordList::Record& file : files) {
        const std::string& path = file->path;
        if (!sub_folder.empty() && path.starts_with(sub_folder)) {
            entries.back() = {.path = folder_of_both(*first, path), .is_folder = true};
            continue;
        }
        const std::size_t slash = path.find('/', begin);
        sub_folder = slash == std::string::npos ? "" : std::string_view(path).substr(0, slash + 1);
        first = &path;
        entries.push_back({.path = path});
    }
    return entries;
}

}  // namespace vitrine::player

#include "analyzer/store/store.hpp"

#include "analyzer/store/disk_use.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

bool is_too_small(const MediaRecord& record, const StoredShot& stored, const StoreBounds& bounds) {
    if (record.kind != MediaKind::film) return false;
    const int wanted = std::min(std::max(record.width, record.height), bounds.clip_side);
    return 4 * std::max(stored.width, stored.height) < 3 * wanted;
}

}  // namespace

Store::Store(fs::path directory, const StoreBounds& bounds)
    : directory_(std::move(directory)), bounds_(bounds) {}

bool Store::lacks(const MediaRecord& record) const {
    if (!is_on() || record.state != MediaState::ready) return false;
    if (record.film && record.film->is_there() && !fs::exists(directory_ / record.film->shot.stored->file))
        return true;
    return std::any_of(record.shots.begin(), record.shots.end(), [&](const Shot& shot) {
        if (!shot.stored) return true;
        return !shot.stored->is_dropped &&
               (!fs::exists(directory_ / shot.stored->file) || is_too_small(record, *shot.stored, bounds_));
    });
}

bool Store::lacks_sound(const MediaRecord& record) const {
    if (!is_on() || record.kind != MediaKind::film || record.state != MediaState::ready ||
        !record.is_complete)
        return false;
    if (!record.sound)
        return record.reason.empty();  // else the film is damaged: a second analysis finds no more
    return !record.sound->is_dropped && !record.sound->file.empty() &&
           !fs::exists(directory_ / record.sound->file);
}

void Store::mark_dropped(MediaRecord& record) const {
    const auto mark = [&](Shot& shot) {
        if (shot.stored && dropped_.contains(shot.stored->file)) shot.stored->is_dropped = true;
    };
    std::ranges::for_each(record.shots, mark);
    if (record.film) mark(record.film->shot);
    if (record.sound && dropped_.contains(record.sound->file)) record.sound->is_dropped = true;
}

void Store::note_record(const MediaRecord& record) {
    std::set<std::string>& names = named_[record.path];
    names.clear();
    for (const Shot& shot : record.shots)
        if (shot.stored && !shot.stored->is_dropped) names.insert(shot.stored->file);
    if (record.film && record.film->is_there()) names.insert(record.film->shot.stored->file);
    if (record.sound && !record.sound->is_dropped && !record.sound->file.empty())
        names.insert(record.sound->file);
    for (const std::string& name : names)
        if (!files_.contains(name)) measure_file(name);
    if (names.empty()) named_.erase(record.path);
}

void Store::forget_file(const std::string& path) {
    named_.erase(path);
}

void Store::measure_file(const std::string& name) {
    struct stat status {};

    if (::stat((directory_ / name).c_str(), &status) < 0 || !S_ISREG(status.st_mode)) return;
    files_[name] = {.bytes = static_cast<std::uint64_t>(status.st_size), .used_ns = used_ns(status)};
}

void Store::read_directory() {
    files_.clear();
    std::error_code missing;
    for (const fs::directory_entry& folder : fs::directory_iterator(directory_, missing)) {
        std::error_code error;
        const std::string id = folder.path().filename().string();
        for (const fs::directory_entry& file : fs::directory_iterator(folder.path(), error))
            measure_file(id + "/" + file.path().filename().string());
        if (!busy_.contains(id)) fs::remove(folder.path(), error);  // only where it is empty
    }
}

void Store::sweep() {
    read_directory();
    const std::set<std::string> named = named_files();
    std::set<std::string> unnamed;
    for (const auto& [name, file] : files_)
        if (!named.contains(name) && !is_busy(name)) unnamed.insert(name);
    for (const std::string& name : std::exchange(unnamed_, unnamed))
        if (unnamed.contains(name)) remove_file(name);
}

std::set<std::string> Store::make_room() {
    const std::uint64_t bytes = excess();
    if (bytes == 0) return {};
    const std::set<std::string> named = named_files();
    std::vector<StoredFile> files;
    for (const auto& [name, file] : files_) {
        const bool is_named = named.contains(name);
        if (is_named || !is_busy(name))
            files.push_back(
                {.name = name, .bytes = file.bytes, .used_ns = file.used_ns, .is_named = is_named});
    }
    std::set<std::string> lost;
    for (const StoredFile& file : files_to_remove(std::move(files), bytes)) {
        remove_file(file.name);
        if (file.is_named && is_on()) lost.insert(file.name);
    }
    dropped_.insert(lost.begin(), lost.end());
    std::set<std::string> paths;
    for (const auto& [path, its] : named_)
        if (std::any_of(its.begin(), its.end(), [&](const auto& name) { return lost.contains(name); }))
            paths.insert(path);
    return paths;
}

void Store::remove_file(const std::string& name) {
    std::error_code ignored;  // it is tried again at the next sweep
    fs::remove(directory_ / name, ignored);
    fs::remove((directory_ / name).parent_path(), ignored);  // only where it is empty
    files_.erase(name);
}

std::uint64_t Store::excess() const {
    std::uint64_t bytes = 0;
    for (const auto& [name, file] : files_)
        bytes += file.bytes;
    return excess_bytes(bytes, bounds_.max_bytes, directory_, bounds_.min_free_bytes);
}

std::set<std::string> Store::named_files() const {
    std::set<std::string> all;
    for (const auto& [path, its] : named_)
        all.insert(its.begin(), its.end());
    return all;
}

bool Store::is_busy(const std::string& name) const {
    return busy_.contains(name.substr(0, name.find('/')));
}

}  // namespace vitrine::analyzer

#include "base/state/catalogue.hpp"

#include "base/state/record_json.hpp"
#include "base/system/atomic_file.hpp"

#include <algorithm>
#include <stdexcept>

namespace vitrine {

namespace fs = std::filesystem;

Catalogue::Catalogue(fs::path directory) : directory_(std::move(directory)) {}

std::vector<MediaRecord> Catalogue::load(const Complaint& complain) const {
    std::vector<MediaRecord> records;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory_, missing)) {
        if (entry.path().extension() != ".json") continue;
        try {
            records.push_back(record_from_json(read_file(entry.path())));
        } catch (const std::runtime_error& error) {  // an unreadable record does not hide the others
            if (complain) complain(entry.path().string(), error.what());
        }
    }
    std::sort(records.begin(), records.end(),
              [](const MediaRecord& a, const MediaRecord& b) { return a.path < b.path; });
    return records;
}

std::optional<MediaRecord> Catalogue::find(const std::string& path) const {
    if (!fs::exists(file_of(path))) return std::nullopt;
    MediaRecord record = record_from_json(read_file(file_of(path)));
    if (record.path != path) return std::nullopt;
    return record;
}

void Catalogue::store(const MediaRecord& record) const {
    fs::create_directories(directory_);
    replace_file(file_of(record.path), to_json(record) + "\n");
}

void Catalogue::remove(const std::string& path) const {
    fs::remove(file_of(path));
}

fs::path Catalogue::file_of(const std::string& path) const {
    return directory_ / (record_id(path) + ".json");
}

}  // namespace vitrine

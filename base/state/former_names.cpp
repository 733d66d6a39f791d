#include "base/state/former_names.hpp"

#include "base/state/record_json.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace vitrine {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t former_length = 16;  // hex digits

std::vector<std::string> former_ids(const fs::path& catalogue) {
    std::vector<std::string> ids;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(catalogue, missing))
        if (entry.path().extension() == ".json" && entry.path().stem().string().size() == former_length)
            ids.push_back(entry.path().stem().string());
    return ids;
}

/// Renames a file or a folder. If one with today's name is there, that is the newer one, and the old one
/// goes.
void rename_or_remove(const fs::path& from, const fs::path& to) {
    std::error_code ignored;
    if (fs::exists(to, ignored))
        fs::remove_all(from, ignored);
    else
        fs::rename(from, to, ignored);
}

}  // namespace

void rename_former(const fs::path& state) {
    const std::vector<std::string> ids = former_ids(state / "catalogue");
    for (const std::string& former : ids) {
        const fs::path record = state / "catalogue" / (former + ".json");
        try {
            const std::string id = record_id(record_from_json(read_file(record)).path);
            rename_or_remove(state / "tapestry" / former, state / "tapestry" / id);
            rename_or_remove(state / "thumbnails" / former, state / "thumbnails" / id);
            // The record comes last: until then all of it is tried again.
            rename_or_remove(record, state / "catalogue" / (id + ".json"));
        } catch (const std::runtime_error&) {
            continue;  // an unreadable record is told of when all are loaded
        }
    }
    if (!ids.empty()) log::info("{} records of version 0.1 have names of today", ids.size());
}

}  // namespace vitrine

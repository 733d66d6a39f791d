#include "analyzer/tapestry/tapestries.hpp"

#include "analyzer/store/disk_use.hpp"
#include "analyzer/tapestry/tapestry_state.hpp"
#include "base/state/tapestry.hpp"
#include "base/system/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <system_error>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

std::uint64_t bytes_in(const fs::path& folder) {
    std::uint64_t bytes = 0;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        std::error_code gone;
        if (it->is_regular_file(gone)) bytes += it->file_size(gone);
    }
    return bytes;
}

/// The last time at which the index was read or written, ns since 1970; 0 without an index.
std::int64_t index_used_ns(const fs::path& folder) {
    struct stat status {};

    if (::stat((folder / "index.json").c_str(), &status) < 0) return 0;
    return used_ns(status);
}

/// Lets this code read a tapestry's index without a trace: reading counts as use only where a tapestry is
/// shown.
class Unused {
  public:
    explicit Unused(const fs::path& folder) : index_(folder / "index.json") {
        struct stat status {};

        is_there_ = ::stat(index_.c_str(), &status) == 0;
        times_[0] = status.st_atim;
    }

    Unused(const Unused&) = delete;
    Unused& operator=(const Unused&) = delete;
    Unused(Unused&&) = delete;
    Unused& operator=(Unused&&) = delete;

    ~Unused() {
        if (is_there_) (void)::utimensat(AT_FDCWD, index_.c_str(), times_.data(), 0);
    }

  private:
    fs::path index_;
    std::array<timespec, 2> times_{{{}, {.tv_sec = 0, .tv_nsec = UTIME_OMIT}}};  // access; modification stays
    bool is_there_ = false;
};

/// Removes the index first: a folder without an index is no tapestry.
void remove_tapestry(const fs::path& folder) {
    std::error_code ignored;  // it is tried again at the next sweep
    fs::remove(folder / "index.json", ignored);
    fs::remove_all(folder, ignored);
}

/// Says if there is an index and it belongs to another film.
bool is_stale(const fs::path& folder, const MediaRecord& record) {
    std::error_code error;
    if (!fs::exists(folder / "index.json", error)) return false;
    try {
        const Tapestry index = read_tapestry(folder);
        return index.bytes != record.bytes || index.mtime_ns != record.mtime_ns;
    } catch (const std::runtime_error&) {  // loading one record: nobody can read it
        return true;
    }
}

std::vector<fs::path> tile_folders(const fs::path& folder) {
    std::vector<fs::path> tiles;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing))
        if (entry.path().filename().string().starts_with("tiles-")) tiles.push_back(entry.path());
    return tiles;
}

/// Removes index and tiles. The frames stay: they may belong to the new content already, and name their
/// content.
void remove_stale(const fs::path& folder) {
    std::error_code ignored;
    fs::remove(folder / "index.json", ignored);
    for (const fs::path& tiles : tile_folders(folder))
        fs::remove_all(tiles, ignored);
}

/// Removes the tiles that the index has not named for ten minutes. Until then a player that has read the
/// index before may still show them.
/// @return true if there were any
bool remove_replaced_tiles(const fs::path& folder) {
    std::error_code error;
    const auto written = fs::last_write_time(folder / "index.json", error);
    if (error || fs::file_time_type::clock::now() - written < std::chrono::minutes(10)) return false;
    std::vector<fs::path> tiles = tile_folders(folder);
    if (tiles.size() < 2) return false;
    const Unused unused(folder);
    try {
        const Tapestry index = read_tapestry(folder);
        if (!index.is_complete) return false;  // a child may be writing
        std::erase(tiles, folder / index.folder);
    } catch (const std::runtime_error&) {  // loading one record: is_stale() sees to it
        return false;
    }
    for (const fs::path& replaced : tiles)
        fs::remove_all(replaced, error);
    return true;
}

}  // namespace

Tapestries::Tapestries(fs::path state, const StoreBounds& bounds)
    : state_(std::move(state)), bounds_(bounds) {}

fs::path Tapestries::folder(const std::string& path) const {
    return tapestry_folder(state_, path);
}

bool Tapestries::hold(const MediaRecord& record, const std::string& choice) {
    const bool is_film = record.kind == MediaKind::film && record.state == MediaState::ready;
    if (!is_film || !is_on()) {
        release(record.path);
        return false;
    }
    Content& content = held_[record.path];
    const bool is_known = content.film.bytes == record.bytes && content.film.mtime_ns == record.mtime_ns;
    content.film = {.bytes = record.bytes, .mtime_ns = record.mtime_ns, .choice = choice};
    content.is_complete = record.is_complete;
    const Unused unused(folder(record.path));
    if (!is_known) {
        if (is_stale(folder(record.path), record)) remove_stale(folder(record.path));
        look_at(record.path);
    }
    return record.is_complete && tapestry_state(folder(record.path), content.film) == TapestryState::lacking;
}

std::optional<std::pair<FilmVersion, bool>> Tapestries::choose(const std::string& path,
                                                               const std::string& choice) {
    const auto found = held_.find(path);
    if (found == held_.end() || !found->second.is_complete) return std::nullopt;
    found->second.film.choice = choice;
    const Unused unused(folder(path));
    return std::pair(found->second.film,
                     tapestry_state(folder(path), found->second.film) == TapestryState::lacking);
}

std::optional<FilmVersion> Tapestries::revive(const std::string& path) const {
    const auto found = held_.find(path);
    if (found == held_.end()) return std::nullopt;
    if (tapestry_state(folder(path), found->second.film) != TapestryState::dropped) return std::nullopt;
    forget_drop(folder(path));
    return found->second.film;
}

void Tapestries::release(const std::string& path) {
    if (held_.erase(path) > 0) remove_tapestry(folder(path));
}

void Tapestries::move(const std::string& from, const std::string& to) const {
    std::error_code error;
    fs::remove_all(folder(to), error);
    fs::rename(folder(from), folder(to), error);
    if (error || !fs::exists(folder(to) / "index.json", error)) return;
    try {
        Tapestry index = read_tapestry(folder(to));
        index.path = to;
        write_tapestry(folder(to), index);
    } catch (const std::runtime_error&) {  // loading one record: it is woven anew
        remove_tapestry(folder(to));
    }
}

void Tapestries::look_at(const std::string& path) {
    const auto found = held_.find(path);
    if (found != held_.end()) found->second.bytes = bytes_in(folder(path));
}

void Tapestries::remove_replaced() {
    for (auto& [path, content] : held_)
        if (remove_replaced_tiles(folder(path))) content.bytes = bytes_in(folder(path));
}

void Tapestries::sweep(const std::vector<std::string>& files) {
    std::set<std::string> ids;
    for (const std::string& path : files)
        ids.insert(record_id(path));
    for (const auto& [path, content] : held_)
        ids.insert(record_id(path));
    if (!is_on()) ids.clear();
    std::vector<fs::path> others;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(state_ / "tapestry", missing))
        if (!ids.contains(entry.path().filename().string())) others.push_back(entry.path());
    for (const fs::path& other : others)
        remove_tapestry(other);
}

std::vector<std::string> Tapestries::make_room(const std::string& busy) {
    std::uint64_t bytes = excess();
    if (bytes == 0) return {};
    std::vector<std::pair<std::int64_t, std::string>> oldest;
    for (const auto& [path, content] : held_)
        if (path != busy && content.bytes > 0) oldest.emplace_back(index_used_ns(folder(path)), path);
    std::ranges::sort(oldest);
    std::vector<std::string> lost;
    for (const auto& [used, path] : oldest) {
        if (bytes == 0) break;
        Content& content = held_.at(path);
        bytes -= std::min(bytes, content.bytes);
        content.bytes = 0;
        remove_tapestry(folder(path));
        if (used == 0) continue;  // it has frames only; they are decoded again in their turn
        note(path, content);
        lost.push_back(path);
    }
    return lost;
}

/// The bytes beyond the bound, or those that the disk lacks.
std::uint64_t Tapestries::excess() const {
    std::uint64_t bytes = 0;
    for (const auto& [path, content] : held_)
        bytes += content.bytes;
    return excess_bytes(bytes, bounds_.max_bytes, state_, bounds_.min_free_bytes);
}

void Tapestries::note(const std::string& path, const Content& content) const {
    try {
        note_dropped(folder(path), content.film.bytes, content.film.mtime_ns);
    } catch (const std::system_error&) {  // a full disk: after a restart it is woven again
        return;
    }
}

}  // namespace vitrine::analyzer

#pragma once

#include "base/settings/choices.hpp"
#include "base/state/record.hpp"
#include "player/scene/files/show_files.hpp"

#include <algorithm>
#include <chrono>
#include <compare>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// The name of one shot in the catalogue.
struct ShotKey {
    std::string path;
    int shot = 0;  // index into MediaRecord::shots

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads the 0 inside the default
    auto operator<=>(const ShotKey&) const = default;
};

/// The order of the shots' turns: each shot once before any of its file repeats, new files first. A shot of a
/// file that repeats has several turns in a round, evenly spread over it.
class ShotRotation {
  public:
    using Fits = std::function<bool(const ShotKey&)>;

    ShotRotation(ShotOrder order, std::uint64_t seed) : order_(order), engine_(seed) {}

    /// Sets the files. Shots that are gone lose their turn. The first shot of a new file is next; its other
    /// shots come last.
    /// @param hints  tell the frequency of files
    void set_files(const RecordList& files, const ShowHints& hints = {});

    /// Removes and returns the first shot of the round that fits. None: no shot fits.
    std::optional<ShotKey> next_shot(const Fits& fits);

    bool has_shot(const Fits& fits) const { return std::any_of(waiting_.begin(), waiting_.end(), fits); }

    /// Appends all shots of the files that have no turn left, those on the wall last.
    /// @param only  the only file whose shots are appended; empty: all files
    void restart_finished(const Fits& is_on_wall, const std::string& only = "");

    /// Appends all shots that have no turn left, those on the wall last.
    void restart_all(const Fits& is_on_wall);

  private:
    struct File {
        std::int64_t mtime_ns = 0;
        std::int64_t taken_ns = 0;
        std::optional<std::chrono::local_days> day;  // on which a camera took it
        int shots = 0;
        int repeat = 1;  // turns in a round
    };

    using Turns = std::map<ShotKey, int>;

    void append(std::vector<ShotKey> again, const Fits& is_on_wall, const Turns& left = {});
    std::vector<ShotKey> repeated(const std::vector<ShotKey>& keys, const Turns& left) const;
    std::vector<ShotKey> ordered(std::vector<ShotKey> keys);
    void keep_time_order(std::vector<ShotKey>& keys) const;

    bool is_anniversary(const ShotKey& key) const;
    void drop_lost_turns(const std::set<std::string>& files);

    ShotOrder order_;
    std::mt19937_64 engine_;
    RecordList records_;  // as they were set last
    ShowHints hints_;     // likewise
    std::map<std::string, File> files_;
    std::deque<ShotKey> waiting_;
};

}  // namespace vitrine::player

#pragma once

#include "player/scene/arrangement.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::player {

/// A file that staff took off the wall, until it changes.
struct RemovedFile {
    std::string path;
    std::uint64_t bytes = 0;
    std::int64_t mtime_ns = 0;

    bool operator==(const RemovedFile&) const = default;
};

/// All that visitors and staff have arranged.
struct WallArrangement {
    std::map<std::string, ArrangedWall> walls;  // by the folder of their outputs; "": of all others
    std::set<std::string> pinned;               // paths of files
    std::set<int> slots;                        // pinned ones
    std::vector<RemovedFile> removed;

    bool operator==(const WallArrangement&) const = default;
};

/// The longest text that is read as an arrangement.
inline constexpr std::size_t max_arrangement_bytes = 8U << 20;

/// Writes an arrangement as JSON. A path that is not UTF-8 also stands there in hex digits.
std::string arrangement_json(const WallArrangement& arrangement);

/// @throws std::runtime_error  telling what is wrong with the text
WallArrangement arrangement_from_json(const std::string& text);

/// The files of arrangements below the state directory: that of the last run, and those with a name. A file
/// is replaced by rename.
class ArrangementFiles {
  public:
    static constexpr std::size_t max_named = 100;

    explicit ArrangementFiles(const std::filesystem::path& state)
        : last_(state / "arrangement.json"), folder_(state / "arrangements") {}

    /// The arrangement of the last run. None: there is none, or none that can be read, which is logged.
    std::optional<WallArrangement> last() const;

    /// Thread-safe. @throws std::system_error
    void write_last(const WallArrangement& arrangement) const;

    /// @throws std::runtime_error, std::system_error  for a person: the name is none, there are too many, or
    /// the file cannot be written
    void save(const std::string& name, const WallArrangement& arrangement) const;

    /// @throws std::runtime_error  for a person: there is none of that name, or it cannot be read
    WallArrangement load(const std::string& name) const;

    /// @throws std::runtime_error  for a person: there is none of that name, or it cannot be removed
    void forget(const std::string& name) const;

    /// All names, ordered.
    std::vector<std::string> names() const;

  private:
    std::filesystem::path file_of(const std::string& name) const;

    std::filesystem::path last_;
    std::filesystem::path folder_;
};

/// True for up to 64 letters and digits of ASCII, and "-", "_" and "." but at the start.
bool is_arrangement_name(std::string_view name);

}  // namespace vitrine::player

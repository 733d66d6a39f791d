#pragma once

#include "analyzer/store/store.hpp"
#include "analyzer/tapestry/tapestry_state.hpp"
#include "base/state/record.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

/// The daemon's list of tapestries: one folder a film, with the name of the film's record. Weaving children
/// fill the folders. The daemon removes the tapestries that no film has any more, and those beyond the
/// bounds, the longest unwatched first. A note in the folder says so, so that a tapestry is not woven again
/// while its film is the same.
class Tapestries {
  public:
    /// @param state  directory; the tapestries are in a folder of their own below
    Tapestries(std::filesystem::path state, const StoreBounds& bounds);

    bool is_on() const { return bounds_.max_bytes > 0; }

    std::filesystem::path folder(const std::string& path) const;

    /// Follows a new or changed record. Removes a tapestry of other content.
    /// @param choice  see FilmVersion
    /// @return true where a tapestry must be woven for it
    bool hold(const MediaRecord& record, const std::string& choice = "");

    /// The film whose record holds, with another choice of keyframes; none where there is no such film, or
    /// its tapestry is not wanted.
    /// @return its version, and true where a tapestry must be woven for it
    std::optional<std::pair<FilmVersion, bool>> choose(const std::string& path, const std::string& choice);

    /// A tapestry that has lost its place to others may be woven again.
    /// @return the film's content, if the tapestry had lost its place
    std::optional<FilmVersion> revive(const std::string& path) const;

    /// Removes the tapestry of a path that has no record any more.
    void release(const std::string& path);

    /// Renames the tapestry of `from` to `to`. Call before the records are held and released.
    void move(const std::string& from, const std::string& to) const;

    /// Measures the folder of a film, where a child wrote or is writing.
    void look_at(const std::string& path);

    /// Removes tiles that finer ones of the same film replaced ten minutes ago or more.
    void remove_replaced();

    /// Removes folders that belong to no record, except those of these files: a child may be writing there.
    void sweep(const std::vector<std::string>& files);

    /// Removes tapestries beyond the bounds. @param busy  path of the film that is being woven; "" for none
    /// @return the films that lost theirs
    std::vector<std::string> make_room(const std::string& busy);

  private:
    struct Content {
        FilmVersion film;
        bool is_complete = false;  // the film's record
        std::uint64_t bytes = 0;   // bytes in the folder
    };

    std::uint64_t excess() const;
    void note(const std::string& path, const Content& content) const;

    std::filesystem::path state_;
    StoreBounds bounds_;
    std::map<std::string, Content> held_;  // path of a ready film -> the content that its tapestry shows
};

}  // namespace vitrine::analyzer

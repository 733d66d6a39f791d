#pragma once

#include "analyzer/store/store.hpp"
#include "base/state/record.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The daemon's list of tapestries: a folder a film, named as its record is. Weaving children put in;
/// it takes out what no film has any more, and what goes beyond the bounds, the one that was looked at
/// longest ago first. That is noted in its folder, so that it is not woven again while its film is the same.
class Tapestries {
  public:
    /// @param state  directory; the tapestries are in a folder of their own below
    Tapestries(std::filesystem::path state, const StoreBounds& bounds);

    bool is_on() const { return bounds_.max_bytes > 0; }

    std::filesystem::path folder(const std::string& path) const;

    /// There is this record now. What there is of another content goes.
    /// @return whether a tapestry is to be woven for it
    bool hold(const MediaRecord& record);

    /// There is no record of this path any more.
    void release(const std::string& path);

    /// The record of `from` is now that of `to`. To be called before the records are held and released.
    void move(const std::string& from, const std::string& to) const;

    /// A child has been putting in, or is.
    void look_at(const std::string& path);

    /// Takes out what is of no record, but for the folders of these files: a child may be putting in.
    void sweep(const std::vector<std::string>& files);

    /// Takes out what goes beyond the bounds. @param busy  path of the film that is being woven; "" for none
    /// @return the films that have lost theirs
    std::vector<std::string> make_room(const std::string& busy);

  private:
    struct Content {
        std::uint64_t film_bytes = 0;
        std::int64_t film_mtime_ns = 0;
        std::uint64_t bytes = 0;  // bytes in the folder
    };

    std::uint64_t excess() const;
    void note(const std::string& path, const Content& content) const;

    std::filesystem::path state_;
    StoreBounds bounds_;
    std::map<std::string, Content> held_;  // path of a film that is ready -> what its tapestry is of
};

}  // namespace vitrine::analyzer

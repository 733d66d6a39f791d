#pragma once

#include "player/scene/files/show_files.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// The turns of files that are one: a group has one turn in a round, as one file has, and its photos take it
/// one after the other, the best first. The films of Live Photos have none.
class GroupTurns {
  public:
    using Fits = std::function<bool(const std::string& path)>;

    /// @param files  those that may be shown
    void set_files(const RecordList& files, const ShowHints& hints);

    /// The files that have turns: of each group its best photo among the files.
    const RecordList& heads() const { return heads_; }

    /// The file that has the turns of this file's group; the file itself where it has no group.
    std::string head_of(const std::string& path) const;

    /// True for a group with further photos than this one.
    bool has_others(const std::string& path, const Fits& fits) const;

    /// Gives the group's turn to its next photo. None: no photo fits.
    /// @param head  of heads()
    std::optional<std::string> take_turn(const std::string& head, const Fits& fits);

    /// True: one of its photos fits.
    bool has_turn(const std::string& head, const Fits& fits) const;

    /// The film that belongs to a photo as a Live Photo. Empty: there is none among the files.
    std::string film_of(const std::string& photo) const;

  private:
    std::vector<std::string> members(const std::string& path) const;
    std::string head_now(const std::string& path) const;

    RecordList files_;
    GroupList groups_;
    RecordList heads_;
    std::map<std::string, std::size_t> next_;  // head -> its next photo's number
};

}  // namespace vitrine::player

#pragma once

#include "base/state/record.hpp"
#include "player/scene/files/near_copies.hpp"
#include "player/scene/files/show_files.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vitrine::player {

/// Finds the files of which at most one is on the wall at a time: near-copies, and the halves of Live Photos.
/// Follows changes: only files that changed are compared, each with those that could be its copies.
class FileGroups {
  public:
    /// @param files  the whole catalogue
    void set_files(const RecordList& files);

    /// The groups of the files that have one.
    const GroupList& groups() const { return groups_; }

  private:
    /// A photo that can be compared.
    struct Known {
        RecordList::Record record;
        PhotoHashes hashes;
        PhotoFacts facts;  // of the record
    };

    void add(const RecordList::Record& record);
    void remove(const MediaRecord& record);
    std::vector<RecordList::Record> candidates(const Known& photo) const;
    void link(const std::string& a, const std::string& b);
    void join_live_pairs(const RecordList::Record& record);
    std::set<std::string> connected(const std::string& path) const;
    bool is_near(const RecordList::Record& best, const RecordList::Record& photo);
    std::vector<FileGroup> groups_among(std::vector<RecordList::Record> photos);
    void regroup(const std::set<std::string>& paths, GroupList::Changes& changes);
    void regroup_touched();

    RecordList files_;
    std::vector<Known> photos_;
    std::unordered_map<std::string, std::size_t> place_;            // of a photo in photos_, by its path
    std::map<std::string, std::set<std::string>> near_;             // path -> paths of its near-copies
    std::map<std::pair<std::string, std::string>, bool> compared_;  // are they near-copies; beside near_
    std::map<std::string, std::set<std::string>> live_;             // photo -> films, and film -> photos
    std::map<std::string, std::set<std::string>> by_name_;          // names that Live Photos share -> paths
    std::set<std::string> touched_;                                 // paths whose groups may be others now
    GroupList groups_;
};

}  // namespace vitrine::player

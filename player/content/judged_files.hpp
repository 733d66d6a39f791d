#pragma once

#include "base/state/visibility.hpp"
#include "player/scene/files/show_files.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace vitrine::player {

/// True: the file is in the list of those that may be shown. At most its folder is not on a screen now.
bool has_passed_filters(Visibility visibility);

/// The visibility of every file of the catalogue, and the list of those that may be shown. Judges a file only
/// when told to: with sixty thousand files, judging all of them takes longer than a picture may.
class JudgedFiles {
  public:
    using Judge = std::function<FileVisibility(const MediaRecord&)>;
    using List = SharedList<FileVisibility>;

    /// @param judge  tells the visibility of a file, but not that it is on the wall
    explicit JudgedFiles(Judge judge) : judge_(std::move(judge)) {}

    /// Judges these files anew.
    /// @param records  the whole catalogue; a path without a record is forgotten
    /// @return  true: the list of those that may be shown is another one
    bool judge(const std::set<std::string>& paths, const RecordList& records);

    /// Judges all files anew.
    bool judge_all(const RecordList& records);

    const List& all() const { return all_; }

    const RecordList& visible() const { return visible_; }

    /// The number of files of each visibility. Some may be zero.
    const std::map<Visibility, std::size_t>& counts() const { return counts_; }

    /// The number of judgements so far.
    std::size_t judgements() const { return judgements_; }

  private:
    struct Changes {
        List::Changes judged;
        RecordList::Changes visible;
    };

    void judge_file(const RecordList::Record& record, Changes& changes);
    void forget_file(const std::string& path, Changes& changes);
    bool apply(const Changes& changes);

    Judge judge_;
    List all_;
    RecordList visible_;
    std::map<Visibility, std::size_t> counts_;
    std::size_t judgements_ = 0;
};

}  // namespace vitrine::player

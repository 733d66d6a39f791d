#pragma once

#include "base/state/record.hpp"

#include <map>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The films whose analysis goes on, with the shots that are known so far. Pure: when to write them is the
/// daemon's to decide.
///
/// A second try begins at the film's first shot again; until it has more to say than the first, the catalogue
/// keeps what the first one said.
class GrowingRecords {
  public:
    /// A record in the catalogue that is not complete, left by an earlier run.
    void known(const MediaRecord& record);

    /// An analysis begins, of the content that `file` names.
    void begin(const MediaRecord& file);

    /// What a child says of its newest shots, or of earlier ones anew; its path, bytes and mtime are those
    /// that were begun.
    void add(const MediaRecord& part);

    /// The records that say more than the catalogue has, each once.
    std::vector<MediaRecord> take_news();

    bool has_news() const;

    /// Its analysis is over, or its file is gone.
    void end(const std::string& path) { growths_.erase(path); }

  private:
    struct Growth {
        MediaRecord record;
        std::size_t published = 0;  // shots that the catalogue has of this content
        bool is_changed = false;    // shots of before say more
    };

    static bool says_more(const Growth& growth);

    std::map<std::string, Growth> growths_;
};

}  // namespace vitrine::analyzer

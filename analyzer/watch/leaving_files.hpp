#pragma once

#include "analyzer/watch/file_facts.hpp"

#include <chrono>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

/// Files that vanished and whose record is still in the catalogue. Each may turn up again, under its own name
/// or another; after a while its record goes. Pure: times are passed in.
class LeavingFiles {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// @param is_done  its record is final, and holds for any file of the same content
    void add(const std::string& path, const FileFacts& facts, bool is_done, Time forget_at);

    /// The knowledge of a path before its file came back.
    struct Return {
        bool is_recorded = false;   // the catalogue has a record of this path
        bool record_holds = false;  // and it is right for the content
    };

    /// There is a file of this path again.
    Return take_back(const std::string& path, const FileFacts& facts);

    /// A rename: the vanished file with the same inode and content gives its record away.
    /// @return the old path; nothing where there is no such file
    std::optional<std::string> take_renamed(const FileFacts& facts);

    /// Paths whose time is over: their records go.
    std::vector<std::string> take_expired(Time now);

    /// The time at which take_expired() will have something.
    std::optional<Time> next_expiry() const;

    bool is_empty() const { return files_.empty(); }

    /// The number of comparisons that take_renamed() has made so far.
    std::size_t compared() const { return compared_; }

  private:
    struct File {
        FileFacts facts;
        bool is_done = false;
        Time forget_at{};
    };

    using Files = std::map<std::string, File>;

    void erase(Files::iterator left);

    Files files_;
    std::set<std::pair<std::uint64_t, std::string>> by_inode_;  // files that are done
    std::set<std::pair<Time, std::string>> by_time_;            // by forget_at
    std::size_t compared_ = 0;
};

}  // namespace vitrine::analyzer

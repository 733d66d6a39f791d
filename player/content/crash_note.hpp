#pragma once

#include "base/state/blame.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// Finds out which file brings the player down: what is open is noted on the disk before it is opened, and a
/// note that is there at the start is evidence. Nothing is fsynced, for a crash of this process does not
/// touch what the kernel has, and one of the machine does not count. A state directory that cannot be written
/// is told once and costs this protection only. Logs.
class CrashNote {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// Counts the crash of an earlier run, if it was one.
    explicit CrashNote(std::filesystem::path state);

    bool is_quarantined(const MediaRecord& record) const { return vitrine::is_quarantined(blame_, record); }

    /// Takes out what is not to be shown: what is quarantined, of which it tells once each, and of those that
    /// may have caused the last crash all but one at a time, so that a further one shows whose it is.
    void hold_back(std::vector<MediaRecord>& records);

    /// To be called before the file is opened.
    void open(const MediaRecord& record, Time now);

    /// @param records  of the catalogue, ordered by path; a file without one is not noted
    void open(const std::string& path, const std::vector<MediaRecord>& records, Time now);
    bool keep(const std::set<std::string>& open, const std::vector<MediaRecord>& records, Time now);

    /// What is still open, to be called now and then. A run of ten minutes forgives all that is not
    /// quarantined.
    ///
    /// @return  whether something that was held back need not be any longer
    bool keep(const std::set<ContentName>& open, Time now);

    /// The run ends as it should.
    void end();

  private:
    void count_crash();
    void forgive();
    std::chrono::seconds opening_time(const ContentName& name) const;
    bool end_trial(Time now);
    void write();

    std::filesystem::path state_;
    Blame blame_;
    PlayingNote note_;                    // as it is on the disk
    std::map<ContentName, Time> opened_;  // what is open
    Time start_{};                        // of the first call
    std::set<ContentName> suspects_;      // that are held back, and the one on trial
    std::optional<ContentName> on_trial_;
    std::optional<Time> trial_begin_;  // when it was first opened
    std::set<std::string> told_;       // quarantined files, by path
    bool is_active_ = true;            // no other player has this state directory, and it can be written
};

}  // namespace vitrine::player

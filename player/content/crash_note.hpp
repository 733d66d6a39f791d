#pragma once

#include "base/state/blame.hpp"
#include "player/scene/show_files.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// Finds out which file brings the player down. It notes each file on the disk before the file is opened; a
/// note that exists at the start is evidence of a crash. Nothing is fsynced: a crash of this process does not
/// touch what the kernel has, and a crash of the machine does not count. Where the state directory cannot be
/// written this is logged once, and only this protection is lost. Logs.
class CrashNote {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// Counts the crash of an earlier run, if it was one.
    explicit CrashNote(std::filesystem::path state);

    /// True: the file has brought the player down too often.
    bool is_quarantined(const MediaRecord& record) const { return vitrine::is_quarantined(blame_, record); }

    /// True: the file is one of several that may have caused the last crash. They are shown again one at a
    /// time, so that a further crash shows which one it was.
    bool is_on_hold(const MediaRecord& record) const;

    /// To be called when there are other files: logs those that are quarantined, once each, and chooses which
    /// suspect is shown next, where none is being tried.
    void set_files(const RecordList& files);

    /// To be called before the file is opened.
    void note_opening(const MediaRecord& record, Time now);

    /// Notes the files that are still open; to be called now and then. A run of ten minutes forgives all
    /// files that are not quarantined.
    /// @return  true: a suspect was cleared, so that another file may be shown
    bool note_open(const std::set<ContentName>& open, Time now);

    /// Takes the note away: the run ends as it should.
    void end_run();

  private:
    void count_crash();
    void forgive();
    std::chrono::seconds opening_time(const ContentName& name) const;
    bool end_trial(Time now);
    void write();

    std::filesystem::path state_;
    Blame blame_;
    PlayingNote note_;                    // the note on the disk
    std::map<ContentName, Time> opened_;  // open files and when they were opened
    Time start_{};                        // the first call
    std::set<ContentName> suspects_;      // files that are on hold, and the one on trial
    std::optional<ContentName> on_trial_;
    std::optional<Time> trial_begin_;  // when the file on trial was first opened
    std::set<std::string> logged_;     // paths of quarantined files
    bool is_active_ = true;            // no other player has this state directory, and it can be written
};

}  // namespace vitrine::player

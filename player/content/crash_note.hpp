#pragma once

#include "base/state/blame.hpp"
#include "player/scene/files/show_files.hpp"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// Finds out which file makes the player crash. It notes each file on the disk before the file is opened; a
/// note that exists at the start is evidence of a crash or a kill. A kill from outside says nothing about any
/// file. Nothing is fsynced: what the kernel has outlasts a crash of this process, and a crash of the machine
/// does not count. If the state directory cannot be written, this is logged once and only this protection is
/// lost. Logs.
class CrashNote {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// Counts a crash if the earlier run ended with one.
    explicit CrashNote(std::filesystem::path state);

    /// True: the file has made the player crash too often.
    bool is_quarantined(const MediaRecord& record) const;

    /// True: the file is one of several that may have caused the last crash. They are shown again one at a
    /// time, so that a further crash shows which one it was.
    bool is_on_hold(const MediaRecord& record) const;

    /// Call when the files have changed. Logs each quarantined file once, and chooses the next suspect to
    /// show if none is on trial.
    /// @return  true: is_on_hold() may answer otherwise for files that have not changed
    bool set_files(const RecordList& files);

    /// Call before the file is opened.
    void note_opening(const MediaRecord& record, Time now);

    /// Call when a file has made its own reader crash. Logs. Twice, and the file is quarantined, unless other
    /// files did the same within an hour.
    void note_reader_crash(const MediaRecord& record, Time now);

    /// Notes the files that are still open. Call now and then. Ten minutes without a crash forgive all files
    /// that are not quarantined.
    /// @return  true: other files may be shown than before
    bool note_open(const std::set<ContentName>& open, Time now);

    /// Forgets all crashes of a file, and tells the analyzer. @param path  "": of all files
    /// @throws std::system_error if the state directory cannot be written
    void acquit(const std::string& path);

    /// Removes the note: the run ends in order.
    void end_run();

  private:
    void count_crash();
    void write_blame();
    void forgive();
    std::chrono::seconds opening_time(const ContentName& name) const;
    bool choose_suspect();
    bool end_trial(Time now);
    bool follow_quarantines();
    void log_quarantine(const MediaRecord& record);
    void write();

    std::filesystem::path state_;
    Blame blame_;
    PlayingNote note_;                    // the note on the disk
    std::map<ContentName, Time> opened_;  // open files and when they were opened
    Time start_{};                        // time of the first call, or of a reader's last crash
    std::set<ContentName> suspects_;      // the files on hold, and the one on trial
    std::optional<ContentName> on_trial_;
    std::string trial_path_;                      // of the file on trial
    std::optional<Time> trial_begin_;             // time of the first opening of the file on trial
    RecordList files_;                            // as they were set last
    std::size_t quarantined_ = 0;                 // contents that are quarantined
    std::set<std::string> logged_;                // paths of quarantined files
    std::map<ContentName, Time> reader_crashes_;  // the last of each content, within an hour
    bool is_active_ = true;  // false: another player has this state directory, or it cannot be written
};

}  // namespace vitrine::player

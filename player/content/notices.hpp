#pragma once

#include "base/hints/notice.hpp"
#include "player/scene/files/show_files.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace vitrine::player {

/// Follows the notices ("!NOW 20min notice/"): which one covers the walls now, and which are over. The time
/// of a notice begins when its first file can be shown. It is noted in the state directory, so that a restart
/// does not begin it again. A notice of which no file can be shown covers nothing. A notice whose files go is
/// forgotten. Logs.
class Notices {
  public:
    using Time = std::chrono::sys_seconds;
    using CanBeShown = std::function<bool(const MediaRecord&)>;

    /// @param note  the file of the note; empty: nothing is noted
    explicit Notices(std::filesystem::path note);

    /// @param files         those with shots
    /// @param can_be_shown  tells whether a file of a notice could be shown if there were no notices
    /// @return true: other files may be shown than before
    bool set_files(const RecordList& files, const CanBeShown& can_be_shown, Time now);

    /// Call about once a second. @return  true: other files may be shown than at the last call
    bool look(Time now);

    /// The name of the notice that covers the walls: of several the one that came last. Empty: none does.
    const std::string& active() const { return active_; }

    /// True for a file of a notice whose time is over.
    bool is_over(const std::string& path) const;

    /// True: another file is shown instead of this one.
    bool is_covered(const std::string& path) const;

  private:
    void read();
    void write() const;

    std::filesystem::path file_;
    std::map<std::string, Time> since_;      // entry -> begin
    std::map<std::string, Notice> notices_;  // those of which a file can be shown
    std::string active_;
    Time now_{};
};

}  // namespace vitrine::player

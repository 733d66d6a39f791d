#pragma once

#include "analyzer/child/child_process.hpp"
#include "analyzer/tapestry/tapestries.hpp"
#include "analyzer/watch/wanted_film.hpp"
#include "analyzer/watch/weave_schedule.hpp"
#include "base/hints/keyframe_choice.hpp"
#include "base/system/event_loop.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The options of weaving.
struct WeaveOptions {
    std::filesystem::path root;        // the media folder
    std::filesystem::path state;       // directory
    StoreBounds bounds;                // max_bytes 0: no tapestries
    std::vector<std::string> command;  // the folder and the film are appended
    ChildLimits limits;
    int wanted_niceness = 5;  // of a child that a visitor waits for: before analyses, behind the player
};

/// Weaves the tapestries of the films that have records, one at a time in a child process, and only while
/// nothing is analysed, except for the film that a visitor waits for. Logs.
class Weaver {
  public:
    /// @param ended  called from the loop when a child has ended
    Weaver(EventLoop& loop, WeaveOptions options, std::function<void()> ended);
    Weaver(const Weaver&) = delete;
    Weaver& operator=(const Weaver&) = delete;
    ~Weaver() = default;

    /// There is this record now; its tapestry is woven where it lacks one.
    void note_record(const MediaRecord& record);

    /// The keyframes that operators have chosen in files, by the paths of films. What a technician has chosen
    /// by touch comes to them. Films of another choice are woven anew.
    void set_choices(const KeyframeChoices& choices);

    /// The keyframes that were chosen for a film, in its file and by touch; an empty choice where there are
    /// none.
    KeyframeChoice keyframes_for(const std::string& path) const;

    /// There is no record of this path any more: its tapestry goes.
    void forget_film(const std::string& path);

    /// Call before the records of both paths are noted and forgotten.
    void rename_film(const std::string& from, const std::string& to);

    /// A child has ended that analysed the film, and may have kept frames of it.
    void note_analysis(const std::string& path) { tapestries_.look_at(path); }

    /// Removes tapestries of no film, and those beyond the bounds. Call from time to time.
    /// @param files  all that there are
    void sweep_tapestries(const std::vector<std::string>& files);

    /// Starts, pauses or continues weaving.
    void advance(WeaveScope scope);

    /// True where nothing is woven, and nothing will be.
    bool is_idle() const { return schedule_.is_idle(); }

  private:
    void perform(const WeaveAction& action);
    std::vector<std::string> command_for(const std::string& path) const;
    void start_child(const std::string& path);
    void finish_weaving(const std::string& path, const ChildResult& result);
    void make_room();
    void follow_wish();
    void read_notes();
    void follow_choices();
    std::string choice_key(const std::string& path) const;

    EventLoop& loop_;  // outlives this
    WeaveOptions options_;
    std::function<void()> ended_;
    Tapestries tapestries_;
    KeyframeChoices written_;  // in files
    KeyframeChoices touched_;  // by touch
    KeyframeChoices choices_;  // of both
    WeaveSchedule schedule_;
    std::unique_ptr<ChildProcess> child_;
    WeaveScope scope_ = WeaveScope::none;  // since the last advance()
    WantedFilm wanted_;
};

}  // namespace vitrine::analyzer

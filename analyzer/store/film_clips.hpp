#pragma once

#include "analyzer/store/clip_form.hpp"
#include "analyzer/store/store_place.hpp"
#include "base/state/record.hpp"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace vitrine::analyzer {

/// Makes the clips of a film's shots, one after another in a thread of its own, while the film is still
/// analysed: a second pass over the film, seconds behind the first.
class FilmClips {
  public:
    FilmClips(std::string film, const ClipForm& form, StorePlace place);
    FilmClips(const FilmClips&) = delete;
    FilmClips& operator=(const FilmClips&) = delete;

    /// Gives up the clips that are not made yet.
    ~FilmClips();

    /// @param shot  later than the last one
    void request_clip(const Shot& shot);

    /// The shots whose clips were made since the last call, or cannot be, with their place in the store. A
    /// clip for which the disk had no room has its place too: it is made when the analyzer starts again.
    std::vector<Shot> take_made();

    /// Waits until every requested clip is made, or cannot be.
    void finish();

  private:
    class Pass;

    void run();
    bool is_stopped();
    std::optional<Shot> next_wanted();
    void make(Pass& pass, Shot shot);

    std::string film_;
    ClipForm form_;
    StorePlace place_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Shot> wanted_;    // guarded by mutex_
    std::vector<Shot> made_;     // guarded by mutex_
    bool is_finishing_ = false;  // guarded by mutex_: no further clip is requested
    bool is_stopped_ = false;    // guarded by mutex_
    std::thread thread_;         // last: all other members are there when it starts
};

}  // namespace vitrine::analyzer

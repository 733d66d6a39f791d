#pragma once

#include "player/input/contact.hpp"

#include <chrono>
#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// A script of events for a wall, so that they can be seen and tested without waiting: files come and go, a
/// visitor touches. One event a line, times in seconds since the start, lengths in canvas px:
///
///     4 add FILE             the file was not there before
///     9 remove FILE          relative to the media folder
///     12 tap X Y             and the other words of the table `input_words` in rehearsal.cpp. Lines at the
///                            same time are several hands
///     14 down 3 X Y          finger 3 comes down; it stays until `up 3` or `cancel 3`
///     0 clock 2026-12-24 17:59:50      sets the local time, which goes on from there
class Rehearsal {
  public:
    /// @throws std::runtime_error naming line and fault
    explicit Rehearsal(const std::string& script);

    /// Goes on to a time. @return  true: files have come or gone
    bool advance(std::chrono::nanoseconds now);

    /// True: the file, relative to the media folder, is there now.
    bool is_present(const std::string& path) const;

    /// The local time that the script sets; none: the real time.
    std::optional<std::chrono::local_seconds> local_time() const;

    /// The input of the visitor since the last call, canvas px.
    std::vector<InputEvent> next_touches();

  private:
    struct FileEvent {
        std::chrono::nanoseconds time{0};
        std::string path;
        bool is_added = false;  // false: the file is removed
    };

    struct Clock {
        std::chrono::nanoseconds time{0};
        std::chrono::local_seconds shows{};
    };

    void read_line(const std::string& line);
    void read_file(std::istream& words, std::chrono::nanoseconds time, bool is_added);

    std::vector<FileEvent> files_;     // in order of time
    std::vector<InputEvent> touches_;  // in order of time
    std::size_t passed_ = 0;           // number of files_ that are over
    std::size_t touched_ = 0;          // number of touches_ that were passed on
    int next_finger_ = 100;            // smaller numbers are those of the script's own fingers
    std::vector<Clock> clocks_;
    std::chrono::nanoseconds now_{0};
};

}  // namespace vitrine::player

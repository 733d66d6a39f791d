#pragma once

#include "base/catalogue/record.hpp"
#include "base/geometry/vec2.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine {

/// A script of what happens to a wall, so that it can be seen and tested without waiting for it: files come
/// and go, a finger drags. One event a line, times in seconds since the start, lengths in canvas px:
///
///     # comment
///     4    add garden/new.jpg           not there before
///     8.5  remove trips/old.jpg
///     12   drag 300 200 700 100 2.5     from, to, in so many seconds
///     0    clock 2026-12-24 17:59:50    the local time, which goes on from there
class Rehearsal {
  public:
    /// @throws std::runtime_error naming line and fault
    explicit Rehearsal(const std::string& script);

    /// Goes on to a time. True: other files are there than before.
    bool advance(std::chrono::nanoseconds now);

    /// Those of the records that are there now.
    std::vector<MediaRecord> present(std::span<const MediaRecord> records) const;

    /// What the clock on the wall shows now; none: the real time.
    std::optional<std::chrono::local_seconds> local_time() const;

    /// Where the finger is now, canvas px.
    std::optional<Vec2> finger() const;

  private:
    struct FileEvent {
        std::chrono::nanoseconds time{0};
        std::string path;
        bool is_added = false;  // else removed
    };

    struct Drag {
        std::chrono::nanoseconds time{0};
        std::chrono::nanoseconds duration{0};
        Vec2 from, to;
    };

    struct Clock {
        std::chrono::nanoseconds time{0};
        std::chrono::local_seconds shows{};
    };

    void read_line(const std::string& line);

    std::vector<FileEvent> files_;  // in order of time
    std::vector<Drag> drags_;
    std::vector<Clock> clocks_;
    std::size_t passed_ = 0;  // of files_
    std::chrono::nanoseconds now_{0};
};

}  // namespace vitrine

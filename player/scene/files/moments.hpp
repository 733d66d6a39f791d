#pragma once

#include "player/scene/files/show_files.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::player {

/// The moments of a catalogue: files that cameras took one after another without a longer pause, such as an
/// afternoon at a lake.
class Moments {
  public:
    explicit Moments(const RecordList& files);

    /// The moment of a file in words: "taken on 2026-07-04 between 14:05 and 17:20, with 11 others". Empty:
    /// no camera told when it was taken, or it was taken alone.
    std::string words_for(const std::string& path) const;

  private:
    struct Moment {
        const MediaRecord* first = nullptr;
        const MediaRecord* last = nullptr;
        std::size_t files = 0;
    };

    RecordList files_;
    std::vector<Moment> moments_;
    std::map<std::string_view, std::size_t> of_;  // a path in files_ -> its moment
};

}  // namespace vitrine::player

#pragma once

#include "analyzer/film/frame_source.hpp"
#include "analyzer/store/film_clips.hpp"
#include "analyzer/store/store_place.hpp"
#include "base/state/record.hpp"

#include <memory>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Writes one medium into the store while it is analysed: a film as clips of its shots and, where it is to be
/// heard, its sound; a photo as a copy.
class StoreWriter {
  public:
    /// @param media  facts of the file that are known before its first frame
    StoreWriter(std::string file, const MediaInfo& media, StorePlace place);
    ~StoreWriter();
    StoreWriter(const StoreWriter&) = delete;
    StoreWriter& operator=(const StoreWriter&) = delete;

    /// A film's shot is over: its clip is made.
    void add_shot(const Shot& shot);

    /// The added shots whose place in the store has become known since the last call.
    std::vector<Shot> take_placed_shots();

    /// Waits for the files that are still being made, and enters the places of all shots in the record. A
    /// film of which no clips can be made is copied.
    void finish(MediaRecord& record);

  private:
    void fill_in_places(MediaRecord& record);

    std::string file_;
    MediaInfo media_;
    StorePlace place_;
    std::unique_ptr<FilmClips> clips_;  // only of a film, where clips can be made
    std::vector<Shot> known_;           // shots with their places
};

}  // namespace vitrine::analyzer

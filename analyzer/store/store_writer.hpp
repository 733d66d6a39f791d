#pragma once

#include "analyzer/store/film_clips.hpp"
#include "analyzer/store/store_place.hpp"
#include "analyzer/video/frame_source.hpp"
#include "base/state/record.hpp"

#include <memory>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Puts one file into the store while it is analysed: a film as clips of its shots and, where
/// it is to be heard, its sound, a photo as a copy.
class Keeper {
  public:
    /// @param media  what the analysis knows of the file before its first frame
    Keeper(std::string file, const MediaInfo& media, StorePlace place);
    ~Keeper();
    Keeper(const Keeper&) = delete;
    Keeper& operator=(const Keeper&) = delete;

    /// The shot of a film is over.
    void found(const Shot& shot);

    /// The shots found whose place in the store has become known since the last call.
    std::vector<Shot> news();

    /// Waits for what is still being made, and says in the whole record where its shots are. A film of which
    /// no clips can be made is copied.
    void complete(MediaRecord& record);

  private:
    void fill_in(MediaRecord& record);

    std::string file_;
    MediaInfo media_;
    StorePlace place_;
    std::unique_ptr<FilmClips> clips_;  // of a film that clips can be made of
    std::vector<Shot> known_;           // with their places
};

}  // namespace vitrine::analyzer

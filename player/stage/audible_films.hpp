#pragma once

#include "player/scene/chosen_sound.hpp"
#include "player/scene/files/show_files.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"

#include <map>
#include <vector>

namespace vitrine::player {

/// Remembers the films that a stage has asked for, and finds those on the screen that may be heard.
class AudibleFilms {
  public:
    /// @param records  the stage's records; they tell where a film's sound is stored
    void note(const ShotRequest& request, const RecordList& records);

    void forget(SourceId source) { films_.erase(source); }

    /// The shots of a frame whose hints ask for sound.
    std::vector<AudibleShot> shots(const Frame& frame, const ShowHints& hints) const;

  private:
    std::map<SourceId, AudibleShot> films_;
};

}  // namespace vitrine::player

#pragma once

#include "player/scene/shot_request.hpp"

#include <optional>

namespace vitrine::player {

/// The same shot in the store: its path is relative to the store, its times are
/// those of the stored file and its size is at most the stored one, which is
/// then enlarged when it is drawn. None if the record knows of no place in the
/// store. The file may have been removed since; this shows when it is opened.
std::optional<ShotRequest> stored_request(const ShotRequest& request);

}  // namespace vitrine::player

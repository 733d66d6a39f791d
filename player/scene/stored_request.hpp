#pragma once

#include "player/scene/shot_request.hpp"

#include <optional>

namespace vitrine::player {

/// The same shot as the store has it: its path is relative to the store, its times are those of the stored
/// file and its size is at most what is stored, which is then enlarged where it is drawn. Nothing where the
/// record knows of no place in the store. Whether the file is still there shows when it is opened.
std::optional<ShotRequest> stored_request(const ShotRequest& request);

}  // namespace vitrine::player

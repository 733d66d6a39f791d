#pragma once

#include "player/scene/shot_request.hpp"

#include <optional>

namespace vitrine::player {

/// The request for the same shot in the store: its path is relative to the store, its times are those of the
/// stored file, and its size is at most the stored size, which is enlarged in drawing. None: the record names
/// no place in the store. The file may have been removed since; that is noticed when it is opened.
std::optional<ShotRequest> stored_request(const ShotRequest& request);

}  // namespace vitrine::player

#pragma once

#include "player/scene/files/shot_rotation.hpp"
#include "player/scene/files/show_files.hpp"

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// Rates a shot in (0, 1]. A shot tells more if its I-Region has a larger share of the picture and if the
/// analysis is certain of it.
double telling(const MediaRecord& record, const Shot& shot);

/// Returns the difference of two shots in [0, 1]. It compares their looks. If a record has none, it is larger
/// the farther apart the shots lie in films and folders.
double unlikeness(const MediaRecord& a, int shot_a, const MediaRecord& b, int shot_b);

/// The shots that stand for a folder: telling ones that are little alike. They are found by farthest-point
/// choice: each is the one whose distance from all before it, and what it tells, are the largest. The same
/// files give the same shots. Of a large folder a sample is looked at, the same from each of its parts.
/// @param files    of the folder and its sub-folders; only shots that can be shown
/// @param kept     shots that stay; they come first
/// @param avoided  paths of files that are left out
/// @param count    at most so many shots; fewer if there are not so many
std::vector<ShotKey> folder_shots(const RecordList& files, std::span<const ShotKey> kept,
                                  const std::set<std::string>& avoided, std::size_t count);

}  // namespace vitrine::player

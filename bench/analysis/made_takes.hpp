#pragma once

#include "bench/analysis/take.hpp"

#include <filesystem>
#include <vector>

namespace vitrine::analyzer {

/// The pictures that takes are drawn with.
struct Palette {
    std::vector<cv::Mat> scenes;    // pictures in which nothing stands out
    std::vector<cv::Mat> subjects;  // pictures of which the middle is cut out
};

/// The photographs of a media folder, scenes being those labelled to have no subject, and drawn landscapes.
Palette palette(const std::filesystem::path& media, int side);

/// The number of drawn takes.
std::size_t made_take_count();

/// A drawn take: a cut-out that moves, its outline beating like limbs, over a scene, seen by a camera that
/// stands, follows, shakes or zooms, with the noise of a sensor and of the light. The same number gives the
/// same take.
Take made_take(std::size_t number, const Palette& palette);

}  // namespace vitrine::analyzer

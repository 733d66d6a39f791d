#pragma once

#include "tests/player/render/reference_compositor.hpp"

#include <chrono>
#include <vector>

namespace vitrine::player {

/// Looks for flashes in a sequence of pictures, as WCAG 2.3.1 describes them: a place becomes brighter by
/// more than a tenth of the full relative luminance and then darker, or the other way round, where the darker
/// one is below 0.8.
class FlashMeter {
  public:
    void add(const ReferenceImage& image, std::chrono::nanoseconds now);

    /// The largest share of the picture that has ever flashed more than twice within a second, that is with
    /// five changes, each opposite to the one before.
    double worst_share() const { return worst_; }

    /// The largest number of such changes of one place within a second.
    std::size_t most_changes() const { return most_; }

  private:
    struct Place {
        double low = 0;  // luminance since the last change
        double high = 0;
        int direction = 0;  // of the last change: 1: brighter, -1: darker
        std::vector<std::chrono::nanoseconds> changes{};
    };

    static void note(Place& place, double luminance, std::chrono::nanoseconds now);

    std::vector<Place> places_;
    double worst_ = 0;
    std::size_t most_ = 0;
};

}  // namespace vitrine::player

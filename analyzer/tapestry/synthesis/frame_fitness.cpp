#include "analyzer/tapestry/synthesis/frame_fitness.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {

namespace {

using namespace std::chrono_literals;

constexpr double min_contrast = 6;      // grey levels; below it a frame is empty
constexpr double flash_step = 40;       // grey levels of the mean to both neighbours
constexpr double same_picture = 25;     // grey levels, of the neighbours of a flash
constexpr auto fade_reach = 2500ms;     // half a long fade
constexpr double fade_likeness = 0.85;  // correlation of a picture with its darker or paler copy
constexpr double fade_loss = 1.3;       // times the contrast that the copy has
constexpr double other_picture = 30;    // grey levels between the two pictures of a dissolve
constexpr double mixture_rest = 0.3;    // share of that which their mixture may leave unexplained
constexpr double min_share = 0.15;      // of either picture in a mixture
constexpr auto shortest_take = 1s;      // that must be shown

/// Mean and standard deviation of all channel values.
struct Tones {
    double mean = 0;
    double contrast = 0;
};

Tones tones_of(const FrameSignature& frame) {
    double sum = 0;
    double squares = 0;
    for (const std::uint8_t value : frame.pixels) {
        sum += value;
        squares += value * value;
    }
    const auto count = static_cast<double>(frame.pixels.size());
    const double mean = sum / count;
    return {.mean = mean, .contrast = std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

class Judge {
  public:
    Judge(std::span<const FrameSignature> frames, std::span<const FilmPart> shots)
        : frames_(frames), shots_(shots) {
        for (const FrameSignature& frame : frames)
            tones_.push_back(tones_of(frame));
    }

    bool is_fit(std::size_t i) const {
        if (tones_[i].contrast < min_contrast || is_flash(i)) return false;
        return is_in_shot(i) || (!is_faded(i) && !is_mixed(i));
    }

    std::size_t richest() const {
        const auto most = std::ranges::max_element(tones_, {}, &Tones::contrast);
        return static_cast<std::size_t>(most - tones_.begin());
    }

  private:
    bool is_in_shot(std::size_t i) const {
        return std::ranges::any_of(shots_, [&](const FilmPart& shot) {
            return frames_[i].time >= shot.begin && frames_[i].time < shot.end;
        });
    }

    bool is_flash(std::size_t i) const {
        if (i == 0 || i + 1 >= frames_.size()) return false;
        const double before = tones_[i].mean - tones_[i - 1].mean;
        const double after = tones_[i].mean - tones_[i + 1].mean;
        return before * after > 0 && std::min(std::abs(before), std::abs(after)) > flash_step &&
               difference(frames_[i - 1], frames_[i + 1]) < same_picture;
    }

    double likeness(std::size_t a, std::size_t b) const {
        double sum = 0;
        for (std::size_t k = 0; k < frames_[a].pixels.size(); ++k)
            sum += (frames_[a].pixels[k] - tones_[a].mean) * (frames_[b].pixels[k] - tones_[b].mean);
        const auto count = static_cast<double>(frames_[a].pixels.size());
        return sum / count / std::max(1.0, tones_[a].contrast * tones_[b].contrast);
    }

    bool is_faded(std::size_t i) const {
        const auto is_richer = [&](std::size_t j) {
            return tones_[j].contrast >= fade_loss * tones_[i].contrast && likeness(i, j) >= fade_likeness;
        };
        for (std::size_t j = i; j-- > 0 && frames_[i].time - frames_[j].time <= fade_reach;)
            if (is_richer(j)) return true;
        for (std::size_t j = i + 1; j < frames_.size() && frames_[j].time - frames_[i].time <= fade_reach;
             ++j)
            if (is_richer(j)) return true;
        return false;
    }

    bool is_mixed(std::size_t i) const {
        for (const std::size_t away : {1U, 2U})
            if (i >= away && i + away < frames_.size() && is_mixture(i, i - away, i + away)) return true;
        return false;
    }

    /// Fits frame = from + share * (to - from).
    bool is_mixture(std::size_t i, std::size_t from, std::size_t to) const {
        const double apart = difference(frames_[from], frames_[to]);
        if (apart < other_picture) return false;
        double along = 0;
        double squares = 0;
        const std::size_t count = frames_[i].pixels.size();
        for (std::size_t k = 0; k < count; ++k) {
            const double way = frames_[to].pixels[k] - frames_[from].pixels[k];
            const double step = frames_[i].pixels[k] - frames_[from].pixels[k];
            along += way * step;
            squares += step * step;
        }
        const double length = apart * apart * static_cast<double>(count);
        const double share = along / length;
        const double rest = squares - along * share;
        return share > min_share && share < 1 - min_share && rest < mixture_rest * mixture_rest * length;
    }

    std::span<const FrameSignature> frames_;
    std::span<const FilmPart> shots_;
    std::vector<Tones> tones_;
};

}  // namespace

double difference(const FrameSignature& a, const FrameSignature& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) {
        const double step = a.pixels[k] - b.pixels[k];
        sum += step * step;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

std::vector<bool> fit_frames(std::span<const FrameSignature> frames, std::span<const FilmPart> shots) {
    const Judge judge(frames, shots);
    std::vector<bool> fit(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        fit[i] = judge.is_fit(i);
    if (std::ranges::find(fit, true) == fit.end()) fit[judge.richest()] = true;
    return fit;
}

std::vector<int> takes_of(std::span<const FrameSignature> frames, std::span<const FilmPart> shots) {
    std::vector<int> numbers(frames.size(), -1);
    for (std::size_t shot = 0; shot < shots.size(); ++shot) {
        if (shots[shot].end - shots[shot].begin < shortest_take) continue;
        const auto first = std::ranges::lower_bound(frames, shots[shot].begin, {}, &FrameSignature::time);
        const auto last = std::ranges::lower_bound(frames, shots[shot].end, {}, &FrameSignature::time);
        for (auto frame = first; frame != last; ++frame)
            numbers[static_cast<std::size_t>(frame - frames.begin())] = static_cast<int>(shot);
    }
    return numbers;
}

}  // namespace vitrine::analyzer

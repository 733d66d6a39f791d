#include "analyzer/film/standing_picture.hpp"

#include <algorithm>

namespace vitrine::analyzer {

namespace {

constexpr double flat = 2;  // grey levels of deviation: a picture of one colour

double largest_difference(const FeatureWindow& window, std::size_t from, std::size_t first,
                          std::size_t last) {
    double largest = 0;
    for (std::size_t i = first; i <= last; ++i)
        largest = std::max(largest, picture_difference(window.at(from), window.at(i)));
    return largest;
}

}  // namespace

std::size_t stands_until(const FeatureWindow& window, std::size_t first, std::size_t last, double share) {
    const double limit = share * largest_difference(window, first, first, last);
    std::size_t frame = first;
    while (frame < last && picture_difference(window.at(first), window.at(frame)) <= limit)
        ++frame;
    return frame;
}

std::size_t stands_from(const FeatureWindow& window, std::size_t first, std::size_t last, double share) {
    const double limit = share * largest_difference(window, last, first, last);
    std::size_t frame = last;
    while (frame > first && picture_difference(window.at(last), window.at(frame - 1)) <= limit)
        --frame;
    return frame;
}

Transition without_standing(const FeatureWindow& window, const Transition& dissolve) {
    const std::size_t first = window.frame_at(dissolve.begin);
    const std::size_t last = window.frame_at(dissolve.end);
    bool is_fade = false;
    for (std::size_t i = first; i <= last; ++i)
        is_fade = is_fade || window.at(i).deviation < flat;
    const double share = is_fade ? StandingShare::fade : StandingShare::dissolve;
    const std::size_t begin = stands_until(window, first, last, share);
    const std::size_t end = stands_from(window, begin, last, share);
    return {window.time(begin), window.time(end), is_fade ? ShotEnd::fade : dissolve.kind};
}

}  // namespace vitrine::analyzer

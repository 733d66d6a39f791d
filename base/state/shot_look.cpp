#include "base/state/shot_look.hpp"

#include "base/state/path_text.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace vitrine {

double distance_between(const ShotLook& a, const ShotLook& b) {
    constexpr double usual_colours = 0.5;  // mean difference of unlike pictures, as a share of the range
    constexpr double max_value = 255;
    double squares = 0;
    for (std::size_t i = 0; i < a.colours.size(); ++i) {
        const double difference = (a.colours[i] - b.colours[i]) / max_value;
        squares += difference * difference;
    }
    const double colours = std::sqrt(squares / static_cast<double>(a.colours.size())) / usual_colours;
    const double hashes = std::popcount(a.hash ^ b.hash) / 64.0;
    return (std::min(1.0, colours) + hashes) / 2;
}

std::string text_of(const ShotLook& look) {
    std::string bytes;
    for (int shift = 56; shift >= 0; shift -= 8)
        bytes += static_cast<char>(look.hash >> shift);
    bytes.append(look.colours.begin(), look.colours.end());
    return to_hex(bytes);
}

ShotLook look_from_text(std::string_view text) {
    const std::string bytes = from_hex(text);
    ShotLook look;
    if (bytes.size() != sizeof look.hash + look.colours.size())
        throw std::runtime_error("record: 'look' is not as long as a look is");
    for (std::size_t i = 0; i < sizeof look.hash; ++i)
        look.hash = look.hash << 8U | static_cast<std::uint8_t>(bytes[i]);
    for (std::size_t i = 0; i < look.colours.size(); ++i)
        look.colours[i] = static_cast<std::uint8_t>(bytes[sizeof look.hash + i]);
    return look;
}

}  // namespace vitrine

#include "base/state/zoom_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

// The file has a magic word, the tile's size, the origin of all places, then the places. All numbers are
// little-endian.

namespace vitrine {

namespace {

constexpr std::string_view magic = "vzoom-1\n";
constexpr int max_side = 4096;                             // px, of a tile
constexpr std::int64_t max_place = std::int64_t{1} << 27;  // px, of a level
constexpr std::size_t head = magic.size() + 2 + 2 + 8;     // bytes
constexpr std::size_t point_bytes = 4 + 2 + 1;
constexpr double parts = 16;         // steps of a place in one px
constexpr double growth_parts = 32;  // steps of a growth in 1
constexpr int max_growth = 255;      // in steps

void append(std::string& bytes, std::uint64_t number, int count) {
    for (int i = 0; i < count; ++i)
        bytes.push_back(static_cast<char>(number >> (8 * i) & 0xff));
}

/// Reads numbers from the front of the bytes.
class Reader {
  public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    std::uint64_t number(int count) {
        std::uint64_t number = 0;
        for (int i = 0; i < count; ++i)
            number |= std::uint64_t{static_cast<unsigned char>(bytes_[at_ + static_cast<std::size_t>(i)])}
                      << (8 * i);
        at_ += static_cast<std::size_t>(count);
        return number;
    }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

void require(bool is_so, std::string_view what) {
    if (!is_so) throw std::runtime_error(fmt::format("zoom field: {}", what));
}

/// Number of points for a tile of this width.
std::size_t count_of(int width) {
    return static_cast<std::size_t>(ZoomField::columns_of(width)) * ZoomField::rows;
}

void check_order(const ZoomField& field) {
    for (int row = 0; row < ZoomField::rows; ++row) {
        for (int column = 0; column < field.columns(); ++column) {
            const Vec2& place = field.place(column, row);
            require(place.y >= 0 && place.y <= field.height, "a place is above or below the strip");
            require(column == 0 || place.x >= field.place(column - 1, row).x, "places go to the left");
            require(row == 0 || place.y >= field.place(column, row - 1).y, "places go up");
        }
    }
}

}  // namespace

std::string to_bytes(const ZoomField& field) {
    const double origin = field.places.empty() ? 0 : std::floor(field.places.front().x);
    std::string bytes(magic);
    append(bytes, static_cast<std::uint64_t>(field.width), 2);
    append(bytes, static_cast<std::uint64_t>(field.height), 2);
    append(bytes, static_cast<std::uint64_t>(static_cast<std::int64_t>(origin)), 8);
    for (std::size_t i = 0; i < field.places.size(); ++i) {
        const Vec2 place = field.places[i];
        const long long growth = std::llround(field.growths[i] * growth_parts);
        append(bytes, static_cast<std::uint64_t>(std::llround((place.x - origin) * parts)), 4);
        append(bytes, static_cast<std::uint64_t>(std::llround(place.y * parts)), 2);
        append(bytes, static_cast<std::uint64_t>(std::clamp<long long>(growth, 0, max_growth)), 1);
    }
    return bytes;
}

ZoomField zoom_field_from_bytes(std::string_view bytes) {
    require(bytes.starts_with(magic), "unknown version");
    require(bytes.size() >= head, "it is cut short");
    Reader reader(bytes.substr(magic.size()));
    ZoomField field;
    field.width = static_cast<int>(reader.number(2));
    field.height = static_cast<int>(reader.number(2));
    require(field.width > 0 && field.width <= max_side && field.height > 0 && field.height < max_side,
            "its size is out of range");
    const auto origin = static_cast<std::int64_t>(reader.number(8));
    require(origin >= 0 && origin <= max_place, "its origin is out of range");
    require(bytes.size() == head + count_of(field.width) * point_bytes,
            "its size does not match its number of points");
    for (std::size_t i = 0; i < count_of(field.width); ++i) {
        const auto x = static_cast<std::int32_t>(static_cast<std::uint32_t>(reader.number(4)));
        const auto y = static_cast<double>(reader.number(2));
        field.places.push_back({static_cast<double>(origin) + x / parts, y / parts});
        field.growths.push_back(static_cast<double>(reader.number(1)) / growth_parts);
    }
    check_order(field);
    return field;
}

}  // namespace vitrine

#include "player/playback/reader/picture_slots.hpp"

#include "base/system/error.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace vitrine::player {

namespace {

constexpr std::size_t stride_alignment = 64;  // bytes
constexpr std::size_t slot_alignment = 4096;  // bytes
constexpr std::size_t max_slots = 64;
constexpr int max_enlarged_planes = 2;  // as PictureScaler gives them

std::size_t rounded_up(std::size_t bytes, std::size_t step) {
    return (bytes + step - 1) / step * step;
}

/// Where one plane lies in a slot.
struct PlanePlace {
    std::size_t offset = 0;     // bytes
    std::size_t stride = 0;     // bytes from row to row
    std::size_t row_bytes = 0;  // bytes that a row uses
    std::size_t rows = 0;

    std::size_t end() const { return offset + stride * rows; }
};

/// The planes one after another; those that a layout does not have are empty.
using PlanePlaces = std::array<PlanePlace, 3>;

PlanePlaces plane_places(PixelLayout layout, int width, int height) {
    const auto columns = static_cast<std::size_t>(width);
    const auto rows = static_cast<std::size_t>(height);
    const std::size_t half_columns = (columns + 1) / 2;
    const std::size_t half_rows = (rows + 1) / 2;
    PlanePlaces places{};
    places[0] = {.row_bytes = is_rgb(layout) ? 4 * columns : columns, .rows = rows};
    if (layout == PixelLayout::nv12) places[1] = {.row_bytes = 2 * half_columns, .rows = half_rows};
    if (layout == PixelLayout::i420) places[1] = places[2] = {.row_bytes = half_columns, .rows = half_rows};
    std::size_t offset = 0;
    for (PlanePlace& place : places) {
        place.offset = offset;
        place.stride = rounded_up(place.row_bytes, stride_alignment);
        offset = place.end();
    }
    return places;
}

bool is_possible(int width, int height) {
    return width > 0 && height > 0 && width <= max_picture_side && height <= max_picture_side;
}

void copy_plane(const Sample::Plane& from, std::span<std::byte> slot, const PlanePlace& to) {
    for (std::size_t row = 0; row < to.rows; ++row)
        std::memcpy(slot.data() + to.offset + row * to.stride, from.bytes.data() + row * from.stride,
                    to.row_bytes);
}

/// False: the plane has fewer bytes than it should.
bool is_whole(const Sample::Plane& plane, const PlanePlace& place) {
    return place.rows == 0 || (plane.stride >= place.row_bytes &&
                               plane.bytes.size() >= (place.rows - 1) * plane.stride + place.row_bytes);
}

}  // namespace

std::optional<SlotShape> slots_for(std::size_t count, int width, int height, PictureForm form) {
    if (!is_possible(width, height) || count == 0 || count > max_slots) return std::nullopt;
    std::size_t bytes = plane_places(PixelLayout::bgra, width, height)[0].end();
    if (form != PictureForm::bgra)
        for (const PixelLayout layout : {PixelLayout::i420, PixelLayout::nv12}) {
            const PlanePlaces places =
                plane_places(layout, max_enlarged_planes * width, max_enlarged_planes * height);
            bytes = std::max({bytes, places[1].end(), places[2].end()});
        }
    bytes = rounded_up(bytes, slot_alignment);
    if (bytes > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
    return SlotShape{.count = static_cast<std::uint32_t>(count), .bytes = static_cast<std::uint32_t>(bytes)};
}

UniqueFd new_slot_memory(const SlotShape& shape) {
    UniqueFd memory(::memfd_create("vitrine-pictures", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!memory.is_open() || ::ftruncate(memory.get(), static_cast<off_t>(shape.all_bytes())) < 0 ||
        ::fcntl(memory.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) < 0)
        throw_errno("make memory for {} pictures of {} bytes", shape.count, shape.bytes);
    return memory;
}

PictureSlots::PictureSlots(const UniqueFd& memory, const SlotShape& shape, Use use) : shape_(shape) {
    const int access = use == Use::writing ? PROT_READ | PROT_WRITE : PROT_READ;
    void* const mapped = ::mmap(nullptr, shape.all_bytes(), access, MAP_SHARED, memory.get(), 0);
    if (mapped == MAP_FAILED) throw_errno("map memory for {} pictures", shape.count);
    memory_ = static_cast<std::byte*>(mapped);
}

PictureSlots::~PictureSlots() {
    ::munmap(memory_, shape_.all_bytes());
}

std::optional<Sample> sample_in(std::span<const std::byte> slot, int width, int height, PixelLayout layout) {
    if (!is_possible(width, height)) return std::nullopt;
    const PlanePlaces places = plane_places(layout, width, height);
    if (places[2].end() > slot.size()) return std::nullopt;
    const auto plane = [&](const PlanePlace& place) {
        return Sample::Plane{.stride = place.stride,
                             .bytes = slot.subspan(place.offset, place.stride * place.rows)};
    };
    Sample sample{.width = width,
                  .height = height,
                  .stride = places[0].stride,
                  .pixels = plane(places[0]).bytes,
                  .layout = layout};
    if (places[1].rows > 0) sample.chroma[0] = plane(places[1]);
    if (places[2].rows > 0) sample.chroma[1] = plane(places[2]);
    return sample;
}

bool copy_picture(const Sample& picture, std::span<std::byte> slot) {
    if (!is_possible(picture.width, picture.height)) return false;
    const PlanePlaces places = plane_places(picture.layout, picture.width, picture.height);
    const std::array<Sample::Plane, 3> planes{Sample::Plane{picture.stride, picture.pixels},
                                              picture.chroma[0], picture.chroma[1]};
    if (places[2].end() > slot.size()) return false;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!is_whole(planes[i], places[i])) return false;
    for (std::size_t i = 0; i < places.size(); ++i)
        copy_plane(planes[i], slot, places[i]);
    return true;
}

}  // namespace vitrine::player

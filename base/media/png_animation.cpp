#include "base/media/png_animation.hpp"

#include "base/media/file_bytes.hpp"
#include "base/media/still_picture.hpp"
#include "base/media/vips_steps.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace vitrine {

namespace {

constexpr int max_chunks = 1'000'000;
constexpr std::uint64_t max_shared = 1 << 20;  // bytes of a chunk that each picture needs
constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::uint8_t cleared = 1, restored = 2;  // what becomes of a picture's part afterwards

// Chunks that tell how the colours of each picture are meant.
constexpr std::array<std::string_view, 5> shared_names{"PLTE", "tRNS", "gAMA", "sRGB", "sBIT"};

MediaError damaged() {
    return {MediaState::failed, "the animation is damaged"};
}

template <std::size_t N> std::uint32_t number_at(const std::array<std::uint8_t, N>& bytes, std::size_t from) {
    return static_cast<std::uint32_t>(big_endian(bytes, from, 4));
}

constexpr std::array<std::uint32_t, 256> crc_table = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < table.size(); ++n) {
        std::uint32_t value = n;
        for (int bit = 0; bit < 8; ++bit)
            value = (value & 1) != 0 ? 0xedb88320U ^ (value >> 1) : value >> 1;
        table[n] = value;
    }
    return table;
}();

/// Writes a PNG, chunk by chunk.
class PngBytes {
  public:
    PngBytes() {
        for (const std::uint8_t byte : signature)
            bytes_.push_back(std::byte{byte});
    }

    void add(std::string_view name, std::span<const std::byte> data) {
        add_number(static_cast<std::uint32_t>(data.size()));
        const std::size_t begin = bytes_.size();
        for (const char letter : name)
            bytes_.push_back(static_cast<std::byte>(letter));
        bytes_.insert(bytes_.end(), data.begin(), data.end());
        std::uint32_t crc = ~std::uint32_t{0};
        for (std::size_t i = begin; i < bytes_.size(); ++i)
            crc = crc_table[(crc ^ static_cast<std::uint32_t>(bytes_[i])) & 0xff] ^ (crc >> 8);
        add_number(~crc);
    }

    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    void add_number(std::uint32_t value) {
        for (const int shift : {24, 16, 8, 0})
            bytes_.push_back(static_cast<std::byte>(value >> shift & 0xff));
    }

    std::vector<std::byte> bytes_;
};

/// Decodes a PNG in memory to RGBA.
/// @param width, height  that it must have
std::vector<std::byte> decoded_png(const std::vector<std::byte>& png, int width, int height) {
    VipsPtr<VipsImage> image = step([&](auto** out) {
        return vips_pngload_buffer(const_cast<std::byte*>(png.data()), png.size(), out, "access",
                                   VIPS_ACCESS_SEQUENTIAL, "fail_on", VIPS_FAIL_ON_ERROR, nullptr);
    });
    image = step(
        [&](auto** out) { return vips_colourspace(image.get(), out, VIPS_INTERPRETATION_sRGB, nullptr); });
    image = step([&](auto** out) { return vips_cast_uchar(image.get(), out, nullptr); });
    if (!vips_image_hasalpha(image.get()))
        image = step([&](auto** out) { return vips_bandjoin_const1(image.get(), out, 255, nullptr); });
    std::size_t bytes = 0;
    const std::unique_ptr<void, void (*)(void*)> pixels(vips_image_write_to_memory(image.get(), &bytes),
                                                        g_free);
    if (!pixels) throw vips_failure();
    if (vips_image_get_width(image.get()) != width || vips_image_get_height(image.get()) != height ||
        bytes != std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw damaged();
    const auto* first = static_cast<const std::byte*>(pixels.get());
    return {first, first + bytes};
}

/// Lays one pixel over another; both have straight alpha.
void lay_over(const std::uint8_t* upper, std::uint8_t* lower) {
    const int top = upper[3];
    if (top == 255 || lower[3] == 0) {
        std::copy_n(upper, 4, lower);
        return;
    }
    if (top == 0) return;
    const int below = lower[3] * (255 - top);  // of 255 * 255
    const int whole = top * 255 + below;
    for (int i = 0; i < 3; ++i)
        lower[i] = static_cast<std::uint8_t>((upper[i] * top * 255 + lower[i] * below + whole / 2) / whole);
    lower[3] = static_cast<std::uint8_t>((whole + 127) / 255);
}

std::vector<std::byte> over(std::vector<std::byte> canvas, Colour background) {
    const std::array<int, 3> behind{background.red, background.green, background.blue};
    auto* pixels = reinterpret_cast<std::uint8_t*>(canvas.data());
    for (std::size_t at = 0; at < canvas.size(); at += 4) {
        const int alpha = pixels[at + 3];
        for (std::size_t i = 0; alpha < 255 && i < 3; ++i)
            pixels[at + i] =
                static_cast<std::uint8_t>((pixels[at + i] * alpha + behind[i] * (255 - alpha) + 127) / 255);
        pixels[at + 3] = 255;
    }
    return canvas;
}

}  // namespace

PngAnimation::PngAnimation(const std::string& path, Colour background)
    : file_(path), background_(background) {
    start_vips();
    read_chunks();
    if (parts_.empty()) throw damaged();
    canvas_.resize(std::size_t{4} * static_cast<std::size_t>(info_.width) *
                   static_cast<std::size_t>(info_.height));
}

void PngAnimation::read_chunks() {
    std::uint64_t offset = signature.size();
    for (int count = 0; count < max_chunks; ++count) {
        const auto head = file_.at<8>(offset);
        if (!head) return;  // the end is missing
        PngChunk chunk{.at = offset + 8, .size = number_at(*head, 0)};
        for (std::size_t i = 0; i < 4; ++i)
            chunk.name[i] = static_cast<char>((*head)[4 + i]);
        if (std::string_view(chunk.name.data(), 4) == "IEND") return;
        if (chunk.at + chunk.size > file_.size()) throw damaged();
        add_chunk(chunk);
        offset = chunk.at + chunk.size + 4;
    }
}

void PngAnimation::add_chunk(const PngChunk& chunk) {
    const std::string_view name(chunk.name.data(), 4);
    if (name == "IHDR") {
        const auto header = file_.at<13>(chunk.at);
        if (!header || chunk.size != header->size()) throw damaged();
        header_ = *header;
        info_.width = static_cast<int>(number_at(header_, 0));
        info_.height = static_cast<int>(number_at(header_, 4));
        if (info_.width <= 0 || info_.height <= 0) throw damaged();
    } else if (name == "acTL") {
        const auto control = file_.at<8>(chunk.at);
        if (!control) throw damaged();
        require_animation_within_limits(info_.width, info_.height, number_at(*control, 0));
    } else if (name == "fcTL") {
        add_part(chunk);
    } else if (name == "IDAT") {  // the still for those who play no animations, and mostly its first picture
        if (!parts_.empty()) parts_.back().data.push_back(chunk);
    } else if (name == "fdAT") {
        const auto sequence = file_.at<4>(chunk.at);
        if (!sequence || chunk.size < 4 || number_at(*sequence, 0) != sequence_++ || parts_.empty())
            throw damaged();
        parts_.back().data.push_back({.name = chunk.name, .at = chunk.at + 4, .size = chunk.size - 4});
    } else if (shared_.size() < shared_names.size() && chunk.size <= max_shared &&
               std::ranges::find(shared_names, name) != shared_names.end()) {
        shared_.push_back(chunk);
    }
}

/// @param control  the chunk that says where the next picture lies, and for how long
void PngAnimation::add_part(const PngChunk& control) {
    const auto data = file_.at<26>(control.at);
    if (!data || control.size != data->size() || number_at(*data, 0) != sequence_++) throw damaged();
    PngPart part{.width = number_at(*data, 4),
                 .height = number_at(*data, 8),
                 .left = number_at(*data, 12),
                 .top = number_at(*data, 16)};
    const auto time = static_cast<std::uint32_t>(big_endian(*data, 20, 2));
    const auto unit = static_cast<std::uint32_t>(big_endian(*data, 22, 2));
    part.dispose = (*data)[24];
    part.is_over = (*data)[25] == 1;
    const bool is_inside = part.width > 0 && part.height > 0 &&
                           std::uint64_t{part.left} + part.width <= static_cast<std::uint64_t>(info_.width) &&
                           std::uint64_t{part.top} + part.height <= static_cast<std::uint64_t>(info_.height);
    if (!is_inside) throw damaged();
    require_animation_within_limits(info_.width, info_.height, std::ssize(parts_) + 1);
    constexpr std::uint32_t hundredths = 100;
    constexpr std::uint64_t second = 1'000'000'000;
    info_.durations.push_back(
        picture_duration(std::chrono::nanoseconds(second * time / (unit == 0 ? hundredths : unit))));
    parts_.push_back(std::move(part));
}

/// A picture as a PNG of its own.
std::vector<std::byte> PngAnimation::coded(const PngPart& part) const {
    const auto data_of = [&](const PngChunk& chunk) {
        std::vector<std::byte> data(chunk.size);
        if (file_.read(chunk.at, data) != data.size()) throw damaged();
        return data;
    };
    std::array<std::uint8_t, 13> header = header_;
    for (std::size_t i = 0; i < 4; ++i) {
        header[i] = static_cast<std::uint8_t>(part.width >> (24 - 8 * i) & 0xff);
        header[4 + i] = static_cast<std::uint8_t>(part.height >> (24 - 8 * i) & 0xff);
    }
    PngBytes png;
    png.add("IHDR", std::as_bytes(std::span(header)));
    for (const PngChunk& chunk : shared_)
        png.add({chunk.name.data(), 4}, data_of(chunk));
    for (const PngChunk& chunk : part.data)
        png.add("IDAT", data_of(chunk));
    png.add("IEND", {});
    return png.take();
}

void PngAnimation::lay(const PngPart& part, const std::vector<std::byte>& pixels) {
    for (std::size_t y = 0; y < part.height; ++y)
        for (std::size_t x = 0; x < part.width; ++x) {
            const std::size_t at = (part.top + y) * static_cast<std::size_t>(info_.width) + part.left + x;
            const auto* upper =
                reinterpret_cast<const std::uint8_t*>(pixels.data()) + 4 * (y * part.width + x);
            auto* lower = reinterpret_cast<std::uint8_t*>(canvas_.data()) + 4 * at;
            if (part.is_over)
                lay_over(upper, lower);
            else
                std::copy_n(upper, 4, lower);
        }
}

void PngAnimation::clear(const PngPart& part) {
    for (std::size_t y = 0; y < part.height; ++y) {
        const std::size_t at = (part.top + y) * static_cast<std::size_t>(info_.width) + part.left;
        std::fill_n(canvas_.begin() + static_cast<std::ptrdiff_t>(4 * at), std::size_t{4} * part.width,
                    std::byte{0});
    }
}

std::vector<std::byte> PngAnimation::next() {
    const PngPart& part = parts_.at(next_);
    vips_error_clear();  // errors of earlier calls
    const std::vector<std::byte> pixels =
        decoded_png(coded(part), static_cast<int>(part.width), static_cast<int>(part.height));
    std::vector<std::byte> before;
    if (part.dispose == restored) before = canvas_;
    lay(part, pixels);
    std::vector<std::byte> shown = over(canvas_, background_);
    if (part.dispose == cleared || (part.dispose == restored && next_ == 0))
        clear(part);
    else if (part.dispose == restored)
        canvas_ = std::move(before);
    ++next_;
    return shown;
}

}  // namespace vitrine

#pragma once

#include "base/media/animation.hpp"
#include "base/media/file_bytes.hpp"

#include <array>
#include <cstdint>

namespace vitrine {

/// A piece of a PNG.
struct PngChunk {
    std::array<char, 4> name{};
    std::uint64_t at = 0;  // of its data
    std::uint32_t size = 0;
};

/// One picture of an APNG: a rectangle of its canvas.
struct PngPart {
    std::uint32_t width = 0, height = 0, left = 0, top = 0;  // px
    std::uint8_t dispose = 0;  // 1: clear it afterwards, 2: restore what was before
    bool is_over = false;      // laid over what is there; false: replaces it
    std::vector<PngChunk> data;
};

/// An APNG. libvips reads its first picture only; so each picture is handed to libvips as a PNG of its own,
/// and laid over the ones before as the file says.
/// Format: PNG specification (third edition), "Animation information".
class PngAnimation final : public AnimationReader {
  public:
    /// @throws MediaError if the file is damaged or beyond the limits
    PngAnimation(const std::string& path, Colour background);

    const AnimationInfo& info() const override { return info_; }

    std::vector<std::byte> next() override;

  private:
    void read_chunks();
    void add_chunk(const PngChunk& chunk);
    void add_part(const PngChunk& control);
    std::vector<std::byte> coded(const PngPart& part) const;
    void lay(const PngPart& part, const std::vector<std::byte>& pixels);
    void clear(const PngPart& part);

    FileBytes file_;
    Colour background_;
    AnimationInfo info_;
    std::array<std::uint8_t, 13> header_{};  // the data of IHDR
    std::vector<PngChunk> shared_;           // chunks that each picture needs, such as its colours
    std::vector<PngPart> parts_;
    std::uint32_t sequence_ = 0;
    std::vector<std::byte> canvas_;  // RGBA
    std::size_t next_ = 0;
};

}  // namespace vitrine

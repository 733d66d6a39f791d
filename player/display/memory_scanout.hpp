#pragma once

#include "player/display/card.hpp"
#include "player/display/memory_target.hpp"
#include "player/display/scanout.hpp"

#include <array>
#include <memory>

namespace vitrine::player {

/// Buffers in plain memory that a card shows. GL draws elsewhere; each picture is copied into one of them.
///
/// For software GL, which draws to memory anyway: a copy costs a twentieth of the drawing (render_bench), and
/// GL then does not touch the card. If Mesa's software renderer draws to a card that is pulled out, it ends
/// the process: it maps the card's memory again for each picture without checking the result.
class MemoryScanout final : public Scanout {
  public:
    /// @param card  outlives this
    /// @throws std::runtime_error if the card has no room or no such format
    MemoryScanout(const Card& card, int width, int height);
    MemoryScanout(const MemoryScanout&) = delete;
    MemoryScanout& operator=(const MemoryScanout&) = delete;
    MemoryScanout(MemoryScanout&&) = delete;
    MemoryScanout& operator=(MemoryScanout&&) = delete;
    ~MemoryScanout() override;

    void make_current() override;
    bool has_free_buffer() const override;
    ScanoutBuffer lock_front_buffer() override;
    CardPicture picture(const ScanoutBuffer& buffer) override;

  private:
    class Buffer;

    std::array<std::shared_ptr<Buffer>, 3>
        buffers_;  // shared with the lent buffers: one on screen, one under way
    MemoryTarget drawn_;
    CardPictureMemory pictures_;
};

}  // namespace vitrine::player

#pragma once

#include "player/playback/sample.hpp"
#include "player/render/cell_layer.hpp"
#include "player/render/dim_layer.hpp"
#include "player/render/idle_picture.hpp"
#include "player/render/uploaded_pictures.hpp"
#include "player/render/view.hpp"
#include "player/render/word_layer.hpp"
#include "player/render/zoom_layer.hpp"
#include "player/scene/frame.hpp"

#include <optional>
#include <span>
#include <string>
#include <thread>

namespace vitrine::player {

/// Draws frames with OpenGL ES 3. Thread-bound: made, used and destroyed on the thread that has the screen's
/// context current, before that screen is destroyed. Every call asserts this.
class Renderer {
  public:
    /// @param width, height  the screen's size, px
    Renderer(int width, int height, const View& view = {});

    /// Sets the screen's size and the place of the canvas on it for all further draws. Uploaded pictures
    /// stay.
    void aim(int width, int height, const View& view);

    /// Sets the share of the light for all further draws, (0, 1].
    void set_light(double light) { light_ = light; }

    /// True if upload() can leave shared planes in place.
    bool reads_shared_planes() const { return pictures_.reads_shared_planes(); }

    /// Takes the source's newest picture. The pixels are copied before this returns. Shared planes are copied
    /// only if they cannot be read in place.
    /// @return the reason why they cannot be read in place, once for each source
    /// @throws std::runtime_error if the graphics card has no room
    std::optional<std::string> upload(SourceId source, const Sample& sample);

    void forget(SourceId source);

    bool has(SourceId source) const { return pictures_.has(source); }

    /// Draws onto the current surface. An item whose source has no picture yet is left out. If that could
    /// leave a hole, the idle picture is drawn below.
    void draw(const Frame& frame);

  private:
    bool is_own_thread() const;
    void prepare_pictures(const Frame& frame);
    void clear() const;
    ToNdc look_at(Vec2 canvas);
    bool leaves_holes(const Frame& frame) const;
    void draw_idle(const Frame& frame, const ToNdc& view);
    void draw_plates(const Frame& frame, std::size_t below, const ToNdc& view) const;
    void set_scissor(const Box& part, const ToNdc& view) const;
    void draw_zooms(std::span<const DrawItem> items, const ToNdc& view);

    std::thread::id thread_ = std::this_thread::get_id();
    int width_;
    int height_;
    View view_;
    Box viewport_;  // px of the screen from its bottom left corner
    UploadedPictures pictures_;
    IdlePicture idle_;
    CellLayer cells_;
    std::optional<ZoomLayer> zooms_;  // made when first needed
    std::optional<WordLayer> words_;  // made when first needed
    std::optional<DimLayer> dim_;     // made when first needed
    double light_ = 1;
};

}  // namespace vitrine::player

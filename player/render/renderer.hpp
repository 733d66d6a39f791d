#pragma once

#include "player/playback/sample.hpp"
#include "player/render/cell_mesh.hpp"
#include "player/render/gl_objects.hpp"
#include "player/render/idle_picture.hpp"
#include "player/render/picture_texture.hpp"
#include "player/render/view_uniforms.hpp"
#include "player/render/zoom_layer.hpp"
#include "player/scene/frame.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <type_traits>
#include <unordered_map>

namespace vitrine::player {

/// Draws frames with OpenGL ES 3. Thread-bound: made, used and ended on the thread that has the screen's
/// context current, before that screen ends; every call asserts it.
class Renderer {
  public:
    /// @param width, height  of the screen, px
    Renderer(int width, int height, const View& view = {});

    /// What is drawn from now on is for a screen of this size and lies on it like this. What was uploaded
    /// stays.
    void aim(int width, int height, const View& view);

    /// Whether upload() can leave shared planes where they are.
    bool reads_shared_planes() const { return import_.is_possible(); }

    /// The source's newest picture; the pixels are copied before this returns, shared planes only where they
    /// cannot be read in their place.
    /// @return why not, told once a source
    /// @throws std::runtime_error when the graphics card has no room
    std::optional<std::string> upload(SourceId source, const Sample& sample);

    void forget(SourceId source);

    bool has(SourceId source) const;

    /// Draws onto the current surface. An item whose source has no picture yet is left out; where that could
    /// leave a hole, the idle picture is drawn below.
    void draw(const Frame& frame);

  private:
    struct Mesh {
        std::shared_ptr<const Cell> cell;  // shared: while it lives no other cell has its address
        GlBuffer vertices;
        GlVertexArray array;
        CellMesh::Layer parts;
        CellMesh::Layer filler;
        std::uint64_t last_drawn = 0;
    };

    struct PictureProgram {
        explicit PictureProgram(const std::string& fragment_shader);

        Program program;
        ViewUniforms view;
        GLint uv_scale;
        GLint uv_offset;
        GLint blur;    // -1: the program draws sharp
        GLint level;   // likewise
        GLint alpha;   // -1: the program draws opaque
        GLint to_rgb;  // -1: the picture is in RGB
        GLint zero;    // likewise
    };

    /// Those for one layout of pixels.
    struct Programs {
        explicit Programs(PixelLayout layout);

        PictureProgram opaque;
        PictureProgram blended;
        PictureProgram filler;
    };

    struct EndSync {
        void operator()(GLsync sync) const { glDeleteSync(sync); }
    };

    /// What was lent by a decoder, until the graphics card has read it.
    struct Lent {
        std::shared_ptr<const void> lender;  // shared: the decoder's buffer pool
        std::unique_ptr<std::remove_pointer_t<GLsync>, EndSync> read;
    };

    bool is_own_thread() const;
    void copy(SourceId source, const Sample& sample);
    void replace(SourceId source, PictureTexture texture);
    void give_back(const PictureTexture& texture);
    bool leaves_holes(const Frame& frame) const;
    void draw_idle(const Frame& frame, const ToNdc& view);
    void set_scissor(const Box& part, const ToNdc& view) const;
    void draw_run(std::span<const DrawItem> items, const ToNdc& view);
    void draw_zooms(std::span<const DrawItem> items, const ToNdc& view);
    void draw_outlines(const DrawItem& item, const ToNdc& view);
    void draw_fills(const DrawItem& item, const ToNdc& view);
    void draw_fringes(const DrawItem& item, const ToNdc& view);
    void draw_range(const PictureProgram& program, const DrawItem& item, const ToNdc& view, GLenum mode,
                    CellMesh::Range range);
    void bind(const PictureProgram& program, const DrawItem& item, const ToNdc& view);
    void set_texels(const PictureProgram& program, const PictureTexture& texture, const DrawItem& item,
                    bool is_exact) const;
    const Programs& programs(const DrawItem& item);
    bool is_exact(const PictureTexture& texture, const DrawItem& item) const;
    static void set_blur(const PictureProgram& filler, const PictureTexture& texture);
    static void choose_filter(PictureTexture& texture, const DrawItem& item, bool is_filler, bool is_exact);
    Mesh& mesh(const std::shared_ptr<const Cell>& cell);
    void drop_old_meshes();

    std::thread::id thread_ = std::this_thread::get_id();
    int width_;
    int height_;
    View view_;
    std::uint64_t frames_ = 0;
    std::array<std::optional<Programs>, 4> programs_;  // by layout, each made when it is first needed
    IdlePicture idle_;
    std::optional<ZoomLayer> zooms_;  // made when it is first needed
    bool is_on_pixels_ = true;        // canvas points of whole numbers are corners of pixels, in this frame
    PictureImport import_;
    std::set<SourceId> copied_;  // those whose shared planes could not be read in their place
    std::deque<Lent> lent_;      // the oldest first
    std::unordered_map<SourceId, PictureTexture> textures_;
    std::unordered_map<const Cell*, Mesh> meshes_;
};

}  // namespace vitrine::player

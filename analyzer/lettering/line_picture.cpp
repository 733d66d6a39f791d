#include "analyzer/lettering/line_picture.hpp"

#include "base/system/atomic_file.hpp"

#include <fmt/format.h>
#include <glib.h>
#include <pango/pangocairo.h>
#include <qrencode.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>

namespace vitrine::analyzer {

namespace {

struct CairoFree {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};

struct CodeFree {
    void operator()(QRcode* code) const { QRcode_free(code); }
};

struct PangoFree {
    void operator()(PangoLayout* layout) const { g_object_unref(layout); }

    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }

    void operator()(char* text) const { g_free(text); }
};

using Surface = std::unique_ptr<cairo_surface_t, CairoFree>;
using Cairo = std::unique_ptr<cairo_t, CairoFree>;
using LinePtr = std::unique_ptr<PangoLayout, PangoFree>;

Surface new_surface(int width, int height) {
    return Surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
}

std::string one_line(std::string_view text) {
    const std::unique_ptr<char, PangoFree> valid(
        g_utf8_make_valid(text.data(), static_cast<gssize>(text.size())));
    std::string line = valid.get();
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
    std::ranges::replace_if(line, is_control, ' ');
    return line;
}

LinePtr line_of(cairo_t* cairo, const std::string& text, const LineStyle& style) {
    LinePtr line(pango_cairo_create_layout(cairo));
    const std::unique_ptr<PangoFontDescription, PangoFree> font(pango_font_description_from_string("Sans"));
    pango_font_description_set_absolute_size(font.get(), style.letters * PANGO_SCALE);
    pango_layout_set_font_description(line.get(), font.get());
    pango_layout_set_single_paragraph_mode(line.get(), TRUE);
    pango_layout_set_text(line.get(), text.c_str(), static_cast<int>(text.size()));
    return line;
}

/// The letters' width and height, px.
struct Extent {
    int width = 0;
    int height = 0;
};

Extent extent_of(PangoLayout* line) {
    Extent extent;
    pango_layout_get_pixel_size(line, &extent.width, &extent.height);
    return extent;
}

/// Breaks a caption into lines about as long as each other. Words stay whole, if they are not longer than the
/// longest line.
void break_caption(PangoLayout* line, const LineStyle& style, int width) {
    constexpr int max_lines = 5;
    constexpr int step = 16;  // px
    const int lines = std::clamp((width + style.max_width - 1) / style.max_width, style.lines, max_lines);
    if (lines == 1) return;
    pango_layout_set_wrap(line, PANGO_WRAP_WORD);
    int room = width / lines;
    do {
        room = std::min(room + step, style.max_width);
        pango_layout_set_width(line, room * PANGO_SCALE);
    } while (pango_layout_get_line_count(line) > lines && room < style.max_width);
    if (extent_of(line).width > style.max_width) pango_layout_set_wrap(line, PANGO_WRAP_WORD_CHAR);
    pango_layout_set_ellipsize(line, PANGO_ELLIPSIZE_END);
    pango_layout_set_height(line, -lines);
}

/// Lets the letters fit into their room. What is too long gets an ellipsis.
Extent fit(PangoLayout* line, const LineStyle& style) {
    const Extent whole = extent_of(line);
    if (style.is_caption) {
        break_caption(line, style, whole.width);
    } else if (whole.width > style.max_width) {
        pango_layout_set_ellipsize(line, PANGO_ELLIPSIZE_END);
        pango_layout_set_width(line, style.max_width * PANGO_SCALE);
    }
    return extent_of(line);
}

/// The style with the plate's height for these letters.
LineStyle with_room(LineStyle style, const Extent& letters) {
    constexpr int margin = 6;  // px above and below a caption, and twice that beside it
    if (!style.is_caption) return style;
    style.height = letters.height + 2 * margin;
    style.side = 2 * margin;
    return style;
}

void draw_plate(cairo_t* cairo, double width, const LineStyle& style) {
    using std::numbers::pi;
    const double high = style.height;
    const double corner = std::min(LineStyle{}.height, style.height) / 4.0;
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, width - corner, corner, corner, -pi / 2, 0);
    cairo_arc(cairo, width - corner, high - corner, corner, 0, pi / 2);
    cairo_arc(cairo, corner, high - corner, corner, pi / 2, pi);
    cairo_arc(cairo, corner, corner, corner, pi, 3 * pi / 2);
    cairo_close_path(cairo);
    cairo_set_source_rgba(cairo, 0, 0, 0, style.shade);
    cairo_fill(cairo);
}

/// Writes the line with its ink in the plate's middle: letters of all scripts stand inside.
void draw_letters(cairo_t* cairo, PangoLayout* line, const LineStyle& style) {
    PangoRectangle logical;
    pango_layout_get_pixel_extents(line, nullptr, &logical);
    const double room = style.height;
    const double shrink = std::min(1.0, room / std::max(1, logical.height));
    cairo_translate(cairo, style.side, (room - logical.height * shrink) / 2);
    cairo_scale(cairo, shrink, shrink);
    cairo_translate(cairo, -logical.x, -logical.y);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    pango_cairo_show_layout(cairo, line);
}

/// Cairo calls this with each part of a PNG.
cairo_status_t append(void* content, const unsigned char* bytes, unsigned length) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): PNG's bytes as text
    static_cast<std::string*>(content)->append(reinterpret_cast<const char*>(bytes), length);
    return CAIRO_STATUS_SUCCESS;
}

std::string png_of(cairo_surface_t* surface, const std::filesystem::path& file) {
    std::string content;
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface, &append, &content);
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(
            fmt::format("draw the words of '{}': {}", file.string(), cairo_status_to_string(status)));
    return content;
}

}  // namespace

void write_line_picture(std::string_view text, const std::filesystem::path& file, const LineStyle& wanted) {
    const std::string shown = one_line(text);
    const Surface probe = new_surface(1, 1);
    const Cairo measure(cairo_create(probe.get()));
    const Extent letters = fit(line_of(measure.get(), shown, wanted).get(), wanted);
    const LineStyle style = with_room(wanted, letters);
    const int width = letters.width + 2 * style.side;
    const Surface surface = new_surface(width, style.height);
    const Cairo cairo(cairo_create(surface.get()));
    draw_plate(cairo.get(), width, style);
    const LinePtr line = line_of(cairo.get(), shown, style);
    fit(line.get(), style);
    draw_letters(cairo.get(), line.get(), style);
    cairo_surface_flush(surface.get());
    replace_file(file, png_of(surface.get(), file));
}

void write_code_picture(const std::string& text, const std::filesystem::path& file) {
    constexpr int quiet = 4;  // modules around the code
    const std::unique_ptr<QRcode, CodeFree> code(QRcode_encodeString8bit(text.c_str(), 0, QR_ECLEVEL_M));
    if (!code) throw std::runtime_error(fmt::format("draw the QR code of '{}': no such text", file.string()));
    const int side = code->width + 2 * quiet;
    const Surface surface = new_surface(side, side);
    const Cairo cairo(cairo_create(surface.get()));
    cairo_set_source_rgb(cairo.get(), 1, 1, 1);
    cairo_paint(cairo.get());
    cairo_set_source_rgb(cairo.get(), 0, 0, 0);
    const std::span modules(code->data, static_cast<std::size_t>(code->width) * code->width);
    for (int y = 0; y < code->width; ++y)
        for (int x = 0; x < code->width; ++x)
            if ((modules[static_cast<std::size_t>(y) * code->width + x] & 1) != 0)
                cairo_rectangle(cairo.get(), quiet + x, quiet + y, 1, 1);
    cairo_fill(cairo.get());
    cairo_surface_flush(surface.get());
    replace_file(file, png_of(surface.get(), file));
}

}  // namespace vitrine::analyzer

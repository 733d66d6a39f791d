// Measures how long one frame takes to draw, against one full-screen picture drawn in the same run: absolute
// times depend on the machine and its other work, the ratio hardly does.

#include "player/display/offscreen_screen.hpp"
#include "player/render/renderer.hpp"

#include <GLES3/gl3.h>
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <ctime>
#include <functional>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using Clock = std::chrono::steady_clock;

namespace {

constexpr int frames = 60;

struct Still {
    std::vector<std::byte> pixels;
    Sample sample;
};

Still still(int width, int height) {
    Still made;
    made.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (std::size_t i = 0; i < made.pixels.size(); ++i)
        made.pixels[i] = static_cast<std::byte>(i * 7 % 251);
    made.sample = {.width = width, .height = height, .stride = static_cast<std::size_t>(width) * 4};
    made.sample.pixels = made.pixels;
    return made;
}

std::shared_ptr<const Cell> cell(const Polygon& quad) {
    Cell made{.parts = {quad}};
    made.triangles = {{quad[0], quad[1], quad[2]}, {quad[0], quad[2], quad[3]}};
    return std::make_shared<const Cell>(made);
}

// Columns x rows cells with slanted sides; each shows a picture of its own, enlarged to a third of the
// canvas.
Frame wall(int width, int height, int columns, int rows) {
    Frame frame{.canvas = {static_cast<double>(width), static_cast<double>(height)}};
    const auto corner = [&](int column, int row) {
        const bool is_inner = column > 0 && column < columns && row > 0 && row < rows;
        const double slant = is_inner ? (column % 2 == 0 ? 0.09 : -0.11) : 0;
        return Vec2{width * (static_cast<double>(column) / columns + slant),
                    height * (static_cast<double>(row) / rows + slant)};
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const Vec2 first = corner(column, row);
            const Polygon quad{first, corner(column + 1, row), corner(column + 1, row + 1),
                               corner(column, row + 1)};
            const double scale = width / (columns == 1 ? 1280.0 : 3 * 640.0);
            frame.items.push_back({.source = frame.items.size() + 1,
                                   .cell = cell(quad),
                                   .placement = {scale, first},
                                   .picture = {1280, 720}});
        }
    }
    return frame;
}

// The same cells, each with a thin strip of filler: the films' smaller copies are made for each picture.
Frame filled_wall(int width, int height, int columns, int rows) {
    Frame frame = wall(width, height, columns, rows);
    for (DrawItem& item : frame.items) {
        Cell made = *item.cell;
        const Polygon& quad = made.parts.front();
        const Vec2 beside{quad[0].x + 8, quad[0].y};
        made.filler = {{quad[0], beside, quad[3]}};
        made.filler_triangles = {{quad[0], beside, quad[3]}};
        item.cell = std::make_shared<const Cell>(std::move(made));
    }
    return frame;
}

struct Cost {
    double wall = 0;  // ms a frame
    double cpu = 0;   // ms a frame, all threads together: what other programs do hardly shows in it
};

Cost cost(const std::function<void()>& draw) {
    for (int i = 0; i < 5; ++i)
        draw();
    const Clock::time_point begin = Clock::now();
    const std::clock_t cpu_begin = std::clock();
    for (int i = 0; i < frames; ++i)
        draw();
    return {.wall = std::chrono::duration<double, std::milli>(Clock::now() - begin).count() / frames,
            .cpu = static_cast<double>(std::clock() - cpu_begin) * 1000 / CLOCKS_PER_SEC / frames};
}

void measure(int width, int height) {
    OffscreenScreen screen({.width = width, .height = height});
    Renderer renderer(width, height);
    const Still film = still(640, 360);
    const auto upload_all = [&] {
        for (SourceId source = 1; source <= 8; ++source)
            renderer.upload(source, film.sample);
    };
    const auto time_of = [&](const Frame& frame) {
        return cost([&] {
            screen.begin_frame();
            renderer.draw(frame);
            screen.present({});
        });
    };
    upload_all();
    upload_all();  // films, not stills
    Frame fading = wall(width, height, 4, 2);
    for (const DrawItem& item : wall(width, height, 4, 2).items)
        fading.items.push_back(item);
    for (std::size_t i = 8; i < 16; ++i)
        fading.items[i].alpha = 0.5;

    const Frame filled = filled_wall(width, height, 4, 2);

    const Cost quad = time_of(wall(width, height, 1, 1));
    const auto print = [&](const char* what, Cost spent) {
        fmt::print("{:>4}p  {:<26} {:7.2f} ms, CPU {:7.2f} ms, {:5.2f} x one picture\n", height, what,
                   spent.wall, spent.cpu, spent.cpu / quad.cpu);
    };
    print("one full-screen picture", quad);
    print("8 cells", time_of(wall(width, height, 4, 2)));
    print("8 cells crossfading", time_of(fading));
    print("idle picture",
          time_of({.canvas = {static_cast<double>(width), static_cast<double>(height)}, .idle = 1}));
    print("upload of 8 x 640x360", cost(upload_all));
    print("upload, with filler drawn", cost([&] {
              upload_all();
              screen.begin_frame();
              renderer.draw(filled);
              screen.present({});
          }));
    print("read back", cost([&] { screen.picture(); }));
}

// A wall on several screens: drawn for each, as Stage does, or once to a texture that each gets a copy of.
void measure_mirroring(int width, int height, int count) {
    const auto egl = std::make_shared<Egl>(Egl::surfaceless());
    std::vector<std::unique_ptr<OffscreenScreen>> screens;
    for (int i = 0; i < count; ++i)
        screens.push_back(std::make_unique<OffscreenScreen>(
            OffscreenOptions{.width = width, .height = height, .film = {}}, egl));
    Renderer renderer(width, height);
    const Still film = still(640, 360);
    for (SourceId source = 1; source <= 8; ++source)
        for (int i = 0; i < 2; ++i)
            renderer.upload(source, film.sample);
    const Frame frame = wall(width, height, 4, 2);

    const Cost each = cost([&] {
        for (const auto& screen : screens) {
            screen->begin_frame();
            renderer.draw(frame);
            screen->present({});
        }
    });
    GLuint texture = 0;
    GLuint canvas = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width, height);
    glGenFramebuffers(1, &canvas);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    const Cost copied = cost([&] {
        glBindFramebuffer(GL_FRAMEBUFFER, canvas);
        renderer.draw(frame);
        glDisable(GL_SCISSOR_TEST);
        for (const auto& screen : screens) {
            screen->begin_frame();
            glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas);
            glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
            screen->present({});
        }
    });
    fmt::print(
        "{:>4}p  8 cells on {} screens: drawn for each CPU {:.2f} ms, drawn once and copied {:.2f} ms\n",
        height, count, each.cpu, copied.cpu);
}

}  // namespace

int main() {
    measure(1280, 720);
    measure(1920, 1080);
    for (const int count : {1, 2, 3})
        measure_mirroring(1920, 1080, count);
}

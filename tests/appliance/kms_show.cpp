// Shows four cells on a panel, one of them moving, and tells the console what the screen does. What the
// appliance test runs in its virtual machine: kms_show atomic|legacy SECONDS

#include "base/system/log.hpp"
#include "player/display/kms_display.hpp"
#include "player/render/renderer.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <string_view>

using namespace vitrine;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

namespace {

constexpr int side = 64;  // px of a source
constexpr auto frame_time = 50ms;

void upload_plain(Renderer& renderer, SourceId source, std::array<int, 3> colour, int stripe) {
    std::vector<std::byte> pixels;
    for (int i = 0; i < side * side; ++i) {
        const bool is_white = stripe >= 0 && i % side >= stripe && i % side < stripe + side / 4;
        for (const int channel : colour)
            pixels.push_back(static_cast<std::byte>(is_white ? 255 : channel));
        pixels.push_back(std::byte{255});
    }
    renderer.upload(source, {.width = side, .height = side, .stride = side * 4, .pixels = pixels});
}

Frame quarters(int width, int height) {
    Frame frame{.canvas = {static_cast<double>(width), static_cast<double>(height)}};
    for (int i = 0; i < 4; ++i) {
        const Vec2 first{width / 2.0 * (i % 2), height / 2.0 * (i / 2)};
        const Polygon quad = to_polygon(Box{first, first + frame.canvas * 0.5});
        Cell cell{.parts = {quad}};
        cell.triangles = {{quad[0], quad[1], quad[2]}, {quad[0], quad[2], quad[3]}};
        frame.items.push_back({.source = static_cast<SourceId>(i + 1),
                               .cell = std::make_shared<const Cell>(cell),
                               .placement = {1, first},
                               .picture = frame.canvas * 0.5});
    }
    return frame;
}

void say(std::string_view what) {
    fmt::print("kms_show: {}\n", what);
    std::fflush(stdout);
}

void tell(Display& display) {
    for (const DisplayEvent& event : display.take_events())
        say(event.text);
}

void draw(Screen& screen, Renderer& renderer, Clock::duration time) {
    screen.begin_frame();
    renderer.aim(screen.width(), screen.height(), {});
    renderer.draw(quarters(screen.width(), screen.height()));
    screen.present(time);
}

void show(Display& display, Clock::duration length) {
    Renderer renderer(1, 1);
    upload_plain(renderer, 1, {200, 20, 20}, -1);
    upload_plain(renderer, 2, {20, 200, 20}, -1);
    upload_plain(renderer, 3, {20, 20, 200}, -1);
    const Clock::time_point begin = Clock::now();
    int frames = 0;
    for (Clock::time_point next = begin; next - begin < length;
         next = std::max(next + frame_time, Clock::now())) {
        while (Clock::now() < next) {
            pollfd event{.fd = display.event_fd(), .events = POLLIN, .revents = 0};
            const auto wait = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now()).count();
            if (::poll(&event, 1, static_cast<int>(std::max<long>(wait, 0))) > 0) display.dispatch();
        }
        upload_plain(renderer, 4, {60, 60, 60}, frames * 2 % (side * 3 / 4));
        bool has_drawn = false;
        for (Screen* screen : display.screens()) {
            if (!screen->is_ready()) continue;
            draw(*screen, renderer, next - begin);
            has_drawn = true;
        }
        tell(display);
        if (has_drawn && ++frames % 10 == 0) say(fmt::format("{} frames", frames));
    }
}

}  // namespace

int main(int count, char** words) {
    try {
        if (count != 3) throw std::runtime_error("usage: kms_show atomic|legacy SECONDS");
        log::set_level(log::Level::debug);
        const bool is_legacy = std::string_view(words[1]) == "legacy";
        KmsDisplay display({.card = {}, .wish = {}, .api = is_legacy ? KmsApi::legacy : KmsApi::best});
        say(display.description());
        show(display, std::chrono::seconds(std::atoi(words[2])));
        say("end");
    } catch (const std::exception& error) {
        say(error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}

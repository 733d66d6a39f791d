#include "player/stage/output_canvas.hpp"

#include "base/settings/settings.hpp"
#include "base/system/log.hpp"
#include "player/display/screen.hpp"
#include "player/stage/stage_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double max_side = 16384;                       // canvas px, the limit of the packing's precision
constexpr double whole_px = 1e-3;                        // canvas px; so near a px is meant
constexpr double min_beyond = 0.5;                       // canvas px; less is rounding
constexpr auto kept_without = std::chrono::seconds(60);  // a place whose output is gone

/// An output on the canvas, in the units of the words.
struct PlacedOutput {
    std::string name;
    Box box;
    Rotation rotation = Rotation::none;
    double density = 1;  // px a unit
};

/// The px of a canvas that fills an output, as it hangs.
Vec2 hanging_size(const KnownOutput& output, Rotation rotation) {
    View view = output.view;
    view.rotation = rotation;
    return canvas_size(output.width, output.height, view);
}

std::vector<PlacedOutput> placed_outputs(const CanvasWords& words, std::span<const KnownOutput> outputs) {
    std::vector<PlacedOutput> placed;
    for (const OutputPlace& place : words.places) {
        const auto output = std::ranges::find(outputs, place.output, &KnownOutput::name);
        if (output == outputs.end()) continue;
        const Rotation rotation = place.turned ? rotation_of(*place.turned) : output->view.rotation;
        const Vec2 px = hanging_size(*output, rotation);
        const Vec2 size = place.size.value_or(px);
        placed.push_back({.name = place.output,
                          .box = {place.at, place.at + size},
                          .rotation = rotation,
                          .density = std::max(px.x / size.x, px.y / size.y)});
    }
    return placed;
}

/// The begin of the names of this box's outputs on a wall of several boxes; empty: there is no such wall.
std::string own_prefix(const Settings& settings) {
    return settings.wall.role == WallRole::alone ? "" : box_name(settings) + "/";
}

double near_whole(double px) {
    return std::abs(px - std::round(px)) < whole_px ? std::round(px) : px;
}

Vec2 near_whole(Vec2 px) {
    return {near_whole(px.x), near_whole(px.y)};
}

}  // namespace

SharedCanvas shared_canvas(const CanvasWords& words, std::span<const KnownOutput> outputs) {
    SharedCanvas shared;
    const std::vector<PlacedOutput> placed = placed_outputs(words, outputs);
    if (placed.empty()) return shared;
    Box all = placed.front().box;
    double density = 0;
    for (const PlacedOutput& output : placed) {
        all = united(all, output.box);
        density = std::max(density, output.density);
    }
    density = std::min(density, max_side / std::max(all.width(), all.height()));
    std::vector<Box> boxes;
    for (const PlacedOutput& output : placed) {
        const Box box{near_whole((output.box.min - all.min) * density),
                      near_whole((output.box.max - all.min) * density)};
        boxes.push_back(box);
        shared.parts[output.name] = {.box = box, .rotation = output.rotation};
    }
    shared.canvas = canvas_of(near_whole((all.max - all.min) * density), std::move(boxes));
    shared.canvas.unit = density;
    shared.canvas.origin = all.min;
    return shared;
}

CanvasWords own_canvas_words(const Settings& settings) {
    CanvasWords words = canvas_named(settings.output.canvas);
    const std::string own = own_prefix(settings);
    if (!own.empty())
        for (OutputPlace& place : words.places)
            if (place.output.starts_with(own)) place.output.erase(0, own.size());
    return words;
}

KnownOutput known_output(const Settings& settings, const Screen& screen) {
    return {.name = screen.name(),
            .width = screen.width(),
            .height = screen.height(),
            .view = view_of(settings, screen.width(), screen.height())};
}

void OutputCanvas::read_words() {
    if (text_ == settings_.output.canvas) return;
    text_ = settings_.output.canvas;
    words_ = own_canvas_words(settings_);
}

void OutputCanvas::take(SharedCanvas shared) {
    if (shared == now_) return;
    before_ = std::exchange(now_, std::move(shared));
    if (!is_shared()) return;
    add_new_outputs();
    log::info("one canvas of {:.0f}x{:.0f} px on {} {}", now_.canvas.x, now_.canvas.y, now_.parts.size(),
              now_.parts.size() == 1 ? "output" : "outputs");
}

/// Adds the outputs that have just come to the canvas before, where they hang. One that has shown all of that
/// canvas so far goes on with it.
void OutputCanvas::add_new_outputs() {
    if (before_.parts.empty()) return;
    const auto [scale, offset] = place_on(before_.canvas, now_.canvas);
    for (const auto& [name, part] : now_.parts)
        if (is_new(name))
            before_.parts.try_emplace(name,
                                      OutputPart{.box = {near_whole((part.box.min - offset) * (1 / scale)),
                                                         near_whole((part.box.max - offset) * (1 / scale))},
                                                 .rotation = part.rotation});
}

/// True for an output that is not there, or was not before the last follow().
bool OutputCanvas::is_new(const std::string& output) const {
    return std::ranges::none_of(
        seen_, [&](const Seen& seen) { return seen.output.name == output && seen.first < seen.last; });
}

void OutputCanvas::see(const KnownOutput& output, std::chrono::nanoseconds now) {
    const auto same =
        std::ranges::find_if(seen_, [&](const Seen& seen) { return seen.output.name == output.name; });
    if (same == seen_.end())
        seen_.push_back({.output = output, .first = now, .last = now});
    else
        *same = {.output = output, .first = same->first, .last = now};
}

std::vector<ActParts> OutputCanvas::parts() const {
    std::vector<ActParts> all;
    for (const SharedCanvas* shared : {&now_, &before_})
        if (!shared->parts.empty()) all.push_back({.canvas = shared->canvas, .parts = act_parts(*shared)});
    return all;
}

std::map<std::string, ActPart> OutputCanvas::act_parts(const SharedCanvas& shared) const {
    std::map<std::string, ActPart> parts;
    const std::string own = own_prefix(settings_);
    for (const auto& [name, part] : shared.parts)
        parts[name.find('/') == std::string::npos ? own + name : name] = {
            .box = part.box, .turned = degrees_of(part.rotation)};
    for (const OutputPlace& place : words_.places)  // of other boxes that are not there yet
        if (place.output.find('/') != std::string::npos && is_new(place.output))
            parts.try_emplace(place.output);
    return parts;
}

void OutputCanvas::show_parts(const WallAct& act) {
    SharedCanvas shared;
    const std::string own = own_prefix(settings_);
    for (const auto& [name, part] : act.parts)
        if (name.starts_with(own))
            shared.parts[name.substr(own.size())] = {.box = part.box, .rotation = rotation_of(part.turned)};
    if (!shared.parts.empty()) shared.canvas = act.canvas;
    take(std::move(shared));
}

void OutputCanvas::follow(std::span<Screen* const> screens, std::chrono::nanoseconds now) {
    if (settings_.wall.role == WallRole::follow) return;  // acts tell
    read_words();
    if (words_.places.empty() && !is_shared()) return;
    for (const Screen* screen : screens)
        see(known_output(settings_, *screen), now);
    if (others_)
        for (const KnownOutput& output : others_->outputs)
            see(output, now);
    if (!screens.empty() || has_others())
        std::erase_if(seen_, [&](const Seen& seen) { return now - seen.last >= kept_without; });
    std::vector<KnownOutput> outputs;
    for (const Seen& seen : seen_)
        outputs.push_back(seen.output);
    take(shared_canvas(words_, outputs));
}

void OutputCanvas::expect(int width, int height) {
    read_words();
    std::vector<KnownOutput> outputs;
    for (const OutputPlace& place : words_.places)
        outputs.push_back({.name = place.output,
                           .width = width,
                           .height = height,
                           .view = view_of(settings_, width, height)});
    now_ = shared_canvas(words_, outputs);
}

/// The canvas of this size: the one before, or else the one that is there now.
const SharedCanvas& OutputCanvas::shared_of(Vec2 canvas) const {
    return now_.canvas != canvas && before_.canvas == canvas ? before_ : now_;
}

/// The part that a screen shows of a canvas. nullptr: none, so it shows all of it.
const OutputPart* OutputCanvas::part_of(const Screen& screen, Vec2 canvas) const {
    const SharedCanvas& shared = shared_of(canvas);
    const auto part = shared.parts.find(screen.name());
    return part == shared.parts.end() || shared.canvas != canvas ? nullptr : &part->second;
}

View OutputCanvas::view_on(const Screen& screen, Vec2 canvas) const {
    View view = view_of(settings_, screen.width(), screen.height());
    if (const OutputPart* const part = part_of(screen, canvas)) {
        view.rotation = part->rotation;
        view.part = part->box;
        if (part->box.is_empty())  // it was not there yet: beside the canvas
            view.part = Box{canvas_size(screen.width(), screen.height(), view) * -1, {0, 0}};
    }
    return letterboxed(screen.width(), screen.height(), view, canvas);
}

bool OutputCanvas::is_beyond(const Screen& screen, Vec2 canvas) const {
    const OutputPart* const part = part_of(screen, canvas);
    if (part == nullptr) return false;
    const Vec2 edge{min_beyond, min_beyond};
    return part->box.is_empty() || intersection(part->box, {edge * -1, canvas + edge}) != part->box;
}

ComingView OutputCanvas::coming_view(const Screen& screen, Vec2 canvas) const {
    View view = view_on(screen, canvas);
    Box all = seen_part(view, canvas);
    for (const auto& [name, part] : shared_of(canvas).parts)
        if (!part.box.is_empty()) all = united(all, part.box);
    view.part = moved(seen_part(view, canvas), all.min * -1);
    return {.canvas = all.max - all.min, .origin = all.min, .view = view};
}

GuideView OutputCanvas::guide_view(const Screen& screen, Vec2 canvas) const {
    const View view = view_on(screen, canvas);
    GuideView guide{.name = own_prefix(settings_) + screen.name(),
                    .size = canvas_size(screen.width(), screen.height(), view),
                    .part = seen_part(view, canvas),
                    .canvas = canvas};
    if (now_.canvas == canvas && is_shared()) {
        guide.unit = now_.canvas.unit;
        guide.origin = now_.canvas.origin;
    }
    return guide;
}

}  // namespace vitrine::player

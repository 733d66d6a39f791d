#include "player/display/kms_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

std::string mode_name(const Output& output) {
    return fmt::format("{}x{}", output.mode.hdisplay, output.mode.vdisplay);
}

}  // namespace

KmsPanels::KmsPanels(KmsSurface& surface, ModeWishes modes, std::vector<DisplayEvent>& events)
    : surface_(surface), modes_(std::move(modes)), events_(events) {}

bool KmsPanels::look(Ask ask) {
    const auto is_lit = [&](std::uint32_t connector) {
        return std::ranges::any_of(
            lit_, [&](const auto& screen) { return screen->output().connector == connector; });
    };
    const auto is_asked = [&](std::uint32_t connector) {
        return ask == Ask::all || (ask == Ask::unlit && !is_lit(connector));
    };
    const std::optional<CardState> state = surface_.card.state(is_asked);
    if (!state) return false;
    for (const CardState::Connector& connector : state->connectors) {
        if (!connector.is_link_bad) continue;
        for (const auto& screen : lit_)
            if (screen->output().connector == connector.id) screen->start_over();
    }
    follow(choose_outputs(*state, modes_, surface_.card.is_atomic(), refusals_), *state);
    return true;
}

void KmsPanels::follow(const std::vector<Output>& outputs, const CardState& state) {
    const auto is_wanted = [&](const std::unique_ptr<KmsScreen>& screen) {
        return std::ranges::any_of(outputs,
                                   [&](const Output& output) { return output.is_same(screen->output()); });
    };
    lent_.clear();
    for (const auto& screen : lit_)
        if (!is_wanted(screen))
            events_.push_back({.text = fmt::format("panel gone from {}", screen->name())});
    std::erase_if(lit_, [&](const auto& screen) { return !is_wanted(screen); });
    for (const Output& output : outputs) {
        const bool is_lit =
            std::ranges::any_of(lit_, [&](const auto& screen) { return screen->output().is_same(output); });
        if (!is_lit) light(output, state, outputs);
    }
    for (const Output& output : outputs)
        for (const auto& screen : lit_)
            if (screen->output().connector == output.connector) lent_.push_back(screen.get());
    if (lit_.empty() && !is_told_dark_) events_.push_back({.text = "no panel"});
    is_told_dark_ = lit_.empty();
}

void KmsPanels::light(const Output& output, const CardState& state, const std::vector<Output>& all) {
    try {
        lit_.push_back(std::make_unique<KmsScreen>(surface_, output, obstacles(state, output, all)));
        events_.push_back({.text = fmt::format("visible {} on {} at {:.2f} Hz", mode_name(output),
                                               output.name, refresh_rate(output.mode))});
    } catch (const std::runtime_error& error) {
        events_.push_back(
            {.is_trouble = true,
             .text = fmt::format("{} stays dark in {}: {}", output.name, mode_name(output), error.what())});
        ++refusals_[output.connector];
        is_look_due_ = true;
    }
}

bool KmsPanels::take_due_look() {
    return std::exchange(is_look_due_, false);
}

void KmsPanels::refuse(const KmsScreen& screen, const std::string& reason) {
    events_.push_back(
        {.is_trouble = true,
         .text = fmt::format("{} refuses {}: {}", screen.name(), mode_name(screen.output()), reason)});
    ++refusals_[screen.output().connector];
    is_look_due_ = true;
}

void KmsPanels::start_over() {
    for (const auto& screen : lit_)
        screen->start_over();
}

std::string KmsPanels::description() const {
    std::string panels;
    for (const auto& screen : lit_)
        panels += fmt::format("{}{} {} at {:.2f} Hz", panels.empty() ? "" : ", ", screen->name(),
                              mode_name(screen->output()), refresh_rate(screen->output().mode));
    return panels;
}

}  // namespace vitrine::player

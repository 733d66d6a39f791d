#include "player/arrangement_service.hpp"

#include "base/system/log.hpp"

#include <nlohmann/json.hpp>

#include <exception>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

using namespace std::chrono_literals;

namespace {

constexpr auto look_interval = 2s;  // what stays so long is written: a hand moves shots all the time

/// @return  why it failed; empty: it has not
std::string written_by(const ArrangementFiles& files, const WallArrangement& arrangement) {
    try {
        files.write_last(arrangement);
        return {};
    } catch (const std::exception& error) {  // no exception may leave a thread; the wall goes on
        return error.what();
    }
}

}  // namespace

ArrangementService::ArrangementService(const std::filesystem::path& state, Calls calls)
    : files_(state), calls_(std::move(calls)) {}

void ArrangementService::take_last() {
    written_ = files_.last();
    if (!written_) return;
    log::info("the wall becomes as it was in the last run");
    calls_.take(*written_);
    last_ = written_;
}

/// The present arrangement; a wall that cannot be told now is as it was.
WallArrangement ArrangementService::present() {
    WallArrangement present = calls_.present();
    if (last_)
        for (const auto& [folder, wall] : last_->walls)
            present.walls.try_emplace(folder, wall);
    return present;
}

void ArrangementService::look(std::chrono::nanoseconds now, bool is_kept) {
    if (now < next_look_) return;
    next_look_ = now + look_interval;
    WallArrangement arrangement = present();
    const bool rests = last_ == arrangement;
    last_ = std::move(arrangement);
    if (!is_kept || !rests || last_ == written_) return;
    if (writing_.valid()) {
        if (writing_.wait_for(0s) != std::future_status::ready) return;
        const std::string trouble = writing_.get();
        if (!trouble.empty() && !std::exchange(has_complained_, true))
            log::warning("the arrangement of the wall is not kept: {}", trouble);
    }
    written_ = last_;
    writing_ = std::async(std::launch::async, written_by, files_, *last_);
}

void ArrangementService::end_run(bool is_kept) {
    if (writing_.valid()) writing_.wait();
    if (!is_kept) return;
    const WallArrangement arrangement = present();
    if (arrangement.walls.empty() || arrangement == written_) return;
    if (const std::string trouble = written_by(files_, arrangement); !trouble.empty())
        log::warning("the arrangement of the wall is not kept: {}", trouble);
}

CommandAnswer ArrangementService::save(const std::string& name) {
    const WallArrangement arrangement = present();
    if (arrangement.walls.empty()) throw std::runtime_error("no wall is shown that could be saved");
    files_.save(name, arrangement);
    log::info("layout saved: '{}'", name);
    return {.text = name, .pictures = {}};
}

CommandAnswer ArrangementService::load(const std::string& name) {
    const WallArrangement arrangement = files_.load(name);
    calls_.take(arrangement);
    log::info("layout loaded: '{}'", name);
    return {.text = name, .pictures = {}};
}

CommandHandlers ArrangementService::handlers() {
    return {{"SaveLayout", [this](const CommandCall& call) { return save(call.file); }},
            {"LoadLayout", [this](const CommandCall& call) { return load(call.file); }},
            {"ForgetLayout",
             [this](const CommandCall& call) {
                 files_.forget(call.file);
                 log::info("layout forgotten: '{}'", call.file);
                 return CommandAnswer{.text = call.file, .pictures = {}};
             }},
            {"Layouts", [this](const CommandCall&) {
                 return CommandAnswer{.text = nlohmann::json(files_.names()).dump(), .pictures = {}};
             }}};
}

}  // namespace vitrine::player

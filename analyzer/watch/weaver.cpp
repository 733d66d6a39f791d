#include "analyzer/watch/weaver.hpp"

#include "analyzer/watch/analysis_outcome.hpp"
#include "base/system/log.hpp"

#include <utility>

namespace vitrine::analyzer {

Weaver::Weaver(EventLoop& loop, WeaveOptions options, std::function<void()> ended)
    : loop_(loop),
      options_(std::move(options)),
      ended_(std::move(ended)),
      tapestries_(options_.state, options_.bounds),
      wanted_(loop, options_.state, [this] {
          follow_wish();
          advance(scope_);
      }) {
    follow_wish();
}

/// A tapestry that has lost its place to others is woven again if a visitor waits for it.
void Weaver::follow_wish() {
    const std::string& path = wanted_.path();
    schedule_.want_film(path);
    if (const std::optional<FilmVersion> film = tapestries_.revive(path))
        schedule_.request_film(path, film->bytes, film->mtime_ns);
}

void Weaver::note_record(const MediaRecord& record) {
    if (tapestries_.hold(record))
        schedule_.request_film(record.path, record.bytes, record.mtime_ns);
    else if (!record.is_complete || record.state != MediaState::ready)
        schedule_.forget_film(record.path);
}

void Weaver::forget_film(const std::string& path) {
    schedule_.forget_film(path);
    advance(scope_);  // its child must not write into the removed folder
    tapestries_.release(path);
}

void Weaver::rename_film(const std::string& from, const std::string& to) {
    schedule_.forget_film(from);
    advance(scope_);
    tapestries_.move(from, to);
}

void Weaver::sweep_tapestries(const std::vector<std::string>& files) {
    wanted_.look();
    follow_wish();
    tapestries_.sweep(files);
    tapestries_.look_at(schedule_.running_film());
    make_room();
}

void Weaver::make_room() {
    for (const std::string& path : tapestries_.make_room(schedule_.running_film())) {
        schedule_.forget_film(path);
        log::info("the tapestries exceed their limit: that of '{}' is removed", path);
    }
}

void Weaver::advance(WeaveScope scope) {
    scope_ = scope;
    for (const WeaveAction& action : schedule_.next_actions(scope))
        perform(action);
}

void Weaver::perform(const WeaveAction& action) {
    switch (action.kind) {
    case WeaveAction::Kind::start:
        return start_child(action.path);
    case WeaveAction::Kind::pause:
        return child_->pause();
    case WeaveAction::Kind::go_on:
        return child_->go_on();
    case WeaveAction::Kind::stop:
        return child_->stop();
    }
}

void Weaver::start_child(const std::string& path) {
    std::vector<std::string> command = options_.command;
    command.push_back("--output=" + tapestries_.folder(path).string());
    command.push_back((options_.root / path).string());
    const bool is_wanted = path == schedule_.wanted_film();
    ChildLimits limits = options_.limits;
    if (is_wanted) limits.niceness = options_.wanted_niceness;
    log::debug("weaving '{}'{}", path, is_wanted ? ", as a visitor waits for it" : "");
    child_ = std::make_unique<ChildProcess>(
        loop_, command, limits, [this, path](const ChildResult& result) { finish_weaving(path, result); });
}

void Weaver::finish_weaving(const std::string& path, const ChildResult& result) {
    child_.reset();
    const bool is_woven = result.end == ChildResult::End::exited && result.code == 0;
    schedule_.finish_weaving(path, is_woven);
    tapestries_.look_at(path);
    tapestries_.remove_replaced();
    if (is_woven)
        log::info("woven: '{}'", path);
    else if (result.end != ChildResult::End::stopped)
        log::warning("not woven: '{}': {}", path, reason_of(result, options_.limits));
    make_room();
    advance(scope_);
    ended_();
}

}  // namespace vitrine::analyzer

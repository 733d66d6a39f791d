#include "analyzer/watch/weaver.hpp"

#include "analyzer/watch/analysis_outcome.hpp"
#include "base/state/keyframe_notes.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <set>
#include <system_error>
#include <utility>

namespace vitrine::analyzer {

namespace {

constexpr const char* choice_name = "keyframes.toml";  // in the tapestry's folder, for its child

}  // namespace

Weaver::Weaver(EventLoop& loop, WeaveOptions options, std::function<void()> ended)
    : loop_(loop),
      options_(std::move(options)),
      ended_(std::move(ended)),
      tapestries_(options_.state, options_.bounds),
      wanted_(loop, options_.state,
              {.wanted =
                   [this] {
                       follow_wish();
                       advance(scope_);
                   },
               .noted =
                   [this] {
                       read_notes();
                       follow_choices();
                   }}) {
    follow_wish();
    read_notes();
}

/// A tapestry that has lost its place to others is woven again if a visitor waits for it.
void Weaver::follow_wish() {
    const std::string& path = wanted_.path();
    schedule_.want_film(path);
    if (const std::optional<FilmVersion> film = tapestries_.revive(path))
        schedule_.request_film(path, film->bytes, film->mtime_ns, film->choice);
}

void Weaver::note_record(const MediaRecord& record) {
    const std::string choice = choice_key(record.path);
    if (tapestries_.hold(record, choice))
        schedule_.request_film(record.path, record.bytes, record.mtime_ns, choice);
    else if (!record.is_complete || record.state != MediaState::ready)
        schedule_.forget_film(record.path);
}

void Weaver::set_choices(const KeyframeChoices& choices) {
    written_ = choices;
    follow_choices();
}

/// The player writes only what it can read.
void Weaver::read_notes() {
    touched_.clear();
    for (const auto& [path, text] : read_keyframe_notes(options_.state))
        touched_[path] = read_keyframe_choice(text, keyframe_notes_file).choice;
}

void Weaver::follow_choices() {
    KeyframeChoices choices = written_;
    for (const auto& [path, touched] : touched_)
        choices[path] = joined_choice(choices[path], touched);
    std::erase_if(choices, [](const auto& one) { return one.second.is_empty(); });
    if (choices == choices_) return;
    const KeyframeChoices before = std::exchange(choices_, std::move(choices));
    std::set<std::string> paths;
    for (const KeyframeChoices* both : {&before, &std::as_const(choices_)})
        for (const auto& [path, choice] : *both)
            paths.insert(path);
    for (const std::string& path : paths) {
        const auto film = tapestries_.choose(path, choice_key(path));
        if (!film) continue;
        const auto& [version, is_lacking] = *film;
        if (is_lacking)
            schedule_.request_film(path, version.bytes, version.mtime_ns, version.choice);
        else
            schedule_.forget_film(path);  // it was woven with that choice before
    }
    advance(scope_);
}

KeyframeChoice Weaver::keyframes_for(const std::string& path) const {
    const auto found = choices_.find(path);
    return found == choices_.end() ? KeyframeChoice{} : found->second;
}

std::string Weaver::choice_key(const std::string& path) const {
    return key_of(keyframes_for(path));
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

std::vector<std::string> Weaver::command_for(const std::string& path) const {
    std::vector<std::string> command = options_.command;
    const std::filesystem::path folder = tapestries_.folder(path);
    command.push_back("--output=" + folder.string());
    if (const auto choice = choices_.find(path); choice != choices_.end()) {
        std::filesystem::create_directories(folder);
        replace_file(folder / choice_name, to_toml(choice->second));
        command.push_back("--keyframes=" + (folder / choice_name).string());
    }
    command.push_back((options_.root / path).string());
    return command;
}

void Weaver::start_child(const std::string& path) {
    const bool is_wanted = path == schedule_.wanted_film();
    ChildLimits limits = options_.limits;
    if (is_wanted) limits.niceness = options_.wanted_niceness;
    log::debug("weaving '{}'{}", path, is_wanted ? ", as a visitor waits for it" : "");
    try {
        child_ = std::make_unique<ChildProcess>(
            loop_, command_for(path), limits,
            [this, path](const ChildResult& result) { finish_weaving(path, result); });
    } catch (const std::system_error& error) {  // a full disk, no process
        log::warning("not woven: '{}': {}", path, error.what());
        schedule_.finish_weaving(path, false);
    }
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

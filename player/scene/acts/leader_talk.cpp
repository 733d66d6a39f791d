#include "player/scene/acts/leader_talk.hpp"

#include "player/scene/acts/lifted_json.hpp"
#include "player/scene/acts/touch_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

using Kind = WallTopic::Kind;

constexpr std::size_t max_touches = 1000;  // messages between two frames: 16 fingers for a second
constexpr int fingers_of_box = 1000;
constexpr auto lifted_pause = std::chrono::milliseconds(250);  // between two messages that say the same

/// The same way with every second moment.
WallWay coarser(const WallWay& way) {
    WallWay half{.keys = {}, .homes = way.homes, .wayless = way.wayless};
    for (std::size_t k = 1 - way.keys.size() % 2; k < way.keys.size(); k += 2)
        half.keys.push_back(way.keys[k]);
    return half;
}

/// An act as text. If it is too long, its way loses moments; empty: it is still too long.
std::string fitting_json(WallAct& act, std::size_t max_bytes) {
    std::string text = to_json(act);
    while (text.size() > max_bytes && act.change && act.change->way && act.change->way->keys.size() > 1) {
        act.change->way = std::make_shared<const WallWay>(coarser(*act.change->way));
        text = to_json(act);
    }
    return text.size() > max_bytes ? std::string() : text;
}

/// Leaves the wall after the act's change, to which the others fade when the change begins.
void drop_way(WallAct& act) {
    WallChange& change = *act.change;
    act.shown.clear();
    change = {.phase = WallChange::Phase::arriving,
              .canvas = change.canvas,
              .wall = std::move(change.wall),
              .is_final = true,
              .began = change.began};
}

WallMessage message_of(Kind kind, std::string payload) {
    return {.topic = {.kind = kind, .box = {}}, .is_retained = true, .payload = std::move(payload)};
}

}  // namespace

std::string LeaderTalk::complaint() const {
    switch (told_) {
    case Told::whole:
        return {};
    case Told::without_way:
        return fmt::format(
            "the way of a change takes more than {} bytes: the other boxes fade to its end; fewer slots "
            "help",
            max_bytes_);
    case Told::nothing:
        return fmt::format(
            "a change cannot be told to the other boxes, as it takes more than {} bytes: they keep what "
            "they show until a change is shorter; fewer slots help",
            max_bytes_);
    }
    return {};
}

void LeaderTalk::hear_more(const WallMessage& message) {
    const std::string& box = message.topic.box;
    if (message.topic.kind == Kind::act)
        throw std::runtime_error("another box leads this wall, too; only one may");
    if (message.topic.kind == Kind::ready) {
        const ActName ready = ready_from_json(message.payload);
        if (ready.run == run_ && ready.generation <= preparation_) ready_[box] = ready.generation;
    }
    if (message.topic.kind == Kind::touch && touches_.size() < max_touches)
        touches_.emplace_back(box, message.payload);
}

std::vector<InputEvent> LeaderTalk::take_touches(const BoxMoment& moment) {
    std::vector<InputEvent> all;
    for (const auto& [box, payload] : std::exchange(touches_, {})) {
        const auto number = std::distance(others().begin(), others().find(box));
        for (InputEvent event : touches_from_json(payload, moment)) {
            if (auto* const contact = std::get_if<Contact>(&event)) {
                contact->finger += fingers_of_box * (static_cast<int>(number) + 1);
                contact->is_told = true;
            }
            all.push_back(event);
        }
    }
    return all;
}

/// The last preparation that all boxes have which are waited for. None: nobody is waited for.
std::optional<std::uint64_t> LeaderTalk::others_ready() const {
    std::optional<std::uint64_t> least;
    for (const auto& [box, note] : others()) {
        const auto ready = ready_.find(box);
        if (note.is_gone || note.leads || ready == ready_.end()) continue;
        if (ready->second + 1 >= preparation_) least = std::min(least.value_or(ready->second), ready->second);
    }
    return least;
}

/// Says what hands do whenever that has changed, and four times a second while they do something: a box that
/// hears nothing puts the shots back. @param epoch  shared time at the player's start
void LeaderTalk::say_lifted(const LedNews& news, std::chrono::nanoseconds epoch,
                            std::vector<WallMessage>& said) {
    ToldHands told{.run = run_, .lifted = news.lifted};
    if (news.tapestry) told.tapestry = moved(*news.tapestry, epoch);
    if (told.is_nothing() && lifted_.empty()) return;
    std::string text = lifted_to_json(told);
    if (text == lifted_ && news.now - lifted_at_ < lifted_pause) return;
    said.push_back({.topic = {.kind = Kind::lifted, .box = {}}, .is_retained = false, .payload = text});
    lifted_ = told.is_nothing() ? std::string() : std::move(text);
    lifted_at_ = news.now;
}

/// An act as text, without its way if that is too long; empty: it is still too long. Numbers it anew.
std::string LeaderTalk::text_of_act(WallAct& act) {
    act.name.generation += skipped_;
    std::string text = fitting_json(act, max_bytes_);
    told_ = Told::whole;
    if (text.empty() && act.change) {
        ++act.name.generation;  // no follower takes it for the act after the one that it shows: it fades
        ++skipped_;
        told_ = Told::without_way;
        drop_way(act);
        text = fitting_json(act, max_bytes_);
    }
    if (text.empty()) told_ = Told::nothing;
    return text;
}

std::vector<WallMessage> LeaderTalk::speak_more(Show& show, const BoxMoment& moment, BoxNote& note) {
    note.leads = true;
    LedShow* const led = show.led();
    if (led == nullptr) return {};
    LedNews news = led->take_news();
    const std::chrono::nanoseconds epoch = moment.epoch + moment.now - news.now;
    const bool needs_act = epoch_ && *epoch_ != epoch && !news.act;
    std::vector<WallMessage> said;
    if (news.preparation) {
        preparation_ = news.preparation->name.generation;
        news.preparation->name.run = run_;
        said.push_back(message_of(Kind::prepare, fitting_json(*news.preparation, max_bytes_)));
    }
    if (news.act) {
        news.act->name.run = run_;
        news.act->epoch = epoch;
        epoch_ = epoch;
        said.push_back(message_of(Kind::act, text_of_act(*news.act)));
        said_ = news.act->name;
    }
    std::erase_if(said, [](const WallMessage& message) { return message.payload.empty(); });
    led->heed({.ready = others_ready(), .needs_act = needs_act});
    note.shown = said_;
    for (const WallMessage& message : said) {
        std::erase_if(kept_, [&](const WallMessage& old) { return old.topic.kind == message.topic.kind; });
        kept_.push_back(message);
    }
    if (std::exchange(says_again_, false)) said = kept_;
    say_lifted(news, moment.epoch, said);
    return said;
}

void LeaderTalk::begin_anew() {
    ++run_;
    preparation_ = 0;
    for (auto& [box, ready] : ready_)
        ready = 0;  // the first preparation is waited for
    skipped_ = 0;
    epoch_.reset();
}

void LeaderTalk::say_again() {
    BoxTalk::say_again();
    says_again_ = true;
}

}  // namespace vitrine::player

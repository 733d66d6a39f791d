#include "player/scene/acts/box_talk.hpp"

#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

constexpr auto told_anew = std::chrono::seconds(10);
constexpr auto told_soon = std::chrono::seconds(1);  // not more often, unless it is urgent
constexpr std::size_t max_boxes = 64;

/// True for what others wait for: the box has other outputs, was touched, or shows its first act.
bool is_urgent(const BoxNote& note, const BoxNote& told) {
    return note.outputs != told.outputs || note.is_awake != told.is_awake ||
           note.shown.has_value() != told.shown.has_value();
}

/// True if both tell the same but for the clock's difference.
bool is_same(BoxNote one, const BoxNote& other) {
    one.difference = other.difference;
    return one == other;
}

}  // namespace

void BoxTalk::hear(const WallMessage& message) {
    using Kind = WallTopic::Kind;
    if (message.topic.box == box_) return;
    if (message.topic.kind != Kind::box) return hear_more(message);
    BoxNote note = box_note_from_json(message.payload);
    if (!others_.contains(message.topic.box) && others_.size() >= max_boxes)
        throw std::runtime_error("the wall has more boxes than it may have");
    others_[message.topic.box] = std::move(note);
}

std::vector<WallMessage> BoxTalk::speak(Show& show, const BoxMoment& moment) {
    BoxNote note = moment.own;
    std::vector<WallMessage> said = speak_more(show, moment, note);
    const auto passed = moment.now - told_at_;
    const bool is_due = !told_ || passed >= told_anew || is_urgent(note, *told_) ||
                        (passed >= told_soon && !is_same(note, *told_));
    if (!is_due) return said;
    said.push_back({.topic = {.kind = WallTopic::Kind::box, .box = box_},
                    .is_retained = true,
                    .payload = to_json(note)});
    told_ = std::move(note);
    told_at_ = moment.now;
    return said;
}

}  // namespace vitrine::player

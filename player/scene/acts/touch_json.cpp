#include "player/scene/acts/touch_json.hpp"

#include "player/scene/acts/act_fields.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine::player {

namespace {

constexpr std::size_t max_events = 500;
constexpr int max_finger = 999;
constexpr double max_notches = 100;
constexpr std::chrono::nanoseconds max_delay = std::chrono::seconds(2);  // of a message on its way
constexpr std::chrono::nanoseconds max_age = std::chrono::seconds(60);   // of an event when it is told

ActJson to_json(const Contact& contact) {
    return {{"kind", static_cast<int>(contact.kind)},
            {"finger", contact.finger},
            {"at", to_act_json(contact.at)}};
}

ActJson to_json(const Wheel& wheel) {
    return {{"notches", wheel.notches}, {"at", to_act_json(wheel.at)}};
}

ActJson to_json(const KeyPress& press) {
    return {{"key", static_cast<int>(press.key)}};
}

/// The time at which a message was sent, by this box's clock.
std::chrono::nanoseconds sent_time(const ActJson& json, const BoxMoment& heard) {
    const std::chrono::nanoseconds sent = time_in(json, "sent_ns") - heard.epoch;
    return std::chrono::abs(heard.now - sent) <= max_delay ? sent : heard.now;
}

InputEvent event_in(const ActJson& json, std::chrono::nanoseconds sent) {
    const std::chrono::nanoseconds time =
        sent - std::chrono::nanoseconds(whole_in(json, "age_ns", -max_age.count(), max_age.count()));
    if (json.contains("notches"))
        return Wheel{.notches = number_in(json.at("notches"), max_notches),
                     .at = vec2_in(json.at("at")),
                     .time = time};
    if (json.contains("key"))
        return KeyPress{.key =
                            static_cast<Key>(whole_in(json, "key", 0, static_cast<std::int64_t>(Key::undo))),
                        .time = time};
    return Contact{.kind = static_cast<Contact::Kind>(whole_in(json, "kind", 0, 3)),
                   .finger = static_cast<int>(whole_in(json, "finger", -1, max_finger)),
                   .at = vec2_in(json.at("at")),
                   .time = time};
}

}  // namespace

std::string touches_to_json(std::span<const InputEvent> events, const BoxMoment& sent) {
    ActJson all = ActJson::array();
    for (const InputEvent& event : events.first(std::min(events.size(), max_events))) {
        ActJson told = std::visit([](const auto& one) { return to_json(one); }, event);
        const std::chrono::nanoseconds age =
            sent.now - std::visit([](const auto& one) { return one.time; }, event);
        told["age_ns"] = std::clamp(age, -max_age, max_age).count();
        all.push_back(std::move(told));
    }
    return ActJson{{"sent_ns", (sent.epoch + sent.now).count()}, {"events", std::move(all)}}.dump();
}

std::vector<InputEvent> touches_from_json(std::string_view text, const BoxMoment& heard) {
    std::vector<InputEvent> events;
    try {
        const ActJson json = ActJson::parse(text);
        const std::chrono::nanoseconds sent = sent_time(json, heard);
        for (const ActJson& event : array_in(json, "events", max_events))
            events.push_back(event_in(event, sent));
    } catch (const nlohmann::json::exception& error) {
        throw ActFault(fmt::format("a box of the wall tells of touches in words that are not understood: {}",
                                   error.what()));
    }
    return events;
}

}  // namespace vitrine::player

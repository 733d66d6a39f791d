#include "player/scene/acts/touch_json.hpp"

#include "player/scene/acts/act_fields.hpp"

#include <fmt/format.h>

namespace vitrine::player {

namespace {

constexpr std::size_t max_events = 500;
constexpr int max_finger = 999;
constexpr double max_notches = 100;

ActJson to_json(const Contact& contact) {
    return {{"kind", static_cast<int>(contact.kind)},
            {"finger", contact.finger},
            {"at", to_act_json(contact.at)}};
}

InputEvent event_in(const ActJson& json, std::chrono::nanoseconds now) {
    if (json.contains("notches"))
        return Wheel{
            .notches = number_in(json.at("notches"), max_notches), .at = vec2_in(json.at("at")), .time = now};
    if (json.contains("key"))
        return KeyPress{.key =
                            static_cast<Key>(whole_in(json, "key", 0, static_cast<std::int64_t>(Key::undo))),
                        .time = now};
    return Contact{.kind = static_cast<Contact::Kind>(whole_in(json, "kind", 0, 3)),
                   .finger = static_cast<int>(whole_in(json, "finger", -1, max_finger)),
                   .at = vec2_in(json.at("at")),
                   .time = now};
}

}  // namespace

std::string touches_to_json(std::span<const InputEvent> events) {
    ActJson all = ActJson::array();
    for (const InputEvent& event : events) {
        if (all.size() == max_events) break;
        if (const auto* contact = std::get_if<Contact>(&event)) all.push_back(to_json(*contact));
        if (const auto* wheel = std::get_if<Wheel>(&event))
            all.push_back({{"notches", wheel->notches}, {"at", to_act_json(wheel->at)}});
        if (const auto* key = std::get_if<KeyPress>(&event))
            all.push_back({{"key", static_cast<int>(key->key)}});
    }
    return ActJson{{"events", std::move(all)}}.dump();
}

std::vector<InputEvent> touches_from_json(std::string_view text, std::chrono::nanoseconds now) {
    std::vector<InputEvent> events;
    try {
        const ActJson json = ActJson::parse(text);
        for (const ActJson& event : array_in(json, "events", max_events))
            events.push_back(event_in(event, now));
    } catch (const nlohmann::json::exception& error) {
        throw ActFault(fmt::format("a box of the wall tells of touches in words that are not understood: {}",
                                   error.what()));
    }
    return events;
}

}  // namespace vitrine::player

#include "base/wall/wall_message.hpp"

#include "base/wall/broken_line.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>

namespace vitrine {

using Json = nlohmann::ordered_json;

namespace {

constexpr int max_depth = 32;  // of objects and arrays within each other: writing them recurses

/// Parses one JSON object. @throws BrokenLine
Json checked_object(std::string_view text) {
    if (text.size() > max_wall_line)
        throw BrokenLine(fmt::format("a message has {} bytes, more than {}", text.size(), max_wall_line));
    const auto bounded = [](int depth, Json::parse_event_t, const Json&) {
        if (depth > max_depth) throw BrokenLine(fmt::format("a message has more than {} levels", max_depth));
        return true;
    };
    try {
        Json json = Json::parse(text, bounded);
        if (!json.is_object()) throw BrokenLine("a message is no JSON object");
        return json;
    } catch (const Json::exception& error) {
        throw BrokenLine(fmt::format("a message is no JSON: {}", error.what()));
    }
}

WallMessage message_in(const Json& json) {
    const auto text = json.at("topic").get<std::string>();
    const auto topic = wall_topic(text);
    if (!topic) throw BrokenLine(fmt::format("a message has the unknown topic '{}'", text.substr(0, 80)));
    const Json& payload = json.at("payload");
    if (!payload.is_object()) throw BrokenLine("a message has a payload that is no JSON object");
    return {.topic = *topic, .is_retained = json.value("retain", false), .payload = payload.dump()};
}

}  // namespace

std::string line_of(const WallMessage& message) {
    const std::string topic = text_of(message.topic);
    return fmt::format(R"({{"topic":"{}","box":"{}","retain":{},"payload":{}}})", topic, message.topic.box,
                       message.is_retained, message.payload);
}

WallMessage wall_message(std::string_view line) {
    try {
        return message_in(checked_object(line));
    } catch (const Json::exception& error) {
        throw BrokenLine(fmt::format("a message lacks a part: {}", error.what()));
    }
}

std::string checked_payload(std::string_view text) {
    return checked_object(text).dump();
}

std::optional<int> payload_version(std::string_view payload) {
    const Json json = checked_object(payload);
    const auto version = json.find("version");
    constexpr std::uint64_t most = 1'000'000;
    if (version == json.end() || !version->is_number_unsigned() || version->get<std::uint64_t>() > most)
        return std::nullopt;
    return version->get<int>();
}

std::string told_tapestry(std::string_view payload) {
    if (payload.find("\"tapestry\"") == std::string_view::npos) return {};  // most messages: not parsed again
    const Json json = checked_object(payload);
    const auto tapestry = json.find("tapestry");
    if (tapestry == json.end() || !tapestry->is_object()) return {};
    Json told = Json::array();
    for (const char* const key : {"path", "folder", "levels"})
        told.push_back(tapestry->value(key, Json()));
    return told.dump();
}

std::string link_payload(bool is_connected, std::string_view says) {
    const Json json{{"connected", is_connected}, {"says", says}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

LinkState link_state(std::string_view payload) {
    try {
        const Json json = checked_object(payload);
        return {.is_connected = json.at("connected").get<bool>(), .says = json.value("says", std::string())};
    } catch (const Json::exception& error) {
        throw BrokenLine(fmt::format("a state of the link lacks a part: {}", error.what()));
    }
}

}  // namespace vitrine

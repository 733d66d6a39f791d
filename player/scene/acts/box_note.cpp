#include "player/scene/acts/box_note.hpp"

#include "player/scene/acts/act_fields.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int max_side = 100'000;        // px of an output
constexpr std::size_t max_outputs = 32;  // of a box
constexpr std::size_t max_text = 4096;   // bytes
constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();

std::string short_text(const ActJson& json) {
    auto text = json.get<std::string>();
    if (text.size() > max_text) throw ActFault("a box of the wall tells a name that is too long");
    return text;
}

ActJson name_to_json(const ActName& name) {
    return {{"run", name.run}, {"generation", name.generation}};
}

ActName name_in(const ActJson& json) {
    return {.run = whole_in(json, "run", 0, largest),
            .generation = static_cast<std::uint64_t>(whole_in(json, "generation", 0, largest))};
}

BoxOutput output_in(const ActJson& json) {
    BoxOutput output{.name = short_text(json.at("name")),
                     .width = static_cast<int>(whole_in(json, "width", 1, max_side)),
                     .height = static_cast<int>(whole_in(json, "height", 1, max_side)),
                     .turned = static_cast<int>(whole_in(json, "turned", 0, 270))};
    if (output.turned % 90 != 0) throw ActFault("a box of the wall has an output that hangs askew");
    return output;
}

BoxNote box_note_in(const ActJson& json) {
    BoxNote note{.leads = json.value("leads", false),
                 .is_gone = json.value("gone", false),
                 .has_guides = json.value("has_guides", false),
                 .is_awake = json.value("is_awake", false)};
    if (json.contains("outputs"))
        for (const ActJson& output : array_in(json, "outputs", max_outputs))
            note.outputs.push_back(output_in(output));
    if (json.contains("shown")) note.shown = name_in(json.at("shown"));
    if (json.contains("lacking"))
        for (const ActJson& path : array_in(json, "lacking", max_told_lacks))
            note.lacking.push_back(short_text(path));
    if (json.contains("fetch_fault")) note.fetch_fault = short_text(json.at("fetch_fault"));
    note.has_right_clock = json.value("has_right_clock", false);
    if (json.contains("difference_us"))
        note.difference = std::chrono::microseconds(whole_in(json, "difference_us", -largest, largest));
    return note;
}

template <typename Read> auto read_json(std::string_view text, Read read) {
    try {
        return read(ActJson::parse(text));
    } catch (const nlohmann::json::exception& error) {
        throw ActFault(fmt::format("a box of the wall says what is not understood: {}", error.what()));
    }
}

}  // namespace

std::string to_json(const BoxNote& note) {
    ActJson json{{"version", 1},
                 {"leads", note.leads},
                 {"has_guides", note.has_guides},
                 {"is_awake", note.is_awake},
                 {"has_right_clock", note.has_right_clock},
                 {"difference_us", note.difference.count()},
                 {"outputs", ActJson::array()},
                 {"lacking", ActJson::array()}};
    for (const BoxOutput& output : note.outputs)
        json["outputs"].push_back({{"name", output.name},
                                   {"width", output.width},
                                   {"height", output.height},
                                   {"turned", output.turned}});
    for (const std::string& path : note.lacking)
        if (json["lacking"].size() < max_told_lacks) json["lacking"].push_back(path);
    if (!note.fetch_fault.empty()) json["fetch_fault"] = note.fetch_fault;
    if (note.shown) json["shown"] = name_to_json(*note.shown);
    return json.dump(-1, ' ', false, ActJson::error_handler_t::replace);
}

BoxNote box_note_from_json(std::string_view text) {
    return read_json(text, box_note_in);
}

std::string ready_to_json(const ActName& preparation) {
    return name_to_json(preparation).dump();
}

ActName ready_from_json(std::string_view text) {
    return read_json(text, name_in);
}

}  // namespace vitrine::player

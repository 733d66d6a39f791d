#include "base/state/record_json.hpp"

#include "base/state/path_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <concepts>
#include <stdexcept>
#include <utility>

namespace vitrine {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t max_shots = 100'000;
constexpr std::size_t max_corners = 1'000;
constexpr int first_analysis = 1;   // of records that do not name it
constexpr double max_pixels = 1e9;  // for a place, and for the way in one second

template <typename Enum, std::size_t n> using Names = std::array<std::pair<Enum, std::string_view>, n>;

constexpr Names<MediaKind, 2> kinds{{{MediaKind::photo, "photo"}, {MediaKind::film, "video"}}};
constexpr Names<MediaState, 5> states{{{MediaState::ready, "ready"},
                                       {MediaState::waiting, "waiting"},
                                       {MediaState::unsupported, "unsupported"},
                                       {MediaState::failed, "failed"},
                                       {MediaState::quarantined, "quarantined"}}};
constexpr Names<FaultOwner, 4> owners{{{FaultOwner::file, name_of(FaultOwner::file)},
                                       {FaultOwner::transport, name_of(FaultOwner::transport)},
                                       {FaultOwner::machine, name_of(FaultOwner::machine)},
                                       {FaultOwner::program, name_of(FaultOwner::program)}}};
constexpr Names<ShotEnd, 5> ends{{{ShotEnd::cut, "cut"},
                                  {ShotEnd::dissolve, "dissolve"},
                                  {ShotEnd::fade, "fade"},
                                  {ShotEnd::end, "end"},
                                  {ShotEnd::split, "split"}}};

constexpr Names<TimeSource, 3> time_sources{
    {{TimeSource::camera, "camera"}, {TimeSource::camera_clock, "camera_clock"}, {TimeSource::file, "file"}}};
constexpr Names<StretchKind, 3> stretches{
    {{StretchKind::transition, "transition"}, {StretchKind::plain, "plain"}, {StretchKind::empty, "empty"}}};

template <typename Table> std::string_view name_in(const Table& table, auto value) {
    for (const auto& [key, name] : table)
        if (key == value) return name;
    throw std::logic_error("a value without a name");
}

template <typename Table> auto value_in(const Table& table, const Json& json, std::string_view key) {
    const std::string text = json.at(std::string(key)).get<std::string>();
    for (const auto& [value, name] : table)
        if (name == text) return value;
    throw std::runtime_error(fmt::format("record: '{}' is not a {}", text, key));
}

double rounded(double pixels) {
    return std::round(pixels * 1000) / 1000;
}

Json to_array(Vec2 v) {
    return Json::array({rounded(v.x), rounded(v.y)});
}

/// nlohmann::json casts any number to the requested type, but a cast beyond its range is undefined.
template <std::integral Number> Number whole(const Json& json, const char* key) {
    const Json& value = json.at(key);
    if (value.is_number_unsigned() && std::in_range<Number>(value.get<std::uint64_t>()))
        return static_cast<Number>(value.get<std::uint64_t>());
    if (value.is_number_integer() && !value.is_number_unsigned() &&
        std::in_range<Number>(value.get<std::int64_t>()))
        return static_cast<Number>(value.get<std::int64_t>());
    throw std::runtime_error(fmt::format("record: '{}' is no whole number, or too large", key));
}

Vec2 to_vec2(const Json& json) {
    const Vec2 v{json.at(0).get<double>(), json.at(1).get<double>()};
    if (!(std::abs(v.x) <= max_pixels && std::abs(v.y) <= max_pixels))
        throw std::runtime_error("record: a place is out of range");
    return v;
}

Json to_object(const StoredShot& stored) {
    return {{"file", stored.file},
            {"begin_ns", stored.begin.count()},
            {"width", stored.width},
            {"height", stored.height},
            {"dropped", stored.is_dropped}};
}

StoredShot to_stored(const Json& json) {
    StoredShot stored;
    stored.file = json.at("file").get<std::string>();
    stored.begin = std::chrono::nanoseconds(whole<std::int64_t>(json, "begin_ns"));
    stored.width = whole<int>(json, "width");
    stored.height = whole<int>(json, "height");
    stored.is_dropped = json.at("dropped").get<bool>();
    if (!is_store_name(stored.file))
        throw std::runtime_error("record: 'file' is not the name of a stored file");
    if (stored.begin.count() < 0 || stored.width <= 0 || stored.height <= 0)
        throw std::runtime_error("record: a stored shot without a size or a place");
    return stored;
}

Json to_object(const StoredSound& sound) {
    return {{"file", sound.file}, {"dropped", sound.is_dropped}};
}

StoredSound to_sound(const Json& json) {
    StoredSound sound{.file = json.at("file").get<std::string>(),
                      .is_dropped = json.at("dropped").get<bool>()};
    if (!sound.file.empty() && !is_store_name(sound.file))
        throw std::runtime_error("record: the sound's 'file' is not the name of a stored file");
    return sound;
}

Json to_object(const Fault& fault) {
    Json json{{"owner", name_of(fault.owner)}, {"since_s", fault.since.count()}};
    if (fault.quarantines == 0) return json;
    json["until_s"] = fault.until.count();
    json["quarantines"] = fault.quarantines;
    return json;
}

Fault to_fault(const Json& json) {
    Fault fault{.owner = value_in(owners, json, "owner"),
                .since = std::chrono::seconds(whole<std::uint32_t>(json, "since_s"))};
    if (!json.contains("quarantines")) return fault;
    fault.until = std::chrono::seconds(whole<std::uint32_t>(json, "until_s"));
    fault.quarantines = whole<std::uint16_t>(json, "quarantines");
    return fault;
}

Json to_object(const Shot& shot) {
    Json polygon = Json::array();
    for (const Vec2& corner : shot.region.polygon)
        polygon.push_back(to_array(corner));
    Json json{{"begin_ns", shot.begin.count()},
              {"end_ns", shot.end.count()},
              {"ends_with", name_of(shot.ends_with)},
              {"region", {{"polygon", polygon}, {"drift", to_array(shot.region.drift)}}}};
    json["analysis"] = shot.analysis;
    if (shot.is_title) json["title"] = true;
    if (shot.certainty) json["certainty"] = rounded(*shot.certainty);
    if (shot.look) json["look"] = text_of(*shot.look);
    if (shot.print) {
        json["print"] = text_of(*shot.print);
        json["sharpness"] = rounded(shot.print->sharpness);
    }
    if (shot.picture)
        json["picture"] = Json::array({to_array(shot.picture->min), to_array(shot.picture->max)});
    for (const Box& mark : shot.marks)
        json["marks"].push_back(Json::array({to_array(mark.min), to_array(mark.max)}));
    if (shot.stored) json["stored"] = to_object(*shot.stored);
    return json;
}

std::vector<Box> to_marks(const Json& json) {
    if (json.size() > Shot::max_marks) throw std::runtime_error("record: a shot has too many marks");
    std::vector<Box> marks;
    for (const Json& mark : json)
        marks.push_back({to_vec2(mark.at(0)), to_vec2(mark.at(1))});
    return marks;
}

Shot to_shot(const Json& json) {
    Shot shot;
    shot.begin = std::chrono::nanoseconds(whole<std::int64_t>(json, "begin_ns"));
    shot.end = std::chrono::nanoseconds(whole<std::int64_t>(json, "end_ns"));
    shot.ends_with = value_in(ends, json, "ends_with");
    const Json& polygon = json.at("region").at("polygon");
    if (polygon.size() > max_corners) throw std::runtime_error("record: a region has too many corners");
    for (const Json& corner : polygon)
        shot.region.polygon.push_back(to_vec2(corner));
    shot.region.drift = to_vec2(json.at("region").at("drift"));
    shot.analysis = json.contains("analysis") ? whole<int>(json, "analysis") : first_analysis;
    if (json.contains("title")) shot.is_title = json["title"].get<bool>();
    if (json.contains("certainty")) shot.certainty = std::clamp(json["certainty"].get<double>(), 0.0, 1.0);
    if (json.contains("look")) shot.look = look_from_text(json["look"].get<std::string>());
    if (json.contains("print")) {
        shot.print = print_from_text(json["print"].get<std::string>());
        shot.print->sharpness = json.at("sharpness").get<double>();
    }
    if (json.contains("picture"))
        shot.picture = Box{to_vec2(json["picture"].at(0)), to_vec2(json["picture"].at(1))};
    if (json.contains("marks")) shot.marks = to_marks(json["marks"]);
    if (json.contains("stored")) shot.stored = to_stored(json["stored"]);
    return shot;
}

Json to_object(const InnerFilm& film) {
    return {{"width", film.width}, {"height", film.height}, {"shot", to_object(film.shot)}};
}

InnerFilm to_film(const Json& json) {
    InnerFilm film{.shot = to_shot(json.at("shot")),
                   .width = whole<int>(json, "width"),
                   .height = whole<int>(json, "height")};
    if (film.width <= 0 || film.height <= 0 || film.shot.end <= film.shot.begin)
        throw std::runtime_error("record: the film in a photo has no size or no time");
    return film;
}

Json to_object(const Stretch& stretch) {
    return {{"begin_ns", stretch.begin.count()},
            {"end_ns", stretch.end.count()},
            {"shows", name_in(stretches, stretch.kind)}};
}

Stretch to_stretch(const Json& json) {
    return {.begin = std::chrono::nanoseconds(whole<std::int64_t>(json, "begin_ns")),
            .end = std::chrono::nanoseconds(whole<std::int64_t>(json, "end_ns")),
            .kind = value_in(stretches, json, "shows")};
}

std::vector<Stretch> to_stretches(const Json& json) {
    if (json.size() > max_shots) throw std::runtime_error("record: too many stretches between shots");
    std::vector<Stretch> result;
    for (const Json& stretch : json)
        result.push_back(to_stretch(stretch));
    return result;
}

Json to_object(const TimeTaken& taken) {
    return {{"at_ms", taken.at.time_since_epoch().count()},
            {"zone_minutes", taken.zone.count()},
            {"by", name_in(time_sources, taken.source)}};
}

TimeTaken to_taken(const Json& json) {
    using std::chrono::milliseconds;
    constexpr std::int64_t max_time = std::int64_t{1} << 50;  // ms; 35,000 years
    constexpr int max_zone = 24 * 60;                         // minutes
    const TimeTaken taken{
        .at = std::chrono::sys_time<milliseconds>(milliseconds(whole<std::int64_t>(json, "at_ms"))),
        .zone = std::chrono::minutes(whole<int>(json, "zone_minutes")),
        .source = value_in(time_sources, json, "by")};
    if (std::abs(taken.at.time_since_epoch().count()) > max_time || std::abs(taken.zone.count()) > max_zone)
        throw std::runtime_error("record: a time is out of range");
    return taken;
}

MediaOrigin to_origin(const Json& json) {
    MediaOrigin origin;
    if (json.contains("taken")) origin.taken = to_taken(json["taken"]);
    if (json.contains("content_id")) origin.content_id = json["content_id"].get<std::string>();
    if (!origin.content_id.empty() && !is_content_id(origin.content_id))
        throw std::runtime_error("record: 'content_id' is no identifier");
    if (json.contains("caption")) origin.caption = json["caption"].get<std::string>();
    return origin;
}

MediaRecord to_record(const Json& json) {
    const int version = whole<int>(json, "version");
    if (version != MediaRecord::current_version)
        throw std::runtime_error(fmt::format("record: unknown version {}", version));
    MediaRecord record;
    record.path = json.contains("path_hex") ? from_hex(json["path_hex"].get<std::string>())
                                            : json.at("path").get<std::string>();
    record.kind = value_in(kinds, json, "kind");
    record.bytes = whole<std::uint64_t>(json, "bytes");
    record.mtime_ns = whole<std::int64_t>(json, "mtime_ns");
    if (json.contains("inode")) record.inode = whole<std::uint64_t>(json, "inode");
    record.state = value_in(states, json, "state");
    record.is_complete = json.at("complete").get<bool>();
    record.reason = json.at("reason").get<std::string>();
    if (json.contains("fault")) record.fault = to_fault(json["fault"]);
    record.width = whole<int>(json, "width");
    record.height = whole<int>(json, "height");
    record.duration = std::chrono::nanoseconds(whole<std::int64_t>(json, "duration_ns"));
    if (json.at("shots").size() > max_shots) throw std::runtime_error("record: too many shots");
    for (const Json& shot : json.at("shots"))
        record.shots.push_back(to_shot(shot));
    if (json.contains("film")) record.film = to_film(json["film"]);
    if (json.contains("between")) record.between = to_stretches(json["between"]);
    record.origin = to_origin(json);
    if (json.contains("sound")) record.sound = to_sound(json["sound"]);
    return record;
}

}  // namespace

std::string_view name_of(MediaState state) {
    return name_in(states, state);
}

std::string_view name_of(ShotEnd end) {
    return name_in(ends, end);
}

std::string_view name_of(MediaKind kind) {
    return name_in(kinds, kind);
}

std::string to_json(const MediaRecord& record) {
    Json shots = Json::array();
    for (const Shot& shot : record.shots)
        shots.push_back(to_object(shot));
    Json json{{"version", MediaRecord::current_version},
              {"path", record.path},
              {"kind", name_of(record.kind)},
              {"bytes", record.bytes},
              {"mtime_ns", record.mtime_ns},
              {"state", name_of(record.state)},
              {"complete", record.is_complete},
              {"reason", record.reason},
              {"width", record.width},
              {"height", record.height},
              {"duration_ns", record.duration.count()},
              {"shots", shots}};
    if (record.film) json["film"] = to_object(*record.film);
    for (const Stretch& stretch : record.between)
        json["between"].push_back(to_object(stretch));
    if (record.inode != 0) json["inode"] = record.inode;
    if (record.fault != Fault{}) json["fault"] = to_object(record.fault);
    if (record.origin.taken) json["taken"] = to_object(*record.origin.taken);
    if (!record.origin.content_id.empty()) json["content_id"] = record.origin.content_id;
    if (!record.origin.caption.empty()) json["caption"] = record.origin.caption;
    if (record.sound) json["sound"] = to_object(*record.sound);
    if (!is_utf8(record.path)) json["path_hex"] = to_hex(record.path);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

MediaRecord record_from_json(std::string_view text) {
    try {
        return to_record(Json::parse(text));
    } catch (const Json::exception& error) {
        throw std::runtime_error(fmt::format("record: {}", error.what()));
    }
}

}  // namespace vitrine

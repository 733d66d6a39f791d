#include "player/control/player_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

using Json = nlohmann::ordered_json;

// The text of JSON. Bytes that are not UTF-8, as in file names, are replaced.
std::string dumped(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// A label's value. Source: the Prometheus text format, which has three escapes and wants UTF-8.
std::string label(const std::string& text) {
    const std::string json = dumped(text);  // bytes that are not UTF-8 are replaced
    const Json clean = Json::parse(json);
    std::string made;
    for (const char c : clean.get<std::string>()) {
        if (c == '\\' || c == '"') made += '\\';
        if (c == '\n')
            made += "\\n";
        else
            made += c;
    }
    return made;
}

/// Adds an object of the analyzer's; nothing where the text is none.
void add_word(Json& json, const std::string& object) {
    Json said = Json::parse(object, nullptr, false);
    if (said.is_object()) json["analyzer"] = std::move(said);
}

std::string answer(const FileReport& report) {
    if (report.state == "unknown" && !report.reason.empty()) return report.reason;
    if (report.state == "unknown") return "It is not in the media folder, or has not been looked at yet.";
    FileVisibility file = report.visibility;
    if (!report.slots.empty()) file.visibility = Visibility::on_wall;  // the report is newer than the list
    if (file.visibility == Visibility::on_wall && report.is_pinned)
        return "It is on the wall, where it is pinned.";
    if (file.visibility == Visibility::waits_for_turn && report.is_pinned)
        return "It is ready and comes onto the wall next.";
    return sentence(file);
}

class Metrics {
  public:
    void family(const char* name, const char* type, const char* help) {
        text_ += fmt::format("# HELP vitrine_{} {}\n# TYPE vitrine_{} {}\n", name, help, name, type);
        name_ = name;
    }

    void value(double number, const std::string& labels = "") {
        text_ += fmt::format("vitrine_{}{} {}\n", name_, labels.empty() ? "" : "{" + labels + "}", number);
    }

    void only(const char* name, const char* type, const char* help, double number) {
        family(name, type, help);
        value(number);
    }

    const std::string& text() const { return text_; }

  private:
    std::string name_;
    std::string text_;
};

std::string mode_of(const ScreenReport& screen) {
    const std::string rate = screen.refresh > 0 ? fmt::format(" at {:.2f} Hz", screen.refresh) : "";
    return fmt::format("{} {}x{}{}", screen.name, screen.width, screen.height, rate);
}

Json wall_json(const WallReport& wall) {
    const auto leader = std::ranges::find_if(wall.boxes, &WallReport::Box::leads);
    Json boxes = Json::array();
    for (const WallReport::Box& box : wall.boxes)
        boxes.push_back({{"name", box.name},
                         {"leads", box.leads},
                         {"gone", box.is_gone},
                         {"act", box.generation},
                         {"right_clock", box.has_right_clock},
                         {"microseconds_off", box.difference.count()},
                         {"lacks", box.lacking},
                         {"fetch_fault", box.fetch_fault},
                         {"says", in_words(box, leader == wall.boxes.end() ? nullptr : &*leader)}});
    return {{"name", wall.name}, {"this", wall.own}, {"link", wall.link}, {"boxes", std::move(boxes)}};
}

}  // namespace

std::string one_line(const PlayerReport& report) {
    std::string modes;
    for (const ScreenReport& screen : report.screens)
        modes += fmt::format("{}{}", modes.empty() ? "" : ", ", mode_of(screen));
    const std::size_t films = static_cast<std::size_t>(
        std::ranges::count_if(report.sources, [](const SourceReport& one) { return one.tier != "photo"; }));
    const bool is_lit = !report.screens.empty();
    return fmt::format(
        "{}{}{}; {} items of {} files, {} films play, {} to come; {}{} pictures shown, {} late",
        name_of(report.state), report.is_paused ? " (paused)" : "",
        is_lit ? ": " + modes : ": " + report.display, report.cells.size(), report.files, films, report.queue,
        is_lit ? fmt::format("{:.1f} a second, last flip {:.1f} s ago, ", report.rate,
                             std::chrono::duration<double>(report.since_flip).count())
               : "",
        report.pictures, report.late);
}

std::string in_words(const WallReport::Box& box, const WallReport::Box* leader) {
    if (box.is_gone)
        return box.leads ? "leads, and is gone: the others go on with what they show" : "is gone";
    std::string words = box.leads ? "leads" : "follows";
    if (!box.leads && leader == nullptr) return words + ", without a leader so far";
    if (!box.leads) {
        const bool is_in_step = box.run == leader->run && box.generation == leader->generation;
        words += is_in_step ? ", in step" : ", not in step so far";
    }
    if (!box.has_right_clock) return words + ", by its own clock: nobody keeps the system's right";
    words +=
        fmt::format(", its time {:.1f} ms off", std::abs(static_cast<double>(box.difference.count())) / 1000);
    if (!box.lacking.empty()) words += fmt::format("; it lacks {} of the files", box.lacking.size());
    return words;
}

std::string to_json(const PlayerReport& report, const std::string& analyzer,
                    const std::optional<WallReport>& wall) {
    Json json{{"state", name_of(report.state)},
              {"paused", report.is_paused},
              {"display", report.display},
              {"files", report.files},
              {"queue", report.queue},
              {"pictures", report.pictures},
              {"late", report.late},
              {"film_pictures_late", report.film_late},
              {"pictures_per_second", report.rate},
              {"seconds_since_flip", std::chrono::duration<double>(report.since_flip).count()},
              {"pinned", report.pinned},
              {"removed", report.dismissed}};
    Json outputs = Json::array();
    for (const ScreenReport& screen : report.screens)
        outputs.push_back({{"name", screen.name},
                           {"width", screen.width},
                           {"height", screen.height},
                           {"hertz", screen.refresh},
                           {"flips", screen.flips}});
    Json cells = Json::array();
    for (const CellReport& cell : report.cells)
        cells.push_back(
            {{"slot", cell.slot}, {"file", cell.path}, {"shot", cell.shot}, {"pinned", cell.is_pinned}});
    Json sources = Json::array();
    for (const SourceReport& source : report.sources)
        sources.push_back({{"file", source.path},
                           {"pictures", source.tier},
                           {"stored", source.is_stored},
                           {"late", source.late}});
    if (wall) json["wall"] = wall_json(*wall);
    json["faults"] = report.faults;
    json["outputs"] = std::move(outputs);
    json["cells"] = std::move(cells);
    json["sources"] = std::move(sources);
    add_word(json, analyzer);
    return dumped(json);
}

std::string to_json(const FileReport& report, const std::string& analyzer) {
    Json json{{"file", report.path},        {"state", report.state},         {"says", answer(report)},
              {"reason", report.reason},    {"kind", report.kind},           {"width", report.width},
              {"height", report.height},    {"shots", report.shots},         {"slots", report.slots},
              {"pinned", report.is_pinned}, {"removed", report.is_dismissed}};
    if (report.state != "unknown") json["wall"] = name_of(report.visibility.visibility);
    if (!report.places.empty()) json["places"] = report.places;
    add_word(json, analyzer);
    return dumped(json);
}

std::string to_metrics(const PlayerReport& report, std::optional<double> degrees,
                       const std::vector<std::pair<std::string, std::size_t>>& states) {
    Metrics metrics;
    metrics.family("state", "gauge", "1 for the present state of the screen.");
    for (const ShowState state :
         {ShowState::showing, ShowState::no_content, ShowState::no_panel, ShowState::off, ShowState::no_flip})
        metrics.value(state == report.state ? 1 : 0, fmt::format("state=\"{}\"", name_of(state)));
    metrics.only("frames_shown_total", "counter", "Pictures shown.", static_cast<double>(report.pictures));
    metrics.only("frames_late_total", "counter", "Pictures that were left out because they came too late.",
                 static_cast<double>(report.late));
    metrics.only("film_frames_late_total", "counter", "Pictures of films that came too late.",
                 static_cast<double>(report.film_late));
    metrics.family("flips_total", "counter", "Pictures that have reached an output.");
    for (const ScreenReport& screen : report.screens)
        metrics.value(static_cast<double>(screen.flips), fmt::format("output=\"{}\"", label(screen.name)));
    metrics.only("seconds_since_flip", "gauge", "Longest time that an output has waited for a picture.",
                 std::chrono::duration<double>(report.since_flip).count());
    metrics.only("items", "gauge", "Cells on the wall.", static_cast<double>(report.cells.size()));
    metrics.only("queue", "gauge", "Sources that have no picture yet.", static_cast<double>(report.queue));
    metrics.family("sources", "gauge", "Sources by the share of their pictures that is decoded.");
    for (const char* tier : {"photo", "all", "reference", "key", "still"})
        metrics.value(static_cast<double>(std::ranges::count(report.sources, tier, &SourceReport::tier)),
                      fmt::format("tier=\"{}\"", tier));
    metrics.family("source_tier", "gauge",
                   "1 for each source, with the share of its pictures that is decoded.");
    for (std::size_t i = 0; i < report.sources.size(); ++i)
        metrics.value(1, fmt::format("source=\"{}\",file=\"{}\",tier=\"{}\"", i,
                                     label(report.sources[i].path), report.sources[i].tier));
    metrics.family("files", "gauge", "Files of the media folder by state.");
    for (const auto& [state, count] : states)
        metrics.value(static_cast<double>(count), fmt::format("state=\"{}\"", label(state)));
    if (degrees)
        metrics.only("temperature_celsius", "gauge", "Temperature of the hottest thermal zone.", *degrees);
    return metrics.text();
}

}  // namespace vitrine::player

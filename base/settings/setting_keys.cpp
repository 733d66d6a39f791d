#include "base/settings/setting_keys.hpp"

#include "base/media/colour.hpp"
#include "base/settings/output_words.hpp"

#include <fmt/format.h>

#include <charconv>
#include <initializer_list>
#include <stdexcept>
#include <utility>
#include <vector>

// All keys: what the file, the command line and the test of config/vitrine.toml are made of.

namespace vitrine {

namespace {

/// Where a key is kept: the member's address in any Settings.
template <typename T> using Member = std::function<T&(Settings&)>;

template <typename T> const T& read(const Member<T>& member, const Settings& settings) {
    return member(const_cast<Settings&>(settings));  // the member function only hands the address on
}

[[noreturn]] void refuse() {
    throw std::invalid_argument("not allowed");
}

std::int64_t whole_number(const SettingValue& value, std::int64_t least, std::int64_t most) {
    const auto* number = std::get_if<std::int64_t>(&value);
    if (number == nullptr || *number < least || *number > most) refuse();
    return *number;
}

SettingKey whole(std::string name, const Member<int>& member, int least, int most) {
    return {
        .name = std::move(name),
        .allowed = fmt::format("a whole number from {} to {}", least, most),
        .assign = [=](Settings& s,
                      const SettingValue& v) { member(s) = static_cast<int>(whole_number(v, least, most)); },
        .text = [=](const Settings& s) { return fmt::format("{}", read(member, s)); }};
}

SettingKey bytes(std::string name, const Member<std::int64_t>& member, std::int64_t most) {
    return {.name = std::move(name),
            .allowed = fmt::format("a whole number from 0 to {}", most),
            .assign = [=](Settings& s, const SettingValue& v) { member(s) = whole_number(v, 0, most); },
            .text = [=](const Settings& s) { return fmt::format("{}", read(member, s)); }};
}

SettingKey number(std::string name, const Member<double>& member, double least, double most) {
    return {.name = std::move(name),
            .allowed = fmt::format("a number from {} to {}", least, most),
            .assign =
                [=](Settings& s, const SettingValue& v) {
                    const auto* whole_value = std::get_if<std::int64_t>(&v);
                    const auto* value = std::get_if<double>(&v);
                    if (whole_value == nullptr && value == nullptr) refuse();
                    const double x = value != nullptr ? *value : static_cast<double>(*whole_value);
                    if (!(x >= least && x <= most)) refuse();
                    member(s) = x;
                },
            .text = [=](const Settings& s) { return fmt::format("{}", read(member, s)); }};
}

template <typename Duration>
SettingKey duration(const std::string& name, const Member<Duration>& member, std::int64_t least,
                    std::int64_t most) {
    return {.name = name,
            .allowed = fmt::format("a whole number from {} to {}", least, most),
            .assign = [=](Settings& s,
                          const SettingValue& v) { member(s) = Duration(whole_number(v, least, most)); },
            .text = [=](const Settings& s) { return fmt::format("{}", read(member, s).count()); }};
}

SettingKey text(std::string name, const Member<std::string>& member, std::string allowed,
                const std::function<bool(const std::string&)>& is_allowed) {
    return {.name = std::move(name),
            .allowed = std::move(allowed),
            .assign =
                [=](Settings& s, const SettingValue& v) {
                    const auto* value = std::get_if<std::string>(&v);
                    if (value == nullptr || !is_allowed(*value)) refuse();
                    member(s) = *value;
                },
            .text = [=](const Settings& s) { return fmt::format("\"{}\"", read(member, s)); }};
}

/// The word that stands in the file for each value of an enum.
template <typename Enum> using Words = std::vector<std::pair<std::string_view, Enum>>;

template <typename Enum> std::string list_of(const Words<Enum>& words) {
    std::string list;
    for (const auto& [word, value] : words)
        list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", word);
    return list;
}

template <typename Enum>
SettingKey choice(std::string name, const Member<Enum>& member, const Words<Enum>& words) {
    return {.name = std::move(name),
            .allowed = "one of " + list_of(words),
            .assign =
                [=](Settings& s, const SettingValue& v) {
                    const auto* text = std::get_if<std::string>(&v);
                    if (text == nullptr) refuse();
                    for (const auto& [word, value] : words) {
                        if (word != *text) continue;
                        member(s) = value;
                        return;
                    }
                    refuse();
                },
            .text =
                [=](const Settings& s) {
                    const Enum value = read(member, s);
                    for (const auto& [word, known] : words)
                        if (known == value) return fmt::format("\"{}\"", word);
                    return std::string("\"\"");
                }};
}

SettingKey path(std::string name, const Member<std::string>& member) {
    return text(std::move(name), member, "a path", [](const std::string& value) { return !value.empty(); });
}

SettingKey optional_path(std::string name, const Member<std::string>& member) {
    return text(std::move(name), member, "a path, or nothing", [](const std::string&) { return true; });
}

SettingKey rotation(std::string name, const Member<int>& member) {
    SettingKey key = whole(std::move(name), member, 0, 270);
    key.allowed = "0, 90, 180 or 270";
    key.assign = [assign = key.assign](Settings& s, const SettingValue& v) {
        if (whole_number(v, 0, 270) % 90 != 0) refuse();
        assign(s, v);
    };
    return key;
}

bool is_folder_name(const std::string& value) {
    constexpr std::size_t longest = 64;
    return value != "." && value != ".." && value.size() <= longest && value.find('/') == std::string::npos;
}

bool is_colour(const std::string& value) {
    return colour_named(value).has_value();
}

bool is_size(std::string_view value) {
    int width = 0;
    int height = 0;
    const char* end = value.data() + value.size();
    const auto [after_width, width_error] = std::from_chars(value.data(), end, width);
    if (width_error != std::errc() || after_width == end || *after_width != 'x') return false;
    const auto [after_height, height_error] = std::from_chars(after_width + 1, end, height);
    return height_error == std::errc() && after_height == end && width >= 16 && height >= 16 &&
           width <= 16384 && height <= 16384;
}

bool is_screen(const std::string& value) {
    if (value == "kms") return true;
    if (value.starts_with("kms:/")) return true;
    if (!value.starts_with("offscreen:")) return false;
    std::string_view rest = std::string_view(value).substr(10);
    for (std::size_t plus = 0; (plus = rest.find('+')) != std::string_view::npos;
         rest.remove_prefix(plus + 1))
        if (!is_size(rest.substr(0, plus))) return false;
    return is_size(rest);
}

void append(std::vector<SettingKey>& keys, std::initializer_list<SettingKey> more) {
    keys.insert(keys.end(), more);
}

void append_analyzer_keys(std::vector<SettingKey>& keys) {
    using S = Settings;
    append(
        keys,
        {
            whole(
                "analyzer.children", [](S& s) -> int& { return s.analyzer.children; }, 0, 64),
            duration<std::chrono::seconds>(
                "analyzer.deadline_seconds", [](S & s) -> auto& { return s.analyzer.deadline; }, 1, 86400),
            number(
                "analyzer.deadline_seconds_per_mebibyte",
                [](S& s) -> double& { return s.analyzer.deadline_per_mebibyte; }, 0, 3600),
            whole(
                "analyzer.memory_mebibytes", [](S& s) -> int& { return s.analyzer.memory; }, 256, 1048576),
            duration<std::chrono::seconds>(
                "analyzer.rescan_seconds", [](S & s) -> auto& { return s.analyzer.rescan; }, 1, 86400),
            duration<std::chrono::milliseconds>(
                "analyzer.quiet_milliseconds", [](S & s) -> auto& { return s.analyzer.quiet; }, 0, 600000),
            whole(
                "analyzer.frame_size", [](S& s) -> int& { return s.analyzer.frame_size; }, 64, 1024),
            number(
                "analyzer.samples_per_second", [](S& s) -> double& { return s.analyzer.samples_per_second; },
                0.1, 120),
            number(
                "analyzer.motion_weight", [](S& s) -> double& { return s.analyzer.motion_weight; }, 0, 1),
            number(
                "analyzer.image_weight", [](S& s) -> double& { return s.analyzer.image_weight; }, 0, 1),
            number(
                "analyzer.face_weight", [](S& s) -> double& { return s.analyzer.face_weight; }, 0, 1),
            optional_path(
                "analyzer.saliency_model", [](S & s) -> auto& { return s.analyzer.saliency_model; }),
            optional_path(
                "analyzer.face_model", [](S & s) -> auto& { return s.analyzer.face_model; }),
            optional_path(
                "analyzer.face_cascade", [](S & s) -> auto& { return s.analyzer.face_cascade; }),
            choice<RegionMode>("analyzer.region", [](S & s) -> auto& { return s.analyzer.region; },
                               {{"min_area", RegionMode::min_area}, {"hull", RegionMode::hull}}),
            number(
                "analyzer.region_mass", [](S& s) -> double& { return s.analyzer.region_mass; }, 0.05, 0.99),
            number(
                "analyzer.region_margin", [](S& s) -> double& { return s.analyzer.region_margin; }, 0, 0.2),
        });
}

void append_player_keys(std::vector<SettingKey>& keys) {
    using S = Settings;
    append(
        keys,
        {
            whole(
                "layout.slots", [](S& s) -> int& { return s.layout.slots; }, 1, 64),
            whole(
                "layout.seed", [](S& s) -> int& { return s.layout.seed; }, 0, 2147483647),
            choice<EnergyMode>("layout.energy", [](S & s) -> auto& { return s.layout.energy; },
                               {{"screen", EnergyMode::screen}, {"paper", EnergyMode::paper}}),
            choice<LayoutOrder>("layout.order", [](S & s) -> auto& { return s.layout.order; },
                                {{"free", LayoutOrder::free}, {"reading", LayoutOrder::reading}}),
            number(
                "layout.max_enlargement", [](S& s) -> double& { return s.layout.max_enlargement; }, 0.1, 100),
            number(
                "layout.clearance_pixels", [](S& s) -> double& { return s.layout.clearance; }, 0, 200),
            choice<CellMethod>("layout.cells", [](S & s) -> auto& { return s.layout.cells; },
                               {{"exact", CellMethod::exact}, {"sampled", CellMethod::sampled}}),
            number(
                "layout.sample_pixels", [](S& s) -> double& { return s.layout.sample_spacing; }, 2, 200),
            number(
                "layout.gutter_pixels", [](S& s) -> double& { return s.layout.gutter; }, 0, 200),
            number(
                "layout.corner_radius_pixels", [](S& s) -> double& { return s.layout.corner_radius; }, 0,
                500),
            number(
                "layout.feather_pixels", [](S& s) -> double& { return s.layout.feather; }, 1, 200),
            choice<WallMode>("layout.mode", [](S & s) -> auto& { return s.layout.mode; },
                             {{"fit", WallMode::fit}, {"pan", WallMode::pan}}),
            choice<FolderMode>("layout.folders", [](S & s) -> auto& { return s.layout.folders; },
                               {{"flat", FolderMode::flat}, {"nested", FolderMode::nested}}),
            choice<ShotOrder>(
                "show.order", [](S & s) -> auto& { return s.show.order; },
                {{"shuffle", ShotOrder::shuffle}, {"name", ShotOrder::name}, {"newest", ShotOrder::newest}}),
            choice<FilmShow>("show.film", [](S & s) -> auto& { return s.show.film; },
                             {{"side_by_side", FilmShow::side_by_side}, {"sequence", FilmShow::sequence}}),
            duration<std::chrono::seconds>(
                "show.dwell_seconds", [](S & s) -> auto& { return s.show.dwell; }, 1, 86400),
            duration<std::chrono::seconds>(
                "show.longest_seconds", [](S & s) -> auto& { return s.show.longest; }, 1, 86400),
            duration<std::chrono::milliseconds>(
                "show.crossfade_milliseconds", [](S & s) -> auto& { return s.show.crossfade; }, 0, 10000),
            duration<std::chrono::milliseconds>(
                "show.motion_milliseconds", [](S & s) -> auto& { return s.show.motion; }, 0, 10000),
            number(
                "show.pan_pixels_per_second", [](S& s) -> double& { return s.show.pan_speed; }, 1, 2000),
            text(
                "show.background", [](S & s) -> auto& { return s.show.background; },
                "a colour like \"#101014\"", is_colour),
            text(
                "input.devices", [](S & s) -> auto& { return s.input.devices; },
                "\"auto\", \"none\" or device nodes like \"/dev/input/event3\", separated by commas",
                [](const std::string& value) {
                    return value == "auto" || value == "none" || value.starts_with('/');
                }),
            duration<std::chrono::seconds>(
                "input.idle_seconds", [](S & s) -> auto& { return s.input.idle; }, 1, 86400),
            text(
                "output.screen", [](S & s) -> auto& { return s.output.screen; },
                "\"kms\", \"kms:/dev/dri/cardN\" or \"offscreen:WIDTHxHEIGHT\", with \"+WIDTHxHEIGHT\" for "
                "more",
                is_screen),
            text(
                "output.mode", [](S & s) -> auto& { return s.output.mode; },
                "a mode like \"1920x1080\" or \"1920x1080@60\", or outputs with modes like "
                "\"HDMI-A-1=1920x1080, HDMI-A-2=1280x720@50\"",
                [](const std::string& value) { return modes_named(value).has_value(); }),
            rotation("output.rotation", [](S& s) -> int& { return s.output.rotation; }),
            text(
                "output.margins", [](S & s) -> auto& { return s.output.margins; },
                "one or four of pixels or per cent, like \"2.5%\" or \"24,0,24,0\"",
                [](const std::string& value) { return margins_named(value).has_value(); }),
            text(
                "output.folders", [](S & s) -> auto& { return s.output.folders; },
                "outputs with folders below the media folder, like \"HDMI-A-1=lobby, HDMI-A-2=hall\"",
                [](const std::string& value) { return output_folders_named(value).has_value(); }),
            whole(
                "output.frame_rate", [](S& s) -> int& { return s.output.frame_rate; }, 1, 240),
            choice<DecoderChoice>(
                "output.decoders", [](S & s) -> auto& { return s.output.decoders; },
                {{"auto", DecoderChoice::automatic}, {"processor", DecoderChoice::processor}}),
            choice<KmsApi>("output.api", [](S & s) -> auto& { return s.output.api; },
                           {{"best", KmsApi::best}, {"legacy", KmsApi::legacy}}),
            text(
                "output.sound", [](S & s) -> auto& { return s.output.sound; },
                "a device of ALSA like \"default\", or nothing", [](const std::string&) { return true; }),
        });
}

std::vector<SettingKey> make_keys() {
    using S = Settings;
    std::vector<SettingKey> keys;
    append(keys, {
                     path(
                         "media.root", [](S & s) -> auto& { return s.media.root; }),
                     path(
                         "state.directory", [](S & s) -> auto& { return s.state.directory; }),
                     bytes(
                         "store.max_bytes", [](S & s) -> auto& { return s.store.max_bytes; },
                         std::int64_t{1} << 50),
                     whole(
                         "store.clip_size", [](S& s) -> int& { return s.store.clip_size; }, 0, 4096),
                     bytes(
                         "tapestry.max_bytes", [](S & s) -> auto& { return s.tapestry.max_bytes; },
                         std::int64_t{1} << 50),
                     text(
                         "status.folder", [](S & s) -> auto& { return s.status.folder; },
                         "the name of a folder, or nothing", is_folder_name),
                     choice<log::Level>("log.level", [](S & s) -> auto& { return s.log.level; },
                                        {{"error", log::Level::error},
                                         {"warning", log::Level::warning},
                                         {"info", log::Level::info},
                                         {"debug", log::Level::debug}}),
                     optional_path(
                         "metrics.file", [](S & s) -> auto& { return s.metrics.file; }),
                 });
    append_analyzer_keys(keys);
    append_player_keys(keys);
    return keys;
}

}  // namespace

std::span<const SettingKey> setting_keys() {
    static const std::vector<SettingKey> keys = make_keys();
    return keys;
}

const SettingKey* find_setting_key(std::string_view name) {
    for (const SettingKey& key : setting_keys())
        if (key.name == name) return &key;
    return nullptr;
}

}  // namespace vitrine

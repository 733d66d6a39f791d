#include "base/settings/setting_keys.hpp"

#include "base/calendar/dates.hpp"
#include "base/calendar/day_windows.hpp"
#include "base/media/colour.hpp"
#include "base/settings/canvas_words.hpp"
#include "base/settings/output_words.hpp"
#include "base/wall/wall_name.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace vitrine {

namespace {

using S = Settings;

constexpr std::int64_t max_space = std::int64_t{1} << 50;  // bytes

bool is_any(const std::string& /*value*/) {
    return true;
}

bool is_not_empty(const std::string& value) {
    return !value.empty();
}

bool is_folder_name(const std::string& value) {
    constexpr std::size_t max_length = 64;
    return value != "." && value != ".." && value.size() <= max_length &&
           value.find('/') == std::string::npos;
}

bool is_colour(const std::string& value) {
    return colour_named(value).has_value();
}

/// The kinds of displays, which player/display/display_kinds.cpp makes.
bool is_screen(const std::string& value) {
    constexpr std::string_view offscreen = "offscreen:";
    if (value == "kms" || value.starts_with("kms:/")) return true;
    return value.starts_with(offscreen) && screen_sizes_named(value.substr(offscreen.size())).has_value();
}

bool is_device_list(const std::string& value) {
    return value == "auto" || value == "none" || value.starts_with('/');
}

bool is_wall_name_or_empty(const std::string& value) {
    return value.empty() || is_wall_name(value);
}

std::string fault_of_wall_name(const std::string& value) {
    return wall_name_fault(value);
}

/// A host name, an address, or nothing.
bool is_host(const std::string& value) {
    constexpr std::size_t max_length = 253;
    constexpr std::string_view inner = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.:%";
    return value.size() <= max_length && !value.starts_with('-') &&
           value.find_first_not_of(inner) == std::string::npos;
}

/// A path of a socket, for which the kernel has little room.
bool is_socket_path(const std::string& value) {
    constexpr std::size_t max_length = 107;
    return value.starts_with('/') && value.size() <= max_length;
}

constexpr auto keys = std::to_array<SettingKey>({
    {"media.root", text<&S::media, &S::Media::root>("a path", is_not_empty), SettingEffect::restart,
     "The folder that Vitrine watches and plays, with all its sub-folders. Operators drop their files here."},
    {"state.directory", text<&S::state, &S::State::directory>("a path", is_not_empty), SettingEffect::restart,
     "The folder for the catalogue and everything else that Vitrine makes. All of it is made from the media "
     "files and can be deleted."},
    {"store.max_bytes", whole<&S::store, &S::Store::max_bytes>(0, max_space), SettingEffect::analyzer,
     "Bytes in the state directory for copies of photos and clips of films. The wall plays these, not the "
     "files in the media folder. When the space is used up, the least recently played ones are deleted; the "
     "wall then plays their files from the media folder. 0: the wall plays everything from the media "
     "folder."},
    {"store.clip_size", whole<&S::store, &S::Store::clip_size>(0, 4096), SettingEffect::analyzer,
     "Longest side of a clip in pixels. A clip is never larger than its film. Larger clips are sharper in "
     "large cells and take more processor time to make and to play. 0: as large as layout.slots makes the "
     "cells on the screens that the player has found, or on a screen 1920 pixels wide before it has found "
     "one."},
    {"tapestry.max_bytes", whole<&S::tapestry, &S::Tapestry::max_bytes>(0, max_space), SettingEffect::restart,
     "Bytes in the state directory for the tapestries of films. A tapestry is a whole film as one picture "
     "that visitors zoom into. The analyzer makes them one after another while it has no file to analyse, "
     "with the processor time that is left. When the space is used up, the tapestry that nobody has looked at"
     " for the longest time is deleted. No film gets more than a quarter of the space. 0: there are no "
     "tapestries."},
    {"tapestry.height", whole<&S::tapestry, &S::Tapestry::height>(0, 600), SettingEffect::analyzer,
     "Height of a tapestry in pixels. It is never taller than one and a half times its film. A taller one is "
     "sharper on large screens, and takes more processor time and space. Each film is first woven 150 pixels "
     "tall, "
     "which takes little time. 0: as tall as the screens need that the player has found, or a screen 1920 "
     "pixels "
     "wide before it has found one."},
    {"status.folder",
     text<&S::status, &S::Status::folder>("the name of a folder, or nothing", is_folder_name),
     SettingEffect::restart,
     "Name of a folder in the media folder, for the people who drop files. Its files status.txt and "
     "index.html say for each file if it is on the wall, and if not, why. Empty: there is no such folder."},
    {"status.played", flag<&S::status, &S::Status::played>(), SettingEffect::restart,
     "Counts for how many seconds each file is seen, day by day. The folder \"played\" of the status folder "
     "has "
     "a table of each of the last 400 days. Needs status.folder."},
    {"log.level",
     choice<&S::log, &S::Log::level>({{{"error", log::Level::error},
                                       {"warning", log::Level::warning},
                                       {"info", log::Level::info},
                                       {"debug", log::Level::debug}}}),
     SettingEffect::now,
     "Lines that are logged: \"error\", \"warning\", \"info\" or \"debug\". Each level includes the levels "
     "before it."},
    {"metrics.file", text<&S::metrics, &S::Metrics::file>("a path, or nothing", is_any), SettingEffect::now,
     "A file into which the player writes its figures every 15 s, for the text file collector of Prometheus' "
     "node exporter (--collector.textfile.directory). Its name ends with \".prom\". The service may write "
     "\"/run/vitrine/vitrine.prom\". Empty: no file."},
    {"analyzer.children", whole<&S::analyzer, &S::Analyzer::children>(0, 64), SettingEffect::analyzer,
     "Number of files that are analysed at the same time, each in a process of its own. One more process "
     "takes files of up to 16 MiB, so that no photo waits for a film. More processes finish a large copy "
     "sooner and leave less processor time for the player. 0: one for every two cores."},
    {"analyzer.deadline_seconds", whole<&S::analyzer, &S::Analyzer::deadline>(1, 86400),
     SettingEffect::analyzer,
     "Processor time in seconds that the analysis of one file may take without progress, plus so many "
     "seconds "
     "for each MiB of the file. Each decoded picture is progress, so a film may take as long as it needs. "
     "The "
     "same time without any computing means that the file's disk or share does not answer."},
    {"analyzer.deadline_seconds_per_mebibyte",
     number<&S::analyzer, &S::Analyzer::deadline_per_mebibyte>(0, 3600),
     SettingEffect::analyzer,
     {}},
    {"analyzer.memory_mebibytes", whole<&S::analyzer, &S::Analyzer::memory>(256, 1048576),
     SettingEffect::analyzer,
     "MiB of memory that one analysing process may allocate. A file that needs more is not shown."},
    {"analyzer.rescan_seconds", whole<&S::analyzer, &S::Analyzer::rescan>(1, 86400), SettingEffect::analyzer,
     "Seconds between two searches through the whole media folder. They find the changes that the kernel does"
     " not report (network mounts)."},
    {"analyzer.quiet_milliseconds", whole<&S::analyzer, &S::Analyzer::quiet>(0, 600000),
     SettingEffect::analyzer,
     "Milliseconds that a file must stay unchanged before it is analysed. 150 ms are enough if the kernel of "
     "this machine reports that the writer has closed the file; it cannot report that for a writer on a "
     "network share. A longer time is safer with slow copies; a shorter time shows files sooner."},
    {"analyzer.frame_size", whole<&S::analyzer, &S::Analyzer::frame_size>(64, 1024), SettingEffect::analyzer,
     "Longest side, in pixels, at which frames of films are analysed. Photos are analysed at twice that size."
     " A larger size finds smaller things and takes longer."},
    {"analyzer.samples_per_second", number<&S::analyzer, &S::Analyzer::samples_per_second>(0.1, 120),
     SettingEffect::analyzer,
     "Frames of each second of a film that are searched for what matters. A higher rate follows fast subjects"
     " better and takes longer."},
    {"analyzer.motion_weight", number<&S::analyzer, &S::Analyzer::motion_weight>(0, 1),
     SettingEffect::analyzer,
     "Weights of motion, of the picture itself and of faces in the search for what matters (paper 1, eq. "
     "3.2). Faces already count in the weight of the picture itself."},
    {"analyzer.image_weight",
     number<&S::analyzer, &S::Analyzer::image_weight>(0, 1),
     SettingEffect::analyzer,
     {}},
    {"analyzer.face_weight",
     number<&S::analyzer, &S::Analyzer::face_weight>(0, 1),
     SettingEffect::analyzer,
     {}},
    {"analyzer.saliency",
     choice<&S::analyzer, &S::Analyzer::saliency>({{{"network", SaliencyMethod::network},
                                                    {"student", SaliencyMethod::student},
                                                    {"plain", SaliencyMethod::plain}}}),
     SettingEffect::analyzer,
     "How the important part of a picture is found. \"network\": a neural network knows things. It takes "
     "about half a second of processor time for a photo and runs while nothing else is to be analysed. Until "
     "then the wall shows the photo with the plain region. In a film it looks at a few small frames of each "
     "shot. \"student\": a small network that has learnt from it looks at each photo at once, and more often "
     "at films. It takes a tenth of the time, and regions are larger. \"plain\": by contrast, motion, place "
     "and faces only."},
    {"analyzer.saliency_model",
     text<&S::analyzer, &S::Analyzer::saliency_model>("a path, or nothing", is_any), SettingEffect::analyzer,
     "The ONNX file of that network. It declares one input of 320 x 320 and its first output is one map, as "
     "U2-Net's is. Each picture is shown to it in the picture's own shape. The default comes with the "
     "analyzer. Empty, or if the file is missing: the plain method."},
    {"analyzer.student_model", text<&S::analyzer, &S::Analyzer::student_model>("a path, or nothing", is_any),
     SettingEffect::analyzer,
     "The ONNX file of the small network. It declares one input of 160 x 160 and its first output is one "
     "map. "
     "With `analyzer.saliency = \"network\"` it looks at those shots of films for which the large network "
     "would take too long. The default comes with the analyzer. Empty, or if the file is missing: the plain "
     "method, also for those shots."},
    {"analyzer.text_model", text<&S::analyzer, &S::Analyzer::text_model>("a path, or nothing", is_any),
     SettingEffect::analyzer,
     "An ONNX file that finds lines of text, so that none is cut. It takes a picture and gives a map of "
     "lines, "
     "as the detectors of PP-OCR do. It is used where `analyzer.saliency` is \"network\". The default comes "
     "with the analyzer. Empty, or if the file is missing: lines of text are not searched for."},
    {"analyzer.face_model", text<&S::analyzer, &S::Analyzer::face_model>("a path, or nothing", is_any),
     SettingEffect::analyzer,
     "An ONNX file of the YuNet face detector. It finds more faces than the cascade, and faster. Empty: the "
     "cascade. The default comes with the analyzer; if it is missing, the cascade is used."},
    {"analyzer.face_cascade", text<&S::analyzer, &S::Analyzer::face_cascade>("a path, or nothing", is_any),
     SettingEffect::analyzer,
     "The Viola-Jones cascade that finds faces if there is no face model. Empty: faces are not searched "
     "for."},
    {"analyzer.region",
     choice<&S::analyzer, &S::Analyzer::region>(
         {{{"min_area", RegionMode::min_area}, {"hull", RegionMode::hull}}}),
     SettingEffect::analyzer,
     "Shape of the region that must not be covered. \"min_area\": the smallest convex region that contains "
     "enough of what matters. \"hull\": the paper's methods for saliency, motion and region, with the "
     "cascade for faces, for comparison; its regions are mostly far larger."},
    {"analyzer.region_mass", number<&S::analyzer, &S::Analyzer::region_mass>(0.05, 0.99),
     SettingEffect::analyzer,
     "If this share of what matters fits into 40 % of the picture, the region is not larger than that. If "
     "not, it is not clear what matters, and the region contains 95 % of it. A higher share makes more "
     "regions large: it "
     "protects more and packs less densely."},
    {"analyzer.region_margin", number<&S::analyzer, &S::Analyzer::region_margin>(0, 0.2),
     SettingEffect::analyzer, "Margin around the region, as a share of the picture's diagonal."},
    {"layout.slots", whole<&S::layout, &S::Layout::slots>(1, 64), SettingEffect::new_walls,
     "Number of shots on the wall at the same time. With more shots each is smaller, and the wall takes more "
     "processor time."},
    {"layout.seed", whole<&S::layout, &S::Layout::seed>(0, 2147483647), SettingEffect::new_walls,
     "Start value of every random choice. The same seed with the same media gives the same wall."},
    {"layout.energy",
     choice<&S::layout, &S::Layout::energy>({{{"screen", EnergyMode::screen}, {"paper", EnergyMode::paper}}}),
     SettingEffect::new_walls,
     "Quantity that the packing minimises. \"screen\": the share of the screen that shows nothing that "
     "matters. \"paper\": equation 3.4 of the paper, for comparison."},
    {"layout.order",
     choice<&S::layout, &S::Layout::order>(
         {{{"free", LayoutOrder::free}, {"reading", LayoutOrder::reading}}}),
     SettingEffect::new_walls,
     "Places of the shots. \"free\": each is placed where it fits best. \"reading\": they keep the order of "
     "show.order, in lines from the top and from left to right; what matters then covers some 8 % less of the"
     " screen."},
    {"layout.neighbours",
     choice<&S::layout, &S::Layout::neighbours>(
         {{{"any", NeighbourChoice::any}, {"alike", NeighbourChoice::alike}}}),
     SettingEffect::new_walls,
     "Shots that stand beside each other on a new wall. \"alike\": those that were taken together or have "
     "like"
     " colours, where packing allows; what matters covers at most 3 % less of the screen. For flat walls in "
     "free order."},
    {"layout.max_enlargement", number<&S::layout, &S::Layout::max_enlargement>(0.1, 100),
     SettingEffect::new_walls,
     "Limit of enlargement, in screen pixels per picture pixel. A higher limit fills the screen with small "
     "pictures, but they are blurred."},
    {"layout.clearance_pixels", number<&S::layout, &S::Layout::clearance>(0, 200), SettingEffect::new_walls,
     "Screen pixels kept free between the regions of two neighbours."},
    {"layout.cells",
     choice<&S::layout, &S::Layout::cells>(
         {{{"taut", CellMethod::taut}, {"exact", CellMethod::exact}, {"sampled", CellMethod::sampled}}}),
     SettingEffect::new_walls,
     "Method that divides the space between the regions. \"taut\": the border of two neighbours is the "
     "shortest way between their regions. \"exact\": the border lies in the middle between the regions, "
     "which "
     "is the Voronoi diagram of their outlines. \"sampled\": the paper's method with points along the "
     "outlines, for comparison; it may cut into "
     "regions."},
    {"layout.sample_pixels", number<&S::layout, &S::Layout::sample_spacing>(2, 200), SettingEffect::new_walls,
     "Screen pixels between two of these points. A larger distance is faster and cuts deeper into regions."},
    {"layout.look",
     choice<&S::layout, &S::Layout::look>(
         {{{"seamless", WallLook::seamless}, {"tiles", WallLook::tiles}, {"soft", WallLook::soft}}}),
     SettingEffect::new_walls,
     "Look of the pictures' edges. \"seamless\": pictures are cut edge to edge. \"tiles\": a thin gutter is "
     "between them, and their corners are round. \"soft\": neighbours fade into each other. The look gives "
     "the "
     "next three keys their values where these are -1."},
    {"layout.gutter_pixels", number<&S::layout, &S::Layout::gutter>(-1, 200), SettingEffect::new_walls,
     "Screen pixels left free between two cells. A gutter never cuts into a region; regions keep at least so "
     "far apart. -1: as layout.look has it."},
    {"layout.corner_radius_pixels", number<&S::layout, &S::Layout::corner_radius>(-1, 500),
     SettingEffect::new_walls,
     "Radius of the rounded corners of the cells, in screen pixels. A corner never cuts into a region. "
     "Where several taut borders meet, corners are round only if there is a gutter. -1: as layout.look has "
     "it."},
    {"layout.feather_pixels", number<&S::layout, &S::Layout::feather>(-1, 200), SettingEffect::new_walls,
     "Screen pixels over which neighbours fade into each other, fewer where a region is nearer. 1 or less: a "
     "clean cut. -1: as layout.look has it."},
    {"layout.mode", choice<&S::layout, &S::Layout::mode>({{{"fit", WallMode::fit}, {"pan", WallMode::pan}}}),
     SettingEffect::new_walls,
     "\"fit\": all slots are on one screen. \"pan\": the wall is as high as the screen, continues to the "
     "right and passes by slowly; each screen's width of it has as many shots as there are slots."},
    {"layout.folders",
     choice<&S::layout, &S::Layout::folders>({{{"flat", FolderMode::flat}, {"nested", FolderMode::nested}}}),
     SettingEffect::new_walls,
     "\"nested\": each folder is one place with several of its shots, beside loose files, and opens by a "
     "touch; "
     "layout.slots counts folders and files. \"flat\": folders are ignored."},
    {"show.order",
     choice<&S::show, &S::Show::order>({{{"shuffle", ShotOrder::shuffle},
                                         {"name", ShotOrder::name},
                                         {"newest", ShotOrder::newest},
                                         {"taken", ShotOrder::taken}}}),
     SettingEffect::new_walls,
     "Order in which shots take their turn: \"shuffle\", \"name\", \"newest\" by the file's time, or "
     "\"taken\" by the time that the camera wrote, the earliest first. New files always come first."},
    {"show.film",
     choice<&S::show, &S::Show::film>({{{"auto", FilmShow::automatic},
                                        {"side_by_side", FilmShow::side_by_side},
                                        {"sequence", FilmShow::sequence}}}),
     SettingEffect::new_walls,
     "Display of a film with many shots. \"side_by_side\": its shots may be beside each other. Every shot of "
     "all files is shown once before any is shown again, so a long film fills the wall once the other files "
     "have been shown. \"sequence\": the film has one place, where its shots follow each other in time; "
     "meanwhile the other files are shown again. If the film is alone on the wall, each of its shots plays "
     "once, and they leave one after another, overlapping in time. \"auto\": \"sequence\" for a film that is "
     "alone on the wall, else \"side_by_side\"."},
    {"show.dwell_seconds", whole<&S::show, &S::Show::dwell>(1, 86400), SettingEffect::new_walls,
     "Seconds that a shot keeps its slot while others wait. A film's shot leaves at the end of a loop."},
    {"show.longest_seconds", whole<&S::show, &S::Show::longest>(1, 86400), SettingEffect::new_walls,
     "Seconds after which a film's shot leaves even if its loop has not ended."},
    {"show.motion_milliseconds", whole<&S::show, &S::Show::motion>(0, 10000), SettingEffect::new_walls,
     "Milliseconds of a change of the wall: shots leave, come and move at the same time. 0: without motion."
     " However short, at most two changes begin in a second, so that bright and dark pictures do not flash."},
    {"show.calm", flag<&S::show, &S::Show::calm>(), SettingEffect::new_walls,
     "true: a calm wall, as museums want it. Shots fade and do not move; at most one change begins in 5 s,"
     " also when visitors touch the wall. Shots cannot be dragged, layout.mode = \"pan\" is \"fit\", and a"
     " tapestry moves only with the fingers."},
    {"show.photo_drift", flag<&S::show, &S::Show::photo_drift>(), SettingEffect::new_walls,
     "true: a photo whose cell shows more than its region moves very slowly inside the cell, never its region"
     " out of it. Every frame is then drawn, also where nothing else moves, so a wall of photos takes"
     " processor time all the while. Without effect on a calm wall and on one that pans."},
    {"show.pan_pixels_per_second", number<&S::show, &S::Show::pan_speed>(1, 2000), SettingEffect::new_walls,
     "Speed of a wall with layout.mode = \"pan\", in screen pixels a second."},
    {"show.background", text<&S::show, &S::Show::background>("a colour like \"#101014\"", is_colour),
     SettingEffect::restart, "Colour behind pictures that have transparent parts."},
    {"show.holidays",
     text<&S::show, &S::Show::holidays>(
         "dates like \"2026-12-25, 2026-12-26\", or nothing",
         [](const std::string& value) { return dates_named(value).has_value(); }),
     SettingEffect::restart,
     "Dates that count as Sundays for hints of weekdays: on a holiday, what is hinted \"Mo-Fr\" is not "
     "shown, "
     "and what is hinted \"Sat,Sun\" is. \"2026-12-25, 2026-12-26\": these two."},
    {"show.captions",
     choice<&S::show, &S::Show::captions>({{{"none", CaptionChoice::none},
                                            {"written", CaptionChoice::written},
                                            {"names", CaptionChoice::names}}}),
     SettingEffect::new_walls,
     "Words over the pictures, where nothing matters. \"written\": those of files such as \"lake.jpg.txt\" "
     "beside "
     "the media, or in photos. \"names\": where there is none, the name of the file. \"none\": no captions. "
     "A caption that "
     "has no "
     "room on the wall is left out."},
    {"show.qr",
     text<&S::show, &S::Show::qr>("a text of at most 250 bytes, such as an address, or nothing",
                                  [](const std::string& value) { return value.size() <= 250; }),
     SettingEffect::new_walls,
     "A QR code for the whole wall, such as \"https://example.org\". It stands where nothing matters, over "
     "the "
     "shot that stands longest and has room for it, and on the idle picture. \"\": none."},
    {"show.share_address",
     text<&S::show, &S::Show::share_address>("a text of at most 250 bytes, or nothing",
                                             [](const std::string& value) { return value.size() <= 250; }),
     SettingEffect::new_walls,
     "The address at which files are dropped, such as '\\\\{host}\\media'. It stands on the idle picture. "
     "{host}: the "
     "name of this machine. \"\": the idle picture tells none."},
    {"show.on_this_day", flag<&S::show, &S::Show::on_this_day>(), SettingEffect::restart,
     "true: files that were taken on this day in other years come first in each round, whatever show.order "
     "says. "
     "The time that the camera wrote counts, where it was taken. Their captions tell the year."},
    {"input.devices",
     text<&S::input, &S::Input::devices>(
         "\"auto\", \"none\" or device nodes like \"/dev/input/event3\", separated by commas",
         is_device_list),
     SettingEffect::restart,
     "Devices with which visitors touch the wall. \"auto\": all touch panels, mice and keyboards, also those "
     "that are plugged in later. \"/dev/input/event3, /dev/input/event5\": only these. \"none\": none. A "
     "panel belongs to the display that udev's WL_OUTPUT names, else to the first display. If there is no "
     "device, or the player is not in the group `input`, the wall just plays."},
    {"input.idle_seconds", whole<&S::input, &S::Input::idle>(1, 86400), SettingEffect::new_walls,
     "Seconds after the last touch until an enlarged picture returns to its place, and until the wall "
     "replaces the tapestry of a film."},
    {"input.hint_seconds", whole<&S::input, &S::Input::hint>(0, 86400), SettingEffect::new_walls,
     "Seconds after the last touch until the wall shows that it can be touched: every ten seconds "
     "all shots but one become dim for a moment. 0: never. A calm wall and one that pans do not."},
    {"input.keep_arrangement", flag<&S::input, &S::Input::keep_arrangement>(), SettingEffect::now,
     "true: after a restart of the player the wall is as it was: which shots are where and how large, which "
     "files and slots are pinned and which files are removed (vitrinectl). Files that are gone drop out, and "
     "new ones come as always. A display of another shape shows the same shots at other places. A wall that "
     "pans keeps only pins and removals."},
    {"input.edit_keyframes", flag<&S::input, &S::Input::edit_keyframes>(), SettingEffect::now,
     "true: for the person who looks after the wall, not for visitors. In a tapestry that is opened from "
     "then "
     "on, a tap on a picture of the strip strikes it, and a tap on the film above makes the picture that it "
     "shows one of the strip. The tapestry is woven anew at once."},
    {"output.screen",
     text<&S::output, &S::Output::screen>(
         "\"kms\", \"kms:/dev/dri/cardN\" or \"offscreen:WIDTHxHEIGHT\", with \"+WIDTHxHEIGHT\" for more",
         is_screen),
     SettingEffect::restart,
     "Screens that show the wall. \"kms\": all displays of the graphics card that has a display connected. "
     "\"kms:/dev/dri/card1\": all displays of that card. Each display shows the wall in its own mode. "
     "\"offscreen:1280x720\": one screen without a display; \"offscreen:1280x720+640x360\": two of them (see "
     "--film and --snapshot of vitrine-player)."},
    {"output.mode",
     text<&S::output, &S::Output::mode>(
         "a mode like \"1920x1080\" or \"1920x1080@60\", or outputs with modes like \"HDMI-A-1=1920x1080, "
         "HDMI-A-2=1280x720@50\"",
         [](const std::string& value) { return modes_named(value).has_value(); }),
     SettingEffect::restart,
     "Mode of the displays: \"1920x1080\" or \"1920x1080@60\" for all, \"HDMI-A-1=1920x1080, "
     "HDMI-A-2=1280x720@50\" for these two. A mode without a name is for all other displays. Empty, or if a "
     "display lacks the mode: the mode that the display prefers."},
    {"output.rotation", whole<&S::output, &S::Output::rotation>(0, 270, 90), SettingEffect::now,
     "Degrees clockwise by which the display itself is turned: 0, 90, 180 or 270. The picture is then "
     "upright."},
    {"output.margins",
     text<&S::output, &S::Output::margins>(
         "one or four of pixels or per cent, like \"2.5%\" or \"24,0,24,0\"",
         [](const std::string& value) { return margins_named(value).has_value(); }),
     SettingEffect::now,
     "Black margins for a display that hides its edges, in pixels or per cent: \"2.5%\" at all sides, or "
     "\"24,0,24,0\" at the left, top, right and bottom side of the display before it is turned. Nothing is "
     "drawn there."},
    {"output.folders",
     text<&S::output, &S::Output::folders>(
         "outputs with folders below the media folder, like \"HDMI-A-1=lobby, HDMI-A-2=hall\"",
         [](const std::string& value) { return output_folders_named(value).has_value(); }),
     SettingEffect::restart,
     "Displays with a wall of their own, each for one folder below the media folder: \"HDMI-A-1=lobby, "
     "HDMI-A-2=hall\". All other displays show the whole media folder together. The log names the displays."},
    {"output.canvas",
     text<&S::output, &S::Output::canvas>(
         "outputs with places like \"HDMI-A-1 0,0; HDMI-A-2 1960,0\", or \"mm: HDMI-A-1 0,0 698x393; "
         "HDMI-A-2 "
         "720,0 698x393 turned 180\"",
         [](const std::string& value) { return canvas_named(value).fault.empty(); },
         [](const std::string& value) { return canvas_named(value).fault; }),
     SettingEffect::now,
     "Displays that show one wall together, each its part: \"HDMI-A-1 0,0; HDMI-A-2 1960,0\". The numbers "
     "are the "
     "place of the display's top left corner, to the right and down, in pixels; so here a bezel is 40 pixels "
     "wide. "
     "After its place a display may have the size of its picture, as it hangs, and its turn, like "
     "\"HDMI-A-2 1960,0 540x960 turned 90\"; else it is as large as its mode, and turned as output.rotation "
     "says. "
     "\"mm: HDMI-A-1 0,0 698x393; HDMI-A-2 720,0 698x393\" is the same in millimetres; there each display "
     "needs its "
     "size. What matters in a picture never rests behind a bezel. All other displays show the whole wall. "
     "The box that leads others names their displays as BOX/DISPLAY: \"hall-2/HDMI-A-1 1960,0\". Empty: "
     "each display shows the whole wall. `vitrinectl canvas` helps to place them."},
    {"output.on",
     text<&S::output, &S::Output::on>(
         "hours like \"Mo-Fr 08:00-18:30, Sat 10-14\", or nothing",
         [](const std::string& value) { return day_windows_named(value).has_value(); }),
     SettingEffect::now,
     "Hours at which the displays are on: \"08-18\", \"Mo-Fr 08:00-18:30, Sat 10-14\", \"20:00-02:00\". "
     "Outside "
     "they are really off, and show nothing. Hours over midnight belong to the day on which they start; a "
     "date "
     "of show.holidays counts as a Sunday. As long as the clock is not plausible, they are on. Empty: "
     "always."},
    {"output.awake_minutes", whole<&S::output, &S::Output::awake>(1, 1440), SettingEffect::now,
     "Minutes for which a touch or a key turns the displays on outside output.on."},
    {"output.dim",
     text<&S::output, &S::Output::dim>(
         "hours with a share like \"20:00-06:00 40%\", or nothing",
         [](const std::string& value) { return dim_windows_named(value).has_value(); }),
     SettingEffect::now,
     "Hours at which the picture is darker, with the share of its light: \"20:00-06:00 40%, Sun 18-20 60%\". "
     "The "
     "first that holds counts. The picture changes slowly. Empty: never."},
    {"output.frame_rate", whole<&S::output, &S::Output::frame_rate>(1, 240), SettingEffect::restart,
     "Limit of the frames that are drawn in a second."},
    {"output.decoders",
     choice<&S::output, &S::Output::decoders>(
         {{{"auto", DecoderChoice::automatic}, {"processor", DecoderChoice::processor}}}),
     SettingEffect::restart,
     "Decoders of films. \"auto\": hardware decoders if some can be opened; the log names them. "
     "\"processor\": software decoders only, for drivers that decode wrongly."},
    {"output.api",
     choice<&S::output, &S::Output::api>({{{"best", KmsApi::best}, {"legacy", KmsApi::legacy}}}),
     SettingEffect::restart,
     "Interface of the graphics card. \"best\": atomic requests if the driver takes them. \"legacy\": the "
     "older calls, for drivers that take atomic requests but fail with them."},
    {"output.sound",
     text<&S::output, &S::Output::sound>("a device of ALSA like \"default\", or nothing", is_any),
     SettingEffect::restart,
     "Device for the sound of films whose hints say `sound`: \"default\" or another device of ALSA, which "
     "`aplay -L` lists, such as \"hdmi:CARD=PCH,DEV=0\". Empty: the wall is always silent."},
    {"wall.role",
     choice<&S::wall, &S::Wall::role>(
         {{{"alone", WallRole::alone}, {"lead", WallRole::lead}, {"follow", WallRole::follow}}}),
     SettingEffect::restart,
     "Several boxes can show one wall. \"alone\": this box knows of no other. \"lead\": this box has the "
     "media folder and decides what all show. \"follow\": it draws its part of what the leader decides. "
     "`vitrinectl wall lead` and `vitrinectl wall join` write this section."},
    {"wall.name",
     text<&S::wall, &S::Wall::name>("letters, digits, '-', '_' and '.', or nothing", is_wall_name_or_empty,
                                    fault_of_wall_name),
     SettingEffect::restart,
     "Name of the wall, the same on all its boxes. It has letters, digits, '-', '_' and '.', a letter or "
     "digit "
     "first, and at most 63 of them."},
    {"wall.box",
     text<&S::wall, &S::Wall::box>("letters, digits, '-', '_' and '.', or nothing", is_wall_name_or_empty,
                                   fault_of_wall_name),
     SettingEffect::restart,
     "Name of this box, which no other box of the wall has. output.canvas of the leader names it. Empty: the "
     "name of the host."},
    {"wall.leader", text<&S::wall, &S::Wall::leader>("a host name, an address, or nothing", is_host),
     SettingEffect::restart, "Host name or address of the leader. Only a follower needs it."},
    {"wall.key", text<&S::wall, &S::Wall::key>("a path", is_not_empty), SettingEffect::restart,
     "File with the key of the wall, the same on all its boxes. Whoever has it can show pictures on the "
     "wall."},
    {"wall.socket",
     text<&S::wall, &S::Wall::socket>("a path of at most 107 bytes, from the root", is_socket_path),
     SettingEffect::restart,
     "Socket at which vitrine-link, which speaks to the other boxes, waits for the player."},
    {"wall.fetch_fault", text<&S::wall, &S::Wall::fetch_fault>("a path", is_not_empty),
     SettingEffect::restart,
     "File in which a follower keeps why it could not fetch the leader's files. `vitrinectl status` tells "
     "it."},
});

}  // namespace

std::string SettingKey::allowed() const {
    return std::visit([](const auto& one) { return one.allowed(); }, kind);
}

void SettingKey::assign(Settings& settings, const SettingValue& value) const {
    std::visit([&](const auto& one) { one.assign(settings, value); }, kind);
}

std::string SettingKey::text(const Settings& settings) const {
    return std::visit([&](const auto& one) { return one.text(settings); }, kind);
}

void SettingKey::copy(const Settings& from, Settings& to) const {
    std::visit([&](const auto& one) { one.copy(from, to); }, kind);
}

std::span<const SettingKey> setting_keys() {
    return keys;
}

const SettingKey* find_setting_key(std::string_view name) {
    for (const SettingKey& key : keys)
        if (key.name == name) return &key;
    return nullptr;
}

const RetiredKey* find_retired_key(std::string_view name) {
    static constexpr std::array retired{
        RetiredKey{"show.crossfade_milliseconds",
                   "show.motion_milliseconds is the length of the whole change, its fades too."},
    };
    const auto* const found = std::ranges::find(retired, name, &RetiredKey::name);
    return found == retired.end() ? nullptr : found;
}

}  // namespace vitrine

#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

/// A length on a screen: so many pixels and so much of its width or height.
struct ScreenLength {
    double pixels = 0;
    double share = 0;

    friend bool operator==(const ScreenLength&, const ScreenLength&) = default;
};

/// What stays black at each side of a screen that hides its edges, as the screen lies before it is turned.
struct Margins {
    ScreenLength left;
    ScreenLength top;
    ScreenLength right;
    ScreenLength bottom;

    friend bool operator==(const Margins&, const Margins&) = default;
};

/// "24" or "2.5%" for all four sides, "24,0,24,0" for left, top, right and bottom; empty: none.
/// Nothing where it is not understood, or a side is negative, above 2000 px or above 40 %.
std::optional<Margins> margins_named(std::string_view text);

/// The mode that an output is asked for; whatever is left out is as its display prefers.
struct ModeWish {
    int width = 0;  // px; 0: as the display prefers
    int height = 0;
    double refresh_rate = 0;  // Hz; 0: the fastest of that size

    friend bool operator==(const ModeWish&, const ModeWish&) = default;
};

struct ModeWishes {
    ModeWish others;  // of the outputs that are not named
    std::map<std::string, ModeWish> named;

    const ModeWish& of(const std::string& output) const;
};

/// "1920x1080" or "1920x1080@59.94" for all outputs, "HDMI-A-1=1920x1080, HDMI-A-2=1280x720@50" for these,
/// "1920x1080, HDMI-A-2=preferred" for one and all others; empty: as the displays prefer.
/// Nothing where it is not understood, names an output twice, a side is not 16 to 16384 px or the rate not 1
/// to 1000 Hz.
std::optional<ModeWishes> modes_named(std::string_view text);

/// "HDMI-A-1=lobby, HDMI-A-2=hall/left": output -> folder below the media folder; empty: none.
/// Nothing where it is not understood, names an output twice, or a folder elsewhere.
std::optional<std::map<std::string, std::string>> output_folders_named(std::string_view text);

}  // namespace vitrine

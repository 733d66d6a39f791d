#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine {

struct ScreenSize {
    int width = 0;  // px
    int height = 0;

    bool operator==(const ScreenSize&) const = default;
};

/// Parses sizes such as "1280x720+640x360". None: another text, or a side is not 16 to 16384 px.
std::optional<std::vector<ScreenSize>> screen_sizes_named(std::string_view text);

/// A length on a screen, the sum of both members.
struct ScreenLength {
    double pixels = 0;
    double share = 0;  // share of the screen's width or height

    bool operator==(const ScreenLength&) const = default;
};

/// The black margin at each side of a screen that hides its edges, before the screen is turned.
struct Margins {
    ScreenLength left;
    ScreenLength top;
    ScreenLength right;
    ScreenLength bottom;

    bool operator==(const Margins&) const = default;
};

/// Parses margins: "24" or "2.5%" for all four sides, "24,0,24,0" for left, top, right and bottom; empty: no
/// margins.
/// @return  none: another text, or a side is negative, above 2000 px or above 40 %
std::optional<Margins> margins_named(std::string_view text);

/// The mode that is set on an output. The display chooses each member that is 0.
struct ModeWish {
    int width = 0;            // px
    int height = 0;           // px
    double refresh_rate = 0;  // Hz; 0: the fastest rate of that size

    bool operator==(const ModeWish&) const = default;
};

struct ModeWishes {
    ModeWish others;  // for the outputs without an entry in `named`
    std::map<std::string, ModeWish> named;

    const ModeWish& of(const std::string& output) const;
};

/// Parses modes: "1920x1080" or "1920x1080@59.94" for all outputs; "HDMI-A-1=1920x1080, HDMI-A-2=1280x720@50"
/// for these outputs; "1920x1080, HDMI-A-2=preferred" for one and all others; empty: the displays' preferred
/// modes.
/// @return  none: another text, an output twice, a side outside 16 to 16384 px, or a rate outside 1 to 1000
/// Hz
std::optional<ModeWishes> modes_named(std::string_view text);

/// Parses folders of outputs: "HDMI-A-1=lobby, HDMI-A-2=hall/left": output -> folder below the media folder.
/// @return  none: another text, an output twice, or a folder elsewhere
std::optional<std::map<std::string, std::string>> output_folders_named(std::string_view text);

}  // namespace vitrine

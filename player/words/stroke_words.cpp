#include "player/words/stroke_words.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double rows = 6;     // of the grid of a letter; it has 4 columns
constexpr double columns = 4;  // of the same
constexpr double advance = 6;  // columns from one letter to the next

/// A letter as lines between points of the grid; each point is its column and its row from the top.
struct Letter {
    char name;
    std::string_view lines;
};

constexpr std::array letters{
    Letter{'A', "0602204246 0343"},
    Letter{'B', "00304142330300 3344453606"},
    Letter{'C', "4130100105163645"},
    Letter{'D', "00204244260600"},
    Letter{'E', "40000646 0333"},
    Letter{'F', "400006 0333"},
    Letter{'G', "41301001051636454323"},
    Letter{'H', "0006 4046 0343"},
    Letter{'I', "1030 2026 1636"},
    Letter{'J', "4045361605"},
    Letter{'K', "0006 400346"},
    Letter{'L', "000646"},
    Letter{'M', "0600234046"},
    Letter{'N', "06004640"},
    Letter{'O', "100105163645413010"},
    Letter{'P', "06003041423303"},
    Letter{'Q', "100105163645413010 2446"},
    Letter{'R', "06003041423303 2346"},
    Letter{'S', "413010010213334445361605"},
    Letter{'T', "0040 2026"},
    Letter{'U', "000516364540"},
    Letter{'V', "002640"},
    Letter{'W', "0016233640"},
    Letter{'X', "0046 4006"},
    Letter{'Y', "002340 2326"},
    Letter{'Z', "00400646"},
    Letter{'0', "100105163645413010"},
    Letter{'1', "112026 1636"},
    Letter{'2', "01103041420646"},
    Letter{'3', "01103041423313 334445361605"},
    Letter{'4', "36300444"},
    Letter{'5', "400003334445361605"},
    Letter{'6', "413010010516364544331304"},
    Letter{'7', "004016"},
    Letter{'8', "100102133342413010 1304051636454433"},
    Letter{'9', "051636454130100102133342"},
    Letter{'-', "0343"},
    Letter{'.', "2526"},
    Letter{'/', "0640"},
    Letter{',', "2516"},
    Letter{' ', ""},
};

constexpr std::string_view unknown = "0040460600";

std::string_view lines_of(char name) {
    const auto capital = static_cast<char>(std::toupper(static_cast<unsigned char>(name)));
    const auto* const found = std::ranges::find(letters, capital, &Letter::name);
    return found == letters.end() ? unknown : found->lines;
}

Vec2 point_of(std::string_view lines, std::size_t at) {
    return {static_cast<double>(lines[at] - '0'), static_cast<double>(lines[at + 1] - '0')};
}

}  // namespace

std::vector<Stroke> strokes_of(std::string_view text) {
    std::vector<Stroke> strokes;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const Vec2 first{static_cast<double>(k) * advance, 0};
        const std::string_view lines = lines_of(text[k]);
        for (std::size_t at = 0; at + 3 < lines.size(); at += 2) {
            if (lines[at] == ' ') ++at;
            if (lines[at + 2] == ' ') continue;
            strokes.push_back(
                {(first + point_of(lines, at)) * (1 / rows), (first + point_of(lines, at + 2)) * (1 / rows)});
        }
    }
    return strokes;
}

double stroke_length(std::string_view text) {
    if (text.empty()) return 0;
    return (static_cast<double>(text.size()) * advance - (advance - columns)) / rows;
}

}  // namespace vitrine::player

#pragma once

#include <array>

namespace vitrine::player {

/// The meaning of a picture's brightness and colour differences.
struct ColourCode {
    enum class Matrix { bt601, bt709, bt2020 };

    Matrix matrix = Matrix::bt601;
    bool is_full_range = false;  // true: 0 to 255; false: 16 to 235 and 16 to 240

    bool operator==(const ColourCode&) const = default;
};

/// rgb = matrix * (coded - zero), all in [0, 1].
struct ColourMatrix {
    std::array<float, 9> matrix{};  // by columns, as GL reads it
    std::array<float, 3> zero{};    // the code of black
};

/// Source: ITU-R BT.601, BT.709 and BT.2020, 8 bits a channel.
inline ColourMatrix colour_matrix(const ColourCode& code) {
    double red = 0.299;
    double blue = 0.114;
    if (code.matrix == ColourCode::Matrix::bt709) {
        red = 0.2126;
        blue = 0.0722;
    } else if (code.matrix == ColourCode::Matrix::bt2020) {
        red = 0.2627;
        blue = 0.0593;
    }
    const double green = 1 - red - blue;
    const double light = code.is_full_range ? 1 : 255.0 / 219;
    const double difference = code.is_full_range ? 1 : 255.0 / 224;
    const double blue_blue = 2 * (1 - blue) * difference;
    const double red_red = 2 * (1 - red) * difference;
    const auto number = [](double value) { return static_cast<float>(value); };
    return {.matrix = {number(light), number(light), number(light),              // column for Y
                       0, number(-blue_blue * blue / green), number(blue_blue),  // column for Cb
                       number(red_red), number(-red_red * red / green), 0},      // column for Cr
            .zero = {code.is_full_range ? 0 : number(16.0 / 255), number(128.0 / 255), number(128.0 / 255)}};
}

}  // namespace vitrine::player

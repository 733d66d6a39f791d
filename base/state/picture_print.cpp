#include "base/state/picture_print.hpp"

#include "base/state/path_text.hpp"

#include <stdexcept>

namespace vitrine {

std::string text_of(const PicturePrint& print) {
    return to_hex(std::string(print.shades.begin(), print.shades.end()));
}

PicturePrint print_from_text(std::string_view text) {
    const std::string bytes = from_hex(text);
    if (bytes.size() != std::size_t{PicturePrint::side} * PicturePrint::side)
        throw std::runtime_error("record: 'print' is not as long as a print is");
    return {.shades = {bytes.begin(), bytes.end()}};
}

}  // namespace vitrine

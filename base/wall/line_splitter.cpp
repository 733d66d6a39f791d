#include "base/wall/line_splitter.hpp"

#include "base/wall/broken_line.hpp"

#include <fmt/format.h>

#include <utility>

namespace vitrine {

std::vector<std::string> LineSplitter::push(std::string_view piece) {
    std::vector<std::string> lines;
    while (!piece.empty()) {
        const std::size_t end = piece.find('\n');
        begun_.append(piece.substr(0, end));
        if (begun_.size() > max_line_)
            throw BrokenLine(fmt::format("a line has more than {} bytes", max_line_));
        if (end == std::string_view::npos) break;
        lines.push_back(std::exchange(begun_, {}));
        piece.remove_prefix(end + 1);
    }
    return lines;
}

}  // namespace vitrine

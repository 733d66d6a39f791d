#include "player/wall_link/fetch_fault.hpp"

#include <fstream>

namespace vitrine::player {

namespace {

constexpr auto spacing = std::chrono::seconds(2);  // of looks
constexpr std::size_t max_bytes = 300;

}  // namespace

void FetchFault::look(std::chrono::nanoseconds now) {
    if (looked_ && now - *looked_ < spacing) return;
    looked_ = now;
    text_.clear();
    std::ifstream file(file_);
    std::getline(file, text_);
    if (text_.size() > max_bytes) text_.resize(max_bytes);
}

}  // namespace vitrine::player

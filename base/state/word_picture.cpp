#include "base/state/word_picture.hpp"

#include "base/state/name_hash.hpp"

namespace vitrine {

std::filesystem::path word_folder(const std::filesystem::path& state) {
    return state / "words";
}

std::filesystem::path word_picture(const std::filesystem::path& state, std::string_view text) {
    return word_folder(state) / (name_hash(text) + ".png");
}

}  // namespace vitrine

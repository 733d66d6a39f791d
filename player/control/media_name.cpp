#include "player/control/media_name.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace vitrine::player {

namespace {

namespace fs = std::filesystem;

constexpr int max_tails = 64;  // twice as many folders as lie within each other in a media folder

// True: the name has the form that programs on another machine use.
bool is_of_a_share(const std::string& given) {
    const bool has_drive =
        given.size() > 2 && std::isalpha(static_cast<unsigned char>(given[0])) != 0 && given[1] == ':';
    return has_drive || given.find("://") != std::string::npos || given.starts_with("//") ||
           given.find('\\') != std::string::npos || given.starts_with("/Volumes/");
}

void add(std::vector<std::string>& names, const fs::path& path) {
    const std::string name = path.lexically_normal().string();
    const bool leads_out =
        name.empty() || name == "." || name.starts_with("/") || name == ".." || name.starts_with("../");
    if (!leads_out && std::ranges::find(names, name) == names.end()) names.push_back(name);
}

// Adds the name without its first folder, without its first two, and so on: the other machine may use any
// name for the share.
void add_tails(std::vector<std::string>& names, std::string text) {
    std::ranges::replace(text, '\\', '/');
    std::size_t slash = text.find('/');
    for (int tail = 0; tail < max_tails && slash != std::string::npos;
         ++tail, slash = text.find('/', slash)) {
        slash = text.find_first_not_of('/', slash);
        if (slash == std::string::npos) return;
        add(names, text.substr(slash));
    }
}

}  // namespace

std::vector<std::string> media_names(const std::string& given, const std::string& folder,
                                     const std::string& root) {
    std::vector<std::string> names;
    if (given.empty()) return names;
    const fs::path here = fs::path(given).is_absolute() ? fs::path(given) : fs::path(folder) / given;
    add(names, here.lexically_normal().lexically_relative(fs::path(root).lexically_normal()));
    add(names, given);
    if (is_of_a_share(given)) add_tails(names, "/" + given);
    return names;
}

}  // namespace vitrine::player

#include "analyzer/lettering/font_places.hpp"

namespace vitrine::analyzer {

std::vector<std::filesystem::path> font_places() {
    return {"/etc/fonts", "/usr/share/fontconfig", "/usr/share/fonts", "/usr/local/share/fonts",
            "/var/cache/fontconfig"};
}

}  // namespace vitrine::analyzer

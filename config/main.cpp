#include "base/settings/settings_text.hpp"

#include <iostream>

/// Prints config/vitrine.toml. The build target `settings_file` puts the text in its place.
int main() {
    std::cout << vitrine::documented_toml();
    return std::cout.good() ? 0 : 1;
}

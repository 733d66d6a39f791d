#include "base/settings/settings_file.hpp"

#include <cstdint>
#include <string_view>

using namespace vitrine;

/// Whatever the text, there are settings or a reason with a line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Settings settings;
    try {
        read_settings({reinterpret_cast<const char*>(data), size}, "fuzz",
                      settings);  // NOLINT: bytes are characters
    } catch (const SettingsError&) {
        return 0;
    }
    return 0;
}

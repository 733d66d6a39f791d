#include "base/state/record_json.hpp"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

using namespace vitrine;

/// Whatever the text, there is a record or a reason; a record is read again as it was written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);  // NOLINT: bytes are characters
    MediaRecord record;
    try {
        record = record_from_json(text);
    } catch (const std::runtime_error&) {
        return 0;
    }
    if (to_json(record_from_json(to_json(record))) != to_json(record)) std::abort();
    return 0;
}

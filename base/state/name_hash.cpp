#include "base/state/name_hash.hpp"

#include "base/system/handle.hpp"

#include <glib.h>

namespace vitrine {

std::string name_hash(std::string_view text) {
    const auto* bytes = reinterpret_cast<const guchar*>(text.data());
    const Handle<char, &g_free> digits(g_compute_checksum_for_data(G_CHECKSUM_SHA256, bytes, text.size()));
    return {digits.get(), name_hash_length};
}

}  // namespace vitrine

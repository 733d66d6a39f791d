#include "base/settings/toml_table.hpp"

namespace vitrine {

toml::table toml_table(std::string_view text, const std::string& source) {
    try {
        return toml::parse(text, source);
    } catch (const toml::parse_error& error) {
        throw TomlError(error.source().begin.line, std::string(error.description()));
    } catch (const std::invalid_argument& error) {
        throw TomlError(1, error.what());
    }
}

}  // namespace vitrine

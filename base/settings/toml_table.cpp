#include "base/settings/toml_table.hpp"

#include <fmt/format.h>

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

std::vector<std::string>
faults_in_keys(std::string_view text, const std::string& source,
               const std::function<std::string(std::string_view key, const toml::node& node)>& read) {
    std::vector<std::string> faults;
    const auto add_fault = [&](unsigned line, const std::string& what) {
        if (!what.empty()) faults.push_back(fmt::format("{}:{}: {}", source, line, what));
    };
    try {
        for (const auto& [key, node] : toml_table(text, source))
            add_fault(node.source().begin.line, read(key, node));
    } catch (const TomlError& error) {
        add_fault(error.line, error.what());
    }
    return faults;
}

}  // namespace vitrine

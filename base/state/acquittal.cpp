#include "base/state/acquittal.hpp"

#include "base/system/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

namespace vitrine {

namespace {

constexpr const char* all_files = "*";
constexpr std::size_t max_acquittals = 1000;

}  // namespace

Acquittals read_acquittals(const std::filesystem::path& state) {
    Acquittals acquittals;
    std::ifstream stream(state / acquitted_file);
    std::string id;
    std::int64_t seconds = 0;
    while (acquittals.size() < max_acquittals && stream >> id >> seconds)
        acquittals[id] = std::chrono::seconds(seconds);
    return acquittals;
}

void write_acquittal(const std::filesystem::path& state, const std::string& path, std::chrono::seconds now) {
    Acquittals acquittals = read_acquittals(state);
    if (path.empty() || acquittals.size() + 1 >= max_acquittals) acquittals.clear();
    acquittals[path.empty() ? all_files : record_id(path)] = now;
    std::string text;
    for (const auto& [id, time] : acquittals)
        text += fmt::format("{} {}\n", id, time.count());
    replace_file(state / acquitted_file, text);
}

bool is_acquitted(const Acquittals& acquittals, const std::string& path, const Fault& quarantine) {
    return std::ranges::any_of(std::array{std::string(all_files), record_id(path)},
                               [&](const std::string& id) {
                                   const auto found = acquittals.find(id);
                                   return found != acquittals.end() && found->second >= quarantine.since;
                               });
}

}  // namespace vitrine

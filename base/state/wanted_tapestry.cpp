#include "base/state/wanted_tapestry.hpp"

#include "base/state/path_text.hpp"
#include "base/system/atomic_file.hpp"

#include <nlohmann/json.hpp>

#include <exception>
#include <system_error>

namespace vitrine {

using Json = nlohmann::ordered_json;

namespace {

constexpr int wish_version = 1;
constexpr std::size_t max_wish_bytes = 32U << 10;  // a path has at most 4 KiB, in hex twice as many

std::string path_in(const std::string& text) {
    const Json json = Json::parse(text);
    if (json.at("version").get<int>() != wish_version) return "";
    if (json.contains("path_hex")) return from_hex(json.at("path_hex").get<std::string>());
    return json.at("path").get<std::string>();
}

}  // namespace

std::string wanted_tapestry(const std::filesystem::path& state, std::filesystem::file_time_type now) {
    const std::filesystem::path file = state / wanted_tapestry_file;
    std::error_code error;
    const auto written = std::filesystem::last_write_time(file, error);
    if (error || now - written > max_wish_age) return "";
    try {
        return path_in(read_file(file, max_wish_bytes));
    } catch (const std::exception&) {  // loading one record: it went just now, or it is no wish
        return "";
    }
}

void want_tapestry(const std::filesystem::path& state, const std::string& path) {
    Json json{{"version", wish_version}, {"path", path}};
    if (!is_utf8(path)) json["path_hex"] = to_hex(path);
    replace_file_unsynced(state / wanted_tapestry_file,
                          json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void withdraw_wish(const std::filesystem::path& state, const std::string& path) {
    if (wanted_tapestry(state, std::filesystem::file_time_type::clock::now()) != path) return;
    std::error_code gone;
    std::filesystem::remove(state / wanted_tapestry_file, gone);
}

}  // namespace vitrine

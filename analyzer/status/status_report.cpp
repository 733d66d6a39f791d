#include "analyzer/status/status_report.hpp"

#include "base/hints/hint_words.hpp"
#include "base/state/path_text.hpp"

#include <nlohmann/json.hpp>

namespace vitrine::analyzer {

std::string status_json(const StatusReport& report) {
    using Json = nlohmann::ordered_json;
    constexpr int version = 1;
    Json files = Json::array();
    for (const StatusEntry& entry : report.files) {
        const auto since =
            std::chrono::floor<std::chrono::seconds>(entry.file.since.time_since_epoch()).count();
        Json file{{"path", entry.file.path}, {"state", name_of(entry.file.state)}, {"since", since}};
        if (!is_utf8(entry.file.path)) file["path_hex"] = to_hex(entry.file.path);
        if (!entry.file.reason.empty()) file["reason"] = entry.file.reason;
        if (entry.hints != Hints{}) file["shown"] = in_words(entry.hints);
        if (!entry.keyframes.is_empty()) file["tapestry"] = in_words(entry.keyframes);
        files.push_back(std::move(file));
    }
    return Json{{"version", version},
                {"online", report.is_online},
                {"remarks", report.remarks},
                {"inbox", report.inbox},
                {"files", std::move(files)}}
               .dump(-1, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

}  // namespace vitrine::analyzer

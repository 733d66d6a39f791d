#include "player/control/analyzer_word.hpp"

#include "base/system/atomic_file.hpp"

#include <nlohmann/json.hpp>

#include <exception>

namespace vitrine::player {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using namespace std::chrono_literals;

namespace {

std::string dumped(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string AnalyzerWord::entry(const std::string& path) const {
    const auto found = entries.find(path);
    return found == entries.end() ? "" : found->second;
}

AnalyzerWord analyzer_word_from(const std::string& json) {
    const Json said = Json::parse(json, nullptr, false);
    if (!said.is_object()) return {};
    AnalyzerWord word;
    Json kept = Json::object();
    for (const auto& [key, value] : said.items()) {
        if (!value.is_array()) {
            kept[key] = value;
            continue;
        }
        for (const Json& one : value) {
            if (!one.is_object()) continue;
            if (one.contains("path") && one["path"].is_string()) word.entries[one["path"]] = dumped(one);
            if (!one.contains("state") || !one["state"].is_string()) continue;
            Json& count = kept["states"][one["state"].get<std::string>()];
            count = (count.is_number() ? count.get<int>() : 0) + 1;
        }
    }
    word.summary = kept.empty() ? "" : dumped(kept);
    return word;
}

AnalyzerWord read_analyzer_word(const fs::path& file) noexcept {
    try {
        return analyzer_word_from(read_file(file));
    } catch (const std::exception&) {  // no exception crosses a thread
        return {};
    }
}

void AnalyzerWordReader::look(Time now) {
    if (now < next_look_) return;
    next_look_ = now + 1s;
    if (reading_.valid()) {
        if (reading_.wait_for(0s) != std::future_status::ready) return;
        replace_word(reading_.get());
    }
    std::error_code missing;
    const auto time = fs::last_write_time(file_, missing);
    const auto size = missing ? 0 : fs::file_size(file_, missing);
    if (missing || read_ == Version(time, size)) return;
    read_ = Version(time, size);
    reading_ = std::async(std::launch::async, read_word_, file_);
}

void AnalyzerWordReader::replace_word(AnalyzerWord word) {
    std::swap(word_, word);
    forgetting_ = std::async(std::launch::async, [before = std::move(word)]() mutable {
        const AnalyzerWord gone = std::move(before);  // ends with the thread's work
    });
}

}  // namespace vitrine::player

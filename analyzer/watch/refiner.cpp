#include "analyzer/watch/refiner.hpp"

#include "analyzer/watch/analysis_outcome.hpp"
#include "base/state/record_json.hpp"
#include "base/system/log.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vitrine::analyzer {

namespace {

constexpr auto collecting = std::chrono::seconds(10);

bool is_refined(const MediaRecord& record) {
    return record.state == MediaState::ready && record.shots.size() == 1 && record.shots.front().certainty;
}

}  // namespace

Refiner::Refiner(EventLoop& loop, RefineOptions options, Refined refined)
    : loop_(loop),
      options_(std::move(options)),
      refined_(std::move(refined)),
      hand_over_(loop.timer([this] { hand_over(); })) {}

void Refiner::note_record(const MediaRecord& record) {
    wishes_.erase(record.path);
    if (options_.command.empty() || record.kind != MediaKind::photo) return;
    if (record.state != MediaState::ready || is_refined(record)) return;
    const Content content{record.bytes, record.mtime_ns};
    const auto tried = tried_.find(record.path);
    if (tried == tried_.end() || tried->second != content) wishes_[record.path] = content;
}

void Refiner::advance(bool is_free) {
    is_free_ = is_free;
    while (is_free_ && running_.size() < options_.children && !wishes_.empty()) {
        const auto newest =
            std::ranges::max_element(wishes_, {}, [](const auto& wish) { return wish.second.mtime_ns; });
        const std::string path = newest->first;
        if (running_.contains(path)) return;  // its child looks at an older content
        tried_[path] = newest->second;
        wishes_.erase(newest);
        start_child(path);
    }
}

void Refiner::start_child(const std::string& path) {
    std::vector<std::string> command = options_.command;
    command.push_back((options_.root / path).string());
    try {
        running_[path] = std::make_unique<ChildProcess>(
            loop_, command, options_.limits,
            [this, path](const ChildResult& result) { finish_child(path, result); });
    } catch (const std::system_error& error) {  // no memory, no process
        running_.erase(path);
        note_failure(path, error.what());
    }
}

void Refiner::finish_child(const std::string& path, const ChildResult& result) {
    const auto ended = running_.extract(path);  // it is destroyed at the end of this call
    try {
        if (result.end != ChildResult::End::exited || result.code != 0)
            throw std::runtime_error(reason_of(result, options_.limits));
        MediaRecord record = record_from_json(result.output);
        if (!is_refined(record)) throw std::runtime_error(record.reason);
        failures_ = 0;
        if (found_.empty()) hand_over_.arm(collecting);
        found_.push_back(std::move(record));
    } catch (const std::runtime_error& error) {
        note_failure(path, error.what());
    }
    advance(is_free_);
    if (backlog() == 0) hand_over();
}

void Refiner::hand_over() {
    hand_over_.disarm();
    refined_(std::exchange(found_, {}));
}

void Refiner::note_failure(const std::string& path, const std::string& reason) {
    log::warning("'{}' keeps its plain region: {}", path, reason);
    if (++failures_ < max_failures) return;
    log::error("the network finds no regions here; photos keep their plain regions until the next start");
    options_.command.clear();
    wishes_.clear();
}

}  // namespace vitrine::analyzer

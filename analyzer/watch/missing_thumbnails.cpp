#include "analyzer/watch/missing_thumbnails.hpp"

#include "base/system/log.hpp"

#include <utility>

namespace vitrine::analyzer {

MissingThumbnails::MissingThumbnails(EventLoop& loop, std::vector<std::string> command,
                                     const ChildLimits& limits, std::function<void()> made)
    : loop_(loop), command_(std::move(command)), limits_(limits), made_(std::move(made)) {}

void MissingThumbnails::request(const std::vector<std::string>& files) {
    if (command_.empty()) return;
    wanted_ = files;
    if (!child_) start_next();
}

void MissingThumbnails::start_next() {
    while (!wanted_.empty()) {
        const std::string file = std::move(wanted_.back());
        wanted_.pop_back();
        if (!tried_.insert(file).second) continue;
        std::vector<std::string> command = command_;
        command.push_back(file);
        child_ =
            std::make_unique<ChildProcess>(loop_, command, limits_, [this, file](const ChildResult& result) {
                if (result.end != ChildResult::End::exited || result.code != 0)
                    log::debug("no thumbnail of '{}': {}", file, result.complaint);
                child_.reset();
                made_();
                start_next();
            });
        return;
    }
}

}  // namespace vitrine::analyzer

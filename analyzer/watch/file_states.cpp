#include "analyzer/watch/file_states.hpp"

namespace vitrine::analyzer {

namespace {

FileState::State state_of(MediaState state) {
    switch (state) {
    case MediaState::ready:
        return FileState::State::ready;
    case MediaState::waiting:
        return FileState::State::waiting;
    case MediaState::unsupported:
        return FileState::State::unsupported;
    case MediaState::failed:
        return FileState::State::failed;
    case MediaState::quarantined:
        return FileState::State::quarantined;
    }
    return FileState::State::waiting;
}

}  // namespace

void FileStates::note_record(const MediaRecord& record) {
    found_[record.path] = {.state = record.state,
                           .reason = record.reason,
                           .fault = record.fault,
                           .caption = {.text = record.origin.caption, .day = record.origin.day_of_camera()}};
    if (is_outdated(record))
        outdated_.insert(record.path);
    else
        outdated_.erase(record.path);
}

void FileStates::forget_file(const std::string& path) {
    found_.erase(path);
    outdated_.erase(path);
}

FileStates::OwnCaption FileStates::caption(const std::string& path) const {
    const auto known = found_.find(path);
    return known == found_.end() ? OwnCaption{} : known->second.caption;
}

const FileStates::Found* FileStates::found(const std::string& path, Schedule::Progress progress) const {
    using Progress = Schedule::Progress;
    if (progress == Progress::settling || progress == Progress::due) return nullptr;
    const auto known = found_.find(path);
    return known == found_.end() ? nullptr : &known->second;
}

FileState::State FileStates::state_of(const Found* found, Schedule::Progress progress) {
    if (found != nullptr) return vitrine::analyzer::state_of(found->state);
    return progress == Schedule::Progress::settling ? FileState::State::copying : FileState::State::analysing;
}

StateCounts FileStates::counts(const Schedule& schedule) const {
    StateCounts counts;
    schedule.visit_files([&](const std::string& path, Schedule::Progress progress, Schedule::Time) {
        ++counts[state_of(found(path, progress), progress)];
    });
    return counts;
}

std::vector<std::string> FileStates::quarantined_files(
    const std::function<bool(const std::string& path, const Fault& quarantine)>& is_over) const {
    std::vector<std::string> files;
    for (const auto& [path, found] : found_)
        if (found.state == MediaState::quarantined && is_over(path, found.fault)) files.push_back(path);
    return files;
}

std::vector<FileState> FileStates::list(const Schedule& schedule, Schedule::Time clock,
                                        std::chrono::system_clock::time_point now) const {
    std::vector<FileState> states;
    schedule.visit_files([&](const std::string& path, Schedule::Progress progress, Schedule::Time since) {
        const Found* known = found(path, progress);
        const auto ago = std::chrono::duration_cast<std::chrono::system_clock::duration>(clock - since);
        states.push_back({.path = path,
                          .state = state_of(known, progress),
                          .since = now - ago,
                          .reason = known == nullptr ? "" : known->reason});
    });
    return states;
}

}  // namespace vitrine::analyzer

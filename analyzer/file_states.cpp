#include "analyzer/file_states.hpp"

namespace vitrine {

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

void FileStates::hold(const MediaRecord& record) {
    found_[record.path] = {.state = record.state, .reason = record.reason};
}

FileState FileStates::state_of(const std::string& path, Schedule::Stage stage) const {
    using Stage = Schedule::Stage;
    const auto found = found_.find(path);
    const auto as_found = [&] {
        return FileState{
            .path = path, .state = vitrine::state_of(found->second.state), .reason = found->second.reason};
    };
    switch (stage) {
    case Stage::settling:
        return {.path = path, .state = FileState::State::copying};
    case Stage::growing:
    case Stage::waiting:
    case Stage::done:
        if (found != found_.end()) return as_found();
        [[fallthrough]];
    case Stage::due:
        break;
    }
    return {.path = path, .state = FileState::State::analysing};
}

std::vector<FileState> FileStates::list(const Schedule& schedule, Schedule::Time clock,
                                        std::chrono::system_clock::time_point now) const {
    std::vector<FileState> states;
    schedule.visit([&](const std::string& path, Schedule::Stage stage, Schedule::Time since) {
        FileState state = state_of(path, stage);
        state.since = now - std::chrono::duration_cast<std::chrono::system_clock::duration>(clock - since);
        states.push_back(std::move(state));
    });
    return states;
}

}  // namespace vitrine

#include "analyzer/child/child_process.hpp"

#include "base/system/error.hpp"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/epoll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <optional>
#include <string_view>
#include <utility>

namespace vitrine::analyzer {

namespace {

constexpr rlim_t max_processor_seconds = 172'800;  // even of a file that gets on and on
constexpr std::string_view killed_first = "1000";  // where memory ends, a child goes and not this process

struct Pipe {
    Pipe() {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) < 0) throw_errno("make a pipe");
        read.reset(ends[0]);
        write.reset(ends[1]);
    }

    UniqueFd read, write;
};

/// Data for the new process, gathered before the fork: after it only async-signal-safe calls are allowed.
struct Launch {
    std::vector<char*> arguments;  // with nullptr at the end
    rlim_t memory = RLIM_INFINITY;
    int niceness = 0;
    int output = -1;
    int complaint = -1;
};

void limit(__rlimit_resource resource, rlim_t value) {
    const rlimit both{value, value};
    ::setrlimit(resource, &both);  // a stricter limit of ours stays
}

/// Runs in the new process. A kernel that refuses it leaves the score of this process.
void be_killed_first() {
    const int score = ::open("/proc/self/oom_score_adj", O_WRONLY);
    if (::write(score, killed_first.data(), killed_first.size()) < 0) errno = 0;
    ::close(score);
}

/// Runs in the new process.
[[noreturn]] void become(const Launch& launch, pid_t parent) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(ChildProcess::exit_not_started);  // it died before that line
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    limit(RLIMIT_CORE, 0);
    if (launch.memory != RLIM_INFINITY) limit(RLIMIT_DATA, launch.memory);
    limit(RLIMIT_CPU, max_processor_seconds);
    if (::nice(launch.niceness) < 0) errno = 0;  // it only runs faster then
    be_killed_first();
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(launch.output, STDOUT_FILENO);
    ::dup2(launch.complaint, STDERR_FILENO);
    ::close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);  // nothing of ours, whoever opened it
    ::execv(launch.arguments.front(), launch.arguments.data());
    constexpr std::string_view sorry = "the analysing program cannot be started\n";
    if (::write(STDERR_FILENO, sorry.data(), sorry.size()) < 0) ::_exit(ChildProcess::exit_not_started);
    ::_exit(ChildProcess::exit_not_started);
}

/// Reads what is there. @return false at the end
bool read_some(const UniqueFd& fd, std::string& text) {
    std::array<char, 1U << 16> buffer;
    const ssize_t n = ::read(fd.get(), buffer.data(), buffer.size());
    if (n < 0) return errno == EAGAIN || errno == EINTR;
    text.append(buffer.data(), static_cast<std::size_t>(n));
    return n > 0;
}

bool has_more(const UniqueFd& fd, std::string& text) {
    const std::size_t before = text.size();
    return read_some(fd, text) && text.size() > before;
}

/// Takes the first line off, where it is whole.
std::optional<std::string> first_line(std::string& text) {
    const std::size_t end = text.find('\n');
    if (end == std::string::npos) return std::nullopt;
    std::string line = text.substr(0, end);
    text.erase(0, end + 1);
    return line;
}

}  // namespace

ChildLimits limits_for(ChildLimits limits, double seconds_per_mebibyte, std::uint64_t bytes) {
    constexpr double bytes_per_mebibyte = 1 << 20;
    constexpr double max_seconds = 86'400;
    const double seconds = seconds_per_mebibyte * static_cast<double>(bytes) / bytes_per_mebibyte;
    limits.patience.computing +=
        std::chrono::milliseconds(std::llround(std::min(seconds, max_seconds) * 1000));
    return limits;
}

ChildProcess::ChildProcess(EventLoop& loop, const std::vector<std::string>& command,
                           const ChildLimits& limits, std::function<void(const ChildResult&)> ended,
                           Said said)
    : limits_(limits), ended_(std::move(ended)), said_(std::move(said)) {
    Pipe output, complaint;
    Launch launch{.memory = limits.memory_bytes > 0 ? limits.memory_bytes : RLIM_INFINITY,
                  .niceness = limits.niceness,
                  .output = output.write.get(),
                  .complaint = complaint.write.get()};
    std::vector<std::string> words = command;
    for (std::string& word : words)
        launch.arguments.push_back(word.data());
    launch.arguments.push_back(nullptr);

    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ < 0) throw_errno("start '{}'", command.front());
    if (pid_ == 0) become(launch, parent);
    ::setpgid(pid_, pid_);  // parent and child both do this; either may be first
    process_.reset(static_cast<int>(::syscall(SYS_pidfd_open, pid_, 0)));
    if (!process_.is_open()) {
        const int error = errno;
        ::kill(-pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
        errno = error;
        throw_errno("watch the process of '{}'", command.front());
    }
    output_ = std::move(output.read);
    complaint_ = std::move(complaint.read);
    ::fcntl(output_.get(), F_SETFL, O_NONBLOCK);
    ::fcntl(complaint_.get(), F_SETFL, O_NONBLOCK);
    process_source_ = loop.watch(process_.get(), EPOLLIN, [this](std::uint32_t) { reap(); });
    output_source_ = loop.watch(output_.get(), EPOLLIN, [this](std::uint32_t) { read_output(); });
    complaint_source_ = loop.watch(complaint_.get(), EPOLLIN, [this](std::uint32_t) { read_complaint(); });
    deadline_.emplace(loop, pid_, limits.patience, [this](ProgressRule::Verdict verdict) {
        kill(verdict == ProgressRule::Verdict::idling ? ChildResult::End::idle : ChildResult::End::late);
    });
}

ChildProcess::~ChildProcess() {
    if (pid_ < 0) return;
    ::kill(-pid_, SIGKILL);
    siginfo_t info{};
    ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG);  // else our own parent reaps it
}

void ChildProcess::pause() {
    if (pid_ < 0) return;
    deadline_->pause();
    ::kill(-pid_, SIGSTOP);
}

void ChildProcess::go_on() {
    if (pid_ < 0) return;
    ::kill(-pid_, SIGCONT);
    deadline_->go_on();
}

void ChildProcess::stop() {
    kill(ChildResult::End::stopped);
}

void ChildProcess::kill(ChildResult::End why) {
    if (is_killed_) return;
    is_killed_ = true;
    result_.end = why;
    if (pid_ >= 0) ::kill(-pid_, SIGKILL);
}

/// Reads some of the output. @return false at its end or limit
bool ChildProcess::read_some_output() {
    std::string& text = said_ ? line_ : result_.output;
    const std::size_t before = text.size();
    const bool has_end = !read_some(output_, text);
    const std::size_t room = limits_.output_bytes - std::min(heard_, limits_.output_bytes);
    heard_ += text.size() - before;
    if (text.size() > before && deadline_) deadline_->note_progress();
    if (heard_ > limits_.output_bytes) {
        text.resize(before + room);
        kill(ChildResult::End::talked_too_much);
        return false;
    }
    if (!said_) return !has_end;
    while (std::optional<std::string> line = first_line(line_)) {
        if (line->empty()) continue;
        said_(*line);
        result_.output = std::move(*line);
    }
    return !has_end;
}

void ChildProcess::read_output() {
    if (!read_some_output()) output_source_ = {};
}

void ChildProcess::read_complaint() {
    if (!read_some(complaint_, result_.complaint)) complaint_source_ = {};
    if (result_.complaint.size() > max_complaint)
        result_.complaint.erase(0, result_.complaint.size() - max_complaint);
}

/// Its children may hold the pipes open, so what is in them now is all that is read. They are killed while
/// the unreaped process still keeps its group's number from being given to others.
void ChildProcess::reap() {
    ::kill(-pid_, SIGKILL);
    siginfo_t info{};
    if (::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED) < 0) throw_errno("wait for a child");
    pid_ = -1;
    std::size_t before = 0;
    do
        before = heard_;
    while (read_some_output() && heard_ > before);
    while (has_more(complaint_, result_.complaint)) {
    }
    if (result_.complaint.size() > max_complaint)
        result_.complaint.erase(0, result_.complaint.size() - max_complaint);
    if (!line_.empty()) result_.output = std::move(line_);
    result_.code = info.si_status;
    if (!is_killed_)
        result_.end = info.si_code == CLD_EXITED ? ChildResult::End::exited : ChildResult::End::killed;
    for (EventLoop::Source* source : {&process_source_, &output_source_, &complaint_source_})
        *source = {};
    deadline_.reset();
    const auto ended = std::move(ended_);
    const ChildResult result = std::move(result_);
    ended(result);
}

}  // namespace vitrine::analyzer

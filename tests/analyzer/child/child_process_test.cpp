#include "analyzer/child/child_process.hpp"

#include "tests/temporary_directory.hpp"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
namespace fs = std::filesystem;
using End = ChildResult::End;

namespace {

/// Runs a shell script to its end; the loop gives up after a minute.
ChildResult run(const std::string& script, const ChildLimits& limits = {}) {
    EventLoop loop;
    std::optional<ChildResult> result;
    const ChildProcess child(loop, {"/bin/sh", "-c", script}, limits,
                             [&](const ChildResult& ended) { result = ended; });
    const auto end = EventLoop::Clock::now() + 60s;
    while (!result && EventLoop::Clock::now() < end)
        loop.run_once(1s);
    REQUIRE(result.has_value());
    return *result;
}

}  // namespace

TEST_CASE("a child's answer is its output, its complaint what it said last") {
    const ChildResult result = run("echo '{}'; echo why >&2; exit 3");
    CHECK(result.end == End::exited);
    CHECK(result.code == 3);
    CHECK(result.output == "{}\n");
    CHECK(result.complaint == "why\n");
}

TEST_CASE("a long output arrives whole, one beyond the limit ends the child") {
    CHECK(run("head -c 3000000 /dev/zero").output.size() == 3'000'000);
    const ChildResult result = run("cat /dev/zero", {.output_bytes = 500'000});
    CHECK(result.end == End::talked_too_much);
    CHECK(result.output.size() == 500'000);
    CHECK(run("head -c 600000 /dev/zero", {.output_bytes = 500'000}).end == End::talked_too_much);
}

TEST_CASE("lines are heard as they come, the last one is the answer") {
    const TemporaryDirectory home;
    const std::string gate = (home.path / "gate").string();
    REQUIRE(::mkfifo(gate.c_str(), 0600) == 0);
    EventLoop loop;
    std::vector<std::string> lines;
    std::optional<ChildResult> result;
    const std::string script =
        "echo one; printf 'tw'; read -r word < '" + gate + "'; echo o; printf 'left over'";
    const ChildProcess child(
        loop, {"/bin/sh", "-c", script}, {}, [&](const ChildResult& ended) { result = ended; },
        [&](const std::string& line) { lines.push_back(line); });
    const auto comes_true = [&](const auto& condition) {
        const auto end = EventLoop::Clock::now() + 60s;
        while (!condition() && EventLoop::Clock::now() < end)
            loop.run_once(1s);
        return condition();
    };
    CHECK(comes_true([&] { return lines == std::vector<std::string>{"one"}; }));  // the child still waits
    CHECK_FALSE(result.has_value());
    std::ofstream(gate) << "go\n";
    CHECK(comes_true([&] { return result.has_value(); }));
    CHECK(lines == std::vector<std::string>{"one", "two"});
    CHECK(result->output == "left over");
}

TEST_CASE("of endless complaints the end is kept") {
    const ChildResult result = run("head -c 1000000 /dev/zero >&2; echo the reason >&2");
    CHECK(result.complaint.size() <= ChildProcess::max_complaint);
    CHECK(result.complaint.ends_with("the reason\n"));
}

TEST_CASE("where memory ends, a child is killed and not the daemon") {
    CHECK(run("cat /proc/self/oom_score_adj").output == "1000\n");
}

TEST_CASE("a crash is told by its signal") {
    const ChildResult result = run("kill -SEGV $$");
    CHECK(result.end == End::killed);
    CHECK(result.code == SIGSEGV);
}

TEST_CASE("a child that waits for what does not come is killed with all its own children") {
    const TemporaryDirectory directory;
    const std::string file = (directory.path / "pid").string();
    const ChildResult result =
        run("sleep 1000 & echo $! > " + file + "; wait", {.patience = {.idling = 300ms}});
    CHECK(result.end == End::idle);
    std::ifstream stream(file);
    pid_t grandchild = 0;
    if (!(stream >> grandchild)) return;  // killed before it could start one
    const auto end = EventLoop::Clock::now() + 60s;
    EventLoop loop;
    while (std::filesystem::exists("/proc/" + std::to_string(grandchild) + "/exe") &&
           EventLoop::Clock::now() < end)
        loop.run_once(10ms);
    std::error_code gone;  // a zombie that nobody reaps has no executable any more
    CHECK_FALSE(std::filesystem::exists("/proc/" + std::to_string(grandchild) + "/exe", gone));
}

TEST_CASE("a child that computes without progress is killed, one that says something now and then is not") {
    const ChildLimits limits{.patience = {.computing = 300ms, .idling = 60s}};
    CHECK(run("while :; do :; done", limits).end == End::late);
    const ChildResult result = run(
        "for i in 1 2 3 4 5 6 7 8; do echo; timeout .1 sh -c 'while :; do :; done'; done; echo done", limits);
    CHECK(result.end == End::exited);
}

TEST_CASE("the processor time that another takes is not held against a child") {
    EventLoop loop;
    std::optional<ChildResult> result;
    ChildProcess child(loop, {"/bin/sh", "-c", "sleep 1000"},
                       {.patience = {.computing = 100ms, .idling = 400ms}},
                       [&](const ChildResult& ended) { result = ended; });
    child.pause();
    for (const auto end = EventLoop::Clock::now() + 1s; EventLoop::Clock::now() < end;)
        loop.run_once(50ms);
    CHECK_FALSE(result.has_value());
    child.go_on();
    while (!result)
        REQUIRE(loop.run_once(60s));
    CHECK(result->end == End::idle);
}

TEST_CASE("the time for which the daemon itself stands still is not held against a child") {
    EventLoop loop;
    std::optional<ChildResult> result;
    ChildProcess child(loop, {"/bin/sh", "-c", "sleep 1000"}, {.patience = {.idling = 800ms}},
                       [&](const ChildResult& ended) { result = ended; });
    loop.run_once(60s);  // the first look at it: by the next it is idle
    const auto end = EventLoop::Clock::now() + 1s;
    while (EventLoop::Clock::now() < end) {
    }
    loop.run_once(0s);
    child.stop();  // too late, if it was killed before
    while (!result)
        REQUIRE(loop.run_once(60s));
    CHECK(result->end == End::stopped);
}

TEST_CASE("a child that left others behind with its pipes open ends all the same") {
    CHECK(run("sleep 1000 & echo done").output == "done\n");
}

TEST_CASE("a child cannot take more memory than allowed") {
    const ChildResult result = run(
        "exec tail /dev/zero", {.patience = {.computing = 50s, .idling = 50s}, .memory_bytes = 100U << 20});
    CHECK(result.end == End::exited);
    CHECK(result.code == 1);
    CHECK(result.complaint.find("memory") != std::string::npos);
}

TEST_CASE("a child has no input, no new privileges, no core file and a lower priority") {
    const ChildResult result =
        run("cat; ulimit -c; grep NoNewPrivs /proc/self/status; nice", {.niceness = 3});
    const std::string expected = "0\nNoNewPrivs:\t1\n";
    REQUIRE(result.output.starts_with(expected));
    const int ours = ::getpriority(PRIO_PROCESS, 0);
    CHECK(std::stoi(result.output.substr(expected.size())) == std::min(ours + 3, 19));
}

TEST_CASE("a child that is stopped says so, and one that is dropped is killed") {
    EventLoop loop;
    std::optional<End> end;
    std::unique_ptr<ChildProcess> child;
    child = std::make_unique<ChildProcess>(loop, std::vector<std::string>{"/bin/sh", "-c", "sleep 1000"},
                                           ChildLimits{}, [&](const ChildResult& result) {
                                               end = result.end;
                                               child.reset();
                                           });
    child->stop();
    while (!end)
        REQUIRE(loop.run_once(60s));
    CHECK(end == End::stopped);
    CHECK_FALSE(child);

    child =
        std::make_unique<ChildProcess>(loop, std::vector<std::string>{"/bin/sh", "-c", "sleep 1000"},
                                       ChildLimits{}, [](const ChildResult&) { FAIL("it ended by itself"); });
    child.reset();
    CHECK_FALSE(loop.run_once(0s));
    while (::waitpid(-1, nullptr, 0) > 0) {
    }
    CHECK(errno == ECHILD);
}

TEST_CASE("a child that is paused stands still until it goes on, and can be killed meanwhile") {
    const TemporaryDirectory home;
    const std::string marks = (home.path / "marks").string();
    const auto marked = [&] { return fs::exists(marks) ? fs::file_size(marks) : 0; };
    EventLoop loop;
    std::optional<ChildResult> result;
    ChildProcess child(loop, {"/bin/sh", "-c", "while sleep 0.01; do echo >> " + marks + "; done"}, {},
                       [&](const ChildResult& ended) { result = ended; });
    const auto grows = [&](std::uintmax_t beyond) {
        const auto end = EventLoop::Clock::now() + 60s;
        while (marked() <= beyond && EventLoop::Clock::now() < end)
            loop.run_once(10ms);
        return marked() > beyond;
    };
    REQUIRE(grows(2));
    child.pause();
    for (int i = 0; i < 5; ++i)
        loop.run_once(10ms);  // the loop finishes the work under way
    const auto before = marked();
    for (int i = 0; i < 20; ++i)
        loop.run_once(10ms);
    CHECK(marked() == before);
    child.go_on();
    CHECK(grows(before));
    child.pause();
    child.stop();
    while (!result)
        loop.run_once(1s);
    CHECK(result->end == End::stopped);
}

TEST_CASE("a program that is not there fails like any other") {
    EventLoop loop;
    std::optional<ChildResult> result;
    const ChildProcess child(loop, {"/nowhere/at-all"}, {},
                             [&](const ChildResult& ended) { result = ended; });
    while (!result)
        REQUIRE(loop.run_once(60s));
    CHECK(result->end == End::exited);
    CHECK(result->code == 127);
    CHECK(result->complaint.find("cannot be started") != std::string::npos);
}

#include "player/control/analyzer_word.hpp"

#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <future>
#include <thread>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

TEST_CASE("nobody waits for the analyzer's word, however long it takes to read") {
    const TemporaryDirectory state;
    const auto file = state.write("status.json", "{}");
    std::promise<void> may_end;
    std::atomic<int> read = 0;
    std::atomic<bool> is_here = false;
    const std::thread::id here = std::this_thread::get_id();
    {
        AnalyzerWordReader reader(file, [&, allowed = may_end.get_future().share()](const auto&) {
            ++read;
            is_here = std::this_thread::get_id() == here;
            if (!is_here) allowed.wait();
            return AnalyzerWord{.summary = "all is well", .entries = {{"a.jpg", "{}"}}};
        });
        auto now = 0s;
        for (; now < 10s; now += 1s)
            reader.look(now);  // would never return if it read here
        CHECK_FALSE(is_here);
        CHECK(reader.word().summary.empty());
        may_end.set_value();
        for (; reader.word().summary.empty() && now < 10'000s; now += 1s) {
            std::this_thread::sleep_for(1ms);
            reader.look(now);
        }
        CHECK(reader.word().summary == "all is well");
        CHECK(reader.word().entry("a.jpg") == "{}");
    }
    CHECK(read == 1);
}

TEST_CASE("the analyzer's word is cut into a summary and a piece for each file") {
    const AnalyzerWord word = analyzer_word_from(
        R"({"online":true,"files":[{"path":"a","state":"ready"},{"path":"b","state":"ready"}]})");
    CHECK(word.summary == R"({"online":true,"states":{"ready":2}})");
    CHECK(word.entry("b") == R"({"path":"b","state":"ready"})");
    CHECK(word.entry("c").empty());
    CHECK(analyzer_word_from("[").summary.empty());
}

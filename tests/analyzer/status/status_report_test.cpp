#include "analyzer/status/status_report.hpp"

#include "analyzer/status/status_page.hpp"
#include "analyzer/status/status_text.hpp"
#include "base/hints/hint_words.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
using State = FileState::State;

namespace {

std::string moment(std::chrono::system_clock::time_point time) {
    return std::to_string(time.time_since_epoch() / 1s) + " s";
}

StatusEntry entry(std::string path, State state, std::string reason = "", std::chrono::seconds since = 0s) {
    return {.file = {.path = std::move(path),
                     .state = state,
                     .since = std::chrono::system_clock::time_point(since),
                     .reason = std::move(reason)},
            .id = "id"};
}

std::string page(const StatusReport& report, const std::set<std::string>& thumbnails = {},
                 bool has_wall = false) {
    return status_page(report, on_page(report), {.thumbnails = thumbnails, .has_wall = has_wall}, moment);
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
        ++found;
    return found;
}

}  // namespace

TEST_CASE("files in the inbox have a list of their own") {
    StatusReport report;
    report.files = {entry("a.jpg", State::ready)};
    report.inbox = {"_INBOX/b<.jpg", "_INBOX/c.jpg"};
    const std::string text = status_text(report, moment);
    CHECK(text.find("_INBOX/c.jpg: In the inbox, not shown until somebody moves it out\n") !=
          std::string::npos);
    CHECK(text.starts_with("1 file: 1 ready\n"));
    CHECK(count(page(report), "_INBOX/") == 2);
    CHECK(page(report).find("b&lt;.jpg") != std::string::npos);
    CHECK(status_json(report).find(R"("inbox":["_INBOX/b<.jpg","_INBOX/c.jpg"])") != std::string::npos);
}

TEST_CASE("each file has a line that says where it stands and why") {
    StatusReport report;
    report.files = {entry("a.jpg", State::ready),
                    entry("b.mp4", State::copying),
                    entry("c.jpg", State::analysing),
                    entry("d.mp4", State::waiting, "the copy is not complete", 90s),
                    entry("e.txt", State::unsupported, "it is no photo and no film"),
                    entry("f.jpg", State::failed, "it cannot be read"),
                    entry("g.mp4", State::quarantined, "twice it crashed its reader")};
    report.files[0].hints = hints_in_name("08-18 20s", NamePart::folder);
    report.files[0].keyframes = {.keyframes = {1s, 2s, 3s}};
    CHECK(status_text(report, moment) ==
          "7 files: 1 ready, 1 copying, 1 looked at, 1 waiting, 1 unsupported, 1 not "
          "readable, 1 quarantined\n"
          "\n"
          "a.jpg: ready, from 08:00 to 18:00, for 20 seconds; tapestry: 3 keyframes chosen\n"
          "b.mp4: copying: it still changes\n"
          "c.jpg: being looked at\n"
          "d.mp4: waiting since 90 s: the copy is not complete\n"
          "e.txt: unsupported because it is no photo and no film\n"
          "f.jpg: not shown because it cannot be read\n"
          "g.mp4: quarantined because twice it crashed its reader\n");
    CHECK(status_text({}, moment) == "0 files\n\n");
}

TEST_CASE("what is wrong with hints stands above the files") {
    StatusReport report;
    report.remarks = {"a/.vitrine.toml:2: there is no key 'huors'"};
    report.files = {entry("a.jpg", State::ready)};
    CHECK(status_text(report, moment) ==
          "1 file: 1 ready\na/.vitrine.toml:2: there is no key 'huors'\n\na.jpg: ready\n");
    CHECK(page(report).find("<p class=\"remark\">a/.vitrine.toml:2: there is no key &#39;huors&#39;</p>") !=
          std::string::npos);
}

TEST_CASE("a name with a newline or tags has one line and one card") {
    StatusReport report;
    report.files = {entry("a\nb<script>\"&.jpg", State::failed, "its name is \"<b>\"")};
    CHECK(count(status_text(report, moment), "\n") == 3);
    const std::string html = page(report);
    CHECK(count(html, "<script") == 0);
    CHECK(count(html, "<b>") == 1);
    CHECK(count(html, "a\\x0ab&lt;script&gt;&quot;&amp;.jpg") == 1);
}

TEST_CASE("the page needs no script, has a thumbnail where there is one, and the wall") {
    StatusReport report;
    report.files = {entry("summer/a.jpg", State::ready), entry("b.jpg", State::ready),
                    entry("c.txt", State::unsupported, "it is no photo and no film")};
    report.files[0].id = "0123456789abcdef";
    const std::string html = page(report, {"0123456789abcdef"}, true);
    CHECK(count(html, "<script") == 0);
    CHECK(count(html, " on") == count(html, " on the wall"));  // no handlers of events either
    CHECK(count(html, "src=\"thumbnails/0123456789abcdef.jpg\"") == 1);
    CHECK(count(html, "src=\"wall.jpg\"") == 1);
    CHECK(count(html, "no picture") == 2);
    CHECK(count(html, "<li") == 3);
    CHECK(count(html, "<ul>") == count(html, "</ul>"));
    CHECK(html.find("Not on the wall") < html.find("c.txt"));
    CHECK(html.find("c.txt") < html.find("Ready to be shown"));
    CHECK(html.find("Ready to be shown") < html.find("a.jpg"));
    CHECK(count(page(report), "wall.jpg") == 0);
}

TEST_CASE("of very many files the page has those at fault and the newest, and says so") {
    StatusReport report;
    for (int i = 0; i < 50'000; ++i)
        report.files.push_back(entry("p" + std::to_string(100'000 + i),
                                     i % 10 == 0 ? State::failed : State::ready, "",
                                     std::chrono::minutes(i)));
    const std::vector<StatusEntry> files = on_page(report);
    CHECK(files.size() == max_on_page);
    CHECK(files.front().file.state == State::failed);
    CHECK(files.back().file.state == State::ready);
    CHECK(files[max_on_page / 2].file.path == "p149999");
    const std::string html = page(report);
    CHECK(html.size() < 1'000'000);
    CHECK(count(html, "1000 of 50000 files are here; status.txt has all of them.") == 1);
    CHECK(count(status_text(report, moment), "\n") == 50'002);
}

TEST_CASE("machines read the same as JSON, exact names in hex") {
    StatusReport report;
    report.is_online = false;
    report.remarks = {"\xff"};
    report.files = {entry("a.jpg", State::ready, "", 5s),
                    entry("\xff.jpg", State::waiting, "half of it is missing", 7s)};
    report.files[0].hints = hints_in_name("3x", NamePart::folder);
    CHECK(status_json(report) ==
          "{\"version\":1,\"online\":false,\"remarks\":[\"\xef\xbf\xbd\"],\"inbox\":[],\"files\":["
          "{\"path\":\"a.jpg\",\"state\":\"ready\",\"since\":5,\"shown\":\"3 times as often\"},"
          "{\"path\":\"\xef\xbf\xbd.jpg\",\"state\":\"waiting\",\"since\":7,\"path_hex\":\"ff2e6a7067\","
          "\"reason\":\"half of it is missing\"}]}\n");
}

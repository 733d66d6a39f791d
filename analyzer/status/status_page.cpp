#include "analyzer/status/status_page.hpp"

#include "analyzer/status/plain_text.hpp"
#include "analyzer/status/status_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine::analyzer {

namespace {

// The page loads nothing from elsewhere, runs no script, and reloads itself.
constexpr std::string_view head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src 'self' file:; style-src 'unsafe-inline'">
<meta http-equiv="refresh" content="30"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Vitrine: what is on the wall</title>
<style>
body { font: 16px/1.45 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; margin: 1.5rem auto; max-width: 75rem;
  padding: 0 1rem; color: #222; background: #f5f5f3; }
h1 { font-size: 1.5rem; margin: 0 0 .25rem; } h2 { font-size: 1.15rem; margin: 2rem 0 .5rem; }
.wall { display: block; width: 100%; max-width: 45rem; margin-top: 1rem; border: 1px solid #999; background: #000; }
.note { color: #666; font-size: .875rem; }
.remark { background: #fdecc8; border-left: 4px solid #d08700; padding: .35rem .75rem; margin: .35rem 0; }
ul { list-style: none; margin: 0; padding: 0; display: grid; gap: .75rem;
  grid-template-columns: repeat(auto-fill, minmax(13.5rem, 1fr)); }
li { background: #fff; border: 1px solid #ddd; border-top: 4px solid #2c8a3d; padding: .5rem; overflow-wrap: anywhere; }
li.busy { border-top-color: #3572b0; } li.wait { border-top-color: #d08700; } li.bad { border-top-color: #c0392b; }
.shot { height: 9rem; display: flex; align-items: center; justify-content: center; background: #eee; color: #888;
  font-size: .8125rem; margin-bottom: .4rem; }
.shot img { max-width: 100%; max-height: 100%; } b { display: block; font-weight: 600; }
.folder { color: #666; font-size: .8125rem; } .why { font-size: .875rem; }
</style></head><body>
)";

const char* look_of(const StatusEntry& entry) {
    using State = FileState::State;
    const State state = entry.file.state;
    const bool is_kept_off = entry.on_wall && !may_be_shown(entry.on_wall->visibility);
    if (state == State::ready) return is_kept_off ? "wait" : "ready";
    if (state == State::copying || state == State::analysing) return "busy";
    return state == State::waiting ? "wait" : "bad";
}

std::string card(const StatusEntry& entry, bool has_thumbnail, const ClockText& clock) {
    const std::string& path = entry.file.path;
    const std::size_t slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
    const std::string picture =
        has_thumbnail ? fmt::format(R"(<img src="thumbnails/{}.jpg" alt="" loading="lazy">)", entry.id)
                      : "no picture";
    return fmt::format(R"(<li class="{}"><div class="shot">{}</div><span class="folder">{}</span><b>{}</b>)"
                       R"(<span class="why">{}</span></li>)"
                       "\n",
                       look_of(entry), picture, html_text(folder), html_text(path.substr(folder.size())),
                       html_text(in_words(entry, clock)));
}

}  // namespace

std::vector<StatusEntry> on_page(const StatusReport& report) {
    std::vector<StatusEntry> ready;
    std::vector<StatusEntry> files;
    for (const StatusEntry& entry : report.files) {
        const bool is_ready = entry.file.state == FileState::State::ready;
        if (is_ready)
            ready.push_back(entry);
        else if (files.size() < max_on_page / 2)
            files.push_back(entry);
    }
    std::stable_sort(ready.begin(), ready.end(), [](const StatusEntry& a, const StatusEntry& b) {
        return std::chrono::floor<std::chrono::minutes>(a.file.since) >
               std::chrono::floor<std::chrono::minutes>(b.file.since);
    });
    ready.resize(std::min(ready.size(), max_on_page - files.size()));
    files.insert(files.end(), ready.begin(), ready.end());
    return files;
}

std::string status_page(const StatusReport& report, const std::vector<StatusEntry>& files,
                        const PageParts& beside, const ClockText& clock) {
    std::string html(head);
    html += fmt::format("<h1>{}</h1>\n", html_text(summary(counts_of(report))));
    if (!report.is_player_running) html += fmt::format("<p class=\"remark\">{}</p>\n", player_is_off);
    if (!report.is_online) html += "<p class=\"remark\">The media folder is not there.</p>\n";
    for (const std::string& remark : report.remarks)
        html += fmt::format("<p class=\"remark\">{}</p>\n", html_text(remark));
    if (beside.has_wall) html += "<img class=\"wall\" src=\"wall.jpg\" alt=\"The wall as it is now\">\n";
    html += "<p class=\"note\">The outlined part of each picture is never covered.</p>\n";
    if (beside.has_played)
        html += "<p class=\"note\"><a href=\"played/\">How long each file was seen, day by day</a></p>\n";
    const auto first_ready = std::ranges::find_if(
        files, [](const StatusEntry& entry) { return entry.file.state == FileState::State::ready; });
    for (auto it = files.begin(); it != files.end(); ++it) {
        if (it == first_ready)
            html += "<h2>Ready to be shown</h2>\n<ul>\n";
        else if (it == files.begin())
            html += "<h2>Not on the wall</h2>\n<ul>\n";
        html += card(*it, beside.thumbnails.contains(it->id), clock);
        if (std::next(it) == first_ready || std::next(it) == files.end()) html += "</ul>\n";
    }
    if (files.size() < report.files.size())
        html += fmt::format("<p class=\"note\">{} of {} files are here; status.txt has all of them.</p>\n",
                            files.size(), report.files.size());
    if (!report.inbox.empty()) html += fmt::format("<h2>{}</h2>\n<ul>\n", what_inbox_is);
    for (const std::string& path : report.inbox)
        html += fmt::format("<li class=\"wait\"><b>{}</b></li>\n", html_text(path));
    if (!report.inbox.empty()) html += "</ul>\n";
    return html + "</body></html>\n";
}

}  // namespace vitrine::analyzer

#pragma once

#include "analyzer/status/status_report.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Files on the page at most; status.txt has all.
constexpr std::size_t max_on_page = 1000;

/// The files on the page: first those that are not ready, at most half of it, then the ready ones, newest
/// first.
std::vector<StatusEntry> on_page(const StatusReport& report);

/// Names the files that lie beside the page.
struct PageParts {
    std::set<std::string> thumbnails;  // ids of those that lie in thumbnails/
    bool has_wall = false;             // wall.jpg
    bool has_played = false;           // tables in played/
};

/// Writes index.html. @param files  those of on_page()
std::string status_page(const StatusReport& report, const std::vector<StatusEntry>& files,
                        const PageParts& beside, const ClockText& clock);

}  // namespace vitrine::analyzer

#pragma once

#include <span>
#include <string_view>

namespace vitrine::analyzer {

/// A file of the page that shows a tapestry in a browser.
struct PageFile {
    std::string_view name;
    std::string_view content;
};

/// The files below page/, which the build puts into the program: index.html first, then what it reads.
std::span<const PageFile> page_files();

}  // namespace vitrine::analyzer

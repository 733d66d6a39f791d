#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace vitrine::analyzer {

/// The folder of a page that shows a tapestry in a browser: index.html, and beside it a folder `tapestry-N`
/// with all that the page reads. A new page replaces an earlier one as a whole: index.html names the new
/// folder once that is complete, then the earlier one goes.
class PageFolder {
  public:
    /// Changes nothing. @throws std::runtime_error that names the folder, where it holds other files than a
    /// page of ours or the rest of one that was interrupted
    explicit PageFolder(std::filesystem::path folder);
    PageFolder(const PageFolder&) = delete;
    PageFolder& operator=(const PageFolder&) = delete;

    /// Removes a page that was not published.
    ~PageFolder();

    /// Makes the folder for the files that the new page reads, with the page's own among them. Call once.
    /// @throws std::system_error
    const std::filesystem::path& begin();

    /// Puts the new page in the place of the earlier one. @pre begin()
    /// @throws std::system_error; the earlier page then stays
    void publish();

  private:
    std::filesystem::path folder_;
    std::filesystem::path data_;  // of the new page; empty: none is begun, or it is published
};

/// A file of the page that shows a tapestry in a browser.
struct PageFile {
    std::string_view name;
    std::string_view content;
};

/// The files below page/, which the build puts into the program: index.html first, then what it reads.
std::span<const PageFile> page_files();

}  // namespace vitrine::analyzer

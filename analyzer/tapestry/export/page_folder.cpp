#include "analyzer/tapestry/export/page_folder.hpp"

#include "base/system/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr const char* page_name = "index.html";
constexpr std::string_view page_mark = R"(<meta name="generator" content="Vitrine tapestry">)";
constexpr std::size_t max_mark_place = 1024;  // bytes of index.html among which the mark is
constexpr std::string_view data_begin = "tapestry-";
constexpr std::string_view data_word = "@FOLDER@";  // stands in index.html for the name of the folder

bool is_page(const fs::path& file) {
    std::ifstream page(file, std::ios::binary);
    std::string begin(max_mark_place, '\0');
    page.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    return begin.find(page_mark) != std::string::npos;
}

bool is_data_folder(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.size() > data_begin.size() && name.starts_with(data_begin) &&
           name.find_first_not_of("0123456789", data_begin.size()) == std::string::npos;
}

void require_page_or_nothing(const fs::path& folder) {
    std::error_code error;
    if (!fs::exists(folder, error)) return;
    if (!fs::is_directory(folder, error))
        throw std::runtime_error(fmt::format("'{}': it is no folder", folder.string()));
    if (is_page(folder / page_name)) return;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (!is_data_folder(entry.path()) && entry.path() != unfinished(folder / page_name))
            throw std::runtime_error(fmt::format("'{}': it holds other files, such as '{}'; name a new "
                                                 "folder, an empty one, or an earlier page",
                                                 folder.string(), entry.path().filename().string()));
}

fs::path new_data_folder(const fs::path& folder) {
    for (int number = 1;; ++number) {
        fs::path made = folder / fmt::format("{}{}", data_begin, number);
        if (fs::create_directories(made)) return made;
    }
}

void remove_data_folders(const fs::path& folder, const fs::path& kept) {
    std::vector<fs::path> others;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (is_data_folder(entry.path()) && entry.path() != kept) others.push_back(entry.path());
    for (const fs::path& other : others)
        fs::remove_all(other);
}

std::string page_naming(const fs::path& data) {
    std::string page(page_files().front().content);
    for (std::size_t at = page.find(data_word); at != std::string::npos; at = page.find(data_word, at))
        page.replace(at, data_word.size(), data.filename().string());
    return page;
}

}  // namespace

PageFolder::PageFolder(fs::path folder) : folder_(std::move(folder)) {
    require_page_or_nothing(folder_);
}

PageFolder::~PageFolder() {
    std::error_code ignored;  // the next page removes it
    if (!data_.empty()) fs::remove_all(data_, ignored);
}

const fs::path& PageFolder::begin() {
    data_ = new_data_folder(folder_);
    for (const PageFile& file : page_files().subspan(1))
        replace_file(data_ / file.name, file.content);
    return data_;
}

void PageFolder::publish() {
    replace_file(folder_ / page_name, page_naming(data_));
    const fs::path published = std::exchange(data_, {});
    remove_data_folders(folder_, published);
}

}  // namespace vitrine::analyzer

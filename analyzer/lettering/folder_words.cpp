#include "analyzer/lettering/folder_words.hpp"

#include "base/hints/hint_words.hpp"
#include "base/state/word_picture.hpp"

#include <set>
#include <string_view>
#include <system_error>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

std::set<std::string> shown_folder_names(std::span<const std::string> paths) {
    std::set<std::string_view> folders;
    for (const std::string_view path : paths)
        for (std::size_t end = path.rfind('/'); end != std::string_view::npos;
             end = path.rfind('/', end - 1)) {
            if (!folders.insert(path.substr(0, end)).second || end == 0) break;
        }
    std::set<std::string> names;
    for (const std::string_view folder : folders)
        names.insert(shown_folder_name(folder));
    return names;
}

std::vector<std::string> lacking_words(const std::set<std::string>& words, const fs::path& state) {
    std::vector<std::string> lacking;
    for (const std::string& word : words) {
        std::error_code error;
        if (!fs::exists(word_picture(state, word), error)) lacking.push_back(word);
    }
    return lacking;
}

void remove_other_words(const std::set<std::string>& words, const fs::path& state) {
    std::set<fs::path> kept;
    for (const std::string& word : words)
        kept.insert(word_picture(state, word).filename());
    std::error_code error;
    std::vector<fs::path> others;
    for (fs::directory_iterator file(word_folder(state), error), end; !error && file != end;
         file.increment(error))
        if (!kept.contains(file->path().filename())) others.push_back(file->path());
    for (const fs::path& other : others)
        fs::remove(other, error);
}

}  // namespace vitrine::analyzer

#include "analyzer/lettering/set_words.hpp"

#include "analyzer/lettering/font_places.hpp"
#include "analyzer/lettering/line_picture.hpp"
#include "base/state/word_picture.hpp"
#include "base/system/error.hpp"
#include "base/system/sandbox.hpp"
#include "base/system/unique_fd.hpp"

#include <fcntl.h>

#include <filesystem>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr const char* thai_words = "/usr/share/libthai";  // pango reads there where Thai words end

void enter_font_sandbox(const fs::path& folder) {
    const UniqueFd written(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (!written.is_open()) throw_errno("open '{}'", folder.string());
    std::vector<UniqueFd> held;
    SandboxRules rules{.readable = {}, .writable = {written.get()}};
    std::vector<fs::path> folders = font_places();
    folders.emplace_back(thai_words);
    for (const fs::path& name : folders) {
        UniqueFd fonts(::open(name.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
        if (!fonts.is_open()) continue;
        rules.readable.push_back(fonts.get());
        held.push_back(std::move(fonts));
    }
    enter_sandbox(rules);
}

}  // namespace

void set_words(std::span<const std::string> texts, const Settings& settings) {
    const fs::path state = settings.state.directory;
    fs::create_directories(word_folder(state));
    enter_font_sandbox(word_folder(state));
    for (const std::string& text : texts) {
        if (const auto code = code_of_key(text)) {
            write_code_picture(*code, word_picture(state, text));
            continue;
        }
        const auto caption = caption_of_key(text);
        write_line_picture(caption ? caption->text : text, word_picture(state, text),
                           caption ? LineStyle{.lines = caption->lines, .is_caption = true} : LineStyle{});
    }
}

}  // namespace vitrine::analyzer

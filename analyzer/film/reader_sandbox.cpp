#include "analyzer/film/reader_sandbox.hpp"

#include "base/media/decoder_table.hpp"
#include "base/media/gst_ptr.hpp"
#include "base/media/media_type.hpp"
#include "base/media/still_picture.hpp"
#include "base/state/media_error.hpp"
#include "base/system/log.hpp"
#include "base/system/sandbox.hpp"
#include "base/system/unique_fd.hpp"

#include <fcntl.h>

#include <array>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

// The pipelines of film_source, clip_reader, clip_writer and stored_sound have these elements beside the
// decoders. An element that is missing here cannot be made in the sandbox.
constexpr std::array own_elements{"appsink",   "appsrc",  "capsfilter", "videoconvert", "videoconvertscale",
                                  "videoflip", "x264enc", "h264parse",  "mp4mux",       "matroskamux",
                                  "filesink"};

/// None: the file is no medium, so nothing decodes it.
std::optional<MediaFormat> format_of(const MediaFile& file) {
    try {
        if (file.is_plain()) return media_format(file.name());
    } catch (const MediaError&) {  // whoever reads it next says so
        return std::nullopt;
    }
    return std::nullopt;
}

void load_readers(MediaFormat format, bool holds_film) {
    init_vips();  // it writes the thumbnails of films, too
    const bool is_photo = kind_of(format) == MediaKind::photo;
    if (is_photo && !holds_film) return;
    start_gstreamer();
    load_decoders(is_photo ? MediaFormat::mp4 : format);
    for (const char* factory : own_elements)
        load_element(factory);
}

std::vector<fs::path> folders_for(std::optional<MediaFormat> format, const ReaderNeeds& needs) {
    if (!format) return {};
    std::vector<fs::path> folders = needs.folders;
    if (kind_of(*format) == MediaKind::film && !needs.film_folder.empty())
        folders.push_back(needs.film_folder);
    return folders;
}

/// The descriptors are held until the sandbox has them.
class Descriptors {
  public:
    void add(const char* name, int flags) {
        UniqueFd file(::open(name, flags | O_PATH | O_CLOEXEC));
        if (!file.is_open()) return log::debug("not in the sandbox: '{}'", name);
        numbers_.push_back(file.get());
        held_.push_back(std::move(file));
    }

    const std::vector<int>& numbers() const { return numbers_; }

  private:
    std::vector<UniqueFd> held_;
    std::vector<int> numbers_;
};

}  // namespace

void enter_reader_sandbox(const MediaFile& file, const ReaderNeeds& needs) {
    const std::optional<MediaFormat> format = format_of(file);
    if (format) load_readers(*format, needs.holds_film);
    Descriptors folders, models;  // models and libraries
    for (const fs::path& folder : folders_for(format, needs)) {
        std::error_code ignored;
        fs::create_directories(folder, ignored);
        folders.add(folder.c_str(), O_DIRECTORY);
    }
    for (const std::string& model : needs.models)
        if (!model.empty()) models.add(model.c_str(), 0);
    for (const fs::path& library : needs.libraries)
        models.add(library.c_str(), O_DIRECTORY);
    // Libraries put files without a name there, such as the code that Orc makes at run time.
    if (!needs.folders.empty()) ::setenv("TMPDIR", needs.folders.front().c_str(), 1);
    SandboxRules rules{.readable = models.numbers(), .writable = folders.numbers()};
    rules.readable.push_back(file.descriptor());
    log::debug("{}", in_words(enter_sandbox(rules)));
}

}  // namespace vitrine::analyzer

#include "analyzer/one_file/inner_film.hpp"

#include "analyzer/film/frame_reader.hpp"
#include "analyzer/one_file/analyze.hpp"
#include "analyzer/origin/motion_photo.hpp"
#include "analyzer/store/store_writer.hpp"
#include "base/media/file_bytes.hpp"
#include "base/state/media_error.hpp"
#include "base/system/error.hpp"
#include "base/system/unique_fd.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <system_error>
#include <vector>

namespace vitrine::analyzer {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t max_film = 200U << 20U;  // bytes; those of phones have 2 to 10 MB

void write_part(const std::string& from, const FilePart& part, const fs::path& to) {
    const FileBytes file(from);
    const UniqueFd output(::open(to.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600));
    if (!output.is_open()) throw_errno("write '{}'", to.string());
    std::vector<std::byte> bytes(std::size_t{1} << 20U);
    for (std::uint64_t done = 0; done < part.bytes;) {
        const auto wanted =
            static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), part.bytes - done));
        const std::size_t got = file.read(part.at + done, std::span(bytes).first(wanted));
        if (got == 0) return;
        if (::write(output.get(), bytes.data(), got) != static_cast<ssize_t>(got))
            throw_errno("write '{}'", to.string());
        done += got;
    }
}

/// Analyses the film and stores its longest shot.
std::optional<InnerFilm> stored_film(const fs::path& file, const StorePlace& place,
                                     const AnalysisSettings& settings) {
    const std::unique_ptr<FrameSource> source = open_media(file.string(), settings.frame_size);
    MediaRecord film = analyze(*source, settings);
    if (film.kind != MediaKind::film || film.shots.empty()) return std::nullopt;
    const Shot longest = *std::ranges::max_element(film.shots, {}, &Shot::duration);
    film.shots = {longest};
    StoreWriter writer(file.string(), source->info(), place);
    writer.add_shot(longest);
    writer.finish(film);
    const InnerFilm found{.shot = film.shots.front(), .width = film.width, .height = film.height};
    return found.shot.stored ? std::optional(found) : std::nullopt;
}

}  // namespace

void add_inner_film(MediaRecord& record, const std::string& photo, const StorePlace& place,
                    const AnalysisSettings& settings) {
    const fs::path copy = place.store / place.id / "inner.mp4";
    const auto leave_out = [&](const std::string& reason) {
        record.reason = fmt::format("its film is not played: {}", reason);
    };
    try {
        if (!may_hold_film(photo)) return;
        const InnerFilmPlace inner = inner_film_place(photo);
        if (!inner.is_promised) return;
        if (!inner.film) return leave_out("there is none where the photo says");
        if (inner.film->bytes > std::min(max_film, place.max_bytes)) return leave_out("it is too large");
        if (!has_room(place)) return leave_out("the disk is full");
        write_part(photo, *inner.film, copy);
        record.film = stored_film(copy, place, settings);
        if (!record.film) leave_out("it cannot be stored");
    } catch (const MediaError& error) {
        leave_out(error.what());
    } catch (const std::system_error& error) {
        leave_out(error.what());
    } catch (const cv::Exception&) {
        leave_out("pictures of its size or shape cannot be analysed");
    } catch (const std::bad_alloc&) {
        leave_out("it needs too much memory");
    }
    std::error_code ignored;
    fs::remove(copy, ignored);
}

}  // namespace vitrine::analyzer

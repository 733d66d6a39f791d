#include "analyzer/origin/motion_photo.hpp"

#include "tests/analyzer/origin/drawn_boxes.hpp"
#include "tests/analyzer/origin/drawn_exif.hpp"
#include "tests/analyzer/origin/drawn_motion_photo.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

const std::string film = movie(movie_header(3'800'000'000));
const std::string picture = jpeg_with(DrawnExif{}.bytes()) + "picture\xff\xd9";

/// A file with this content, looked at.
struct Looked {
    TemporaryDirectory house;
    std::string path;
    InnerFilmPlace place;

    explicit Looked(const std::string& content)
        : path(house.write("a.jpg", content).string()), place(inner_film_place(path)) {}
};

void check_found(const std::string& before, const std::string& behind) {
    const Looked looked(before + film + behind);
    CHECK(may_hold_film(looked.path));
    CHECK(looked.place.is_promised);
    REQUIRE(looked.place.film);
    CHECK(*looked.place.film == FilePart{.at = before.size(), .bytes = film.size()});
}

}  // namespace

TEST_CASE("the film in a motion photo is found by both kinds of Google's XMP, and by Samsung's list") {
    check_found(with_xmp(picture, micro_video_xmp(film.size())), "");
    check_found(with_xmp(picture, motion_photo_xmp(film.size())), "");
    const std::string samsung = samsung_end(film);
    const std::size_t at = samsung.find("ftyp") - 4;
    check_found(picture + samsung.substr(0, at), samsung.substr(at + film.size()));
    check_found(with_xmp(picture, motion_photo_xmp(film.size() + samsung.size() - at - film.size())) +
                    samsung.substr(0, at),
                samsung.substr(at + film.size()));
}

TEST_CASE("a photo that names a film where none is has none, and says that it should") {
    for (const std::string& xmp :
         {micro_video_xmp(film.size() + 1), motion_photo_xmp(0), micro_video_xmp(std::size_t{1} << 39U)}) {
        const Looked looked(with_xmp(picture, xmp) + film);
        CHECK(looked.place.is_promised);
        CHECK_FALSE(looked.place.film);
    }
    const Looked stripped(with_xmp(picture, motion_photo_xmp(film.size())));
    CHECK(stripped.place.is_promised);
    CHECK_FALSE(stripped.place.film);
}

TEST_CASE("a plain photo names no film") {
    const Looked looked(picture);
    CHECK_FALSE(may_hold_film(looked.path));
    CHECK_FALSE(looked.place.is_promised);
    CHECK_FALSE(looked.place.film);
}

TEST_CASE("no damage of a motion photo does more than hide its film") {
    std::mt19937 random(7);
    const std::vector<std::string> files{with_xmp(picture, motion_photo_xmp(film.size())) + film,
                                         picture + samsung_end(film)};
    for (int round = 0; round < 300; ++round) {
        std::string content = files[static_cast<std::size_t>(round) % files.size()];
        for (int i = 0; i < 8; ++i)
            content[random() % content.size()] = static_cast<char>(random());
        if (round % 3 == 0) content.resize(random() % content.size());
        const Looked looked(content);
        if (!looked.place.film) continue;
        CHECK(looked.place.film->at + looked.place.film->bytes <= content.size());
        CHECK(content.substr(looked.place.film->at + 4, 4) == "ftyp");
    }
}

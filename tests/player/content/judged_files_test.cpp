#include "player/content/judged_files.hpp"

#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// Files that are judged by a rule of the test.
struct Jury {
    bool judge(const std::set<std::string>& paths) { return files.judge(paths, records); }

    RecordList records = photos(3);
    std::map<std::string, Visibility> said;
    JudgedFiles files{[this](const MediaRecord& file) {
        const auto found = said.find(file.path);
        return FileVisibility{.path = file.path,
                              .visibility = found == said.end() ? Visibility::waits_for_turn : found->second};
    }};
};

}  // namespace

TEST_CASE("only the files that are named are judged") {
    Jury jury;
    CHECK(jury.files.judge_all(jury.records));
    CHECK(jury.files.judgements() == 3);
    jury.said = {{"p100", Visibility::dismissed}, {"p101", Visibility::dismissed}};

    CHECK(jury.judge({"p101"}));

    CHECK(jury.files.judgements() == 4);
    CHECK(jury.files.visible().size() == 2);
    CHECK(jury.files.all().find("p100")->visibility == Visibility::waits_for_turn);
    CHECK(jury.files.all().find("p101")->visibility == Visibility::dismissed);
    CHECK(jury.files.counts().at(Visibility::dismissed) == 1);
    CHECK(jury.files.counts().at(Visibility::waits_for_turn) == 2);
    CHECK_FALSE(jury.judge({"p101"}));
}

TEST_CASE("a file that is gone is forgotten, and another version of it is another list") {
    Jury jury;
    jury.files.judge_all(jury.records);
    jury.records.apply({{"p100", nullptr}, {"p102", std::make_shared<const MediaRecord>(photo("p102", 9))}});

    CHECK(jury.judge({"p100", "p102", "unheard of"}));

    CHECK(jury.files.visible().size() == 2);
    CHECK(jury.files.all().size() == 2);
    CHECK(jury.files.counts().at(Visibility::waits_for_turn) == 2);
    CHECK(jury.files.visible().find("p102")->mtime_ns == 9);
}

TEST_CASE("a file that is gone is forgotten as well where all are judged") {
    Jury jury;
    jury.files.judge_all(jury.records);
    jury.records.apply({{"p101", nullptr}});
    CHECK(jury.files.judge_all(jury.records));
    CHECK(jury.files.visible().size() == 2);
    CHECK(jury.files.all().size() == 2);
}

TEST_CASE("a file of a folder that no screen shows stays in the list") {
    Jury jury;
    jury.said = {{"p100", Visibility::other_folder}, {"p101", Visibility::closed_folder}};
    jury.files.judge_all(jury.records);
    CHECK(jury.files.visible().size() == 3);
}

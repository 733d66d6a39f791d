#include "base/settings/settings_snapshot.hpp"

#include "base/settings/setting_keys.hpp"
#include "base/settings/settings_file.hpp"
#include "base/settings/settings_text.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

namespace {

Settings read_again(const Settings& settings) {
    Settings again;
    read_settings(to_toml(settings), "again", again);
    return again;
}

void check_same(const Settings& a, const Settings& b) {
    for (const SettingKey& key : setting_keys())
        CHECK_MESSAGE(key.text(a) == key.text(b), key.name);
}

Settings odd_settings() {
    Settings settings;
    settings.media.root = "/srv/a \"quoted\" \\ folder\twith tab";
    settings.analyzer.face_cascade = "";
    settings.analyzer.region_mass = 1.0 / 3;
    settings.layout.slots = 5;
    return settings;
}

}  // namespace

TEST_CASE("settings written as a file are the same when they are read again") {
    check_same(read_again({}), {});
    const Settings odd = odd_settings();
    check_same(read_again(odd), odd);
    CHECK(read_again(odd).analyzer.region_mass == odd.analyzer.region_mass);
}

TEST_CASE("a snapshot is read by its path, also once it was replaced") {
    SettingsSnapshot snapshot({});
    Settings read;
    read_settings_file(snapshot.path(), read);
    check_same(read, {});
    const std::string path = snapshot.path();
    snapshot.replace(odd_settings());
    CHECK(snapshot.path() == path);
    read_settings_file(path, read);
    check_same(read, odd_settings());
}

#include "player/playback/hardware_decoders.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace vitrine;
using namespace vitrine::player;

namespace {

DecoderMap chosen_of(const std::set<std::string>& usable) {
    return hardware_decoders([&](const std::string& element) { return usable.contains(element); });
}

}  // namespace

TEST_CASE("without hardware every film is decoded by the processor") {
    CHECK(chosen_of({}).empty());
    CHECK(in_words({}) == "by the processor");
}

TEST_CASE("stateless V4L2 goes before VA, and VA before stateful V4L2") {
    CHECK(chosen_of({"v4l2h264dec", "vah264dec", "v4l2slh264dec"}).at("avdec_h264") == "v4l2slh264dec");
    CHECK(chosen_of({"v4l2h264dec", "vah264dec"}).at("avdec_h264") == "vah264dec");
    CHECK(chosen_of({"v4l2h264dec"}).at("avdec_h264") == "v4l2h264dec");
}

TEST_CASE("each codec is chosen for by itself") {
    const DecoderMap decoders = chosen_of({"v4l2slh265dec", "v4l2h264dec", "vaav1dec"});
    CHECK(decoders ==
          DecoderMap{{"avdec_h264", "v4l2h264dec"}, {"avdec_h265", "v4l2slh265dec"}, {"av1dec", "vaav1dec"}});
    CHECK(in_words(decoders) == "by vaav1dec instead of av1dec, v4l2h264dec instead of avdec_h264, "
                                "v4l2slh265dec instead of avdec_h265");
}

TEST_CASE("an element that is not installed is not usable, one that needs no device is") {
    CHECK_FALSE(is_usable_here("no-such-decoder"));
    CHECK(is_usable_here("avdec_h264"));
}

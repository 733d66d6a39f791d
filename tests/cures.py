#!/usr/bin/env python3
"""Each cure of docs/testing.md's table of defects is taken out of the tree, and its test must fail.

    cures.py [PRESET [NAME...]]      PRESET: of a build that is there and up to date (dev)
    cures.py --check                 builds nothing: is the text of each cure found once?

It works on this tree, which must be as committed, and restores every file; the build must be brought up to date
afterwards. A cure whose text is not found once, and a test that passes without its cure, are failures.
"""
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

TREE = Path(__file__).resolve().parents[1]


@dataclass
class Cure:
    name: str
    file: str
    cure: str
    without: str
    test: str  # of ctest: TARGET.FILE


CURES = [
    Cure("a TV that was off", "player/display/output_state.cpp",
         "    needs_mode_ = error != 0;", "    needs_mode_ = false;", "display_test.output_state_test"),
    Cure("a frozen flip", "player/display/output_state.cpp",
         "    if (!flip_since_ || now - *flip_since_ <= flip_patience) return false;\n    start_over();", "    return now < Time{};",
         "display_test.output_state_test"),
    Cure("half a photo", "base/media/still_picture.cpp",
         "    require_complete(path, format);\n", "", "media_test.still_picture_test"),
    Cure("a copy under way", "analyzer/watch/schedule.cpp",
         "if (!is_same || entry.facts.blocks != facts.blocks) return see_change(", "if (false) return see_change(",
         "watch_test.schedule_test"),
    Cure("files that no event told of", "analyzer/watch/daemon.cpp",
         "    rescan_.arm(interval);", "", "watch_test.daemon_test"),
    Cure("a file replaced on the disk", "analyzer/watch/schedule.cpp",
         "        if (!is_same) return see_change(path, entry, facts, delay, now);\n        entry.facts = facts;", "        entry.facts = facts;",
         "watch_test.schedule_test"),
    Cure("a file deleted while it plays", "player/scene/wall_slots.cpp",
         "            slot = {};\n", "", "scene_test.wall_slots_test"),
    Cure("a file replaced while it plays", "player/scene/wall_slots.cpp",
         "            put_shot(slot, key);\n            due_.reset();\n", "", "scene_test.wall_slots_test"),
    Cure("a share that hangs", "player/playback/source_pool.cpp",
         "return entry.second.is_preparing() && !entry.second.is_stuck();", "return entry.second.is_preparing();", "playback_test.keeping_time_test"),
    Cure("an empty file", "base/media/media_type.cpp",
         '    if (head.empty()) throw MediaError(MediaState::waiting, "the file is empty");', "", "media_test.media_type_test"),
    Cure("a child that hangs", "analyzer/watch/child_process.cpp",
         "    kill(verdict ==", "    if (false) kill(verdict ==", "watch_test.child_process_test"),
    Cure("a picture too large", "base/media/still_picture.cpp",
         "    require_within_limits(info);\n    return info;", "    return info;", "media_test.still_picture_test"),
    Cure("pictures kept for ever", "player/scene/wall_sources.cpp",
         "        if (!kept.contains(source)) retired.push_back(source);\n",
         "        (void)kept, (void)source;\n", "scene_test.wall_test"),
    Cure("gaps in loops", "player/playback/loop_seeker.cpp",
         "is_playing() && seek(GST_SEEK_FLAG_SEGMENT, place)", "is_playing() && seek(GST_SEEK_FLAG_SEGMENT | GST_SEEK_FLAG_FLUSH, place)",
         "playback_test.film_loop_test"),
    Cure("black before the next picture", "player/scene/wall.cpp",
         "    if (change_ && change_->phase == Phase::waiting) wait_for_sources(now);\n",
         "    if (change_ && change_->phase == Phase::waiting) { shown_.clear(); wait_for_sources(now); }\n",
         "scene_test.wall_test"),
    Cure("a photo's orientation", "base/media/still_picture.cpp",
         '"size", VIPS_SIZE_DOWN,', '"size", VIPS_SIZE_DOWN, "no_rotate", TRUE,', "media_test.still_picture_test"),
    Cure("a film's orientation", "player/playback/film_loop.cpp",
         "videoflip video-direction=auto", "videoflip video-direction=identity", "playback_test.film_loop_test"),
    Cure("a corner of an I-Region", "player/layout/cells/cells.cpp",
         "        shown[i] = union_of(rounded, {to_grid(regions[i])});", "        shown[i] = rounded, (void)regions;", "layout_test.cells_test"),
    Cure("a clock before the files", "player/content/calendar.cpp",
         "    if (now < earliest_.time() && !fs::exists(set_by_network, missing)) return std::nullopt;\n", "    (void)missing;\n",
         "content_test.calendar_test"),
    Cure("junk names", "analyzer/watch/media_folder.cpp",
         "(lower.starts_with('.') && !begins_with_period(name)) || ", "(lower.starts_with('.') && lower.size() < 3 && !begins_with_period(name)) || ", "watch_test.media_folder_test"),
    Cure("a player that stands still", "player/control/health.cpp",
         "    if (!is_dark && !has_flipped) return false;\n", "    (void)is_dark, (void)has_flipped;\n", "control_test.health_test"),
    Cure("a film that stands still", "player/playback/watchdog.cpp",
         "    if (now - *starved_ < patience) return Verdict::fine;", "    return Verdict::fine;", "upkeep_test.watchdog_test"),
    Cure("a file that brings the player down", "base/state/blame.cpp",
         "constexpr int opening_points = 2;", "constexpr int opening_points = 0;", "content_test.crash_note_test"),
    Cure("blame of others", "player/content/crash_note.cpp",
         "    if (suspects_.empty()) return false;\n    const ContentName", "    return false;\n    const ContentName", "content_test.crash_note_test"),
    Cure("a folder that answers with any error", "analyzer/watch/folder_follower.cpp",
         "    if (errno == ENOENT || errno == ENOTDIR) return;\n", "    if (!fs::exists(folder_.root())) return;\n", "watch_test.daemon_test"),
    Cure("errors of the transport", "analyzer/watch/analysis_outcome.cpp",
         "    if (record.fault.owner != FaultOwner::file) return Answer::postponed;\n", "", "watch_test.daemon_test"),
    Cure("a deleted file beside a folder that cannot be read", "analyzer/watch/folder_follower.cpp",
         "!listing.is_unread(path)", "listing.unread.empty()", "watch_test.daemon_test"),
    Cure("half a listing", "analyzer/watch/folder_follower.cpp",
         "        if (look.presence == MediaFolder::Presence::gone) lost.push_back(path);\n        if (look.presence == MediaFolder::Presence::there) see_file(look.file, now);\n",
         "        lost.push_back(path);\n", "watch_test.folder_follower_test"),
    Cure("a kill from outside", "player/content/crash_note.cpp",
         "if (!has_own_crash(state_ / crashed_file)) {", "if (false) {", "content_test.crash_note_test"),
    Cure("a reader that is killed from outside", "analyzer/watch/analysis_outcome.cpp",
         "is_own_crash(result.code) ? FaultOwner::file : FaultOwner::machine", "FaultOwner::file", "watch_test.daemon_test"),
    Cure("crashes of several readers", "analyzer/watch/attempts.cpp",
         "        if (circumstances.have_others_died) return postpone(pace);\n", "", "watch_test.attempts_test"),
    Cure("a quarantine without an end", "base/state/blame.cpp",
         "           now < suspicion.since + quarantine_time(suspicion.quarantines);", "           now >= suspicion.since;", "state_test.blame_test"),
    Cure("a busy box", "analyzer/watch/progress_rule.cpp",
         "    if (has_progressed_) at_progress_ = processor;\n", "", "watch_test.progress_rule_test"),
    Cure("a catalogue that never rests", "player/content/catalogue_follower.cpp",
         "    if (now - *changed_since_ >= max_settle_time) return request_changed();\n", "", "content_test.catalogue_follower_test"),
    Cure("only the records that changed", "player/content/catalogue_reader.cpp",
         "            if (record && *record == *known->second) continue;\n", "", "content_test.catalogue_reader_test"),
    Cure("a name of thousands of folders", "player/control/media_name.cpp",
         "constexpr int max_tails = 64;", "constexpr int max_tails = 100'000;", "control_test.media_name_test"),
    Cure("no process to be had", "analyzer/watch/daemon.cpp",
         "    } catch (const std::system_error& error) {  // no memory", "    } catch (const std::bad_alloc& error) {  // no memory", "watch_test.daemon_test"),
    Cure("another file of the same size and time", "analyzer/watch/schedule.cpp",
         "(entry.is_remote || is_same_file(entry.facts, facts))", "true", "watch_test.schedule_test"),
    Cure("a media folder that is a link", "analyzer/watch/folder_follower.cpp",
         "folder_.absolute(folder), is_root)) return;", "folder_.absolute(folder), false)) return;", "watch_test.daemon_test"),
]


def run(*command):
    return subprocess.run([str(word) for word in command], cwd=TREE, text=True, errors="replace", capture_output=True)


def failing_tests(cure, preset):
    """Builds and tests; the lines of ctest that say so, or None where it does not compile."""
    built = run("cmake", "--build", "--preset", preset, "--target", cure.test.split(".")[0])
    if built.returncode != 0:
        print(built.stdout[-3000:])
        return None
    tested = run("ctest", "--preset", preset, "-R", f"^{cure.test}$", "--no-tests=error", "--timeout", "300")
    return [line for line in tested.stdout.splitlines() if "***" in line]


def is_found_once(cure):
    file = TREE / cure.file
    count = file.read_text().count(cure.cure) if file.exists() else 0
    if count != 1:
        print(f"{cure.name}: its text is found {count} times in {cure.file}:\n{cure.cure}")
    return count == 1


def is_proven(cure, preset):
    """Takes the cure out; true if its test fails then."""
    file = TREE / cure.file
    if not is_found_once(cure):
        return False
    text = file.read_text()
    try:
        file.write_text(text.replace(cure.cure, cure.without))
        failing = failing_tests(cure, preset)
    finally:
        file.write_text(text)
    if failing is None:
        print(f"{cure.name}: does not compile without the cure")
    else:
        print(f"{cure.name}: " + (f"{cure.test} fails" if failing else f"{cure.test} PASSES without the cure"), flush=True)
    return bool(failing)


def main():
    if sys.argv[1:] == ["--check"]:
        sys.exit(not all([is_found_once(cure) for cure in CURES]))
    if run("git", "status", "--porcelain", "--untracked-files=no").stdout:
        sys.exit("the tree is not as committed")
    preset, names = (sys.argv[1:2] or ["dev"])[0], sys.argv[2:]
    chosen = [cure for cure in CURES if not names or cure.name in names]
    proven = [cure for cure in chosen if is_proven(cure, preset)]
    print(f"{len(proven)} of {len(chosen)} proven")
    sys.exit(len(proven) != len(chosen))


if __name__ == "__main__":
    main()

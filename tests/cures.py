#!/usr/bin/env python3
"""Each cure of docs/testing.md's table of defects is taken out of the tree, and its test must fail.

    cures.py [PRESET [NAME...]]      PRESET: of CMakePresets.json (cures); the rig is in `release` only
    cures.py --check                 builds nothing: is the text of each cure found once?

It works on this tree, which must be as committed, and restores every file; the build must be brought up to date
afterwards. A cure whose text is not found once, a test that passes without its cure, and one that fails with it, too,
are failures.
"""
import re
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
    targets: tuple = ()  # to build, where the test is a script
    only: str = ""  # the preset that has the test, where not all have it


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
    Cure("once without a tapestry", "analyzer/watch/daemon.cpp",
         " || (options_.weaves && !weaver_.is_idle())", "", "watch_test.daemon_weave_test"),
    Cure("a small head that is cut off a film", "analyzer/one_file/frame_search.cpp",
         "if (frame.finer)", "if (frame.finer && !faces_)", "real.photographs_test", ("photographs_test",)),
    Cure("a dog taken for a face in a film", "analyzer/saliency/sample.cpp",
         "face.box.height() <= max_small_face * map_side", "face.box.height() <= 1e3 * max_small_face", "saliency_test.shot_region_test"),
    Cure("a caption on another picture", "player/scene/caption_place.cpp",
         "    return cell.parts.empty() ? nullptr : &cell.parts.front();", "    return cell.parts.empty() ? nullptr : &cell.parts.back();",
         "scene_test.caption_place_test"),
    Cure("a cell with another form for one frame", "player/layout/cells/far_parts.cpp",
         "neighbours.emplace_back(distance_to(items.regions[j], middle), j)", "neighbours.emplace_back(distance_to(items.regions[j], middle) * 0 - touch_of(part, shown[j]), j)",
         "scene_test.transition_test"),
    Cure("a tapestry in place of the folder that was tapped twice", "player/scene/folders/folder_wall.cpp",
         "    const bool is_opening = !wanted_.empty() || ", "    const bool is_opening = ", "stage_test.tapestry_playback_test"),
    Cure("a change of places that makes half the wall small", "player/layout/plan/flat_plan.cpp",
         " || !has_calm_way(request, *other)) continue;", ") continue;", "layout_test.plan_test"),
    Cure("a hole where a small picture took a large one's seat", "player/layout/plan/flat_plan.cpp",
         "if (hole <= max_hole || !can_be_filled(problem, frames)) return layout;", "if (hole >= 0) return layout;", "layout_test.plan_test"),
    Cure("a crop that is another photo", "player/scene/files/near_copies.cpp",
         "std::min({least, std::popcount(a.parts.at(i) ^ b.whole), std::popcount(a.whole ^ b.parts.at(i))})", "least + 0 * static_cast<int>(i)",
         "scene_test.file_groups_test"),
    Cure("two skies that are one photo", "player/scene/files/near_copies.cpp",
         "constexpr double min_pattern_likeness = 0.7;", "constexpr double min_pattern_likeness = -2;", "scene_test.file_groups_test"),
    Cure("a shot that darts", "player/scene/transition.cpp",
         "std::sqrt(way_from(transition, key))", "std::max(1.0, 0 * way_from(transition, key))", "scene_test.transition_test"),
    Cure("a hard cut from the tapestry to the wall", "player/stage/show_switch.cpp",
         "    left_ = std::exchange(shown_, {});\n", "    left_ = tapestry_ ? std::exchange(shown_, {}) : std::vector<DrawItem>();\n", "switch_flash_test.switch_flash_test"),
    Cure("a first picture by a wrong clock", "player/scene/acts/followed_wall.cpp",
         "has_time = shown_ ||", "has_time = true ||", "acts_test.shared_wall_test"),
    Cure("a chosen keyframe", "analyzer/tapestry/synthesis/keyframes.cpp",
         "    for (const int frame : settings.chosen)\n        medoids.add(frame);\n", "", "weave_test.film_weave_test"),
    Cure("a struck keyframe", "analyzer/tapestry/weave/film_weave.cpp",
         "if (is_struck(chosen, frames[frame].time)) ", "if (false) ", "weave_test.film_weave_test"),
    Cure("a dark band after a drop on a wall of few", "player/layout/edit/make_way.cpp",
         "            take_if_closes_hole(farthest_);\n", "", "layout_test.make_way_test"),
    Cure("a wall that comes back while keyframes are edited", "player/scene/tapestry/tapestry_show.cpp",
         "(patience_ && !edit_)", "patience_", "scene_test.keyframe_edit_test"),
    Cure("keyframes chosen by touch", "analyzer/watch/weaver.cpp",
         "    for (const auto& [path, touched] : touched_)\n        choices[path] = joined_choice(choices[path], touched);\n", "", "watch_test.daemon_weave_test"),
    Cure("a technician's tap that plays", "player/scene/tapestry/strip_finger.cpp",
         "    if (strip.edit != nullptr) return edit(tap, strip);\n", "", "scene_test.keyframe_edit_test"),
    Cure("a technician's tap that nobody hears", "player/stage/tapestry_playback.cpp",
         "    hand_over_choice();\n    if (", "    if (", "stage_test.tapestry_playback_test"),
    Cure("another choice of keyframes", "analyzer/tapestry/tapestry_state.cpp",
         "(!has_choice || index.choice == film.choice)", "(has_choice || true)", "watch_test.daemon_weave_test"),
    Cure("a visitor who waits behind other films", "analyzer/watch/weave_schedule.cpp",
         "    if (scope != WeaveScope::none && is_wanted) return wanted;\n", "    (void)is_wanted;\n", "watch_test.weave_schedule_test"),
    Cure("a film that is opened before it is woven", "analyzer/tapestry/weave_file.cpp",
         "        if (!has_index(directory, head_))\n            write_first_view(", "        if (!has_index(directory, head_) && head_.path.empty())\n            write_first_view(",
         "real.weave_file_test",
         targets=("weave_file_test",)),
    Cure("a strip that jumps when a better one comes", "player/scene/tapestry/woven_strips.cpp",
         "    motion.move_to({coming_->strip().tapestry(), box}, place);\n", "", "scene_test.woven_strips_test"),
    Cure("a visitor who waits for ever", "player/stage/tapestry_playback.cpp",
         "    end_waiting(now);\n", "", "stage_test.tapestry_playback_test"),
    Cure("a keyframe of a fade or a dissolve", "analyzer/tapestry/synthesis/frame_fitness.cpp",
         "return is_in_shot(i) || (!is_faded(i) && !is_mixed(i));", "return true;", "tapestry_test.frame_fitness_test"),
    Cure("hard borders of bricks in a tapestry", "analyzer/tapestry/synthesis/retarget.cpp",
         "        stitch(tile, section_, span_, neighbours_);\n", "        (void)stitch;\n", "tapestry_test.retarget_test"),
    Cure("smears in the corners of a tapestry", "analyzer/tapestry/synthesis/brickwork.cpp",
         "std::clamp(columns_beside(keyframe, is_left), least,", "std::clamp(0 * columns_beside(keyframe, is_left), least,", "tapestry_test.retarget_test"),
    Cure("regions that weigh nothing in a tapestry", "analyzer/tapestry/synthesis/brickwork.cpp",
         "settings.region_weight}", "1}", "tapestry_test.retarget_test"),
    Cure("the black columns of DV films", "analyzer/film/active_picture.cpp",
         "std::floor(min_depth * side)", "min_depth * side", "film_test.active_picture_test"),
    Cure("a page over other files", "analyzer/tapestry/export/page_folder.cpp",
         "    if (is_page(folder / page_name)) return;", "    if (is_page(folder / page_name) || true) return;", "page_export_test.page_folder_test"),
    Cure("a poster of small frames", "analyzer/tapestry/weave/sharp_frames.cpp",
         "    const int height = std::clamp(brick_height / 2 * 2, 2, std::max(2, whole));",
         "    const int height = std::clamp(brick_height / 2 * 2, 2, std::min(whole, kept.active().height));", "weave_test.poster_test"),
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
    Cure("a child that hangs", "analyzer/child/child_process.cpp",
         "    kill(verdict ==", "    if (false) kill(verdict ==", "child_test.child_process_test"),
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
    Cure("a seam across an I-Region", "player/layout/cells/taut.cpp",
         "            way = way_round(bend, std::move(*corners));", "            (void)way_round;", "layout_test.taut_test"),
    Cure("a crooked seam", "player/layout/cells/taut.cpp",
         "            if (field.is_movable(k)) pull(field, k);", "            (void)pull;", "layout_test.taut_test"),
    Cure("a clock before the files", "player/content/calendar.cpp",
         "    if (now < earliest_.time() && !is_clock_kept_right()) return std::nullopt;\n", "",
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
         "    if (errno == ENOENT || errno == ENOTDIR) return;\n",
         "    if (!fs::exists(folder_.absolute(folder))) return;\n", "watch_test.folder_follower_test"),
    Cure("errors of the transport", "analyzer/watch/analysis_outcome.cpp",
         "    if (record.fault.owner != FaultOwner::file) return Answer::postponed;\n", "", "watch_test.daemon_test"),
    Cure("a deleted file beside a folder that cannot be read", "analyzer/watch/folder_follower.cpp",
         "!listing.is_unread(path)", "listing.unread.empty()", "watch_test.daemon_test"),
    Cure("bars in records of an earlier version", "analyzer/watch/daemon.cpp",
         "    if (is_free && read_outdated_file(book_.states(), schedule_)) return wake_.arm(0s);\n", "    (void)read_outdated_file;\n",
         "watch_test.daemon_test"),
    Cure("bars in a tapestry of an earlier version", "analyzer/watch/file_book.cpp",
         "        followers_.weaver.forget_film(record.path);  // its tapestry", "        (void)record;  // its tapestry", "watch_test.daemon_weave_test"),
    Cure("a wall that loses shots while films are read again", "analyzer/watch/file_book.cpp",
         "known_growth(record(path)).value_or(FilmGrowth(begun))", "(false ? known_growth({}) : std::nullopt).value_or(FilmGrowth(begun))", "watch_test.file_book_test"),
    Cure("a dark line at the edge of the screen", "player/layout/plan/flat_plan.cpp",
         "std::clamp(request.margin, min_clearance, max_margin)", "std::clamp(request.margin + 1, min_clearance, max_margin)", "layout_test.filling_test"),
    Cure("a logo taken for a picture within bars", "analyzer/film/active_picture.cpp",
         "    if (across.first == 0 && along.first > 0)", "    if (false && across.first == 0 && along.first > 0)", "film_test.active_picture_test"),
    Cure("a shot in a hand that other boxes do not show", "player/scene/acts/leader_talk.cpp",
         "    say_lifted(news, said);\n", "", "acts_test.shared_wall_test"),
    Cure("a shot that stays in a hand where the network was cut", "player/scene/acts/followed_lifted.cpp",
         "    if (now - seen_at_ >= patience) seen_ = {};\n", "    (void)now, (void)patience;\n", "acts_test.shared_wall_test"),
    Cure("a black cell of two triangles and a flat one", "player/render/cell_mesh.cpp",
         "        if (is_flat(triangle)) continue;\n", "        (void)is_flat;\n", "render_test.renderer_test"),
    Cure("a black triangle in a frame of a change", "player/layout/cells/triangulation.cpp",
         "                if (area() <= 0) break;\n", "                break;\n", "layout_test.cells_test"),
    Cure("half a listing", "analyzer/watch/folder_follower.cpp",
         "        if (look.presence == MediaFolder::Presence::gone) lost.push_back(path);\n        if (look.presence == MediaFolder::Presence::there) see_file(look.file, now);\n",
         "        lost.push_back(path);\n", "pipeline.hostile_share",
         targets=("vitrine-analyzer",), only="release"),
    Cure("a kill from outside", "player/content/crash_note.cpp",
         "if (!has_own_crash(state_ / crashed_file)) {", "if (false) {", "content_test.crash_note_test"),
    Cure("a reader that is killed from outside", "analyzer/watch/analysis_outcome.cpp",
         "is_own_crash(result.code) ? FaultOwner::file : FaultOwner::machine", "FaultOwner::file", "watch_test.daemon_test"),
    Cure("crashes of several readers", "analyzer/watch/attempts.cpp",
         "        if (circumstances.have_others_died) return postpone(pace);\n", "", "watch_test.attempts_test"),
    Cure("a quarantine without an end", "base/state/blame.cpp",
         "           now < suspicion.since + quarantine_time(suspicion.quarantines);", "           now >= suspicion.since;", "state_test.blame_test"),
    Cure("a busy box", "analyzer/child/progress_rule.cpp",
         "    if (has_progressed_) at_progress_ = processor;\n", "", "child_test.progress_rule_test"),
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
    Cure("a file that the wall avoids", "player/content/visible_files.cpp",
         "    if (std::ranges::any_of(content.folders, is_open)) return Visibility::avoided;\n", "",
         "content_test.visible_files_test"),
    Cure("tiles that a fade leaves out", "player/display/mesa_options.cpp",
         "    ::setenv(mesa_variable, all.c_str(), 1);\n", "", "reference_test.reference_test"),
    Cure("a hole where a shot leaves", "player/scene/transition_frame.cpp",
         "    fill_gaps(layer, wall);\n", "    (void)fill_gaps;\n", "scene_test.transition_test"),
    Cure("a region that one that leaves covers", "player/scene/transition.cpp",
         "        if (!overlap.is_empty()) share = std::min(share, overlap.begin);\n", "        (void)overlap;\n",
         "scene_test.transition_test"),
    Cure("dark filler that moves with a hand", "player/scene/lifted_shots.cpp",
         "        item.filler_light = filler_light_.at(frame.time);\n", "", "scene_test.transition_test"),
    Cure("a strip of a shot far from its cell", "player/layout/cells/cells.cpp",
         "    give_far_parts(shares.shown, sites);\n", "", "layout_test.cells_test"),
    Cure("slivers of bars", "player/scene/wall_cells.cpp",
         "        items.push_back(without_bleeding_edge(placed.shot.item, placed.shot.picture, placed.placement));\n",
         "        items.push_back(placed.shot.item);\n        (void)without_bleeding_edge;\n", "moving_frames_test.moving_frames_test"),
    Cure("a tiny newcomer", "player/layout/pack/filling.cpp",
         " + tininess_weight * lacks_ / count;", ";", "layout_test.plan_test"),
    Cure("a reader that names a slot beyond its memory", "player/playback/reader/picture_intake.cpp",
         "    if (note.slot >= memory->slots->shape().count) refuse();\n", "", "reader_test.picture_intake_test"),
    Cure("a reader that names a picture larger than its slot", "player/playback/reader/picture_slots.cpp",
         "    if (places[2].end() > slot.size()) return std::nullopt;\n", "", "reader_test.picture_intake_test"),
    Cure("a reader that the player's machine has killed", "player/playback/reader/reader_link.cpp",
         "if (std::ranges::find(own_signals, note.signal) != own_signals.end())", "if (note.signal != 0 && !own_signals.empty())", "reader_test.reader_link_test"),
    Cure("the last word of a reader that leaves messages unread", "base/system/message_socket.cpp",
         "(errno == EINTR || errno == ECONNRESET)", "errno == EINTR", "system_test.message_socket_test"),
    Cure("a film that becomes large in its midst", "base/media/film_size.cpp",
         " || pixels_of(size) > std::max(max_growth * first, usual_pixels)", " || first < 0", "media_test.decode_chain_test"),
    Cure("uploads in the process that owns the screen", "player/playback/playing_shot.cpp",
         "    if (!stored && options.uploads.make_film) options.make_film = options.uploads.make_film;\n", "", "playback_test.source_pool_test"),
    Cure("the sound of uploads in that process", "player/playback/sound/wall_sound.cpp",
         "if (shot.stored && !shot.stored->is_dropped) return true;", "return true;", "sound_test.wall_sound_test"),
    Cure("readers of several files that crash", "player/content/crash_note.cpp",
         "reader_crashes_.size() == 1", "true", "content_test.crash_note_test"),
    Cure("a media folder that is a link", "analyzer/watch/folder_follower.cpp",
         "folder_.absolute(folder), is_root)) return;", "folder_.absolute(folder), false)) return;", "watch_test.daemon_test"),
    Cure("a film that becomes too large in its midst", "base/media/decode_chain.cpp",
         "            limit_pictures_at(element);\n", "", "media_test.film_size_test"),
    Cure("decoders that no document names", "base/media/decoder_table.cpp",
         '    DecoderRow{"image/jpeg", "jpegparse"', '    DecoderRow{"video/x-huffyuv", nullptr, "avdec_huffyuv"},\n    DecoderRow{"image/jpeg", "jpegparse"',
         "media_test.decode_chain_test"),
    Cure("a reader's files", "base/system/sandbox.cpp",
         "    if (sandbox.limits_files) limit_files(rules, landlock_abi());\n", "    if (false) limit_files(rules, landlock_abi());\n",
         "system_test.sandbox_test"),
    Cure("a reader's calls", "base/system/sandbox.cpp",
         "    if (sandbox.limits_calls) limit_calls();\n", "    if (false) limit_calls();\n", "system_test.sandbox_test"),
    Cure("a link in place of a file", "base/system/hold_below.cpp",
         "RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS", "RESOLVE_BENEATH", "system_test.hold_below_test"),
    Cure("a lit scene between two fades", "analyzer/film/standing_picture.cpp",
         "while (frame < last && end.stands_at(frame, kind))", "while (frame < first && end.stands_at(frame, kind))", "film_test.transitions_test"),
    Cure("a stretch shorter than a shot", "analyzer/film/shot_detector.cpp",
         "    if (!is_short) give_montage(out);\n", "    if (!is_short) give_montage(out);\n    else montage.reset();\n",
         "film_test.shot_detector_test"),
    Cure("a place for black", "analyzer/one_file/analyze.cpp",
         "        if (kind == PictureKind::plain) return;\n", "", "analyze_test.analyze_test"),
    Cure("seconds of empty ground", "analyzer/saliency/take_parts.cpp",
         "    if (end - begin <= max_unsplit) return {{begin, end}};\n", "    if (end > begin) return {{begin, end}};\n",
         "saliency_test.take_parts_test"),
    Cure("a shot of half a second for minutes", "player/scene/wall_slots.cpp",
         "    if (loop < short_shot &&", "    if (loop < short_shot && loop > short_shot &&", "scene_test.wall_slots_test"),
    Cure("a film alone that stands still", "player/scene/wall_slots.cpp",
         "slot.ahead = stay - first - stay * k / count;", "slot.ahead = stay - stay / count - stay * k / count, (void)first;", "scene_test.wall_slots_test"),
    Cure("a reader that is taken over", "analyzer/film/reader_sandbox.cpp",
         'log::debug("{}", in_words(enter_sandbox(rules)));', 'log::debug("{}", in_words(Sandbox{}));', "pipeline.take_over",
         targets=("vitrine-analyzer", "gstvitrinetakeover")),
    Cure("only the files that changed are judged", "player/content/visible_files.cpp",
         ": judged_.judge(*paths, records_);", ": judged_.judge_all(records_);", "content_test.visible_files_test"),
    Cure("a change copies one block of a list", "player/scene/files/shared_list.hpp",
         "            if (change == end)\n", "            if (change == end && changes.empty())\n", "scene_test.shared_list_test"),
    Cure("a folder that closes leaves the wall as it was", "player/scene/folders/folder_stack.cpp",
         "    top().hold(true);\n    levels_.emplace_back(", "    levels_.emplace_back(", "scene_test.folder_wall_test"),
    Cure("nobody stays in a folder for ever", "player/scene/folders/folder_wall.cpp",
         "    if (now - touched_ >= idle_) wished_depth_ = 1;\n", "", "scene_test.folder_wall_test"),
    Cure("shots of a folder that are alike", "player/scene/files/folder_shots.cpp",
         "        choose(next, candidates);\n", "", "scene_test.folder_shots_test"),
    Cure("a stack that is used up", "player/content/crash_signal.cpp",
         "    if (::sigaltstack(nullptr, &stack) < 0 || (stack.ss_flags & SS_DISABLE) == 0) return;\n", "    return;\n",
         "content_test.crash_note_test"),
    Cure("a name in _STATUS that is taken beforehand", "analyzer/status/status_folder.cpp",
         "    const std::string beside = unfinished_name();", '    const std::string beside = name + (unfinished_name().empty() ? "" : ".new");', "status_test.status_folder_test"),
    Cure("a name in _STATUS that blocks the others", "analyzer/status/status_writer.cpp",
         "        complaint->second = true;\n", "        complaint->second = true;\n        if (complaints_.size() == 1) throw;\n",
         "status_test.status_writer_test"),
    Cure("a question that cannot be asked", "player/control/authority.cpp",
         "            questions_.erase(number);\n", "", "control_test.bus_object_test"),
    Cure("the bus and pictures take turns", "player/control/bus_object.cpp",
         "SD_EVENT_PRIORITY_NORMAL)", "SD_EVENT_PRIORITY_IMPORTANT)", "control_test.bus_object_test"),
    Cure("a face in a flat picture", "analyzer/faces/yunet.cpp",
         "std::max(min_input, ", "std::max(0, ", "pipeline.endurance", targets=("vitrine-analyzer", "vitrine-player"), only="release"),
    Cure("a box that joins says so at once", "player/scene/acts/box_talk.cpp",
         " || note.shown.has_value() != told.shown.has_value()", "", "acts_test.shared_wall_test"),
    Cure("a notice while films are analysed", "analyzer/watch/analyses.cpp",
         "    if (notice_named(path)) limits.niceness = 0;  // it must be seen at once\n", "", "watch_test.daemon_test"),
    Cure("a notice before its copy", "analyzer/watch/daemon.cpp",
         "    if (notice_named(action.path) && action.facts.bytes <= options_.pace.small_bytes) outputs.stored = false;\n", "",
         "watch_test.daemon_test"),
    Cure("screenshots beside the pictures", "player/control/picture_answers.cpp",
         "                          ring(event);\n                      })});\n",
         "                          ring(event);\n                      })});\n    calls_.back().thread.join();\n",
         "control_test.bus_object_test"),
    Cure("one screenshot a second", "player/control/rate_limit.hpp",
         "        if (now < next_) return false;\n", "", "control_test.rate_limit_test"),
    Cure("status.json on a thread of its own", "player/control/analyzer_word.cpp",
         "std::async(std::launch::async, read_word_, file_)", "std::async(std::launch::deferred, read_word_, file_)",
         "control_test.analyzer_word_test"),
    Cure("libvips without modules", "base/media/still_picture.cpp",
         '        ::setenv("VIPSHOME", "/var/empty", 1);\n', "", "media_test.vips_modules_test"),
    Cure("a state directory in the media folder", "analyzer/watch/daemon.cpp",
         '    if (state.empty() || *state.begin() == ".." || state == ".") return folders;\n', "    return folders;\n", "watch_test.daemon_test"),
    Cure("the rename of a large folder", "analyzer/watch/leaving_files.cpp",
         '    for (auto it = by_inode_.lower_bound({facts.inode, ""});\n         it != by_inode_.end() && it->first == facts.inode; ++it) {\n        ++compared_;\n',
         "    for (auto it = by_inode_.begin(); it != by_inode_.end(); ++it) {\n        ++compared_;\n        if (it->first != facts.inode) continue;\n",
         "watch_test.leaving_files_test"),
    Cure("a file server that is away for long", "systemd/vitrine-analyzer.service",
         "StartLimitIntervalSec=0\n", "", "systemd.units", targets=("base_geometry",)),
    Cure("a daemon that stands still", "analyzer/child/child_deadline.cpp",
         "std::min<std::chrono::nanoseconds>(EventLoop::Clock::now() - looked_, 2 * interval_)",
         "std::chrono::nanoseconds(EventLoop::Clock::now() - looked_)", "child_test.child_process_test"),
    Cure("films of any shape", "analyzer/saliency/sample.cpp",
         "std::max(1, static_cast<int>(std::lround(size.height * scale)))", "static_cast<int>(std::lround(size.height * scale))",
         "saliency_test.sample_test"),
    Cure("a reader that hangs when its player leaves", "player/playback/reader/reader_link.hpp",
         "void leave() const { socket_->end_receiving(); }", "void leave() const {}", "reader_test.reader_link_test"),
    Cure("a recording that begins within a packet", "base/media/media_type.cpp",
         "begin < packet; ++begin", "begin < 1; ++begin", "media_test.media_type_test"),
    Cure("complaints of libraries", "base/media/gst_ptr.cpp",
         "        g_log_set_default_handler(&log_for_library, nullptr);\n", "        (void)&log_for_library;\n", "media_test.gst_ptr_test"),
    Cure("names that are made up to share a record", "base/state/name_hash.cpp",
         "G_CHECKSUM_SHA256", "G_CHECKSUM_MD5", "state_test.record_test"),
    Cure("what an earlier version has stored", "base/state/former_names.cpp",
         "        fs::rename(from, to, ignored);\n", "        (void)0;\n", "state_test.former_names_test"),
    Cure("changes that flash", "player/scene/wall.cpp",
         "    if (!pace.is_free(now)) return false;\n", "", "flash_test.flash_test"),
    Cure("a calm wall", "player/scene/wall.cpp",
         "pace_(settings.is_calm ? calm_spacing : flash_spacing)", "pace_(flash_spacing)", "scene_test.wall_test"),
    Cure("a photo that drifts out of its cell", "player/scene/photo_drift.cpp",
         "way_within(region, placed.cell->parts[0], direction) - outline_clearance,", "(void(&way_within), 1e9),",
         "scene_test.photo_drift_test"),
    Cure("a program that hangs in a call", "base/system/stop_request.cpp",
         "    ::_exit(limit_.exit_code);\n", "", "system_test.stop_request_test"),
    Cure("a stop while the server is silent", "base/system/stop_request.cpp",
         "    ::_exit(limit_.exit_code);\n", "", "pipeline.hostile_share", targets=("vitrine-analyzer",), only="release"),
    Cure("memory that ends", "analyzer/child/child_process.cpp", "    be_killed_first();\n", "    (void)be_killed_first;\n",
         "child_test.child_process_test"),
    Cure("a slot that is not there", "player/player_service.cpp",
         "    if (call.slot < 0 || call.slot >= view_.settings.layout.slots)\n", "    if (call.slot < 0)\n",
         "pipeline.control", targets=("vitrine-player", "vitrinectl")),
    Cure("a dead box that nobody marks", "link/broker_client.cpp", r"""gone = R"({"gone":true})";""", r"""gone = R"({"gone":false})";""",
         "pipeline.link", targets=("vitrine-link",)),
    Cure("a broker that forgets", "link/link.cpp",
         "    for (const auto& [topic, message] : sent_)  // the broker may have been started anew, with nothing kept\n        broker_.publish(message);\n",
         "", "pipeline.link", targets=("vitrine-link",)),
    Cure("an act of another version", "link/message_rules.cpp", "    if (*version != known_version)\n", "    if (*version < 0)\n",
         "link_test.message_rules_test"),
    Cure("a message without a floor", "base/wall/wall_message.cpp", "if (depth > max_depth)", "if (depth < 0)",
         "wall_link_test.wall_message_test"),
    Cure("an end that takes no lines", "base/wall/line_connection.cpp", "    if (out_.size() > max_waiting)", "    if (out_.empty())",
         "wall_link_test.line_socket_test"),
    Cure("an explanation of a hostile file", "analyzer/one_file/file_analysis.cpp",
         "    needs.libraries = font_places();\n    enter_reader_sandbox(analysed.media(), needs);\n",
         "    needs.libraries = font_places();\n", "pipeline.take_over",
         targets=("vitrine-analyzer", "gstvitrinetakeover")),
    # In the rig (tests/appliance/cases/services.py)
    Cure("starts that fail", "systemd/vitrine-player.service", "StartLimitIntervalSec=0\n", "", "slow.services",
         targets=("release_tests",), only="release"),
    Cure("a player that hangs", "systemd/vitrine-player.service", "WatchdogSec=30\n", "", "slow.services",
         targets=("release_tests",), only="release"),
    Cure("an analyzer that hangs", "systemd/vitrine-analyzer.service", "WatchdogSec=60\n", "", "slow.services",
         targets=("release_tests",), only="release"),
    Cure("a unit's limit of memory", "systemd/vitrine-analyzer.service", "OOMPolicy=continue\n", "", "slow.services",
         targets=("release_tests",), only="release"),
    Cure("a clock that jumps", "player/content/calendar.cpp",
         "    if (now < earliest_.time() && !is_clock_kept_right()) return std::nullopt;\n", "",
         "slow.services", targets=("release_tests",), only="release"),
    Cure("a stop while the share hangs", "base/system/stop_request.cpp",
         "    ::_exit(limit_.exit_code);\n", "", "slow.services", targets=("release_tests",), only="release"),
    Cure("an animation without end", "base/media/animation.cpp",
         "    if (pictures > most)\n", "    if (false)\n", "media_test.animation_test"),
    Cure("a photo that waits for the network", "analyzer/watch/refiner.cpp",
         "while (is_free_ && running_.size()", "while (running_.size()", "watch_test.refiner_test"),
    Cure("a network that does not work", "analyzer/watch/refiner.cpp",
         "    options_.command.clear();\n", "", "watch_test.refiner_test"),
    Cure("a photo without a single subject", "analyzer/saliency/i_region.cpp",
         "const bool is_sure = subject.certainty >= sure_certainty;", "const bool is_sure = true;",
         "saliency_test.subject_outline_test"),
    Cure("the coarsest map of a network", "analyzer/saliency/saliency_network.cpp",
         "net_.forward(output_)", "net_.forward()", "saliency_test.image_saliency_test"),
    Cure("a subject that moves on after the network's look", "analyzer/saliency/salient_volume.cpp",
         "drift * frames[i].time - way;", "drift * frames[i].time;", "saliency_test.salient_volume_test"),
    Cure("one of many that move is not the subject", "analyzer/saliency/shot_region.cpp",
         "std::min(sum / looks, enough_motion * moving)", "std::min(sum / looks, enough_motion + moving)", "saliency_test.shot_region_test"),
    Cure("the network looks at films", "analyzer/one_file/analyze.cpp",
         "        looks_.look(shot, samples);\n", "", "analyze_test.analyze_test"),
    Cure("a line of text is not cut", "analyzer/saliency/shot_region.cpp",
         "        result.push_back(line);\n", "        (void)line;\n", "saliency_test.shot_region_test"),
    Cure("a page is its text", "analyzer/saliency/shot_region.cpp",
         "        evidence.is_page = !page.empty();\n", "", "saliency_test.shot_region_test"),
    Cure("a film's words are searched", "analyzer/one_file/frame_search.cpp",
         "    if ((is_film || network_) &&", "    if (network_ &&", "analyze_test.analyze_test"),
    Cure("OpenCV 4.6 and a picture of another size", "analyzer/words/line_detector.cpp",
         "        if (size != size_ && !size_.empty())", "        if (size_.empty())", "words_test.line_detector_test"),
    Cure("a small subject is a blur to the network", "analyzer/saliency/subject_outline.cpp",
         "std::min(undecided_share(map), growth_doubt * growth)", "(void(growth), undecided_share(map))",
         "saliency_test.subject_outline_test"),
    Cure("a single picture out of the middle", "player/layout/pack/filling.cpp",
         "best_.cost - rounding_gain", "best_.cost", "layout_test.plan_test"),
    Cure("gaps where most regions are new", "player/scene/wall.cpp",
         "    forget_places_of_few(plan.items);\n", "    (void)&forget_places_of_few;\n", "scene_test.wall_test"),
    Cure("half a picture that is never drawn", "base/state/tapestry.cpp",
         "    return std::clamp(levels[level].keyframes[keyframe], piece, duration - piece);", "    return (void)piece, levels[level].keyframes[keyframe];",
         "state_test.tapestry_test"),
    Cure("a touched picture of the other row", "player/scene/tapestry/tapestry_view.cpp",
         "const int nearest = 2 * static_cast<int>(std::floor(x / width)) + row;", "const int nearest = static_cast<int>(std::lround(2 * (x + row * width / 2) / width)) - 1;",
         "scene_test.touched_places_test"),
    Cure("moments between shots that cannot be played", "player/scene/tapestry/film_spans.cpp",
         "found == shots.end() || found->begin > time ? nullptr : &*found;", "found == shots.end() ? nullptr : &*found;",
         "scene_test.tapestry_preview_test"),
    Cure("what plays leaves the strip", "player/scene/tapestry/tapestry_motion.cpp",
         "    keep_in_view(passed, place);\n", "    (void)&TapestryMotion::keep_in_view;\n", "scene_test.tapestry_show_test"),
    Cure("a film's end that leads nowhere", "player/scene/tapestry/tapestry_preview.cpp",
         "    return now >= end ? std::optional(end) : std::nullopt;", "    return (void)now, (void)end, std::nullopt;", "scene_test.tapestry_show_test"),
    Cure("a preview that does not follow the finger", "player/scene/tapestry/strip_finger.cpp",
         "        strip.preview.look_at(strip.place.time_at(", "        if (false) strip.preview.look_at(strip.place.time_at(", "scene_test.tapestry_show_test"),
    Cure("a preview that waits for a decoder", "player/scene/tapestry/tapestry_picture.cpp",
         "    if (scrubbed.moment() && has_kept(*scrubbed.moment())) {", "    if (false && scrubbed.moment() && has_kept(*scrubbed.moment())) {",
         "scene_test.tapestry_show_test"),
    Cure("a preview that stays empty on a screen of another size", "player/scene/tapestry/tapestry_show.cpp",
         "    if (awaited) preview_.play", "    if (awaited && awaited->count() < 0) preview_.play", "scene_test.tapestry_show_test"),
    Cure("a preview that stays empty until a tap", "player/stage/tapestry_playback.cpp",
         "                              .plays_at_once = true,\n", "", "stage_test.tapestry_playback_test"),
    Cure("a motion photo without its film", "player/scene/wall_shot.cpp",
         "    if (record->film && record->film->is_there()) {", "    if (false) {", "scene_test.file_groups_test"),
    Cure("a caption over a face or a bezel", "player/scene/caption_place.cpp",
         "!touches_any(wide, room.avoided)", "!touches_any(wide, {})", "scene_test.caption_place_test"),
    Cure("like shots that stand apart", "player/layout/plan/plan.cpp",
         "        return wants_alike(request) ? with_alike_neighbours(request, layout, watch) : layout;\n",
         "        (void)wants_alike(request);\n        return layout;\n", "layout_test.neighbours_test"),
    Cure("a box that shows half a wall", "player/scene/acts/followed_wall.cpp",
         "(has_time && sources_.are_there(*waiting_))", "has_time", "acts_test.shared_wall_test"),
    Cure("a box that begins when it hears", "player/scene/wall.cpp",
         "now + lead;", "now;", "acts_test.shared_wall_test"),
    Cure("a change that is told too late", "player/scene/acts/led_wall.hpp",
         "milliseconds(1250)", "milliseconds(500)", "acts_test.shared_wall_test"),
    Cure("a clock that nobody keeps right", "player/scene/acts/wall_clock.cpp",
         "    if (!reading.is_right) {\n        is_right_ = false;\n        return;\n    }\n", "", "acts_test.wall_clock_test"),
    Cure("an act that names any file", "player/scene/acts/shot_json.cpp",
         '    if (!is_store_name(stored.file)) throw ActFault("an act names a file that is no file of a store");\n', "", "acts_test.act_json_test"),
]


def run(*command):
    return subprocess.run([str(word) for word in command], cwd=TREE, text=True, errors="replace", capture_output=True)


def targets_of(cure):
    return cure.targets or (cure.test.split(".")[0],)


def is_built(preset, targets):
    built = run("cmake", "--build", "--preset", preset, "--target", *targets)
    if built.returncode != 0:
        print(built.stdout[-3000:])
    return built.returncode == 0


def passing_tests(preset, tests):
    """Runs the tests; the names of those that pass."""
    said = run("ctest", "--preset", preset, "-R", f"^({'|'.join(tests)})$", "--no-tests=error", "--timeout", "300").stdout
    return set(re.findall(r"Test +#\d+: (\S+) [. ]*Passed", said))


def tests_that_pass_now(cures, preset):
    """Builds the tests of these cures with all cures in, and runs them; the names of those that pass."""
    if run("cmake", "--preset", preset).returncode != 0:
        sys.exit(f"there is no preset '{preset}'")
    if not is_built(preset, sorted({target for cure in cures for target in targets_of(cure)})):
        sys.exit("the tree does not compile as it is")
    return passing_tests(preset, sorted({cure.test for cure in cures}))


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
        compiles = is_built(preset, targets_of(cure))
        fails = compiles and cure.test not in passing_tests(preset, [cure.test])  # what it needs runs, too
    finally:
        file.write_text(text)
    says = f"{cure.test} fails" if fails else f"{cure.test} PASSES without the cure" if compiles else "does not compile without the cure"
    print(f"{cure.name}: {says}", flush=True)
    return fails


def main():
    if sys.argv[1:] == ["--check"]:
        sys.exit(not all([is_found_once(cure) for cure in CURES]))
    if run("git", "status", "--porcelain", "--untracked-files=no").stdout:
        sys.exit("the tree is not as committed")
    preset, names = (sys.argv[1:2] or ["cures"])[0], sys.argv[2:]
    chosen = [cure for cure in CURES if cure.only in ("", preset) and (not names or cure.name in names)]
    passing = tests_that_pass_now(chosen, preset)
    for test in sorted({cure.test for cure in chosen} - passing):
        print(f"{test} fails with all cures in", flush=True)
    proven = [cure for cure in chosen if cure.test in passing and is_proven(cure, preset)]
    print(f"{len(proven)} of {len(chosen)} proven")
    sys.exit(len(proven) != len(chosen))


if __name__ == "__main__":
    main()

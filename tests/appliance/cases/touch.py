"""A touch panel on the wall: taps, holds, and two fingers at once. uinput makes the panel, so kernel, udev and libinput are real."""
import shutil
from pathlib import Path

from appliance import STILLS
from machine import HEIGHT, WIDTH, wait_for

FIFO = "/run/rig-touches"
NEAR = 0.25 * (WIDTH ** 2 + HEIGHT ** 2) ** 0.5  # px: a shot goes so near to its finger, as it stays on the screen


def places_in(picture):
    """The middle of each photo that a picture shows."""
    return {name: middle for name, colour in STILLS.items() if (middle := picture.middle_of(colour))}


def distance(a, b):
    return ((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5


class Panel:
    """A panel that is plugged in."""

    def __init__(self, box):
        self.box = box
        shutil.copy(Path(__file__).parent.parent / "touch_panel.pl", box.machine.share)
        box.machine.mount_share()
        box.sh(f"install -m 755 /host/touch_panel.pl /tmp; umount /host; modprobe uinput; mkfifo {FIFO}")
        begin = box.now()
        box.sh(f"systemd-run -q --unit=rig-panel perl /tmp/touch_panel.pl {WIDTH} {HEIGHT} {FIFO}")
        box.wait_for_word("input: found 'rig panel'", begin)

    def touch(self, *lines):
        told = "\n".join(lines)
        self.box.sh(f"cat >{FIFO} <<'END'\n{told}\nEND")


def at(slot, point):
    return f"{slot} {point[0]:.0f} {point[1]:.0f}"


def way(slot, begin, end, steps=8):
    """The contacts of a finger that moves."""
    return [at(slot, [b + (e - b) * k / steps for b, e in zip(begin, end)]) for k in range(steps + 1)]


def wait_for_picture(box, what, is_right):
    """Until the panel's picture is right."""
    wait_for(what, lambda: is_right(box.machine.picture()))
    return box.look(what)


def wait_for_share(box, what, name, share):
    """Until a file's colour covers so much of the panel."""
    wait_for_picture(box, what, lambda picture: picture.share_of(STILLS[name]) >= share)


def are_near(picture, places, reach):
    """True if photos are in their places, or no farther from them, px."""
    now = places_in(picture)
    return all(name in now and distance(now[name], place) < reach for name, place in places.items())


def wait_for_places(box, what, places):
    """Until each photo is where it was. A photo that returns lies above others, and would take their touches."""
    wait_for_picture(box, what, lambda picture: are_near(picture, places, 4))


def tap(box, panel):
    places = places_in(box.wait_for_wall("the wall before a touch"))
    panel.touch(at(0, places["red"]), "rest 0.1", "0 up")
    wait_for_share(box, "the tapped photo on the whole screen", "red", 0.6)
    panel.touch(at(0, (WIDTH / 2, HEIGHT / 2)), "rest 0.1", "0 up")
    wait_for_places(box, "the wall after the second tap", places)


def hold(box, panel):
    places = places_in(box.wait_for_wall("the wall before a hold"))
    panel.touch(at(1, places["blue"]))
    wait_for_share(box, "the held photo large", "blue", 0.25)  # on the wall it has half of that
    panel.touch("1 up")
    wait_for_places(box, "the wall after the hold", places)


def drag_two(box, panel):
    """Two fingers at once, each with a photo of its own."""
    before = places_in(box.wait_for_wall("the wall before two fingers"))
    goals = {"red": before["blue"], "blue": before["red"]}
    steps = [way(slot, before[name], goals[name]) for slot, name in enumerate(goals)]
    panel.touch(*[line for both in zip(*steps) for line in (*both, "rest 0.05")])

    held = wait_for_picture(box, "two fingers with a photo each", lambda picture: are_near(picture, goals, NEAR))
    panel.touch("rest 0.3", "0 up", "1 up")

    def are_put_down(picture):
        """A photo in a hand is smaller than on the wall."""
        larger = all(picture.share_of(STILLS[name]) > 1.2 * held.share_of(STILLS[name]) for name in goals)
        return larger and are_near(picture, goals, NEAR)

    wait_for_picture(box, "the wall after two fingers", are_put_down)


def run(box):
    pid = box.pid()
    panel = Panel(box)
    tap(box, panel)
    hold(box, panel)
    drag_two(box, panel)
    begin = box.now()
    box.sh("systemctl stop rig-panel")
    box.wait_for_word("input: gone: 'rig panel'", begin)
    box.wait_for_wall("the wall without the panel")
    assert box.pid() == pid, "it is the same process"

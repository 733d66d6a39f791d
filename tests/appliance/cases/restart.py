"""The player is restarted, killed and stopped: over a restart the screen keeps its picture until the next process has one.

Two restarts and a kill, or as many more of each as VITRINE_RIG_RESTARTS says.
"""
import os
import time

from machine import wait_for

MORE = int(os.environ.get("VITRINE_RIG_RESTARTS", 0))
RESTARTS = 1 + MORE
KILLS = 1 + MORE
PAUSE = 0.02  # s between two looks: without one they slow the machine down; each of its pictures lasts a second
MAX_BLACK = 0.3  # of the screen; the wall leaves none, the console is black


def buffers(box):
    """Pictures that the card knows of."""
    box.sh("mountpoint -q /sys/kernel/debug || mount -t debugfs none /sys/kernel/debug")
    return int(box.sh("cat /sys/kernel/debug/dri/0/framebuffer | grep -c '^framebuffer\\['"))


def unit(box, what):
    return box.sh(f"systemctl show -p {what} --value vitrine-player")


def never_black(box, what, act):
    """Does something that brings another process, and looks at the panel until that one has shown its first picture."""
    before = box.machine.picture()
    assert before.share_of((0, 0, 0), 8) <= MAX_BLACK, "the wall to begin with"
    pid, begin = box.pid(), box.now()
    act()
    looks, same, whole, first = 0, 0, 0, None
    end = time.monotonic() + 600
    while first is None and time.monotonic() < end:
        time.sleep(PAUSE)
        picture = box.machine.picture()
        looks += 1
        if picture.share_of((0, 0, 0), 8) > MAX_BLACK:
            box.look(f"black after {what}")
            raise AssertionError(f"{what}: the screen is black, look {looks}")
        same += picture.size == before.size
        whole += not box.lacking(picture)
        if looks % 4 == 0:
            first = next((line for _, line in box.words(begin, None) if "first picture on Virtual-1" in line), None)
    assert first, f"{what}: no first picture"
    assert whole, f"{what}: the wall was never seen, so its last picture was not kept"
    assert same == looks, f"{what}: another mode in between"
    assert box.pid() != pid, f"{what}: the same process"
    box.wait_for_wall(f"the wall after {what}", keeps=False)
    print(f"{what}: {looks} looks, none black, the whole wall in {whole}; {first}")


def run(box):
    box.restart(layout__slots=4, show__dwell_seconds=3600)
    box.wait_for_wall("the wall")
    assert unit(box, "NFileDescriptorStore") == "1", "systemd holds the card"
    never_black(box, "the first restart", lambda: box.sh("systemctl restart --no-block vitrine-player"))
    known = buffers(box)
    for number in range(RESTARTS):
        never_black(box, f"restart {number}", lambda: box.sh("systemctl restart --no-block vitrine-player"))
    for number in range(KILLS):
        never_black(box, f"kill {number}", lambda: box.sh("systemctl kill -s KILL vitrine-player"))
    wait_for("pictures of earlier processes to be gone", lambda: buffers(box) <= known)
    assert unit(box, "NFileDescriptorStore") == "1"
    print(f"{buffers(box)} pictures known to the card after {RESTARTS + KILLS + 1} restarts")

    # Who stops it has the console back, and the card.
    box.sh("systemctl stop vitrine-player")
    wait_for("the console", lambda: box.machine.picture().share_of((0, 0, 0), 8) > MAX_BLACK)
    assert unit(box, "NFileDescriptorStore") == "0", "nothing is held of a stopped service"
    box.look("stopped")
    box.sh("systemctl start vitrine-player")
    box.wait_for_wall("the wall after a start")

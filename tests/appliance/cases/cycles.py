"""A panel is pulled out and put back again and again: 5 times, or as often as VITRINE_RIG_CYCLES says.

From the panel to the first picture it may take 5 s. The machine's clock goes on while its processors wait for the host's, but
its kernel counts by ticks what they did, and misses those that it was not there for. The share of time that is not counted
is the host's, and is taken off.
"""
import os

MOST = 5  # s
PROCESSORS = 2


def clocks(box):
    """Two of the machine's, in seconds: the one that always goes on, and what its processors did and rested."""
    now, *counted = box.sh("cut -d' ' -f1 /proc/uptime; head -1 /proc/stat | cut -d' ' -f3-").split()
    return float(now), sum(map(int, counted)) / 100 / PROCESSORS


def cycle(box):
    """One; the seconds from the panel to its first picture, as the player says, and about how many on a quiet host."""
    box.pull()
    plugged, counted = clocks(box)
    box.panel()
    told = box.wait_for_word(r"first picture on Virtual-1 after (\d+) ms", plugged)
    delay = int(told[1]) / 1000
    seen, counted_then = clocks(box)
    own = min(1.0, (counted_then - counted) / (seen - plugged))
    box.wait_for_wall("the wall", size=(640, 360), keeps=False)
    return delay, delay * own


def run(box):
    pid, delays, owns = box.pid(), [], []
    for number in range(int(os.environ.get("VITRINE_RIG_CYCLES", 5))):
        delay, own = cycle(box)
        delays.append(delay)
        owns.append(own)
        assert own <= MOST, f"{delay} s to the first picture of cycle {number}, {own:.1f} s of them its own"
        assert box.pid() == pid, f"another process after {number} cycles"
    for what, seconds in (("", sorted(delays)), (", without what the host took", sorted(owns))):
        print(f"{len(delays)} cycles, same process; first picture after {seconds[len(seconds) // 2]:.1f} s (median), {seconds[-1]:.1f} s (most){what}")
    box.look("after the last cycle")

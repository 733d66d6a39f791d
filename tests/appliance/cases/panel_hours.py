"""Evening after evening the panel goes off by `output.on`, and comes back in the morning: 3 times, or as often as
VITRINE_RIG_NIGHTS says. The machine's clock is set, as nobody waits for a night."""
import datetime
import os

from machine import wait_for

FIRST = datetime.datetime(2027, 3, 1)


def set_clock(box, day, hour):
    """5 s after an hour of the day with that number. The guest's steady clock before it."""
    begin = box.now()
    box.sh(f"date -u -s '{FIRST + datetime.timedelta(days=day, hours=hour, seconds=5)}'")
    return begin


def signal(box):
    """"On" while the kernel sends the panel a signal, else "Off"."""
    return box.sh("cat /sys/class/drm/card*-Virtual-1/dpms").strip()


def night(box, day):
    evening = set_clock(box, day, 20)
    box.wait_for_word("panels off", evening)
    wait_for("the panel's signal to end", lambda: signal(box) == "Off")
    morning = set_clock(box, day + 1, 8)
    box.wait_for_word("panels on", morning)
    wait_for("the panel's signal", lambda: signal(box) == "On")
    box.wait_for_wall("the wall in the morning", size=(640, 360), keeps=False)


def run(box):
    box.sh("systemctl stop systemd-timesyncd 2>/dev/null; timedatectl set-timezone UTC", fails=True)
    set_clock(box, 0, 12)
    box.restart(output__on="08:00-20:00")
    pid = box.pid()
    box.wait_for_wall("the wall by day", size=(640, 360))
    nights = int(os.environ.get("VITRINE_RIG_NIGHTS", 3))
    for day in range(nights):
        night(box, day)
        assert box.pid() == pid, f"another process after {day} nights"
    box.look("after the last night")
    print(f"{nights} nights, same process; the signal ended and came back with the wall each time")

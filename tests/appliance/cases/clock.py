"""A machine without a clock starts in 1970, one with a bad one fifty years ahead: the wall plays, and nobody miscounts."""
import re

from appliance import MEDIA
from machine import wait_for

WRONG = {"in 1970": "@86400", "in fifty years": "+50 years"}
MISCOUNTED = re.compile(r"(?<![\w.-])-\d+(\.\d+)? (m?s|pictures|frames)\b|\b(nan|inf)\b|\d{12,}|overflow|out of range|in the future", re.I)


def run(box):
    box.sh("systemctl stop systemd-timesyncd 2>/dev/null", fails=True)
    for when, date in WRONG.items():
        pid, begin = box.pid(), box.now()
        box.sh(f"date -s '{date}'")
        # What plays goes on: the same process, and the film moves.
        box.wait_for_motion(f"the film to move {when}")
        assert box.pid() == pid, f"{when} the player is another process"

        # What is started there finds its way, and files of that time are taken.
        box.sh(f"systemctl restart vitrine-analyzer; touch {MEDIA}/red.png")
        box.restart()
        box.wait_for_wall(f"the wall {when}", size=(640, 360))
        box.wait_for_motion(f"the film to move after a start {when}")
        status = [(0, line) for line in box.sh("systemctl show -p StatusText --value vitrine-player vitrine-analyzer").splitlines()]
        for unit in ("vitrine-player", "vitrine-analyzer"):
            for _, line in box.journal(unit, begin) + status:
                assert not MISCOUNTED.search(line), f"{when} {unit} says: {line}"
        # What changes from now on is still noticed.
        box.sh(f"mv {MEDIA}/red.png /run/red.png")
        wait_for(f"red.png to leave the wall {when}", lambda: "red" in box.lacking(box.machine.picture()))
        box.sh(f"install -o vitrine -g vitrine -m 664 /run/red.png {MEDIA}/red.png")
        box.wait_for_wall(f"the whole wall again {when}", size=(640, 360))
    box.sh("date -s '-50 years'")
    box.wait_for_motion("the film to move when the clock has gone back")

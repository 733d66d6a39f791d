"""The units do what docs/technician.md says: starts that fail, programs that hang, too little memory, a clock that jumps, and a
stop while the share hangs.

The media folder is a share whose server stops answering when it is told to: bindfs over the folder itself. Nothing is in the
store, so that the player reads the share as well.
"""
import json

from appliance import COLOURS, MEDIA
from image import run as tool
from machine import wait_for

PLAYER, ANALYZER = "vitrine-player", "vitrine-analyzer"
UNITS = (PLAYER, ANALYZER)
FAILED_STARTS = {PLAYER: 12, ANALYZER: 6}  # of the player more than systemd's own limit allows in so short a time
ORANGE, HOURS = (250, 130, 0), "10-12 Morning"
HELD = "grep -ls request_wait_answer /proc/{}/task/*/stack"  # who waits for the server of the share


def run(box):
    as_shipped(box)
    behind_a_share(box)
    starts_that_fail(box)
    programs_that_hang(box)
    too_little_memory(box)
    a_clock_that_jumps(box)
    a_stop_while_the_share_hangs(box)


def shown(box, unit, what):
    return box.sh(f"systemctl show -p {what} --value {unit}")


def pids(box):
    return {unit: shown(box, unit, "MainPID") for unit in UNITS}


def records(box):
    """{path: state} of the catalogue."""
    texts = box.sh("cd /var/lib/vitrine/catalogue && for file in *.json; do tr -d '\\n' <$file; echo; done").splitlines()
    return {record["path"]: record["state"] for record in map(json.loads, texts)}


def wait_for_both(box):
    for unit in UNITS:
        box.wait_until_active(unit)
    box.wait_for_word("first picture on", pid=box.pid())  # until then there is the last process' one
    box.wait_for_wall("the wall")


def told(box, what, since):
    print(f"{what}: {box.now() - since:.0f} s", flush=True)


def as_shipped(box):
    """The units' own lines hold, but for what an emulated machine is too slow for: a start has all time, a stop six times the units',
    and a limit of starts, which the units have not, would be reached by three in ten seconds."""
    for unit in UNITS:
        drop_in = f"/run/systemd/system/{unit}.service.d/rig.conf"
        box.sh(f"printf '[Unit]\\nStartLimitBurst=2\\n[Service]\\nTimeoutStartSec=infinity\\nTimeoutStopSec=60\\n' >{drop_in}")
    box.sh("systemctl daemon-reload")


def behind_a_share(box):
    box.sh(f"systemctl stop {' '.join(UNITS)}; mkdir /run/server; mount --bind --make-private {MEDIA} /run/server; "
           f"bindfs -o nonempty /run/server {MEDIA}")
    box.set(store__max_bytes=0, layout__slots=len(COLOURS) + 1, analyzer__rescan_seconds=5)


def starts_that_fail(box):
    """The programs cannot be executed, as in the midst of an update that failed; then they can."""
    begin = box.now()
    box.sh(f"systemctl start {ANALYZER}; chmod a-x /usr/bin/{PLAYER}; systemctl start --no-block {PLAYER}")
    wait_for_failed_starts(box, PLAYER)
    box.sh(f"chmod a+x /usr/bin/{PLAYER}; chmod a-x /usr/bin/{ANALYZER}; systemctl kill -s KILL {ANALYZER}")
    wait_for_failed_starts(box, ANALYZER)
    box.sh(f"chmod a+x /usr/bin/{ANALYZER}")
    wait_for_both(box)
    told(box, "the wall after starts that failed", begin)


def wait_for_failed_starts(box, unit):
    wait_for(f"{unit} to be started {FAILED_STARTS[unit]} times",
             lambda: is_tried(box, unit) and int(shown(box, unit, "NRestarts")) >= FAILED_STARTS[unit])


def is_tried(box, unit):
    assert shown(box, unit, "Result") != "start-limit-hit", f"{unit} is given up"
    return True


def programs_that_hang(box):
    begin, before = box.now(), pids(box)
    box.sh(f"systemctl kill -s STOP --kill-whom=main {' '.join(UNITS)}")
    for unit in UNITS:
        wait_for(f"the watchdog of {unit}", lambda: shown(box, unit, "MainPID") not in ("0", before[unit]))
        assert any("Watchdog timeout" in line for _, line in box.journal(unit, begin)), f"it was not the watchdog that ended {unit}"
    wait_for_both(box)
    told(box, "the wall after programs that hung", begin)


def too_little_memory(box):
    """The reader of one photo needs more than the unit may have: an interlaced picture is held as a whole."""
    begin, before = box.now(), pids(box)
    name = f"{HOURS}/orange.png"
    box.sh(f"systemctl set-property --runtime {ANALYZER} MemoryMax={most_memory(box)}")
    drop_photo_of_the_morning(box)
    wait_for("the kernel to kill a reader", lambda: int(box.sh(f"grep -w oom_kill {cgroup()}/memory.events | cut -d' ' -f2")))
    wait_for("its record", lambda: records(box).get(name) == "waiting")
    assert pids(box) == before, "a service is another process"
    assert shown(box, ANALYZER, "ActiveState") == "active"
    assert any("lacks memory" in line for _, line in box.journal(ANALYZER, begin)), "its reason is not told"
    told(box, "a reader without memory", begin)
    box.sh(f"systemctl set-property --runtime {ANALYZER} MemoryMax=infinity")
    wait_for("the photo to be tried again", lambda: records(box).get(name) == "ready")
    assert pids(box) == before, "a service is another process"
    assert set(records(box).values()) == {"ready"}, records(box)
    told(box, "it is ready", begin)


def drop_photo_of_the_morning(box):
    tool("ffmpeg", "-v", "error", "-f", "lavfi", "-i", f"color=0x{bytes(ORANGE).hex()}:size=3000x3000", "-frames:v", 1, "-flags", "+ildct",
         box.machine.share / "orange.png")
    box.machine.mount_share()
    tomorrow = box.sh("date -d '1 day' +%F")  # later than every record, so that the clock is plausible
    box.sh(f"date -s '{tomorrow} 11:00'; mkdir '/run/server/{HOURS}'; cp /host/orange.png '/run/server/{HOURS}'; umount /host")


def cgroup():
    return f"/sys/fs/cgroup/system.slice/{ANALYZER}.service"


def most_memory(box):
    """Bytes: what the daemon has, and twice what the reader of a small photo needs."""
    words = box.sh(f"cat {cgroup()}/memory.stat").split()
    now = dict(zip(words[::2], map(int, words[1::2])))
    return now["anon"] + now["kernel"] + (24 << 20)


def pictures(box):
    """How many the player has shown, as its status says every 5 s. A film may stand still where the machine is too slow."""
    return box.sh(f"systemctl show -p StatusText --value {PLAYER} | grep -o '[0-9]* pictures shown'", fails=True)


def set_clock(box, date, is_open):
    """Until the photo that has hours is there, or gone."""
    box.sh(f"date -s '{date}'")
    wait_for(f"the photo of the morning to be {'there' if is_open else 'gone'} at {date}",
             lambda: (box.machine.picture().share_of(ORANGE) > 0.01) == is_open)
    box.look(f"the wall at {date}")


def a_clock_that_jumps(box):
    begin, before, day = box.now(), pids(box), box.sh("date +%F")
    kept = box.sh("cd /var/lib/vitrine/catalogue; stat -c '%n %i %Y' *.json")
    set_clock(box, f"{day} 11:10", True)
    for date, is_open in ((f"{day} 13:00", False), (f"{day} 11:30", True), ("2001-01-01 11:30", False), (f"{day} 11:40", True)):
        set_clock(box, date, is_open)
        box.wait_for_wall(f"the wall at {date}", keeps=False)
        before_jump = pictures(box)
        wait_for(f"more pictures at {date}", lambda: pictures(box) not in ("", before_jump))
    box.sh("sleep 6")  # longer than a rescan
    assert pids(box) == before, "a service is another process"
    assert box.sh("cd /var/lib/vitrine/catalogue; stat -c '%n %i %Y' *.json") == kept, "records were written anew"
    for _, line in box.journal(ANALYZER, begin):
        assert not line.startswith(("gone", "renamed", "ready", "analysing")), line
    told(box, "the clock", begin)


def hang_the_share(box):
    """Stops the share's server between two requests: no process ends, not even by SIGKILL, that waits for the answer to a request
    which the server of a FUSE file system has taken."""
    box.sh("mountpoint -q /sys/fs/fuse/connections || mount -t fusectl fusectl /sys/fs/fuse/connections")
    box.sh(f"systemctl kill -s STOP {' '.join(UNITS)}")
    wait_for("the answers of the share", lambda: box.sh("cat /sys/fs/fuse/connections/*/waiting | sort -u") == "0")
    box.sh(f"pkill -STOP -x bindfs; systemctl kill -s CONT {' '.join(UNITS)}")


def a_stop_while_the_share_hangs(box):
    pid, before, day = shown(box, ANALYZER, "MainPID"), records(box), box.sh("date +%F")
    set_clock(box, f"{day} 13:00", False)
    hang_the_share(box)
    box.sh(f"date -s '{day} 11:50'")  # the photo of the morning is to be read again
    wait_for("the analyzer to hang", lambda: box.sh(HELD.format(pid), fails=True))
    wait_for("a reader of the player to hang", lambda: box.sh(
        f"for reader in $(pgrep -x vitrine-reader); do {HELD.format('$reader')}; done", fails=True))
    begin = box.now()
    box.sh(f"systemctl stop {' '.join(UNITS)}")
    told(box, "both stopped", begin)
    for unit in UNITS:
        state = shown(box, unit, "ActiveState"), shown(box, unit, "Result")
        assert state == ("inactive", "success"), f"{unit} counts as {state}"

    box.sh(f"pkill -CONT -x bindfs; systemctl start {ANALYZER}")
    box.wait_until_active(ANALYZER)
    wait_for("all files to be ready again", lambda: "5 ready" in shown(box, ANALYZER, "StatusText"))
    assert records(box) == before, records(box)

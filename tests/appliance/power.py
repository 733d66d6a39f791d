"""The power goes while files arrive: what the analyzer had said to be ready before has its record after, whole."""
import json
import re
import time

from appliance import MEDIA
from disk_machine import DiskMachine

CATALOGUE = "/var/lib/vitrine/catalogue"
LONGEST = 120  # s until a cut; the first promises are made after some 50
# Files come, are written over and go; what has come is flushed, so that a record of it must not go either.
ARRIVALS = f"""
cd {MEDIA}; cp -p red.png /tmp/one.png; cp -p blue.png /tmp/two.png; i=0
while :; do
    i=$((i + 1))
    cp /tmp/one.png stays-$i.png; sync stays-$i.png .
    if [ $((i % 2)) = 0 ]; then cat /tmp/one.png >over.png; else cat /tmp/two.png >over.png; fi
    cp /tmp/two.png goes-$i.png; rm -f goes-$((i - 2)).png
    sleep 3
done
"""


def records(box, state=None, before=None):
    """Paths of the records (in a state, written before a moment in seconds since 1970); each must be whole."""
    found = set()
    listed = box.sh(f"cd {CATALOGUE} && for f in *.json; do [ ! -e \"$f\" ] || {{ stat -c %Y \"$f\"; tr -d '\\n' <\"$f\"; echo; }}; done")
    lines = listed.splitlines()
    for changed, text in zip(lines[::2], lines[1::2]):
        record = json.loads(text)
        if (state is None or record["state"] == state) and (before is None or int(changed) < before):
            found.add(record["path"])
    return found


def start_arrivals(box):
    box.sh(f"cat >/run/arrivals <<'END'\n{ARRIVALS}END")
    box.sh("systemd-run --quiet --unit=told sh -c 'journalctl -f -n 0 -o cat -u vitrine-analyzer >/dev/ttyS0'; sleep 1; "
           "systemd-run --quiet --unit=arrivals --uid=vitrine --gid=vitrine sh /run/arrivals")


def promised(said):
    """Files that the analyzer has told to be ready, in what the machine's console said; a last line that was cut off is not among them."""
    return set(re.findall(r"ready: '(stays-\d+\.png)'\r?\n", said))


def cut_once(disk, snapshot, chance, pictures, guarded):
    said = {}

    def arrive(box):
        start_arrivals(box)
        time.sleep(chance.uniform(0, LONGEST))
        said["before"] = box.machine.cut()

    guarded(DiskMachine(disk, snapshot, safe=True), pictures / "before", arrive)
    guarded(DiskMachine(disk, safe=True), pictures / "after", lambda box: check(box, promised(said["before"])))


def check(box, due):
    """The machine that has started again."""
    started = int(box.sh("awk '/^btime/ {print $2}' /proc/stat"))
    kept = records(box, before=started)
    box.wait_until_active("vitrine-player")
    box.wait_for_word("first picture on")
    box.look("after the cut")
    errors = box.sh("dmesg | grep -iE 'ext4-fs.*(error|corrupt)' || true")
    recovered = box.sh("journalctl -b -q -o cat -u 'systemd-fsck@*' | grep -c 'recovering journal' || true")
    assert recovered != "0", "nothing was being written when the power went"
    failed = box.sh("systemctl --failed --no-legend --plain | cut -d' ' -f1")
    unreadable = [line for _, line in box.journal("vitrine-analyzer") if "unreadable" in line or "no sense" in line]
    print(f"{len(due)} records promised, {len(kept)} kept, file systems that were mended: {recovered}")
    assert not due - kept, f"lost: {sorted(due - kept)}"
    assert not errors and not failed and not unreadable, f"{errors} {failed} {unreadable}"

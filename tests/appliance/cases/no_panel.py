"""Without a panel nothing is drawn, and the processor rests.

The player's processor time is compared with that of a loop of the shell in the same seconds: where the host is short of
processors, both grow.
"""

SECONDS = 5
LOOP = "i=0; while [ $i -lt 50000 ]; do i=$((i + 1)); done; cat /proc/$$/stat"
MAX_LOOPS = 0.3  # 0.02 to 0.1; 0.9 where the player goes on with its pictures


def processor_time(stat):
    """Of a process, in seconds."""
    fields = stat.rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / 100


def loops(box, pid):
    """The player's processor time in ten seconds, in loops of the shell."""
    begin = box.now()
    before = processor_time(box.sh(f"cat /proc/{pid}/stat"))
    loop = processor_time(box.sh(f"sleep {SECONDS}; sh -c '{LOOP}'"))
    used = processor_time(box.sh(f"sleep {SECONDS}; cat /proc/{pid}/stat")) - before
    seconds = box.now() - begin
    print(f"{used:.2f} s of the player in {seconds:.1f} s, {loop:.2f} s of the loop")
    return used / seconds * 10 / loop


def run(box):
    box.restart(output__frame_rate=5)  # more than the rig's own, so that a player that goes on drawing is found out
    pid = box.pid()
    playing = loops(box, pid)

    box.pull()
    idle = min(loops(box, pid) for _ in range(3))

    print(f"{playing:.2f} loops with a panel, {idle:.2f} without")
    box.panel()
    box.wait_for_wall("the wall on the panel that came back")
    assert box.pid() == pid, "it is the same process"
    assert idle < MAX_LOOPS, f"{idle:.2f} loops without a panel"

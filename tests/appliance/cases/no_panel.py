"""Without a panel nothing is decoded or drawn, and the processor rests.

Decoders and rasterizer have threads of their own, which use no processor time then. That of the whole player is compared
with that of a loop of the shell in the same seconds: where the host is short of processors, both grow.
"""

SECONDS = 5
LOOP = "i=0; while [ $i -lt 50000 ]; do i=$((i + 1)); done; cat /proc/$$/stat"
MAX_LOOPS = 0.6  # 0.02 to 0.4; 0.9 where the player goes on with its pictures
MAX_DRAWING = 0.05  # of the time that threads use with a panel


def processor_time(stat):
    """Of a process, in seconds."""
    fields = stat.rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / 100


def thread_times(box, pid):
    """The processor time of each thread of the player but its first, in seconds."""
    stats = box.sh(f"cat /proc/{pid}/task/*/stat 2>/dev/null || true").splitlines()
    return {stat.split()[0]: processor_time(stat) for stat in stats if stat.split()[0] != str(pid)}


def drawing_time(box, pid):
    """The processor time of threads that decode and draw, in seconds a second."""
    begin, before = box.now(), thread_times(box, pid)
    box.sh(f"sleep {SECONDS}")
    after = thread_times(box, pid)
    return sum(time - before.get(thread, 0) for thread, time in after.items()) / (box.now() - begin)


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
    playing, drawing = loops(box, pid), drawing_time(box, pid)

    box.pull()
    idle, drawing_idle = (min(measure(box, pid) for _ in range(3)) for measure in (loops, drawing_time))

    print(f"{playing:.2f} loops with a panel, {idle:.2f} without; threads that draw: {drawing:.3f} and {drawing_idle:.3f} s a second")
    box.panel()
    box.wait_for_wall("the wall on the panel that came back")
    assert box.pid() == pid, "it is the same process"
    assert idle < MAX_LOOPS, f"{idle:.2f} loops without a panel"
    assert drawing_idle < MAX_DRAWING * drawing, f"{drawing_idle:.3f} of {drawing:.3f} s a second are used to draw without a panel"

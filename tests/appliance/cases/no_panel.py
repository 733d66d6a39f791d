"""Without a panel nothing is drawn, and the processor rests."""

SECONDS, MOST = 10, 0.02  # 0.5 %; 4.5 % where the player goes on with its pictures


def processor_time(box, pid):
    """Of the process, in seconds."""
    fields = box.sh(f"cat /proc/{pid}/stat").rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / 100


def share(box, pid):
    begin, used = box.now(), processor_time(box, pid)
    box.sh(f"sleep {SECONDS}")
    return (processor_time(box, pid) - used) / (box.now() - begin)


def run(box):
    box.restart(output__frame_rate=5)  # more than the rig's own, so that a player that goes on drawing is found out
    pid = box.pid()
    playing = share(box, pid)

    box.pull()
    # The least of three: what the host takes from the machine counts there as time of the process that was running.
    idle = min(share(box, pid) for _ in range(3))

    print(f"{playing:.1%} of a processor with a panel, {idle:.1%} without")
    assert idle < MOST, f"{idle:.1%} of a processor without a panel"
    box.panel()
    box.wait_for_wall("the wall on the panel that came back")
    assert box.pid() == pid, "it is the same process"

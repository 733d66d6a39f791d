"""A second panel comes: it shows the wall too, in its own mode, and the first goes on; and one goes without the other."""


def run(box):
    pid = box.pid()

    box.panel(800, 450, head=1)
    box.wait_for_wall("the wall on the second panel", head=1, size=(800, 450))
    box.wait_for_wall("the wall on the first still", size=(640, 360))
    box.wait_for_motion("the film to move on the second", head=1)
    box.wait_for_motion("the film to move on the first")

    begin = box.now()
    box.unplug()
    box.wait_for_word("panel gone from Virtual-1", begin)
    box.wait_for_motion("the film to move on the second alone", head=1)
    box.panel()
    box.wait_for_wall("the wall on the first again", size=(640, 360))
    assert box.pid() == pid, "it is the same process"

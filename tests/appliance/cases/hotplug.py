"""A panel goes and comes back, and another one of another size comes in its place: nobody has to do anything."""


def run(box):
    pid = box.pid()

    box.pull()
    box.panel()
    box.wait_for_wall("the wall on the panel that came back", size=(640, 360))

    box.panel(800, 480)
    box.wait_for_wall("the wall in the native mode of another panel", size=(800, 480))
    box.wait_for_motion("the film to move there")

    box.pull()
    box.panel(480, 640)
    box.wait_for_wall("the wall on an upright panel", size=(480, 640))
    assert box.pid() == pid, "it is the same process"

"""Two panels, each with the wall of a folder of its own."""
from appliance import MEDIA
from machine import wait_for

FOLDERS = {"hall": ["blue.png", "magenta.mp4"], "lobby": ["red.png", "green.png"]}


def run(box):
    for folder, files in FOLDERS.items():
        box.sh(f"cd {MEDIA}; install -d -o vitrine -g vitrine {folder}; mv {' '.join(files)} {folder}")
    box.panel(800, 450, head=1)
    box.restart(output__folders="Virtual-1=hall, Virtual-2=lobby")

    for head, (folder, files) in enumerate(FOLDERS.items()):
        names = {file.split(".")[0] for file in files}
        # Until its own first picture a panel shows what it showed before: the wall of all files.
        wait_for(f"the {folder} alone", lambda: box.files_in(box.machine.picture(head)) == names)
        box.wait_for_wall(f"the wall of the {folder}", head=head, files=names)
    box.wait_for_motion("the film to move in the hall")

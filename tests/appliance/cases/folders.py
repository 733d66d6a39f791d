"""Two panels, each with the wall of a folder of its own."""
from appliance import MEDIA

FOLDERS = {"hall": ["blue.png", "magenta.mp4"], "lobby": ["red.png", "green.png"]}


def run(box):
    for folder, files in FOLDERS.items():
        box.sh(f"cd {MEDIA}; install -d -o vitrine -g vitrine {folder}; mv {' '.join(files)} {folder}")
    box.panel(800, 450, head=1)
    box.restart(output__folders="Virtual-1=hall, Virtual-2=lobby")

    for head, (folder, files) in enumerate(FOLDERS.items()):
        names = {file.split(".")[0] for file in files}
        picture = box.wait_for_wall(f"the wall of the {folder}", head=head, files=names)
        assert box.files_in(picture) == names, f"the wall of the {folder} shows {box.files_in(picture)}"
    box.wait_for_motion("the film to move in the hall")

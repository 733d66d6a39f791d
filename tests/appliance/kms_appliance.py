#!/usr/bin/env python3
"""Boots a virtual machine with a graphics card and looks at what kms_show puts on its panel.

kms_appliance.py PROGRAM WORK_DIR: needs qemu-system-x86, kmod, cpio, busybox-static and Debian's package
mirror, the first time, for a kernel. The machine is emulated, so that it runs anywhere; it is slow, and
nothing is said about speed here: only the picture, and that it moves, stops and comes back.
"""
import json, pathlib, re, shutil, socket, subprocess, sys, time

PATIENCE = 240  # s, for each step: the emulated machine may be starved by others
LIBRARIES = "/usr/lib/x86_64-linux-gnu"
LOADED_BY_NAME = [  # what the program opens at run time
    f"{LIBRARIES}/libEGL_mesa.so.0", f"{LIBRARIES}/dri/kms_swrast_dri.so", f"{LIBRARIES}/dri/swrast_dri.so"]
INIT = """#!/bin/sh
mount -t proc proc /proc; mount -t sysfs sys /sys; mount -t devtmpfs dev /dev
for module in $(cat /modules); do insmod $module; done
exec >/dev/ttyS0 2>&1
for api in atomic legacy; do echo "phase $api"; kms_show $api 12; done
panel=$(echo /sys/class/drm/card0-Virtual-1/status)
echo "phase unplugged"; echo off >$panel; kms_show atomic 30 & sleep 8
echo "phase plugged"; echo detect >$panel; sleep 10
echo "phase pulled"; echo off >$panel; wait
echo "phase over"; poweroff -f
"""


def run(*command, **more):
    return subprocess.run(command, check=True, capture_output=True, text=True, **more).stdout


def kernel(work):
    """The folder of an unpacked Debian kernel."""
    tree = work / "kernel"
    if not list(tree.glob("boot/vmlinuz-*")):
        depends = run("apt-cache", "depends", "linux-image-amd64")
        package = re.search(r"Depends: (linux-image-\S+)", depends).group(1)
        run("apt-get", "download", package, cwd=work)
        run("dpkg", "-x", next(work.glob(f"{package}_*.deb")), tree)
    return tree


def gpu_modules(tree, version):
    """The kernel modules of the emulated card, in the order to load them."""
    if not (tree / f"lib/modules/{version}/modules.dep").exists():
        run("depmod", "-b", tree, version)
    listed = [run("modprobe", "--show-depends", "-d", tree, "-S", version, name) for name in ("virtio_pci", "virtio_gpu")]
    paths = [line.split()[1] for text in listed for line in text.splitlines() if line.startswith("insmod")]
    return list(dict.fromkeys(paths))


def copy_with_libraries(files, root):
    for file in files:
        needed = re.findall(r"(/\S+) \(0x", run("ldd", file))
        for path in {*needed, file}:
            target = root / path.lstrip("/")
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, target)


def initramfs(work, program, modules):
    root = work / "root"
    shutil.rmtree(root, ignore_errors=True)
    for folder in ("bin", "dev", "proc", "sys", "tmp", "lib", "lib64"):
        (root / folder).mkdir(parents=True)
    shutil.copy("/bin/busybox", root / "bin/busybox")
    for name in ("sh", "mount", "insmod", "cat", "echo", "sleep", "poweroff"):
        (root / "bin" / name).symlink_to("busybox")
    copy_with_libraries([program, *LOADED_BY_NAME], root)
    shutil.copy(program, root / "bin/kms_show")
    vendors = root / "usr/share/glvnd/egl_vendor.d"
    vendors.mkdir(parents=True)
    shutil.copy("/usr/share/glvnd/egl_vendor.d/50_mesa.json", vendors)
    for module in modules:
        shutil.copy(module, root / "lib")
    (root / "modules").write_text("".join(f"/lib/{pathlib.Path(module).name}\n" for module in modules))
    (root / "init").write_text(INIT)
    (root / "init").chmod(0o755)
    names = run("find", ".", cwd=root)
    with open(work / "initramfs", "wb") as archive:
        subprocess.run(["cpio", "-o", "-H", "newc", "--quiet"], input=names.encode(), stdout=archive, cwd=root, check=True)


class Machine:
    def __init__(self, work, vmlinuz):
        self.work, self.log = work, work / "serial.log"
        self.log.write_text("")
        self.process = subprocess.Popen([
            "qemu-system-x86_64", "-machine", "q35,usb=off", "-accel", "tcg,thread=multi", "-cpu", "Nehalem", "-smp", "2",
            "-m", "1500", "-nodefaults", "-no-user-config", "-display", "none", "-vga", "none",
            "-device", "virtio-gpu-pci,id=gpu0,xres=640,yres=360", "-kernel", vmlinuz, "-initrd", work / "initramfs",
            "-append", "console=ttyS0 quiet mitigations=off", "-serial", f"file:{self.log}",
            "-qmp", f"unix:{work / 'qmp'},server=on,wait=off"])
        self.seen = 0

    def ask(self, name, **arguments):
        with socket.socket(socket.AF_UNIX) as door:
            door.settimeout(PATIENCE)
            door.connect(str(self.work / "qmp"))
            words = door.makefile("rw")
            words.readline()
            for request in ({"execute": "qmp_capabilities"}, {"execute": name, "arguments": arguments}):
                words.write(json.dumps(request) + "\n")
                words.flush()
                while "return" not in (answer := json.loads(words.readline())):
                    assert "error" not in answer, answer

    def wait_for(self, pattern):
        """Waits until the console says it, after what was waited for before."""
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline:
            found = re.compile(pattern).search(self.log.read_text(errors="replace"), self.seen)
            if found:
                self.seen = found.end()
                return found.group(0)
            assert self.process.poll() is None, f"the machine ended before '{pattern}'"
            time.sleep(0.2)
        raise AssertionError(f"the console never said '{pattern}'")

    def picture(self, name):
        """What the panel shows: width, height and RGB bytes."""
        path = self.work / f"{name}.ppm"
        self.ask("screendump", filename=str(path), device="gpu0", head=0)
        data = path.read_bytes()
        head = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", data)
        return int(head[1]), int(head[2]), data[head.end():]


def check_quarters(picture):
    width, height, pixels = picture
    assert (width, height) == (640, 360), (width, height)
    for (x, y), wanted in {(100, 60): (200, 20, 20), (540, 60): (20, 200, 20), (100, 300): (20, 20, 200)}.items():
        begin = (y * width + x) * 3
        seen = tuple(pixels[begin:begin + 3])
        assert all(abs(a - b) <= 4 for a, b in zip(seen, wanted)), f"at {x},{y}: {seen}, expected {wanted}"


def look(machine):
    for api in ("atomic", "legacy"):
        machine.wait_for(f"phase {api}")
        print(machine.wait_for(rf"kms_show: .*\({api}\).*"), flush=True)
        machine.wait_for("10 frames")
        first = machine.picture(f"{api}-1")
        machine.wait_for("frames")
        second = machine.picture(f"{api}-2")
        check_quarters(first)
        check_quarters(second)
        assert first[2] != second[2], "the picture stands still"
        machine.wait_for("kms_show: end")
    assert "panel gone" not in machine.log.read_text(errors="replace")[:machine.seen], "a steady panel went dark"
    machine.wait_for("no panel yet")
    for phase, state in (("plugged", "visible 640x360 on Virtual-1"), ("pulled", "panel gone from Virtual-1")):
        machine.wait_for(f"phase {phase}")
        machine.wait_for(f"kms_show: {state}")
        print(phase, "->", state, flush=True)
        if phase == "plugged":
            machine.wait_for("10 frames")
            check_quarters(machine.picture("plugged"))
    machine.wait_for("kms_show: end")
    machine.wait_for("phase over")


def main():
    program, work = sys.argv[1], pathlib.Path(sys.argv[2]).absolute()
    work.mkdir(parents=True, exist_ok=True)
    tree = kernel(work)
    vmlinuz = next(tree.glob("boot/vmlinuz-*"))
    initramfs(work, program, gpu_modules(tree, vmlinuz.name.removeprefix("vmlinuz-")))
    machine = Machine(work, vmlinuz)
    try:
        look(machine)
    except AssertionError as error:
        sys.exit(f"{error}\n--- console ---\n{machine.log.read_text(errors='replace')[-3000:]}")
    finally:
        machine.process.kill()
        machine.process.wait()
    print("the panel showed what it should")


main()

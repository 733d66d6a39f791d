"""vkms, a graphics card in software that flips at true 60 Hz, which Debian's kernel comes without: built from its source.

Everything is unpacked beside the image; nothing is installed on this host.
"""
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from image import NotHere, run


def download(folder, *packages):
    """Unpacks packages into a folder."""
    run("apt-get", "download", *packages, cwd=folder)
    for archive in folder.glob("*.deb"):
        run("dpkg-deb", "-x", archive, folder)
        archive.unlink()


def headers(folder, release):
    """The tree to build modules of a kernel against; its makefiles' paths are made to lead into the folder."""
    common = re.sub(r"-amd64$", "-common", release)
    kbuild = "linux-kbuild-" + re.match(r"\d+\.\d+", release)[0]
    download(folder, f"linux-headers-{release}", f"linux-headers-{common}", kbuild)
    tree = folder / f"usr/src/linux-headers-{release}"
    makefile = tree / "Makefile"
    makefile.write_text(makefile.read_text().replace("/usr/src/", f"{folder}/usr/src/"))
    return tree


def build(folder, release):
    version = re.match(r"\d+\.\d+", release)[0]
    tree = headers(folder, release)
    download(folder, f"linux-source-{version}")
    source = f"linux-source-{version}/drivers/gpu/drm/vkms"
    run("tar", "-xf", folder / f"usr/src/linux-source-{version}.tar.xz", "-C", folder, source)
    run("make", "-C", tree, f"M={folder / source}", "CONFIG_DRM_VKMS=m", "modules")
    run("strip", "-g", folder / source / "vkms.ko")
    return folder / source / "vkms.ko"


def ensure(image):
    """The module for an image's kernel. Raises NotHere where it cannot be made."""
    kept = image / "vkms.ko"
    if kept.exists():
        return kept
    release = (image / "kernel-release").read_text().strip()
    folder = Path(tempfile.mkdtemp(dir=image, prefix="making-"))
    try:
        build(folder, release).rename(kept)
    except subprocess.CalledProcessError as error:
        raise NotHere(f"no vkms for Linux {release}: {error.stderr[-1000:]}") from error
    except OSError as error:
        raise NotHere(f"no vkms for Linux {release}: {error}") from error
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return kept

"""Films whose decoder crashes, hangs or eats memory: poison/plugin.cpp stands for the decoder of AV1."""
import os
import subprocess
from pathlib import Path

KINDS = {"aborts": 100, "sleeps": 104, "allocates": 108, "spins": 112}  # by the width of the picture


def make_film(path, width):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "lavfi", "-i",
                    f"color=gray:size={width}x64:rate=10:duration=0.3,format=yuv420p", "-c:v", "libaom-av1", "-cpu-used", "8", "-f", "matroska",
                    str(path)], check=True)


def poisoned_environment(build, system_plugins, home):
    """The variables with which a program decodes by the plugin of the tests. `home`: a folder for what it needs."""
    plugins = Path(home) / "plugins"  # all but the one with the decoder that poison stands for
    plugins.mkdir(exist_ok=True)
    for plugin in Path(system_plugins).glob("*.so"):
        link = plugins / plugin.name
        if plugin.name != "libgstlibav.so" and not link.is_symlink():
            link.symlink_to(plugin)
    return os.environ | {"GST_PLUGIN_PATH": f"{plugins}:{Path(build) / 'tests' / 'pipeline'}",
                         "GST_PLUGIN_SYSTEM_PATH": str(Path(home) / "none"), "GST_REGISTRY": str(Path(home) / "registry")}

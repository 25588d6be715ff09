"""The wheel that scripts/wheel.py makes of what is built."""
import os
import subprocess
import sys

from repo import ROOT

BUILD = os.environ.get("PAVER_BUILD") or os.path.join(ROOT, "build")


def make(folder):
    """Makes it in an empty folder; its path."""
    done = subprocess.run([sys.executable, os.path.join(ROOT, "scripts", "wheel.py"), BUILD, str(folder)],
                          capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    name, = os.listdir(folder)
    return os.path.join(folder, name)

"""Every text of the workbench is translated into every language of Resources/translations."""
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402


def main():
    done = subprocess.run([sys.executable, os.path.join(repo.ROOT, "scripts", "translations"), "--check"],
                          capture_output=True, text=True)
    if "ImportError" in done.stderr:
        repo.skip("the Python module, which has the texts of options, is not built")
    faults = [] if done.returncode == 0 else (done.stdout + done.stderr).splitlines()
    if not any(name.endswith(".ts") for name in os.listdir(os.path.join(repo.ROOT, "Resources", "translations"))):
        faults.append("Resources/translations has no language")
    repo.finish(faults)


if __name__ == "__main__":
    main()

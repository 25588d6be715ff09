"""The examples of "From Python" in README.md run as they stand."""
import os
import re

from conftest import ROOT


def test_the_examples_run(tmp_path, monkeypatch, capsys):
    with open(os.path.join(ROOT, "README.md")) as file:
        section = re.search(r"^### From Python\n(.*?)^##", file.read(), re.M | re.S).group(1)
    blocks = re.findall(r"((?:^    .*\n|^\n)+)", section, re.M)
    code = [re.sub(r"^    ", "", block, flags=re.M) for block in blocks if "paver." in block]
    assert code
    os.symlink(os.path.join(ROOT, "Resources"), tmp_path / "Resources")
    os.symlink(os.path.join(ROOT, "bindings"), tmp_path / "bindings")
    monkeypatch.chdir(tmp_path)
    for block in code:
        exec(compile(block, "README.md", "exec"), {})
    assert (tmp_path / "conesphere.msh").exists()
    assert "quads" in capsys.readouterr().out

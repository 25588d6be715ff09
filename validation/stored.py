"""Results of solving, kept in small files so that pictures and tables are made again without solving."""
import json
import os


class Missing(Exception):
    """A case that another series has to solve first."""


class Stored:
    """What a series has solved, by key, in one file of JSON. `fresh`: as if there were nothing; `is_kept`: nothing is solved."""

    def __init__(self, path, fresh=False, is_kept=False):
        self.path, self.is_kept, self.cases = path, is_kept, {}
        if os.path.exists(path) and not fresh:
            with open(path) as f:
                self.cases = json.load(f)

    def beside(self, series):
        """What another series has stored; that one solves it."""
        return Stored(os.path.join(os.path.dirname(self.path), series + ".json"), is_kept=True)

    def has(self, text):
        """Whether some case has this in its key."""
        return any(text in key for key in self.cases)

    def get(self, key, solve):
        """The case of that key; solved by `solve()` (a dict of what JSON knows) where it is not there."""
        if key not in self.cases:
            if self.is_kept:
                raise Missing(f"{os.path.basename(self.path)} lacks {key}; run validation/figures for that series first")
            self.cases[key] = solve()
            self._write()
            print(f"  {key}: " + ", ".join(f"{k} {v}" for k, v in self.cases[key].items() if not isinstance(v, list)),
                  flush=True)
        return self.cases[key]

    def _write(self):
        """One case per line, for versions to be compared."""
        lines = (f"{json.dumps(k)}: {json.dumps(v, separators=(',', ':'))}" for k, v in sorted(self.cases.items()))
        os.makedirs(os.path.dirname(self.path), exist_ok=True)
        with open(self.path + ".part", "w") as f:
            f.write("{\n" + ",\n".join(lines) + "\n}\n")
        os.replace(self.path + ".part", self.path)

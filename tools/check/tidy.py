#!/usr/bin/env python3
"""clang-tidy on sources that are read together: the libraries' headers, which take most of its time,
are read once for many sources instead of once for each.

usage: tidy.py BUILD SOURCE...

Sources whose commands in BUILD/compile_commands.json differ in nothing but the file are included by
one file of BUILD/tidy, unless both give one name to something of their own (in an unnamed namespace).
What does not compile together is tried again in halves. Ends with 1 if anything is found.
"""

import collections
import concurrent.futures
import itertools
import json
import os
import re
import subprocess
import sys
from pathlib import Path

CLANG_TIDY = "clang-tidy-14"
MOST_TOGETHER = 16
# Layout as clang-format leaves it: what is declared in a namespace starts its line.
DECLARED = re.compile(
    r"^(?:(?:struct|class|enum class|using|concept)\s+(\w+)"
    r"|(?:template.*|[\w\[].*?)\b(\w+)\s*(?:\(|=|\{|\[|;))"
)


def own_names(source):
    """The names that a source declares in its unnamed namespaces."""
    names, inside = set(), False
    for line in source.read_text(encoding="utf-8").splitlines():
        if line.startswith("namespace {"):
            inside = True
        elif line.startswith("}  // namespace"):
            inside = False
        elif inside and (match := DECLARED.match(line)):
            names.add(match.group(1) or match.group(2))
    return names


def commands_of(build, wanted):
    """For each command, without its file: the wanted sources that it compiles."""
    alike = collections.defaultdict(list)
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = Path(entry["directory"], entry["file"]).resolve()
        if source in wanted:
            command = re.sub(r" -o \S+ -c \S+$", "", entry["command"])
            alike[(entry["directory"], command)].append(source)
    return alike


def batches_of(sources):
    """Sources in batches in which no own name occurs twice; the emptiest batch that fits."""
    batches = []
    for source in sources:
        names = own_names(source)
        fitting = [b for b in batches if len(b[0]) < MOST_TOGETHER and not b[1] & names]
        if fitting:
            batch = min(fitting, key=lambda b: len(b[0]))
        else:
            batch = ([], set())
            batches.append(batch)
        batch[0].append(source)
        batch[1].update(names)
    return [batch[0] for batch in batches]


class Tidy:
    def __init__(self, build):
        self.folder = build / "tidy"
        self.folder.mkdir(exist_ok=True)
        self.numbers = itertools.count()  # each taken once, by whichever thread

    def write(self, batch, directory, command):
        """A folder with a file that includes the batch, and with the command that compiles it."""
        folder = self.folder / str(next(self.numbers))
        folder.mkdir(exist_ok=True)
        together = folder / "together.cpp"
        together.write_text("".join(f'#include "{source}"\n' for source in batch))
        # A local name of one source may shadow another source's; GCC looks at each alone.
        command += f" -Wno-shadow -c {together}"
        entry = {"directory": directory, "command": command, "file": str(together)}
        (folder / "compile_commands.json").write_text(json.dumps([entry]))
        return folder

    def run(self, batch, directory, command):
        """What clang-tidy says of a batch; empty where it finds nothing."""
        folder = self.write(batch, directory, command)
        done = subprocess.run(
            [CLANG_TIDY, "-p", folder, "--quiet", "--warnings-as-errors=*", folder / "together.cpp"],
            capture_output=True, text=True)
        if done.returncode == 0:
            return ""
        if len(batch) > 1 and "clang-diagnostic-error" in done.stdout:
            half = len(batch) // 2
            return (self.run(batch[:half], directory, command)
                    + self.run(batch[half:], directory, command))
        return done.stdout or done.stderr


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    build = Path(sys.argv[1]).resolve()
    wanted = {Path(source).resolve() for source in sys.argv[2:]}
    tidy = Tidy(build)
    work = [(batch, directory, command)
            for (directory, command), sources in commands_of(build, wanted).items()
            for batch in batches_of(sorted(sources))]
    known = {source for batch, _, _ in work for source in batch}
    for source in sorted(wanted - known):
        sys.exit(f"tidy: {source} is not compiled in {build}; build it first (./dev build)")
    work.sort(key=lambda w: -len(w[0]))
    found = ""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        running = [pool.submit(tidy.run, *w) for w in work]
        for done, future in enumerate(concurrent.futures.as_completed(running), 1):
            if said := future.result():
                print(said, flush=True)
                found += said
            elif sys.stdout.isatty():
                print(f"\r{done} of {len(running)} batches", end="", flush=True)
    print(f"{len(known)} sources in {len(work)} batches: {'see above' if found else 'nothing found'}")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()

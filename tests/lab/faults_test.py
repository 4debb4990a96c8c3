"""What goes wrong in a booth, done on purpose: nothing that was stored may be lost, and the session
must go on where it was.

    faults_test.py BIMODAL OBSERVER CLEAR_CLIENT FOLDER

The observer and the client are not used here; the arguments are those of presenter_test.py.
"""

import argparse
import pathlib
import signal
import sqlite3
import subprocess
import sys
import time

from laboratory import Laboratory, wait_for

PROTOCOL = pathlib.Path(__file__).with_name("protocol.json")


class Session:
    """A real session with simulated answers, in the background."""

    def __init__(self, laboratory, bimodal, data, trials, *options):
        self.data = data
        self.log = open(data.with_suffix(".log"), "ab")
        command = [bimodal, "run", PROTOCOL, "--participant", "P01", "--answers", "simulated"]
        command += ["--no-practice", "--trials", trials, "--windowed", "--data", data, *options]
        self.process = subprocess.Popen(
            [str(part) for part in command],
            env=laboratory.environment,
            stdin=subprocess.DEVNULL,
            stdout=self.log,
            stderr=subprocess.STDOUT,
        )

    def stored(self):
        return len(query(self.data, "SELECT trial FROM trial"))

    def wait_for_trials(self, count):
        def are_there():
            if self.process.poll() is not None:
                raise RuntimeError(f"the session ended with {self.process.returncode}")
            return self.stored() >= count

        wait_for(are_there, f"trial {count}", 120)


def query(data, sql):
    if not data.exists():
        return []
    try:
        with sqlite3.connect(f"file:{data}?mode=ro", uri=True) as database:
            return database.execute(sql).fetchall()
    except sqlite3.OperationalError:  # its tables are being made
        return []


def require(is_kept, text):
    print(("ok     " if is_kept else "BROKEN ") + text, flush=True)
    return 0 if is_kept else 1


def is_whole(data, trials):
    """Every planned trial is there once, in one session that is complete."""
    stored = [trial for (trial,) in query(data, "SELECT trial FROM trial ORDER BY trial")]
    sessions = query(data, "SELECT outcome FROM session")
    return stored == list(range(trials)) and sessions == [("complete",)]


def sound_server_dies(laboratory, bimodal, folder):
    """Killed in the middle of a trial, and started again some seconds later."""
    data, trials = folder / "sound.sqlite", 12
    session = Session(laboratory, bimodal, data, trials)
    session.wait_for_trials(4)
    time.sleep(0.5)
    laboratory.sound_server.send_signal(signal.SIGKILL)
    laboratory.sound_server.wait()
    kinds = lambda: [kind for (kind,) in query(data, "SELECT kind FROM event")]
    wait_for(lambda: "paused" in kinds(), "the pause", 30)
    kept = session.stored()
    broken = require(session.process.poll() is None, "the session waits for the sound")
    laboratory.start_sound()
    code = session.process.wait(180)
    broken += require(code == 0, f"it ended with {code}")
    broken += require(
        session.stored() >= kept and is_whole(data, trials),
        f"{session.stored()} of {trials} trials stored, {kept} of them before",
    )
    broken += require("resumed" in kinds(), "it is stored that the session was resumed")
    return broken


def session_is_killed(laboratory, bimodal, folder):
    """By SIGKILL, and taken up again."""
    data, trials = folder / "killed.sqlite", 8
    first = Session(laboratory, bimodal, data, trials)
    first.wait_for_trials(3)
    first.process.kill()
    first.process.wait()
    kept = first.stored()
    second = Session(laboratory, bimodal, data, trials, "--resume")
    code = second.process.wait(180)
    return require(
        code == 0 and kept >= 3 and is_whole(data, trials),
        f"killed after {kept} trials, resumed: {second.stored()} of {trials}, exit code {code}",
    )


def screen_dies(laboratory, bimodal, folder):
    """The compositor is killed: the session ends, what it stored stays, and goes on elsewhere."""
    data, trials = folder / "screen.sqlite", 6
    first = Session(laboratory, bimodal, data, trials)
    first.wait_for_trials(2)
    laboratory.screen.kill()
    laboratory.screen.wait()
    first.process.wait(60)
    kept = first.stored()
    for file in laboratory.runtime.glob("wayland-*"):
        file.unlink()
    laboratory.start_screen()
    second = Session(laboratory, bimodal, data, trials, "--resume")
    code = second.process.wait(180)
    return require(
        code == 0 and kept >= 2 and is_whole(data, trials),
        f"the screen died after {kept} trials, resumed: {second.stored()} of {trials}",
    )


def main():
    parser = argparse.ArgumentParser()
    for name in ("bimodal", "observer", "clear_client"):
        parser.add_argument(name)
    parser.add_argument("folder", type=pathlib.Path)
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    for file in given.folder.glob("*.sqlite*"):
        file.unlink()
    with Laboratory(given.observer, given.folder) as laboratory:
        broken = sum(
            fault(laboratory, given.bimodal, given.folder)
            for fault in (session_is_killed, sound_server_dies, screen_dies)
        )
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()

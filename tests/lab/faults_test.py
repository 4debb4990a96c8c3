"""What goes wrong in a booth, done on purpose: nothing that was stored may be lost, and the session
must go on where it was.

    faults_test.py BUILD FOLDER
"""

import argparse
import datetime
import pathlib
import signal
import sqlite3
import subprocess
import sys
import time

from laboratory import HEIGHT, WIDTH, Laboratory, wait_for

PROTOCOL = pathlib.Path(__file__).with_name("protocol.json")


class Session:
    """A real session with simulated answers, in the background."""

    def __init__(self, laboratory, data, trials, *options, environment=None):
        self.data = data
        self.log = open(data.with_suffix(".log"), "ab")
        command = [laboratory.bimodal, "run", PROTOCOL, "--participant", "P01", "--answers", "simulated"]
        command += ["--no-practice", "--trials", trials, "--windowed", "--data", data, *options]
        self.process = subprocess.Popen(
            [str(part) for part in command],
            env=laboratory.environment | (environment or {}),
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


def sound_server_dies(laboratory, folder):
    """Killed in the middle of a trial, and started again some seconds later."""
    data, trials = folder / "sound.sqlite", 12
    session = Session(laboratory, data, trials)
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


def session_is_killed(laboratory, folder):
    """By SIGKILL, and taken up again."""
    data, trials = folder / "killed.sqlite", 8
    first = Session(laboratory, data, trials)
    first.wait_for_trials(3)
    first.process.kill()
    first.process.wait()
    kept = first.stored()
    second = Session(laboratory, data, trials, "--resume")
    code = second.process.wait(180)
    return require(
        code == 0 and kept >= 3 and is_whole(data, trials),
        f"killed after {kept} trials, resumed: {second.stored()} of {trials}, exit code {code}",
    )


def wall_clock_is_set(laboratory, folder):
    """An hour back and two hours on, in the middle of the session: no instant knows of it."""
    data, trials = folder / "clock.sqlite", 10
    preloaded = {"LD_PRELOAD": str(laboratory.stepped_clock)}
    code = Session(laboratory, data, trials, environment=preloaded).process.wait(180)
    broken = require(code == 0 and is_whole(data, trials), f"the clock was set, exit code {code}")
    ((ended,),) = query(data, "SELECT ended_utc FROM session")
    ahead = datetime.datetime.fromisoformat(ended) - datetime.datetime.now(datetime.timezone.utc)
    broken += require(ahead > datetime.timedelta(minutes=30), f"it believed to end at {ended}")
    starts = [at for (at,) in query(data, "SELECT stimulus_start_ns FROM trial ORDER BY trial")]
    lasting = (starts[-1] - starts[0]) / 1e9
    broken += require(starts == sorted(starts) and lasting < 60, f"it took {lasting:.1f} s")
    off = query(data, "SELECT count(*) FROM event WHERE kind IN ('late_frame', 'late_sound')")
    return broken + require(off[0][0] <= 1, f"{off[0][0]} late frames and sounds")


def refresh_changes(laboratory, folder):
    """From 60 to 75 Hz in the middle of the session: it is noticed, and the session goes on."""
    data, trials = folder / "refresh.sqlite", 10
    session = Session(laboratory, data, trials)
    session.wait_for_trials(4)
    laboratory.command_screen("output", "HEADLESS-1", "mode", "--custom", f"{WIDTH}x{HEIGHT}@75Hz")
    code = session.process.wait(180)
    laboratory.command_screen("output", "HEADLESS-1", "mode", "--custom", f"{WIDTH}x{HEIGHT}@60Hz")
    noticed = query(data, "SELECT detail FROM event WHERE kind = 'paused'")
    after = query(data, "SELECT trial FROM trial WHERE flagged = 0 AND trial > 6")
    return require(
        code == 0 and is_whole(data, trials), f"refresh changed: exit code {code}"
    ) + require(
        len(noticed) == 1 and noticed[0][0].startswith("the screen refreshes every") and after,
        f"it was noticed: {noticed}; {len(after)} trials kept after it",
    )


def window_is_hidden(laboratory, folder):
    """As if the screen slept: the compositor shows the window no more, and the session pauses, with a
    message, until the experimenter lets it go on."""
    data, trials = folder / "hidden.sqlite", 8
    session = Session(laboratory, data, trials)
    session.wait_for_trials(3)
    laboratory.command_screen("workspace", "2")
    kinds = lambda: [kind for (kind,) in query(data, "SELECT kind FROM event")]
    wait_for(lambda: "paused" in kinds(), "the pause", 60)
    kept = session.stored()
    laboratory.command_screen("workspace", "1")
    monitor = [laboratory.bimodal, "monitor", data, "--resume"]
    told = laboratory.run(monitor, "resume.log")
    code = session.process.wait(180)
    silent = query(data, "SELECT DISTINCT trial FROM event WHERE kind = 'screen_silent'")
    return require(
        told == 0 and code == 0 and is_whole(data, trials),
        f"the window was hidden after {kept} trials: exit code {code}, {session.stored()} of {trials}",
    ) + require(silent, f"{len(silent)} trials flagged as the screen was silent")


def screen_dies(laboratory, folder):
    """The compositor is killed: the session ends, what it stored stays, and goes on elsewhere."""
    data, trials = folder / "screen.sqlite", 6
    first = Session(laboratory, data, trials)
    first.wait_for_trials(2)
    laboratory.screen.kill()
    laboratory.screen.wait()
    first.process.wait(60)
    kept = first.stored()
    for file in laboratory.runtime.glob("wayland-*"):
        file.unlink()
    laboratory.start_screen()
    second = Session(laboratory, data, trials, "--resume")
    code = second.process.wait(180)
    return require(
        code == 0 and kept >= 2 and is_whole(data, trials),
        f"the screen died after {kept} trials, resumed: {second.stored()} of {trials}",
    )


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", help="where everything was built")
    parser.add_argument("folder", type=pathlib.Path)
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    for file in given.folder.glob("*.sqlite*"):
        file.unlink()
    with Laboratory(given.build, given.folder) as laboratory:
        broken = sum(
            fault(laboratory, given.folder)
            for fault in (
                session_is_killed,
                wall_clock_is_set,
                refresh_changes,
                window_is_hidden,
                sound_server_dies,
                screen_dies,
            )
        )
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()

"""A laboratory without hardware: a compositor and a sound server that nobody sees or hears.

The compositor (sway, headless) refreshes at about 60 Hz, the sound server (JACK, dummy) is paced
like a sound card. An observer, a program of its own, watches both from outside.
"""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

WIDTH, HEIGHT = 1280, 1024


class Unavailable(Exception):
    """What the laboratory is made of is not on this machine."""


def require(*programs):
    missing = [program for program in programs if shutil.which(program) is None]
    if missing:
        raise Unavailable("not installed: " + ", ".join(missing) + "; see tools/packages.txt")


def may_be_urgent():
    return subprocess.run(["chrt", "--fifo", "10", "true"], capture_output=True).returncode == 0


def wait_for(condition, what, seconds=20.0):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.05)
    raise RuntimeError(f"{what} did not start within {seconds:g} s")


class Laboratory:
    """Starts everything on entry, as an ordinary user what refuses root; ends it on exit.

    `build`: where the programs were built, under test and of the laboratory."""

    def __init__(self, build, folder):
        build = pathlib.Path(build).resolve()
        self.bimodal = build / "bin" / "bimodal"
        self.observer = build / "tests" / "lab_observer"
        self.clear_client = build / "tests" / "lab_clear_client"
        self.stepped_clock = build / "tests" / "liblab_stepped_clock.so"
        self.folder = pathlib.Path(folder)
        self.processes = []

    def __enter__(self):
        require("sway", "jackd", "setpriv", "chrt")
        self.folder.mkdir(parents=True, exist_ok=True)
        self.runtime = pathlib.Path(tempfile.mkdtemp(prefix="bimodal-lab-"))
        self.runtime.chmod(0o700)
        self.environment = {
            key: value
            for key, value in os.environ.items()
            if key not in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER")
        }
        self.environment |= {
            "XDG_RUNTIME_DIR": str(self.runtime),
            "SDL_VIDEODRIVER": "wayland",
            "JACK_DEFAULT_SERVER": f"bimodal-lab-{os.getpid()}",
            "JACK_NO_START_SERVER": "1",
            "JACK_NO_AUDIO_RESERVATION": "1",
            "BIMODAL_CACHE": str(self.runtime / "films"),
        }
        try:
            self.keep_awake()
            self.start_screen()
            self.start_sound()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            process.terminate()
        for process in self.processes:
            try:
                process.wait(5)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        shutil.rmtree(self.runtime, ignore_errors=True)

    def start(self, command, log, **options):
        with open(self.folder / log, "wb") as out:
            process = subprocess.Popen(
                command, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, **options
            )
        self.processes.append(process)
        return process

    def keep_awake(self):
        """Where machines are virtual, a processor that sleeps may take milliseconds to wake."""
        for _ in range(os.cpu_count()):
            idle = ["chrt", "--idle", "0", "sh", "-c", "while :; do :; done"]
            self.processes.append(subprocess.Popen(idle))

    def start_screen(self):
        configuration = self.runtime / "sway.conf"
        configuration.write_text(
            f"output HEADLESS-1 mode --custom {WIDTH}x{HEIGHT}@60Hz\n"
            "default_border none\nfocus_follows_mouse no\n"
        )
        command = ["sway", "-c", str(configuration)]
        if os.geteuid() == 0:  # sway refuses root
            configuration.chmod(0o644)
            shutil.chown(self.runtime, "nobody")
            command = ["setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups"] + command
        if may_be_urgent():  # like a screen, which nobody keeps waiting
            command = ["chrt", "--fifo", "20"] + command
        environment = self.environment | {
            "HOME": str(self.runtime),
            "WLR_BACKENDS": "headless",
            "WLR_RENDERER": "pixman",
            "WLR_LIBINPUT_NO_DEVICES": "1",
        }
        self.screen = self.start(command, "sway.log", env=environment)
        socket = wait_for(
            lambda: [p.name for p in self.runtime.glob("wayland-*") if p.suffix != ".lock"],
            "sway",
        )
        self.environment["WAYLAND_DISPLAY"] = socket[0]

    def command_screen(self, *command):
        """Asks the compositor, as `swaymsg` does."""
        (socket,) = self.runtime.glob("sway-ipc.*.sock")
        subprocess.run(
            ["swaymsg", "-s", str(socket), "--", *command], check=True, stdout=subprocess.DEVNULL
        )

    def start_sound(self):
        server = self.environment["JACK_DEFAULT_SERVER"]
        urgency = ["-R", "-P", "60"] if may_be_urgent() else ["-r"]
        command = ["jackd", "-n", server, *urgency, "-d", "dummy"]
        command += ["-r", "48000", "-p", "128", "-P", "4", "-C", "4"]
        self.sound_server = self.start(command, "jackd.log", env=self.environment)
        wait_for(
            lambda: subprocess.run(
                ["jack_wait", "-s", server, "-c"],
                env=self.environment,
                capture_output=True,
                text=True,
            ).stdout.startswith("running"),
            "the JACK server",
        )

    def run(self, command, log, **options):
        """Runs a program to its end in here; its output goes to a file. Returns its exit code."""
        with open(self.folder / log, "wb") as out:
            return subprocess.run(
                [str(part) for part in command],
                env=self.environment | options.pop("environment", {}),
                stdout=out,
                stderr=subprocess.STDOUT,
                stdin=subprocess.DEVNULL,
                **options,
            ).returncode

    def observe(self, name, region, columns=2, channels=2):
        return Observation(self, name, region, columns, channels)


class Observation:
    """The observer watches while this is entered; afterwards `seen` has what it saw."""

    def __init__(self, laboratory, name, region, columns, channels):
        self.file = laboratory.folder / f"{name}.observed.jsonl"
        self.command = [str(laboratory.observer), str(self.file)]
        self.command += [str(number) for number in (*region, columns, channels)]
        self.environment = laboratory.environment
        self.seen = []

    def __enter__(self):
        self.process = subprocess.Popen(
            self.command,
            env=self.environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        if self.process.stdout.readline().strip() != "watching":
            raise RuntimeError("the observer cannot watch")
        return self

    def __exit__(self, *_):
        time.sleep(0.3)  # the last refreshes and samples are on their way
        self.process.stdin.close()
        if self.process.wait(120) != 0:
            raise RuntimeError("the observer failed")
        with open(self.file, encoding="utf-8") as lines:
            self.seen = [json.loads(line) for line in lines]


class Load:
    """Both cores busy with something else."""

    def __enter__(self):
        self.processes = [
            subprocess.Popen(["sh", "-c", "while :; do :; done"]) for _ in range(os.cpu_count())
        ]
        return self

    def __exit__(self, *_):
        for process in self.processes:
            process.kill()
            process.wait()

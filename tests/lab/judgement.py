"""What the observer saw, against what the program reported."""

import bisect
import statistics

MS = 1e6  # ns


def refreshes(seen):
    return [event for event in seen if event["kind"] == "refresh"]


def onsets_of_light(seen, column=0, dark=64, light=192):
    """Instants at which a column of the region went from dark to light."""
    screen = refreshes(seen)
    return [
        now["at_ns"]
        for before, now in zip(screen, screen[1:])
        if before["levels"][column] < dark and now["levels"][column] > light
    ]


def onsets_of_sound(seen, channel=0):
    return [e["at_ns"] for e in seen if e["kind"] == "sound" and e["channel"] == channel]


def nearest(instants, wanted, within=float("inf")):
    """The instant nearest to `wanted`, if it is not farther than `within`; else None."""
    at = bisect.bisect(instants, wanted)
    near = [i for i in instants[max(0, at - 1) : at + 1] if abs(i - wanted) <= within]
    return min(near, key=lambda i: abs(i - wanted), default=None)


class Troubles:
    """When the compositor left a refresh out or the sound server reported an overrun, by the
    observer's record. They excuse what is of their kind: frames by refreshes that never were, sounds
    by overruns."""

    BEFORE_NS, AFTER_NS = 0.8e9, 1.0e9  # of a trial's onset, in which its fixation and sound lie
    MOST_PERIODS = 1.5
    OF_SOUND = {"sound_jump", "underflow", "late_sound", "av_offset"}
    OF_SCREEN = {"late_frame", "early_frame", "av_offset", "refresh_changed"}

    def __init__(self, seen):
        shown = [refresh["at_ns"] for refresh in refreshes(seen)]
        gaps = [after - before for before, after in zip(shown, shown[1:])]
        longest = self.MOST_PERIODS * statistics.median(gaps)
        late = [after for after, gap in zip(shown[1:], gaps) if gap > longest]
        self.late = sorted(late)
        self.overruns = sorted(event["at_ns"] for event in seen if event["kind"] == "xrun")

    def excuse(self, onset, kinds):
        """Whether all that flags the trial of this onset has an excuse."""
        overrun, late = self.near(self.overruns, onset), self.near(self.late, onset)
        return all(
            (overrun and kind in self.OF_SOUND) or (late and kind in self.OF_SCREEN)
            for kind in kinds
        )

    def near(self, instants, onset):
        first = bisect.bisect(instants, onset - self.BEFORE_NS)
        return first < bisect.bisect(instants, onset + self.AFTER_NS)


def moments(values):
    return {
        "n": len(values),
        "mean_ms": statistics.fmean(values) if values else None,
        "sd_ms": statistics.stdev(values) if len(values) > 1 else None,
        "min_ms": min(values, default=None),
        "max_ms": max(values, default=None),
    }


def missed_refreshes(seen, column=1):
    """Refreshes of a client that draws each one anew at which the screen did not change; and how
    many it drew."""
    screen = refreshes(seen)
    levels = [refresh["levels"][column] for refresh in screen]
    changes = [i for i in range(1, len(levels)) if levels[i] != levels[i - 1]]
    if not changes:
        return 0, 0
    first, last = changes[0], changes[-1]
    return sum(levels[i] == levels[i - 1] for i in range(first + 1, last)), last - first


def judge_frames(seen, frames, level_of, column=1):
    """Differences between reported and observed instants (ms) of (frame, reported_ns): the observed
    one is the nearest refresh at which the frame's own level appeared; None if it never did."""
    screen = refreshes(seen)
    instants = [refresh["at_ns"] for refresh in screen]
    found = []
    for frame, reported in frames:
        at = bisect.bisect(instants, reported)
        near = [
            (reported - instants[i]) / MS
            for i in range(max(1, at - 4), min(len(screen), at + 4))
            if abs(screen[i]["levels"][column] - level_of(frame)) <= 20
            and abs(screen[i - 1]["levels"][column] - level_of(frame)) > 20
        ]
        found.append(min(near, key=abs, default=None))
    return found

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


def nearest(instants, wanted):
    """The instant nearest to `wanted`; None without instants."""
    at = bisect.bisect(instants, wanted)
    return min(instants[max(0, at - 1) : at + 1], key=lambda i: abs(i - wanted), default=None)


class Troubles:
    """When the compositor left a refresh out or the sound server reported an overrun, by the
    observer's record: no presenter can do anything about those."""

    BEFORE_NS, AFTER_NS = 0.8e9, 0.6e9  # of a trial's onset, in which its fixation and sound lie
    MOST_PERIODS = 1.5

    def __init__(self, seen):
        shown = [refresh["at_ns"] for refresh in refreshes(seen)]
        gaps = [after - before for before, after in zip(shown, shown[1:])]
        longest = self.MOST_PERIODS * statistics.median(gaps)
        late = [after for after, gap in zip(shown[1:], gaps) if gap > longest]
        overruns = [event["at_ns"] for event in seen if event["kind"] == "xrun"]
        self.instants = sorted(late + overruns)

    def near(self, onset):
        """Whether there was one around a trial's onset."""
        first = bisect.bisect(self.instants, onset - self.BEFORE_NS)
        return first < bisect.bisect(self.instants, onset + self.AFTER_NS)


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

#!/usr/bin/env python3
"""Writes protocols/observers/typical.json: what a simulated listener confuses.

The numbers are CHOSEN BY US, PLAUSIBLE, NOT MEASURED. They serve to rehearse an experiment and to
test its analysis; no conclusion about people may rest on them. The rule:

    P(r | s) = (1 - g) exp(-k d(s, r)) / sum over r' of exp(-k d(s, r'))  +  g / n

for the n phones r of the same kind (25 consonants, or 16 vowels), with d a sum of feature
differences weighed below, k the acuity of a modality and g = 0.02 guessing. Features are weighed so
that

* hearing in noise keeps voicing, nasality and manner better than place, as Miller and Nicely (1955,
  J. Acoust. Soc. Am. 27, 338-352) found, and the first formant (vowel height) better than the
  second (backness);
* seeing hardly tells the members of a viseme class apart (classes in the manner of Walden et al.
  1977, J. Speech Hear. Res. 20, 130-145, and of Owens & Blazek 1985, J. Speech Hear. Res. 28,
  381-393), and knows vowels by lip rounding and jaw opening.

The two acuities were set by trial so that, of the 414 words, .56 are right by ear at -8 dB, .13 by
eye and .83 by both. Run it as  python3 tools/observers/make_typical.py [FILE].
"""

import json
import math
import sys
from pathlib import Path

FILE = Path(__file__).resolve().parents[2] / "protocols" / "observers" / "typical.json"
GUESSING = 0.02
STATED_SNR_DB = -8
SLOPE_PER_DB = 0.25
DECIMALS = 6
ACUITY = {"auditory": 0.83, "visual": 0.6}

# voiced, manner, place (0 lips ... 6 glottis), sibilant
CONSONANTS = {
    "P": (0, "stop", 0.0, 0),
    "B": (1, "stop", 0.0, 0),
    "M": (1, "nasal", 0.0, 0),
    "W": (1, "approximant", 0.5, 0),
    "WH": (0, "approximant", 0.5, 0),
    "F": (0, "fricative", 1.0, 0),
    "V": (1, "fricative", 1.0, 0),
    "TH": (0, "fricative", 2.0, 0),
    "DH": (1, "fricative", 2.0, 0),
    "T": (0, "stop", 3.0, 0),
    "D": (1, "stop", 3.0, 0),
    "N": (1, "nasal", 3.0, 0),
    "S": (0, "fricative", 3.0, 1),
    "Z": (1, "fricative", 3.0, 1),
    "L": (1, "approximant", 3.0, 0),
    "R": (1, "approximant", 3.5, 0),
    "SH": (0, "fricative", 4.0, 1),
    "ZH": (1, "fricative", 4.0, 1),
    "CH": (0, "affricate", 4.0, 1),
    "JH": (1, "affricate", 4.0, 1),
    "Y": (1, "approximant", 4.5, 0),
    "K": (0, "stop", 5.0, 0),
    "G": (1, "stop", 5.0, 0),
    "NG": (1, "nasal", 5.0, 0),
    "HH": (0, "fricative", 6.0, 0),
}
VOICING_HEARD = 2.6
MANNER_HEARD = {  # between different manners; a pair that is not here costs OTHER_MANNER
    frozenset(("stop", "affricate")): 1.6,
    frozenset(("stop", "fricative")): 1.8,
    frozenset(("fricative", "affricate")): 1.4,
    frozenset(("nasal", "approximant")): 2.2,
    frozenset(("fricative", "approximant")): 2.6,
}
OTHER_MANNER = 3.0
PLACE_HEARD = 1.5  # for any difference
PLACE_STEP_HEARD = 0.2  # and for each place between
SIBILANCE_HEARD = 1.2

VISEMES = ["P B M", "F V", "TH DH", "W WH R", "SH ZH CH JH", "T D N S Z L", "Y K G NG HH"]
WITHIN_VISEME = 0.3
BETWEEN_VISEMES = 6.5
CLOSER_VISEMES = {  # by the first member of each
    frozenset(("T", "Y")): 2.0,
    frozenset(("T", "SH")): 4.2,
    frozenset(("T", "TH")): 4.4,
    frozenset(("SH", "Y")): 4.6,
    frozenset(("TH", "Y")): 4.8,
}

# height (0 open ... 3 close), backness (0 front ... 2 back), rounding (0 ... 1): of the beginning and
# of the end; whether long; whether r-coloured
VOWELS = {
    "IY": ((3.0, 0.0, 0.0), (3.0, 0.0, 0.0), 1, 0),
    "IH": ((2.4, 0.4, 0.0), (2.4, 0.4, 0.0), 0, 0),
    "EY": ((2.0, 0.2, 0.0), (2.8, 0.1, 0.0), 1, 0),
    "EH": ((1.4, 0.4, 0.0), (1.4, 0.4, 0.0), 0, 0),
    "AE": ((0.6, 0.4, 0.0), (0.6, 0.4, 0.0), 1, 0),
    "AA": ((0.0, 1.4, 0.0), (0.0, 1.4, 0.0), 1, 0),
    "AH": ((1.1, 1.2, 0.0), (1.1, 1.2, 0.0), 0, 0),
    "AX": ((1.5, 1.0, 0.0), (1.5, 1.0, 0.0), 0, 0),
    "ER": ((1.5, 1.0, 0.4), (1.5, 1.0, 0.4), 1, 1),
    "AO": ((0.7, 1.8, 0.6), (0.7, 1.8, 0.6), 1, 0),
    "OW": ((1.6, 1.8, 0.7), (2.5, 1.8, 1.0), 1, 0),
    "UH": ((2.4, 1.5, 0.6), (2.4, 1.5, 0.6), 0, 0),
    "UW": ((3.0, 1.7, 1.0), (3.0, 1.7, 1.0), 1, 0),
    "AY": ((0.2, 1.0, 0.0), (2.3, 0.4, 0.0), 1, 0),
    "AW": ((0.3, 1.0, 0.0), (2.2, 1.7, 0.8), 1, 0),
    "OY": ((1.0, 1.8, 0.7), (2.3, 0.4, 0.0), 1, 0),
}
# weights of height, backness, rounding; then of length and r-colour
VOWEL_WEIGHTS = {
    "auditory": ((1.1, 0.8, 0.3), 0.6, 2.0),
    "visual": ((0.5, 0.1, 1.6), 0.3, 0.3),
}


def main():
    file = Path(sys.argv[1]) if len(sys.argv) > 1 else FILE
    description = {
        "name": "typical",
        "provenance": "chosen by us, plausible, not measured; written by"
        " tools/observers/make_typical.py, which states the rule",
        "stated_snr_db": STATED_SNR_DB,
        "slope_per_db": SLOPE_PER_DB,
    }
    for modality in ("auditory", "visual"):
        description[modality] = {
            "consonants": table(list(CONSONANTS), consonant_distance, modality),
            "vowels": table(list(VOWELS), vowel_distance, modality),
        }
    file.write_text(as_text(description), encoding="ascii")


def consonant_distance(one, other, modality):
    if one == other:
        return 0.0
    return heard_distance(one, other) if modality == "auditory" else seen_distance(one, other)


def heard_distance(one, other):
    voice, manner, place, sibilant = CONSONANTS[one]
    other_voice, other_manner, other_place, other_sibilant = CONSONANTS[other]
    distance = VOICING_HEARD * abs(voice - other_voice)
    if manner != other_manner:
        distance += MANNER_HEARD.get(frozenset((manner, other_manner)), OTHER_MANNER)
    if place != other_place:
        distance += PLACE_HEARD + PLACE_STEP_HEARD * abs(place - other_place)
    return distance + SIBILANCE_HEARD * abs(sibilant - other_sibilant)


def seen_distance(one, other):
    first, second = viseme(one)[0], viseme(other)[0]
    if first == second:
        return WITHIN_VISEME
    return CLOSER_VISEMES.get(frozenset((first, second)), BETWEEN_VISEMES)


def viseme(phone):
    return next(members.split() for members in VISEMES if phone in members.split())


def vowel_distance(one, other, modality):
    weights, length_weight, colour_weight = VOWEL_WEIGHTS[modality]
    begin, end, length, colour = VOWELS[one]
    other_begin, other_end, other_length, other_colour = VOWELS[other]
    distance = length_weight * abs(length - other_length) + colour_weight * abs(colour - other_colour)
    for mine, yours in ((begin, other_begin), (end, other_end)):
        distance += sum(w * abs(a - b) for w, a, b in zip(weights, mine, yours))
    return distance


def table(phones, distance, modality):
    """Columns in the order of `phones`, and for each stimulus a row that sums to 1 as printed: what
    rounding leaves goes to the right answer."""
    rows = {}
    for stimulus in phones:
        similar = [math.exp(-ACUITY[modality] * distance(stimulus, r, modality)) for r in phones]
        row = [
            round((1 - GUESSING) * s / sum(similar) + GUESSING / len(phones), DECIMALS)
            for s in similar
        ]
        right = phones.index(stimulus)
        row[right] = round(1 - sum(row[:right] + row[right + 1 :]), DECIMALS)
        rows[stimulus] = row
    return {"columns": phones, "rows": rows}


def as_text(description):
    """JSON with one row of a table a line."""
    lines = []
    for key, value in description.items():
        if not isinstance(value, dict):
            lines.append(f"  {json.dumps(key)}: {json.dumps(value)}")
            continue
        tables = []
        for kind, content in value.items():
            rows = ",\n".join(
                f'        {json.dumps(phone)}: [{", ".join(f"{p:.{DECIMALS}f}" for p in row)}]'
                for phone, row in content["rows"].items()
            )
            tables.append(
                f"    {json.dumps(kind)}: {{\n"
                f'      "columns": {json.dumps(content["columns"])},\n'
                f'      "rows": {{\n{rows}\n      }}\n    }}'
            )
        lines.append(f"  {json.dumps(key)}: {{\n" + ",\n".join(tables) + "\n  }")
    return "{\n" + ",\n".join(lines) + "\n}\n"


if __name__ == "__main__":
    main()

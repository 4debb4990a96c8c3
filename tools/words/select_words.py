#!/usr/bin/env python3
"""Chooses the words that the experiments present, by a rule without any chance in it.

Writes into stimuli/assets/words (or the folder given) four lists of one format, and a table:

  monosyllables-414.json        the main list
  monosyllables-420.json        the list of the compressed-speech experiment; none is in the main list
  practice-12.json              practice words, none of them in the other lists
  familiar-monosyllables.json   what a simulated listener may answer
  proportions.csv               how often each sound stands where, in English and in the main list

Run it as  python3 tools/words/select_words.py [FOLDER].  It reads two files that Debian 12
installs: the list of familiar words (package wamerican-small) and the pronouncing dictionary
(package pocketsphinx-en-us). The same two files give the same bytes. The rule in prose stands in
stimuli/assets/words/README.md.
"""

import hashlib
import json
import re
import sys
from collections import Counter
from pathlib import Path

import exclusions

FAMILIAR = Path("/usr/share/dict/american-english-small")
DICTIONARY = Path("/usr/share/pocketsphinx/model/en-us/cmudict-en-us.dict")
ASSETS = Path(__file__).resolve().parents[2] / "stimuli" / "assets" / "words"
SOURCES = (
    "spellings: SCOWL american-english-small (Debian wamerican-small);"
    " pronunciations: CMU Pronouncing Dictionary (Debian pocketsphinx-en-us)"
)

VOWELS = set("AA AE AH AO AW AY EH ER EY IH IY OW OY UH UW".split())
MAIN_SIZE = 414
COMPRESSED_SIZE = 420
PRACTICE_SIZE = 12
SHORTEST, LONGEST = 2, 8  # letters
NONE = "-"  # in place of a consonant that is not there


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ASSETS
    dictionary = read_dictionary()
    listed = FAMILIAR.read_text(encoding="utf-8").split()
    familiar = [word for word in listed if re.fullmatch("[a-z]+", word) and word in dictionary]
    names = {word.lower() for word in listed if re.fullmatch("[A-Z][a-z]*", word)}

    uninflected = reference_population(familiar, dictionary)
    pool = presentable(uninflected, familiar, names, dictionary)
    english = count_features(uninflected, dictionary)
    chosen = choose(pool, quotas(english, MAIN_SIZE), MAIN_SIZE, dictionary)
    rest = [word for word in pool if word not in chosen]
    practice = choose(rest, quotas(english, PRACTICE_SIZE), PRACTICE_SIZE, dictionary)
    rest = [word for word in rest if word not in practice]
    compressed = choose(rest, quotas(english, COMPRESSED_SIZE), COMPRESSED_SIZE, dictionary)
    answers = possible_answers(familiar, dictionary)

    write(
        folder / "monosyllables-414.json",
        "414 monosyllables",
        "familiar, uninflected, inoffensive, one pronunciation, no homophone; initial consonant,"
        " vowel, final consonant and cluster sizes in the proportions of familiar uninflected"
        " monosyllables",
        chosen,
        dictionary,
    )
    write(
        folder / "monosyllables-420.json",
        "420 monosyllables",
        "as the 414 monosyllables, of which none is here",
        compressed,
        dictionary,
    )
    write(
        folder / "practice-12.json",
        "12 practice words",
        "as the 414 monosyllables, of which none is here",
        practice,
        dictionary,
    )
    write(
        folder / "familiar-monosyllables.json",
        "familiar monosyllables",
        "every familiar word with exactly one pronunciation, of one syllable, inoffensive;"
        " inflected forms and homophones included",
        answers,
        dictionary,
    )
    print(f"{len(uninflected)} uninflected familiar monosyllables, {len(pool)} may be presented,")
    print(f"{len(chosen)} and {len(compressed)} chosen, {len(practice)} for practice, {len(answers)} possible answers")
    worst = write_proportions(folder / "proportions.csv", english, chosen, dictionary)
    print(f"largest distance from a quota: {worst} words")


def read_dictionary():
    """All pronunciations of each spelling, in the order of the file."""
    dictionary = {}
    for line in DICTIONARY.read_text(encoding="ascii").splitlines():
        entry, *phones = line.split()
        spelling = re.sub(r"\(\d+\)$", "", entry)
        dictionary.setdefault(spelling, []).append(tuple(phones))
    return dictionary


def reference_population(familiar, dictionary):
    """The monosyllables of English whose proportions the list follows: every familiar word of two
    letters or more that has one syllable in each of its pronunciations and is no inflected form."""
    known = set(familiar)
    return [
        word
        for word in familiar
        if len(word) >= SHORTEST
        and one_syllable(word, dictionary)
        and word not in exclusions.IRREGULAR_FORMS
        and not is_inflected(word, known, dictionary)
    ]


def presentable(words, familiar, names, dictionary):
    """Those of the words that a participant may be given."""
    spellings = {}
    for word in familiar:
        for pronunciation in dictionary[word]:
            spellings.setdefault(pronunciation, set()).add(word)
    excluded = (
        exclusions.SUGGESTIVE
        | exclusions.DISTRESSING
        | exclusions.UNFAMILIAR
        | exclusions.NOT_QUITE_WORDS
    )
    return [
        word
        for word in words
        if SHORTEST <= len(word) <= LONGEST
        and len(dictionary[word]) == 1
        and spellings[dictionary[word][0]] == {word}
        and word not in names
        and word not in excluded
        and not is_offensive(word)
    ]


def possible_answers(familiar, dictionary):
    """One pronunciation each, so that an answer's phones are what its spelling is scored as."""
    return [
        word
        for word in familiar
        if len(word) >= SHORTEST
        and len(dictionary[word]) == 1
        and one_syllable(word, dictionary)
        and word not in exclusions.NOT_QUITE_WORDS
        and not is_offensive(word)
    ]


def one_syllable(word, dictionary):
    return all(sum(phone in VOWELS for phone in phones) == 1 for phones in dictionary[word])


def bases(word):
    """Spellings of which the word may be a regular plural, third person or past form."""
    for ending in ("s", "es", "d", "ed"):
        if word.endswith(ending):
            stem = word[: -len(ending)]
            yield stem
            if len(stem) > 2 and stem[-1] == stem[-2]:
                yield stem[:-1]
    if word.endswith(("ies", "ied")):
        yield word[:-3] + "y"
    if word.endswith("ves"):
        yield word[:-3] + "f"
        yield word[:-3] + "fe"


def is_inflected(word, known, dictionary):
    """Whether a shorter familiar word and one of the endings S, Z, T, D, or V Z for F, make it
    both in spelling and in sound."""
    for base in bases(word):
        if base not in known:
            continue
        for said in dictionary[word]:
            for stem in dictionary[base]:
                if len(said) == len(stem) + 1 and said[-1] in ("S", "Z", "T", "D"):
                    if said[:-1] == stem or word.endswith("ves"):
                        return True
    return False


def is_offensive(word):
    return word in exclusions.OFFENSIVE or any(
        base in exclusions.OFFENSIVE for base in bases(word)
    )


def features(word, dictionary):
    """What the quotas count, from the first pronunciation."""
    phones = dictionary[word][0]
    at = next(index for index, phone in enumerate(phones) if phone in VOWELS)
    onset, coda = phones[:at], phones[at + 1 :]
    return (
        ("initial", onset[0] if onset else NONE),
        ("onset size", str(len(onset))),
        ("vowel", phones[at]),
        ("coda size", str(len(coda))),
        ("final", coda[-1] if coda else NONE),
    )


def count_features(words, dictionary):
    """{margin: {value: number of words}}."""
    counts = {}
    for word in words:
        for margin, value in features(word, dictionary):
            counts.setdefault(margin, Counter())[value] += 1
    return counts


def quotas(counts, size):
    """How many of `size` words should have each feature: its proportion in `counts`, by the method
    of largest remainders. In the main list a feature that occurs has at least one word, taken from
    the feature that has the most."""
    targets = {}
    for margin, counter in counts.items():
        exact = {value: size * n / sum(counter.values()) for value, n in counter.items()}
        whole = {value: int(share) for value, share in exact.items()}
        left = size - sum(whole.values())
        for value in sorted(exact, key=lambda v: (whole[v] - exact[v], v))[:left]:
            whole[value] += 1
        if size >= MAIN_SIZE:
            for value in sorted(whole):
                if whole[value] == 0:
                    whole[max(sorted(whole), key=whole.get)] -= 1
                    whole[value] = 1
        targets.update({(margin, value): count for value, count in whole.items()})
    return targets


def choose(pool, targets, size, dictionary):
    """Words that meet the quotas. First, one word after the other, always the one that the quotas
    miss most; then single exchanges as long as one brings the list nearer to the quotas. Between
    equals the SHA-256 of the spelling decides, which favours no letter and no sound."""
    order = sorted(pool, key=lambda word: hashlib.sha256(word.encode()).hexdigest())
    of = {word: features(word, dictionary) for word in order}
    counts = Counter()

    def gain(word):
        return sum((2 * (targets[f] - counts[f]) - 1) / max(targets[f], 1) for f in of[word])

    chosen = []
    left = list(order)
    for _ in range(size):
        best = max(left, key=gain)  # the first of equals
        left.remove(best)
        chosen.append(best)
        counts.update(of[best])
    exchange(chosen, left, of, counts, targets)
    return set(chosen)


def exchange(chosen, left, of, counts, targets):
    """Exchanges a chosen word for one that is left while that lowers the sum, over features, of
    the squared distance from the quota divided by the quota."""

    def change(features_changed, step):
        """What adding (+1) or removing (-1) a word does to the sum."""
        return sum(
            (2 * step * (counts[f] - targets[f]) + 1) / max(targets[f], 1)
            for f in features_changed
        )

    improved = True
    while improved:
        improved = False
        for place, out in enumerate(chosen):
            removal = change(of[out], -1)
            counts.subtract(of[out])
            best = min(left, key=lambda word: change(of[word], +1))
            if removal + change(of[best], +1) < -1e-9:
                counts.update(of[best])
                left[left.index(best)] = out
                chosen[place] = best
                improved = True
            else:
                counts.update(of[out])


def write_proportions(file, english, chosen, dictionary):
    """One feature a line; returns the largest distance of the main list from a quota."""
    targets = quotas(english, MAIN_SIZE)
    counts = count_features(chosen, dictionary)
    lines = ["margin,value,english,quota,chosen"]
    worst = 0
    for margin, value in sorted(targets):
        quota, count = targets[margin, value], counts[margin][value]
        lines.append(f"{margin},{value},{english[margin][value]},{quota},{count}")
        worst = max(worst, abs(count - quota))
    file.write_text("\n".join(lines) + "\n", encoding="ascii")
    return worst


def write(file, name, rule, words, dictionary):
    """One word a line, so that a change is seen in a diff."""
    head = {"name": name, "rule": rule, "sources": SOURCES}
    lines = [f"  {json.dumps(key)}: {json.dumps(text)}," for key, text in head.items()]
    entries = [
        "    "
        + json.dumps({"word": word, "phones": list(dictionary[word][0])})
        for word in sorted(words)
    ]
    text = "{\n" + "\n".join(lines) + '\n  "words": [\n' + ",\n".join(entries) + "\n  ]\n}\n"
    file.write_text(text, encoding="ascii")


if __name__ == "__main__":
    main()

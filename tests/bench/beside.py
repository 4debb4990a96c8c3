"""What bimodal_bench measures of the analysis, done with numpy in one thread: times in ms.

usage: beside.py
"""

import csv
import random
import time

import numpy

LABELS = 18
RESPONSES = 120  # a row
DRAWS = 10_000


def timed(name, deed):
    begin = time.perf_counter()
    deed()
    print(f"numpy {numpy.__version__}: {name:42} {1e3 * (time.perf_counter() - begin):9.0f} ms")


def transmitted(counts):
    """Bits, of matrices along the first axis."""
    n = counts.sum(axis=(1, 2))

    def k_log_k(k):
        return k * numpy.log2(numpy.maximum(k, 1))

    sums = k_log_k(counts).sum(axis=(1, 2))
    sums -= k_log_k(counts.sum(axis=2)).sum(axis=1) + k_log_k(counts.sum(axis=1)).sum(axis=1)
    return numpy.log2(n) + sums / n


def bootstraps_of_transmission():
    generator = numpy.random.default_rng(1)
    proportions = numpy.full((LABELS, LABELS), 0.5 / (LABELS - 1))
    numpy.fill_diagonal(proportions, 0.5)
    draws = [generator.multinomial(RESPONSES, row, size=DRAWS) for row in proportions]
    transmitted(numpy.stack(draws, axis=1))


def permute_phonemes():
    """20 participants x 414 words x 2 conditions of three phones, labels of words exchanged."""
    generator = numpy.random.default_rng(1)
    labels, pairs, phones = 24, 20 * 414, 3
    stimuli = generator.integers(labels, size=(pairs, 1, phones))
    wrong = generator.integers(labels, size=(pairs, 2, phones))
    right = generator.random((pairs, 2, phones)) < 0.5
    cells = stimuli * labels + numpy.where(right, stimuli, wrong)
    difference = numpy.zeros((pairs, labels * labels), dtype=numpy.float32)
    for condition, sign in ((0, 1), (1, -1)):
        for phone in range(phones):
            numpy.add.at(difference, (numpy.arange(pairs), cells[:, condition, phone]), sign)
    for _ in range(DRAWS // 500):
        signs = generator.integers(2, size=(500, pairs)).astype(numpy.float32) * 2 - 1
        numpy.square(signs @ difference).sum(axis=1)


def table_of_trials():
    generator = random.Random(1)
    words = [f"w{i}" for i in range(414)]
    lines = ["participant,condition,stimulus,response"]
    for participant in range(20):
        for word in words:
            for condition in "ABCD":
                answer = word if generator.random() < 0.5 else generator.choice(words)
                lines.append(f"P{participant},{condition},{word},{answer}")
    return lines


def count_words(lines):
    """Reads trials and counts words right by participant and condition; no phonemes, no intervals."""
    counts = {}
    for row in csv.DictReader(lines):
        key = row["participant"], row["condition"]
        right, trials = counts.get(key, (0, 0))
        counts[key] = right + (row["stimulus"] == row["response"]), trials + 1


if __name__ == "__main__":
    timed("bootstraps_of_transmission", bootstraps_of_transmission)
    timed("permute_phonemes (of sums, no p of cells)", permute_phonemes)
    trials = table_of_trials()
    timed("33,120 trials read, words counted only", lambda: count_words(trials))

#!/usr/bin/env python3
"""The golden plan of plan_test.cpp, computed apart from the C++ code.

SplitMix64 (Steele, Lea & Flood 2014), xoshiro256** (Blackman & Vigna 2018), unbiased integers by
rejection, Fisher and Yates; seeds are derived as derive_seed in stimuli/base/random.cpp does it.
Prints words, conditions and the first noise seed of participant 1: 414 words w0..w413, seed 1993,
three conditions, assignment "once".
"""

M = (1 << 64) - 1


def mix(state):
    state = (state + 0x9E3779B97F4A7C15) & M
    z = state
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & M
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & M
    return state, z ^ (z >> 31)


def rotl(x, k):
    return ((x << k) | (x >> (64 - k))) & M


def derive(parent, purpose, indices=()):
    state, seed = mix(parent)
    for value in [*purpose.encode(), len(purpose), *indices]:
        state, drawn = mix(state ^ value)
        seed = rotl(seed, 23) ^ drawn
    return seed


class Xoshiro:
    def __init__(self, seed):
        self.s = []
        for _ in range(4):
            seed, word = mix(seed)
            self.s.append(word)

    def bits(self):
        s = self.s
        result = (rotl(s[1] * 5 & M, 7) * 9) & M
        shifted = (s[1] << 17) & M
        s[2] ^= s[0]
        s[3] ^= s[1]
        s[1] ^= s[2]
        s[0] ^= s[3]
        s[2] ^= shifted
        s[3] = rotl(s[3], 45)
        return result

    def below(self, bound):
        while True:
            drawn = self.bits()
            if drawn >= (1 << 64) % bound:
                return drawn % bound


def shuffled(count, seed):
    items = list(range(count))
    random = Xoshiro(seed)
    for last in range(count, 1, -1):
        other = random.below(last)
        items[last - 1], items[other] = items[other], items[last - 1]
    return items


SEED, WORDS, CONDITIONS, PARTICIPANT, SESSION = 1993, 414, 3, 1, 1
list_of = {word: place % CONDITIONS
           for place, word in enumerate(shuffled(WORDS, derive(SEED, "lists")))}
order = shuffled(WORDS, derive(SEED, "order", (PARTICIPANT, SESSION)))[:5]
print(", ".join(f'"w{word}"' for word in order))
print(", ".join(f"{(list_of[word] + PARTICIPANT) % CONDITIONS}U" for word in order))
print(hex(derive(SEED, "noise", (PARTICIPANT, SESSION, 0))))

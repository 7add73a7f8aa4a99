#!/usr/bin/env python3
"""How long a farm or a number of shards takes: a cost model, and a simulation of every rank that it is held against.

    bench/farm_model.py                        the table of docs/scale.md
    bench/farm_model.py --journal FILE         the same of the durations in a journal (.cylon/journal.jsonl)
    bench/farm_model.py --check                exit code 1 where model and simulation differ by more than 20 %
    bench/farm_model.py --most 30000           up to so many units alone, which takes less time

The simulation knows events alone: a rank asks, the leader answers one rank after the other, a unit ends.  It hands out
as harness/cli/farm.cc does (units_at_once).  The model is a formula:

    farm:    T = t0 + E[end] + N tm
             P(end < x) = F(x)^S (1 - (G(x) - G(x - t)) / t)^(N - S) for x >= t, the moment at which the last unit is given out:
             S t = S G(t) + (N - S) / t * integral of G from 0 to t, or the leader's answers * ts if that is later
    shards:  T = t0 + E[max of n loads] + N tm; a load is a sum of Poisson(N / n) units (Panjer 1981)

    N units, their durations with distribution F and G(x) = E[min(duration, x)], on S slots (ranks times -j).  S units start
    at 0, the others at moments that are uniform up to t, until which all slots are busy: the second equation counts the work.

What it does not know: a network, a file system that slows down, engines that compete for memory bandwidth.
"""
import argparse
import bisect
import heapq
import json
import math
import random
import sys

# Assumed, not measured: what they are on a cluster, a run there must say (--start and so on).  [s]
COSTS = {
    "start": 0.8,      # t0: mpirun or a shard starts, reads scenarios, and agrees
    "service": 20e-6,  # ts: the leader answers one question
    "answer": 0.5e-3,  # tq: a rank waits for an answer while the leader has nothing else to do (half of its longest nap)
    "merge": 0.25e-3,  # tm: the leader reads, joins and reports a unit
}
ALLOWED = 0.20


def units_at_once(left, ranks):
    return max(1, min(16, left // (64 * ranks)))


def answers(count, ranks):
    """How many answers hand out all units; those that say that there are none left not counted."""
    left, n = count, 0
    while left > 0:
        left -= units_at_once(left, ranks)
        n += 1
    return n


class Durations:
    """An empirical distribution."""

    def __init__(self, values):
        self.values = sorted(values)
        n = len(self.values)
        self.mean = sum(self.values) / n
        self.deviation = math.sqrt(max(0.0, sum(v * v for v in self.values) / n - self.mean**2)) / self.mean
        # G, and its own integral, at each value.
        self.least, self.area, last, g, area = [], [], 0.0, 0.0, 0.0
        for i, value in enumerate(self.values):
            rest = (n - i) / n
            area += g * (value - last) + rest * (value - last) ** 2 / 2
            g += (value - last) * rest
            self.least.append(g)
            self.area.append(area)
            last = value

    def draw(self, rng):
        return self.values[rng.randrange(len(self.values))]

    def below(self, x):
        return bisect.bisect_right(self.values, x) / len(self.values)

    def mean_least(self, x):
        """G(x), and its integral up to x."""
        if x <= 0:
            return 0.0, 0.0
        n, i = len(self.values), bisect.bisect_left(self.values, x)
        at, g, area = (self.values[i - 1], self.least[i - 1], self.area[i - 1]) if i else (0.0, 0.0, 0.0)
        rest = (n - i) / n
        return g + (x - at) * rest, area + g * (x - at) + rest * (x - at) ** 2 / 2


def all_given_out(count, slots, durations):
    """t of the formula; 0 where every unit has a slot."""
    if count <= slots:
        return 0.0
    low, high = 0.0, count * durations.mean / slots
    for _ in range(60):
        t = (low + high) / 2
        g, area = durations.mean_least(t)
        if slots * g + (count - slots) / t * area > slots * t:
            low = t
        else:
            high = t
    return (low + high) / 2


def model_farm(count, slots, durations, pieces=400):
    asked, first = answers(count, slots), min(count, slots)
    t = max(all_given_out(count, slots, durations) + asked / slots * COSTS["answer"], asked * COSTS["service"])
    end, step = t, durations.values[-1] / pieces
    for k in range(pieces):
        x = t + (k + 0.5) * step
        later = 1 - (durations.mean_least(x)[0] - durations.mean_least(x - t)[0]) / t if t > 0 else 1.0
        end += (1 - durations.below(x) ** first * later ** (count - first)) * step
    return COSTS["start"] + end + count * COSTS["merge"]


def simulate_farm(count, slots, durations, rng):
    """Every slot asks by itself; the leader, which is one of them, answers in the order in which it is asked."""
    left, free_at, end = count, 0.0, 0.0
    asking = [(rng.random() * COSTS["answer"], slot) for slot in range(slots)]
    heapq.heapify(asking)
    while asking:
        now, slot = heapq.heappop(asking)
        begin = max(now + rng.random() * 2 * COSTS["answer"], free_at) if now >= free_at else free_at
        free_at = begin + COSTS["service"]
        if left == 0:
            continue
        units = units_at_once(left, slots)
        left -= units
        ends = free_at + sum(durations.draw(rng) for _ in range(units))
        end = max(end, ends)
        heapq.heappush(asking, (ends, slot))
    return COSTS["start"] + max(end, free_at) + count * COSTS["merge"]


def model_shards(count, shards, durations, pieces=1200):
    each = count / shards
    square = sum(v * v for v in durations.values) / len(durations.values)
    top = each * durations.mean + 7 * math.sqrt(each * square) + 1.5 * durations.values[-1]
    step = top / pieces
    # The distribution on a grid, each duration between its two neighbours so that the mean is kept.
    grid = {}
    for value in durations.values:
        i = int(value / step)
        for place, weight in ((i, i + 1 - value / step), (i + 1, value / step - i)):
            grid[place] = grid.get(place, 0.0) + weight / len(durations.values)
    # Panjer: p(m) = (each / m) * sum of j f(j) p(m - j); f(0) only makes units fewer.
    weights = [(place, place * share) for place, share in sorted(grid.items()) if place > 0 and share > 0]
    p = [math.exp(-each * (1 - grid.get(0, 0.0)))]
    for m in range(1, pieces + 1):
        p.append(each / m * sum(share * p[m - place] for place, share in weights if place <= m))
    below, largest = 0.0, 0.0
    for share in p:
        below += share
        largest += (1 - min(1.0, below) ** shards) * step
    return COSTS["start"] + largest + count * COSTS["merge"]


def simulate_shards(count, shards, durations, rng):
    loads = [0.0] * shards
    for _ in range(count):
        loads[rng.randrange(shards)] += durations.draw(rng)
    return COSTS["start"] + max(loads) + count * COSTS["merge"]


def lognormal(mean, deviation, rng, count=1000):
    spread = math.log(1 + deviation**2)
    values = [math.exp(rng.gauss(-spread / 2, math.sqrt(spread))) for _ in range(count)]
    return Durations([mean * value * count / sum(values) for value in values])


def two_kinds(short, long, share, count=1000):
    return Durations([long if i < share * count else short for i in range(count)])


def of_journal(file):
    values = []
    with open(file, encoding="utf-8") as lines:
        for line in lines:
            try:
                object_ = json.loads(line)
            except ValueError:
                continue  # cut off
            if "cell" in object_:
                values.append(object_["seconds"])
    if not values:
        sys.exit(f"{file}: no cell in it")
    return Durations(values)


def mean_of(trial, least, most=2000, certain=0.03):
    """Its expected value, which is what the model says: until the standard error is 3 %."""
    values = []
    while len(values) < most:
        values.append(trial())
        if len(values) >= least:
            mean = sum(values) / len(values)
            error = math.sqrt(sum((v - mean) ** 2 for v in values) / (len(values) * (len(values) - 1)))
            if error < certain * mean:
                break
    return sum(values) / len(values)


def rows(durations):
    """Units, slots: from a workstation to a cluster, from fewer units than slots to many."""
    for name, one in durations.items():
        for slots in (8, 64, 512, 10_000):
            for each in (0.5, 3, 30):
                yield name, one, int(slots * each), slots


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--journal")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--most", type=int, default=10**9)
    parser.add_argument("--seed", type=int, default=23)
    for name, seconds in COSTS.items():
        parser.add_argument(f"--{name}", type=float, default=seconds, metavar="S")
    options = parser.parse_args()
    COSTS.update({name: getattr(options, name) for name in COSTS})
    rng = random.Random(options.seed)
    if options.journal:
        durations = {"journal": of_journal(options.journal)}
    else:
        durations = {"0.1 s, even": lognormal(0.1, 0.5, rng), "0.3 s, uneven": lognormal(0.3, 1.5, rng),
                     "0.05 and 10 s": two_kinds(0.05, 10, 0.02)}
    print(f"{'durations':<16}{'mean':>8}{'dev.':>6}{'units':>9}{'slots':>7}{'farm':>10}{'simulated':>11}{'':>7}"
          f"{'shards':>10}{'simulated':>11}{'':>7}{'ideal':>9}")
    worst = 0.0
    for name, one, count, slots in rows(durations):
        if count > options.most:
            continue
        shown = [f"{name:<16}{one.mean:>8.3f}{one.deviation:>6.2f}{count:>9}{slots:>7}"]
        for model, simulate in ((model_farm, simulate_farm), (model_shards, simulate_shards)):
            predicted = model(count, slots, one)
            simulated = mean_of(lambda: simulate(count, slots, one, rng), max(3, min(1000, 300_000 // count)))
            error = predicted / simulated - 1
            worst = max(worst, abs(error))
            shown.append(f"{predicted:>10.2f}{simulated:>11.2f}{error:>+7.1%}")
        shown.append(f"{count * one.mean / slots:>9.2f}")
        print("".join(shown))
    print(f"largest difference: {worst:.1%}, allowed: {ALLOWED:.0%}")
    return 1 if options.check and worst > ALLOWED else 0


if __name__ == "__main__":
    sys.exit(main())

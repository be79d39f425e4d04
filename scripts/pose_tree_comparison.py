"""How often labellings of a skeleton's ends are right."""
import itertools

import numpy as np

from pose_tree_extremities import are_right

PAIRS = list(itertools.combinations(range(5), 2))  # of head, hand, hand, foot, foot
KINDS = 'head', 'hand', 'hand', 'foot', 'foot'
MOST_ENDS = 14  # of the longest branches; more would take long


def all_choices(f):
    """All (head, hand, hand, foot, foot) of different ends."""
    ends = np.argsort(-f.ends[:, 9], kind='stable')[:MOST_ENDS]
    found = []
    for head in ends:
        rest = [end for end in ends if end != head]
        for hands in itertools.combinations(rest, 2):
            feet = [end for end in rest if end not in hands]
            found += [(head, *hands, *pair) for pair in itertools.combinations(feet, 2)]
    return np.array(found, int).reshape(-1, 5)


def path_lengths(f, chosen, stature):
    """[choices, pairs]: shortest paths inside the hull, in statures."""
    return np.stack([f.short[chosen[:, a], chosen[:, b]] for a, b in PAIRS], 1) / stature


def fit_lengths(frames, statures):
    """Mean and standard deviation of the path lengths by the kinds of their ends: ten numbers."""
    values = {}
    for f in frames:
        chosen = all_choices(f)
        right = chosen[are_right(f, chosen)][:1]
        for row in path_lengths(f, right, statures[f.capture[:3]]):
            for (a, b), length in zip(PAIRS, row):
                values.setdefault((KINDS[a], KINDS[b]), []).append(length)
    return {kinds: (np.mean(lengths), np.std(lengths)) for kinds, lengths in values.items()}


def by_lengths(f, model, stature):
    """Whether the most likely choice has the right kinds."""
    chosen = all_choices(f)
    if len(chosen) == 0:
        return False
    mean, spread = np.array([model[KINDS[a], KINDS[b]] for a, b in PAIRS]).T
    away = (path_lengths(f, chosen, stature) - mean) / spread
    return bool(are_right(f, chosen[[(away**2).sum(1).argmin()]])[0])


def percent(values):
    return f'{100 * np.mean(values):5.1f} %' if len(values) else '      -'


def table(known, others, statures):
    """Shares of the hulls without a cut limb, by their pitch and labelling. known: those to which the
    lengths are fitted"""
    def whole(frames):
        return [f for f in frames if not f.limb_cut]
    seen = [f for f in whole(known) if f.longest > 0 and len(f.ends) >= 5]
    model = fit_lengths(seen, statures)
    others = whole(others)
    names = list(others[0].rankings)
    out = [f'{"labelling":12s} {"pitch":>9s} {"hulls":>6s} {"kinds":>8s} {"kinds and sides":>16s}']
    for pitch in sorted({f.capture.rsplit('_', 1)[1] for f in others}):
        here = [f for f in others if f.capture.endswith(pitch)]

        def add(name, kinds, right):
            out.append(f'{name:12s} {pitch:>9s} {len(here):6d} {percent(kinds):>8s} '
                       f'{percent(right):>16s}')
        for name in names:
            add(name, *([f.rankings[name][i] for f in here] for i in (0, 1)))
        add('lengths', [f.longest > 0 and by_lengths(f, model, statures[f.capture[:3]])
                        for f in here], [])
        add('learned', [f.kinds for f in here], [f.right for f in here])
    return '\n'.join(out) + '\n'

"""The model of the ends of a skeleton, as in src/skeleton/label_template.cpp."""
import itertools

import numpy as np

from additive_models import descend, named_curves, spread, table
from pose_tree_files import BODY_KNOTS, END_KNOTS, extremities_text

END_CURVES, BODY_CURVES = list(END_KNOTS.values()), list(BODY_KNOTS.values())
HEADS, HANDS, FEET = 4, 7, 6  # candidates of each kind, as in label_template.cpp


def end_values(f):
    e, s = f.ends, f.longest
    values = [(f.tips[:, 2] - f.low) / s, (f.high - f.tips[:, 2]) / s, e[:, 5], e[:, 6] / s,
              e[:, 7] / s, e[:, 8] / s, e[:, 9] / s, e[:, 10], f.tree.max(1) / s]
    return [value[:, None] for value in values]


def fit_ends(frames):
    """Multinomial logit of nothing, head, hand, foot."""
    x = table(*map(np.concatenate, zip(*(spread(end_values(f), END_CURVES) for f in frames))),
              END_CURVES)
    true = np.concatenate([f.true for f in frames])
    kind = np.select([(true & bits) > 0 for bits in (1, 6, 24)], [1, 2, 3])
    rows = np.arange(len(kind))

    def loss(weights):
        score = x @ weights[:-1] + weights[-1]
        score -= score.max(1, keepdims=True)
        p = np.exp(score)
        p /= p.sum(1, keepdims=True)
        value = -np.log(p[rows, kind] + 1e-12).mean()
        p[rows, kind] -= 1
        return value, np.vstack([x.T @ p, p.sum(0)]) / len(rows)
    weights = descend(loss, END_CURVES, 4, 5e-5, 1e-3)
    return weights[:, 1:] - weights[:, :1]


def choices(f, end_weights):
    """All (head, hand, hand, foot, foot) that label_template.cpp looks at, and their ends' odds."""
    index, weight = spread(end_values(f), END_CURVES)
    odds = (end_weights[index] * weight[:, :, None]).sum(1) + end_weights[-1]
    heads, hands, feet = (np.argsort(-odds[:, kind], kind='stable')[:most]
                          for kind, most in enumerate((HEADS, HANDS, FEET)))
    found = []
    for head, (a, b) in itertools.product(heads,
                                          itertools.combinations_with_replacement(feet, 2)):
        ways = f.short[head, [a, b]]
        if head in (a, b) or not .7 <= ways.mean() <= 2.2 or abs(np.log(ways[0] / ways[1])) > .5:
            continue
        found += [(head, c, d, a, b) for c, d in itertools.combinations(hands, 2)
                  if not {c, d} & {head, a, b}]
    return np.array(found, int).reshape(-1, 5), odds


def body_values(f, chosen):
    h, a, b, c, d = chosen.T
    tree, short, ends, tips, z = f.tree, f.short, f.ends, f.tips, f.tips[:, 2]
    size = .5 * (short[h, c] + short[h, d])
    low = np.minimum(z[c], z[d])

    def gap(i, j):
        return np.linalg.norm(tips[i] - tips[j], axis=1)

    def arm(ways, hand):
        return .5 * np.minimum(ways[hand, h] + ways[hand, c] - ways[h, c],
                               ways[hand, h] + ways[hand, d] - ways[h, d])
    neck = .5 * (tree[h, a] + tree[h, b] - tree[a, b])
    hips = .5 * (tree[c, h] + tree[d, h] - tree[c, d])
    hand_foot = [(a, c), (a, d), (b, c), (b, d)]
    kinds = [(h,), (a, b), (c, d)]

    def shares(*lengths):
        return np.stack(lengths, 1) / size[:, None]

    def column(of):
        return [shares(*(ends[i, of] for i in kind)) for kind in kinds]

    def plain(of):
        return [np.stack([ends[i, of] for i in kind], 1) for kind in kinds]
    radii = itertools.chain.from_iterable(zip(column(7), column(8)))
    return [shares(short[h, a], short[h, b]), shares(tree[h, a], tree[h, b]), shares(short[a, b]),
            shares(tree[a, b]), shares(*(short[pair] for pair in hand_foot)),
            shares(*(tree[pair] for pair in hand_foot)), shares(short[c, d]), shares(tree[c, d]),
            size[:, None], np.abs(np.log(short[h, c] / short[h, d]))[:, None], shares(gap(c, d)),
            shares(gap(a, b)), shares(neck), shares(hips - neck),
            np.abs(np.log(tree[h, a] / tree[h, b]))[:, None], shares(z[h] - low),
            shares(z[c] - f.low, z[d] - f.low), shares(np.abs(z[c] - z[d])),
            shares(z[a] - low, z[b] - low), *radii, *column(9), *plain(10), *column(6), *plain(5),
            (c == d).astype(float)[:, None], shares(arm(short, a), arm(short, b)),
            shares(arm(tree, a), arm(tree, b)), shares(gap(h, a), gap(h, b)),
            shares(*(gap(*pair) for pair in hand_foot))]


def are_right(f, chosen):
    h, a, b, c, d = (f.true[chosen[:, i]] for i in range(5))

    def pair(one, other, bit):
        return ((one & bit) > 0) & ((other & 2 * bit) > 0)
    return ((h & 1) > 0) & (pair(a, b, 2) | pair(b, a, 2)) & (pair(c, d, 8) | pair(d, c, 8))


def fit_body(frames, end_weights, weights=None, most=50):
    """Logit over all choices of five ends of one skeleton and "none is right"."""
    draw, blocks = np.random.default_rng(0), []
    for f in frames:
        chosen, odds = choices(f, end_weights)
        if len(chosen) == 0:
            continue
        index, weight = spread(body_values(f, chosen), BODY_CURVES)
        right = are_right(f, chosen)
        kinds = [0, 1, 1, 2, 2]
        score = (odds[chosen, kinds].sum(1) if weights is None
                 else (weights[index, 0] * weight).sum(1))
        order = np.argsort(-score)
        keep = np.unique(np.concatenate([order[:most], order[right[order]][:30],
                                         draw.choice(len(chosen), min(20, len(chosen)), False)]))
        blocks.append((index[keep], weight[keep], right[keep]))
    x = table(*(np.concatenate([block[i] for block in blocks]) for i in (0, 1)), BODY_CURVES)
    right = np.concatenate([block[2] for block in blocks])
    counts = np.array([len(block[2]) for block in blocks])
    first = np.concatenate([[0], np.cumsum(counts)[:-1]])
    frame = np.repeat(np.arange(len(counts)), counts)
    transposed = x.T.tocsr()

    def loss(weights):
        score, none = x @ weights[:-1, 0], weights[-1, 0]
        top = np.maximum(np.maximum.reduceat(score, first), none)
        e, e_none = np.exp(score - top[frame]), np.exp(none - top)
        good = np.add.reduceat(e * right, first)
        has = good > 0
        everything = np.add.reduceat(e, first) + e_none
        wanted = np.where(has, good, e_none)
        value = (np.log(everything) - np.log(wanted)).mean()
        slope = e / everything[frame] - np.where(has[frame], e * right / wanted[frame], 0)
        last = (e_none / everything - ~has).sum()
        return value, np.append(transposed @ slope, last)[:, None] / len(counts)
    return descend(loss, BODY_CURVES, 1, 6e-5, 2e-3, weights, 120)


def fit(frames):
    """The text of models/pose_tree_extremities.yaml. Hulls with a limb cut off are left out."""
    frames = [f for f in frames if not f.limb_cut]
    hulls = len(frames)
    frames = [f for f in frames if len(f.ends) >= 4]
    ends = fit_ends(frames)
    body = fit_body(frames, ends)
    body = fit_body(frames, ends, body)
    extremities = {name: (ends[-1, kind], named_curves(END_KNOTS, ends[:, kind]))
                   for kind, name in enumerate(('head', 'hand', 'foot'))}
    return extremities_text(hulls, extremities, named_curves(BODY_KNOTS, body[:, 0]), body[-1, 0])

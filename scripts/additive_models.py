"""Sums of curves, each piecewise linear through evenly spaced knots, fitted by penalised likelihood."""
import numpy as np
from scipy.optimize import minimize
from scipy.sparse import csr_matrix


def spread(values, curves):
    """Indices and weights of the knots that values [rows, curves][, instances] lie between."""
    index, weight, first = [], [], 0
    for value, (low, high, knots) in zip(values, curves):
        at = np.clip((value - low) / (high - low), 0, 1) * (knots - 1)
        left = np.minimum(at.astype(int), knots - 2)
        index += [first + left, first + left + 1]
        weight += [1 - (at - left), at - left]
        first += knots
    return np.concatenate(index, 1), np.concatenate(weight, 1)


def table(index, weight, curves):
    rows = np.arange(0, index.size + 1, index.shape[1])
    return csr_matrix((weight.ravel(), index.ravel(), rows),
                      shape=(len(index), sum(curve[2] for curve in curves)))


def bends(curves):
    """Second differences of all curves."""
    rows, first, count = [], 0, sum(curve[2] for curve in curves)
    for curve in curves:
        for knot in range(first, first + curve[2] - 2):
            rows.append(np.bincount([knot, knot + 1, knot + 1, knot + 2], [1, -1, -1, 1], count))
        first += curve[2]
    return np.array(rows)


def penalised(loss, curves, ridge, bend):
    """Adds a ridge and the squared second differences; the last row of weights is free."""
    differences = bends(curves)

    def sum_of(flat, shape):
        weights = flat.reshape(shape)
        value, slope = loss(weights)
        inner = weights[:-1]
        curved = differences @ inner
        value += ridge * (inner**2).sum() + bend * (curved**2).sum()
        slope[:-1] += 2 * ridge * inner + 2 * bend * differences.T @ curved
        return value, slope.ravel()
    return sum_of


def descend(loss, curves, columns, ridge, bend, start=None, steps=200):
    shape = (sum(curve[2] for curve in curves) + 1, columns)
    start = np.zeros(shape) if start is None else start
    return minimize(penalised(loss, curves, ridge, bend), start.ravel(), (shape,), jac=True,
                    method='L-BFGS-B', options=dict(maxiter=steps)).x.reshape(shape)


def named_curves(curves, weights):
    """name -> (low, high, values at the knots). curves: name -> (low, high, how many knots)"""
    named, first = {}, 0
    for name, (low, high, knots) in curves.items():
        named[name] = (low, high, list(weights[first:first + knots]))
        first += knots
    return named

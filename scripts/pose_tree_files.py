"""How models/pose_tree_extremities.yaml and models/pose_tree_validity.yaml are written."""

# Knots of the curves, by the features of extremity_label_model.h: low, high, how many.
END_KNOTS = {
    'end_up': (0, 1.2, 8), 'end_down': (0, 1.2, 8), 'end_direction': (-1, 1, 5),
    'end_extent': (0, .12, 6), 'end_tip_radius': (.01, .07, 7), 'end_limb_radius': (.01, .08, 7),
    'end_branch': (0, .5, 8), 'end_cut': (0, 1, 2), 'end_reach': (.4, 1.1, 7)}
BODY_KNOTS = {
    'head_hand_path': (.1, 1, 10), 'head_hand_tree_path': (.1, 1.2, 10),
    'hand_hand_path': (.05, 1.6, 10), 'hand_hand_tree_path': (.05, 1.6, 10),
    'hand_foot_path': (.1, 1.5, 11), 'hand_foot_tree_path': (.1, 1.6, 11),
    'foot_foot_path': (.05, 1.4, 10), 'foot_foot_tree_path': (.05, 1.4, 10),
    'head_feet_metres': (.8, 2, 7), 'feet_unlike': (0, .4, 6), 'foot_foot_gap': (0, .6, 9),
    'hand_hand_gap': (0, 1.2, 7), 'neck_length': (0, .5, 9), 'torso_length': (-.2, .8, 10),
    'hands_unlike': (0, .8, 7), 'head_up': (0, 1.2, 7), 'foot_up': (0, .7, 8),
    'feet_unevenness': (0, .5, 6), 'hand_up': (0, 1.2, 7), 'head_tip_radius': (.02, .1, 7),
    'head_limb_radius': (.02, .1, 7), 'hand_tip_radius': (.01, .07, 7),
    'hand_limb_radius': (.01, .08, 7), 'foot_tip_radius': (.01, .07, 7),
    'foot_limb_radius': (.01, .09, 7), 'head_branch': (0, .5, 8), 'hand_branch': (0, .6, 9),
    'foot_branch': (0, .6, 9), 'head_cut': (0, 1, 2), 'hand_cut': (0, 1, 2), 'foot_cut': (0, 1, 2),
    'head_extent': (0, .12, 6), 'hand_extent': (0, .12, 6), 'foot_extent': (0, .12, 6),
    'head_direction': (-1, 1, 5), 'hand_direction': (-1, 1, 5), 'foot_direction': (-1, 1, 5),
    'feet_together': (0, 1, 2), 'arm_path': (0, .6, 9), 'arm_tree_path': (0, .6, 9),
    'head_hand_gap': (0, .8, 8), 'hand_foot_gap': (0, 1.5, 9)}

EXTREMITIES = """\
# Made by: scripts/fit_pose_tree extremities SAMPLES > models/pose_tree_extremities.yaml
# SAMPLES is a folder that `scripts/fit_pose_tree film SAMPLES` has filled.
# How the pose tree names the ends of a skeleton: penalised maximum likelihood (ridge and second
# differences) over {hulls} hulls of eight people of the virtual studio, 1.5 to 1.9 m tall, in tight
# and loose clothes and skirts, seen by four, seven and eight cameras.
# A curve is a part of a log-odds: `knots` are its values at evenly spaced places from `low` to
# `high`. It is linear between them and level beyond them. The curves and the constant add up.
# The features are those of src/skeleton/labelling/extremity_label_model.h.
# Of one end, against "none of these": within 15 cm of the true end (head: 25 cm).
extremities:
{extremities}\
# Of five ends, against all other choices and against "no choice is right".
body:
  no_body_log_odds: {no_body:.2f}
  curves:
{body}"""

VALIDITY = """\
# Made by: scripts/fit_pose_tree validity SAMPLES > models/pose_tree_validity.yaml
# SAMPLES is a folder that `scripts/fit_pose_tree film SAMPLES` has filled after the present
# models/pose_tree_extremities.yaml was built in.
# How likely all labels and both sides of a pose tree are right: penalised logit over {hulls} hulls
# of 24 people of the virtual studio, others than those of pose_tree_extremities.yaml. One hull in
# ten has a limb cut off.
# A curve is a part of the log-odds: `knots` are its values at evenly spaced places from `low` to
# `high`. It is linear between them and level beyond them. The curves and the intercept add up.
# The features are those of src/skeleton/labelling/validity_features.h.
intercept: {intercept:.2f}
curves:
{curves}"""

EXTREMITY = """\
  {name}:
    constant: {constant:.2f}
    curves:
{curves}"""


def curve_lines(curves, indent):
    """One line for each curve. curves: name -> (low, high, knots)"""
    return ''.join(
        f'{" " * indent}{name}: {{low: {low:.4g}, high: {high:.4g}, '
        f'knots: [{", ".join(f"{round(knot, 2) + 0:g}" for knot in knots)}]}}\n'
        for name, (low, high, knots) in curves.items())


def extremities_text(hulls, extremities, body, no_body):
    """extremities: head, hand, foot -> (constant, curves); no_body: log-odds"""
    return EXTREMITIES.format(
        hulls=hulls, no_body=no_body, body=curve_lines(body, 4),
        extremities=''.join(EXTREMITY.format(name=name, constant=constant,
                                             curves=curve_lines(curves, 6))
                            for name, (constant, curves) in extremities.items()))


def validity_text(hulls, intercept, curves):
    return VALIDITY.format(hulls=hulls, intercept=intercept, curves=curve_lines(curves, 2))

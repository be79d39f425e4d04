#include "skeleton/doubt_weights.h"

// Made by scripts/fit_pose_tree: penalised logit over 6048 hulls of the virtual studio of 24
// persons whom the model of the ends was not fitted to, who do all motions of config/motions before
// rings of four, seven and eight cameras, some with damaged masks and small images, some with
// silhouettes from the images.

namespace markerless_mocap {

const double kDoubtConstant = -3.54;

const std::array<LabelCurve, kLabelDoubtCount> kDoubtCurves = {
    {{-8.893, 6.27, {-3.05, -1.84, -0.37, 1.64, 3.62}},
     {0.002858, 0.2156, {-1.45, -0.16, 0.69, 0.5, 0.43}},
     {0, 0.1137, {-0.04, 0.3, 0.16, -0.05, -0.37}},
     {0.02902, 0.9998, {-0.77, -0.38, 0.23, 0.44, 0.48}},
     {-0.7605, 1, {-0.56, -0.16, 0.19, 0.36, 0.17}},
     {-0.02072, 0.06354, {-0.97, -0.21, 0.37, 0.48, 0.33}},
     {0, 0.1688, {1.63, 0.96, 0.09, -0.9, -1.78}},
     {0.7987, 1, {-0.27, -0.04, 0.01, 0.06, 0.24}},
     {0.02998, 0.3525, {-1.41, -0.42, 0.24, 0.64, 0.95}},
     {0, 0.3741, {0.41, 0.55, 0.23, -0.22, -0.97}},
     {0.009093, 0.06124, {-0.43, 0, 0.26, 0.23, -0.07}},
     {0.01527, 0.369, {-0.45, -0.47, -0.19, 0.33, 0.78}},
     {0.0341, 0.4196, {-0.16, 0.29, 0.44, 0.04, -0.61}},
     {0, 0.3156, {-0.22, 0, 0.05, 0.1, 0.06}},
     {0, 0.007726, {0.08, 0.14, 0.15, -0.04, -0.34}},
     {0, 1, {1.22, -1.22}}}};

}  // namespace markerless_mocap

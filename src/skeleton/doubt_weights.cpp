#include "skeleton/doubt_weights.h"

// Made by scripts/fit_pose_tree: penalised logit over 6948 hulls of the virtual studio of 24
// persons whom the model of the ends was not fitted to, who do all motions of config/motions before
// rings of four, seven and eight cameras, some with damaged masks and small images, some with
// silhouettes from the images.

namespace markerless_mocap {

const double kDoubtConstant = -3.41;

const std::array<LabelCurve, kLabelDoubtCount> kDoubtCurves = {
    {{-9.141, 6.271, {-3.02, -1.82, -0.37, 1.65, 3.56}},
     {0.002998, 0.2151, {-1.51, -0.2, 0.68, 0.55, 0.47}},
     {0, 0.1137, {-0.13, 0.33, 0.23, -0.03, -0.4}},
     {0.02967, 0.9998, {-0.66, -0.36, 0.2, 0.38, 0.44}},
     {-0.7717, 1, {-0.9, -0.17, 0.33, 0.45, 0.27}},
     {-0.02041, 0.06413, {-1.16, -0.25, 0.43, 0.55, 0.43}},
     {0, 0.1634, {1.54, 0.96, 0.14, -0.87, -1.78}},
     {0.8044, 1, {-0.23, -0.04, 0.01, 0.04, 0.22}},
     {0.02992, 0.3517, {-1.34, -0.35, 0.26, 0.59, 0.84}},
     {0, 0.3675, {0.35, 0.55, 0.22, -0.22, -0.9}},
     {0.009171, 0.06043, {-0.39, -0.06, 0.19, 0.22, 0.04}},
     {0.01527, 0.369, {-0.41, -0.45, -0.21, 0.29, 0.79}},
     {0.0341, 0.4195, {-0.15, 0.26, 0.44, 0.04, -0.6}},
     {0, 0.3164, {-0.35, -0.05, 0.06, 0.16, 0.17}},
     {0, 0.007556, {0.07, 0.12, 0.14, -0.02, -0.3}},
     {0, 1, {0.98, -0.98}}}};

}  // namespace markerless_mocap

#include "skeleton/labelling/validity_weights.h"

// Made as by scripts/fit_pose_tree: penalised logit over 7259 hulls of the virtual studio of 24
// persons whom the model of the ends was not fitted to, who do all motions of config/motions before
// rings of four, seven and eight cameras, some with damaged masks and small images, some with
// silhouettes from the images, one in ten with a limb cut off.

namespace markerless_mocap {

const double kValidityIntercept = -6.02;

const std::array<PiecewiseLinear, kValidityFeatureCount> kValidityCurves = {
    {{-9.262, 6.268, {-2.16, -1.3, -0.23, 1.27, 2.42}},
     {0.003058, 0.2137, {-1.2, -0.07, 0.57, 0.34, 0.36}},
     {0, 0.114, {-0.16, 0.24, 0.13, 0, -0.21}},
     {0.02926, 0.9997, {-0.86, -0.49, 0.22, 0.55, 0.57}},
     {-0.8093, 1, {-0.81, -0.17, 0.25, 0.45, 0.28}},
     {-0.02469, 0.06414, {-1.48, -0.37, 0.47, 0.76, 0.62}},
     {0, 0.173, {1.48, 0.94, 0.15, -0.83, -1.75}},
     {0.7983, 1, {-0.3, -0.1, 0.01, 0.09, 0.3}},
     {0.02992, 0.3516, {-0.69, -0.26, 0.06, 0.29, 0.6}},
     {0, 0.3692, {0.23, 0.55, 0.17, -0.2, -0.75}},
     {0.009148, 0.06092, {-0.26, -0.06, 0.2, 0.16, -0.04}},
     {0.01519, 0.369, {-0.45, -0.46, -0.29, 0.28, 0.91}},
     {0.03298, 0.4211, {-0.16, 0.2, 0.35, 0.06, -0.44}},
     {0, 0.319, {-0.51, -0.09, 0.11, 0.23, 0.25}},
     {0, 0.008127, {0.13, 0.17, 0.15, -0.06, -0.39}},
     {0.1797, 0.5671, {-1.08, -0.4, 0.17, 0.67, 0.64}},
     {0.001065, 0.6245, {1.3, 0.83, -0.01, -0.74, -1.38}},
     {0, 0.1209, {0.51, 0.44, 0.2, -0.24, -0.91}},
     {0.003275, 0.06197, {0.14, -0.1, -0.11, 0, 0.06}},
     {0.005931, 0.03449, {-0.09, -0.13, 0.03, 0.07, 0.12}},
     {0.0032, 0.0438, {0.16, 0.06, -0.02, -0.06, -0.15}},
     {0, 1, {1.26, -1.27}}}};

}  // namespace markerless_mocap

#include "skeleton/labelling/model_curves.h"

namespace markerless_mocap {

PiecewiseLinear curveIn(YamlMap map) {
  PiecewiseLinear curve{map.number("low"), map.number("high"), map.numbers("knots")};
  if (!(curve.low < curve.high)) map.fail("'high' must be above 'low'");
  if (curve.knots.size() < 2) map.fail("'knots' must be at least two numbers");
  map.finish();
  return curve;
}

}  // namespace markerless_mocap

#include <iostream>

#include "markerless_mocap/pipeline/pipeline.h"

int main() {
  std::cout << markerless_mocap::describePipelineOptions();
  return 0;
}

# Makes the target markerless_mocap::markerless_mocap. catkin's markerless_mocapConfig.cmake includes
# this file; where the package is built without ROS, this file is markerless_mocapConfig.cmake.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(yaml-cpp)
if(NOT TARGET opencv_core)  # to find it again would change OpenCV_LIBS
  find_dependency(OpenCV COMPONENTS core)
endif()
if(NOT TARGET markerless_mocap::markerless_mocap)  # catkin_make configures all packages together
  include(${markerless_mocap_DIR}/markerless_mocapTargets.cmake)
endif()
list(APPEND markerless_mocap_LIBRARIES markerless_mocap::markerless_mocap)

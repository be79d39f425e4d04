# What other projects link: the rooms pipeline and formats and all rooms below as one shared library
# markerless_mocap::markerless_mocap, with the headers under include/. Everything else is private.
include(GNUInstallDirs)
set(MOCAP_CMAKE_DESTINATION share/${PROJECT_NAME}/cmake)  # where catkin installs its configuration, too

set(objects "")
get_target_property(rooms mocap_pipeline MOCAP_ROOMS)
list(APPEND rooms formats)
foreach(room ${rooms})
  get_target_property(type mocap_${room} TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    list(APPEND objects $<TARGET_OBJECTS:mocap_${room}>)
  endif()
endforeach()
add_library(markerless_mocap SHARED ${objects})
add_library(markerless_mocap::markerless_mocap ALIAS markerless_mocap)
set_target_properties(markerless_mocap PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
# The rooms' objects are all there already: from mocap_pipeline come the libraries they need.
target_link_libraries(markerless_mocap
  PRIVATE mocap_pipeline mocap_formats INTERFACE Eigen3::Eigen opencv_core yaml-cpp)
target_include_directories(markerless_mocap INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(markerless_mocap INTERFACE cxx_std_17)

install(TARGETS markerless_mocap EXPORT markerless_mocap DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT markerless_mocap NAMESPACE markerless_mocap::
  FILE markerless_mocapTargets.cmake DESTINATION ${MOCAP_CMAKE_DESTINATION})
install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} PATTERN ros EXCLUDE)
if(NOT MARKERLESS_MOCAP_WITH_ROS)  # else catkin_package() makes these, see ros.cmake
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file(markerless_mocapConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/markerless_mocapConfigVersion.cmake
    DESTINATION ${MOCAP_CMAKE_DESTINATION})
  install(FILES cmake/markerless_mocap-extras.cmake
    DESTINATION ${MOCAP_CMAKE_DESTINATION} RENAME markerless_mocapConfig.cmake)
endif()

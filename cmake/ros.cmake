# catkin caches the tests' environment while it configures and leaves out folders that are not there
# yet: without these the first build's rostests would not find our Python messages.
if(NOT CATKIN_DEVEL_PREFIX)
  set(CATKIN_DEVEL_PREFIX ${CMAKE_BINARY_DIR}/devel)
endif()
file(MAKE_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib/python3/dist-packages)

get_property(core_targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)

# Messages, conversions, nodelets with their executables, tools.
find_package(catkin REQUIRED COMPONENTS roscpp roslib nodelet pluginlib rosbag message_generation
  rosgraph_msgs std_msgs geometry_msgs sensor_msgs visualization_msgs std_srvs tf2_msgs tf2_ros tf2_eigen
  cv_bridge diagnostic_updater dynamic_reconfigure interactive_markers)

file(GLOB messages RELATIVE ${PROJECT_SOURCE_DIR}/msg CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/msg/*.msg)
add_message_files(FILES ${messages})
generate_messages(DEPENDENCIES std_msgs geometry_msgs)
catkin_package(INCLUDE_DIRS include CATKIN_DEPENDS message_runtime std_msgs geometry_msgs sensor_msgs
  CFG_EXTRAS markerless_mocap-extras.cmake)
set_target_properties(markerless_mocap PROPERTIES
  LIBRARY_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_LIB_DESTINATION})
export(EXPORT markerless_mocap NAMESPACE markerless_mocap::
  FILE ${CATKIN_DEVEL_PREFIX}/${MOCAP_CMAKE_DESTINATION}/markerless_mocapTargets.cmake)
install(DIRECTORY include/markerless_mocap/ros DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})

# catkin's definitions and folder are for what uses ROS. The core compiles as it does without ROS, so that
# the compiler's cache has it once one of the two builds is there.
get_directory_property(ros_definitions COMPILE_DEFINITIONS)
set_directory_properties(PROPERTIES COMPILE_DEFINITIONS "")
foreach(target ${core_targets})
  get_target_property(folders ${target} INCLUDE_DIRECTORIES)
  if(folders)
    list(REMOVE_ITEM folders ${CATKIN_DEVEL_PREFIX}/include)
    set_target_properties(${target} PROPERTIES INCLUDE_DIRECTORIES "${folders}")
  endif()
endforeach()

# Everything that includes a ROS header: ROS's own headers are not held to our warnings.
function(mocap_use_ros target)
  target_compile_definitions(${target} PUBLIC ${ros_definitions})
  target_include_directories(${target} SYSTEM PUBLIC
    ${CATKIN_DEVEL_PREFIX}/include ${catkin_INCLUDE_DIRS})
  target_link_libraries(${target} PUBLIC ${catkin_LIBRARIES})
  add_dependencies(${target} ${PROJECT_NAME}_generate_messages_cpp)
endfunction()

find_package(JPEG REQUIRED)
find_package(PNG REQUIRED)
mocap_room(ros DEPENDS checks hull silhouette tracking LIBRARIES JPEG::JPEG PNG::PNG opencv_imgcodecs)
mocap_use_ros(mocap_ros)

# The Point Cloud Library with all that it needs is for these files alone: its headers build slowly,
# and its libraries load VTK. Its own PCLConfig.cmake asks for VTK's and MPI's configurations, too.
find_package(PkgConfig REQUIRED)
pkg_check_modules(PCL REQUIRED pcl_common pcl_io)
find_library(PCL_IO_PLY pcl_io_ply REQUIRED)
mocap_room(clouds DEPENDS ros LIBRARIES pcl_io ${PCL_IO_PLY} pcl_common)
target_include_directories(mocap_clouds SYSTEM PUBLIC ${PCL_INCLUDE_DIRS})

# One executable per stage, named as the node, hosts the stage's nodelet.
set(stages silhouette visual_hull body_segmentation pose_tree pose_fitting virtual_studio usb_cameras)
file(GLOB_RECURSE node_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/nodes/*.cpp)
list(FILTER node_sources EXCLUDE REGEX "_main\\.cpp$")
set(host_sources ${PROJECT_SOURCE_DIR}/src/nodes/common/stage_host.cpp
  ${PROJECT_SOURCE_DIR}/src/nodes/common/master_watch.cpp)
list(REMOVE_ITEM node_sources ${host_sources})
add_library(markerless_mocap_nodelets SHARED ${node_sources})
target_include_directories(markerless_mocap_nodelets PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(markerless_mocap_nodelets PUBLIC mocap_ros mocap_pipeline mocap_capture
  mocap_evaluation opencv_videoio)
mocap_use_ros(markerless_mocap_nodelets)
add_library(mocap_stage_host STATIC ${host_sources})
target_include_directories(mocap_stage_host PUBLIC ${PROJECT_SOURCE_DIR}/src)
mocap_use_ros(mocap_stage_host)
foreach(stage ${stages})
  add_executable(${stage}_host src/nodes/host_main.cpp)
  target_link_libraries(${stage}_host PUBLIC mocap_stage_host)
  set_target_properties(${stage}_host PROPERTIES OUTPUT_NAME ${stage})
  target_compile_definitions(${stage}_host PRIVATE MOCAP_NODELET="${PROJECT_NAME}/${stage}"
    MOCAP_NODE="${stage}")
  mocap_use_ros(${stage}_host)
  list(APPEND programs ${stage}_host)
endforeach()
add_executable(all_stages_host src/nodes/all_stages_main.cpp)
set_target_properties(all_stages_host PROPERTIES OUTPUT_NAME all_stages)
target_link_libraries(all_stages_host PUBLIC mocap_stage_host)
mocap_use_ros(all_stages_host)
list(APPEND programs all_stages_host)
set(stage_programs ${programs})

# One program per src/<room>/<folder>/<program>_main.cpp. What users run lies in tools; studies are
# for those who work on the methods and are not installed.
function(mocap_programs room)
  mocap_targets(library ${room})
  file(GLOB_RECURSE mains CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${room}/*_main.cpp)
  set(names "")
  foreach(main ${mains})
    get_filename_component(name ${main} NAME_WE)
    string(REGEX REPLACE "_main$" "" name ${name})
    add_executable(${name} ${main})
    target_link_libraries(${name} PRIVATE ${library} CLI11::CLI11)
    list(APPEND names ${name})
  endforeach()
  set(room_programs ${names} PARENT_SCOPE)
endfunction()

# Each folder of tools is a room of its own, so that one program builds without what others need.
mocap_room(tools/common DEPENDS ros pipeline capture evaluation exports pages
  LIBRARIES nlohmann_json::nlohmann_json opencv_calib3d opencv_imgcodecs opencv_videoio)
set(tools "")
function(mocap_tool folder)
  mocap_room(tools/${folder} DEPENDS tools/common ${ARGN})
  mocap_programs(tools/${folder})
  set(tools ${tools} tools/${folder} PARENT_SCOPE)
  set(programs ${programs} ${room_programs} PARENT_SCOPE)
endfunction()
mocap_tool(calibrate_rig calibration formats)
mocap_tool(check checks calibration)
mocap_tool(convert_calibration formats)
mocap_tool(describe_motion)
mocap_tool(describe_options)
mocap_tool(evaluate)
mocap_tool(export_hull clouds)
mocap_tool(export_motion)
mocap_tool(human_urdf)
mocap_tool(import checks formats)
mocap_tool(join_results)
mocap_tool(make_board calibration)
mocap_tool(offline)
mocap_tool(render)
mocap_room(studies DEPENDS ${tools})
mocap_programs(studies)
if(MARKERLESS_MOCAP_TESTS)
  mocap_targets(libraries ${tools})
  mocap_room_tests(tools ${libraries})
endif()

# What scripts/demo shows.
add_custom_target(demo_programs
  DEPENDS markerless_mocap_nodelets ${stage_programs} mocap_offline ${PROJECT_NAME}_generate_messages)

install(TARGETS ${programs} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(TARGETS markerless_mocap_nodelets LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(FILES nodelets.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
catkin_install_python(PROGRAMS scripts/hosts_launch DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(DIRECTORY config launch models rviz urdf DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})

if(MARKERLESS_MOCAP_TESTS)
  mocap_room_tests(nodes markerless_mocap_nodelets)
endif()
if(MARKERLESS_MOCAP_TESTS AND CATKIN_ENABLE_TESTING)
  find_package(rostest REQUIRED)
  file(GLOB node_tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/nodes/*.test)
  foreach(test ${node_tests})
    add_rostest(${test})
  endforeach()
  # Network namespaces where they are allowed; skipped elsewhere.
  add_test(NAME hosts_launch COMMAND ${CATKIN_DEVEL_PREFIX}/env.sh
    ${PYTHON_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/network/hosts_launch_test.py)
  add_test(NAME network COMMAND ${CATKIN_DEVEL_PREFIX}/env.sh ${PYTHON_EXECUTABLE}
    ${PROJECT_SOURCE_DIR}/test/network/network_test.py
    ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION})
  add_test(NAME binding COMMAND ${CATKIN_DEVEL_PREFIX}/env.sh ${PYTHON_EXECUTABLE}
    ${PROJECT_SOURCE_DIR}/test/network/binding_test.py
    ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION})
  set_tests_properties(network binding PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 240)
endif()

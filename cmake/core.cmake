# The ROS-free rooms. DEPENDS are the arrows of docs/architecture.md; scripts/check_arrows holds the
# includes to them.
include(cmake/resources.cmake)
mocap_resource(humanUrdfTemplate urdf/human.urdf.in)
mocap_resource(contourBodyYaml models/contour_body.yaml)
mocap_resource(motionStatisticsYaml models/motion_statistics.yaml)
mocap_resource(poseTreeExtremitiesYaml models/pose_tree_extremities.yaml)
mocap_resource(poseTreeValidityYaml models/pose_tree_validity.yaml)
mocap_room(resources SOURCES ${MOCAP_RESOURCE_SOURCES})

mocap_room(text)
mocap_room(options DEPENDS text LIBRARIES Eigen3::Eigen yaml-cpp)
mocap_room(numerics LIBRARIES Eigen3::Eigen)
mocap_room(files DEPENDS text LIBRARIES yaml-cpp $<LINK_ONLY:tinyxml2::tinyxml2>)
mocap_room(camera DEPENDS files numerics text LIBRARIES Eigen3::Eigen yaml-cpp)
mocap_room(formats DEPENDS camera files numerics text LIBRARIES opencv_core tinyxml2::tinyxml2 TESTS_USE capture)
mocap_room(calibration DEPENDS camera files numerics options text
  LIBRARIES Ceres::ceres opencv_aruco opencv_calib3d opencv_core opencv_imgproc TBB::tbb
  TESTS_USE capture)
mocap_room(body DEPENDS files numerics LIBRARIES Eigen3::Eigen $<LINK_ONLY:tinyxml2::tinyxml2> urdfdom_model)
mocap_room(products LIBRARIES Eigen3::Eigen opencv_core)
mocap_room(silhouette DEPENDS files numerics options products
  LIBRARIES opencv_core opencv_dnn opencv_imgproc opencv_objdetect opencv_video TBB::tbb)
mocap_room(hull DEPENDS camera numerics options products LIBRARIES opencv_core TBB::tbb)
mocap_room(skeleton DEPENDS files numerics options products resources LIBRARIES TBB::tbb TESTS_USE hull)
mocap_room(segmentation DEPENDS numerics options products LIBRARIES TBB::tbb TESTS_USE hull)
mocap_room(optimisation DEPENDS numerics LIBRARIES Eigen3::Eigen TBB::tbb)

mocap_room(tracking DEPENDS body camera files options products resources LIBRARIES opencv_core opencv_imgproc)
mocap_room(region DEPENDS tracking body camera numerics products
  LIBRARIES Eigen3::Eigen opencv_core opencv_imgproc TBB::tbb TESTS_USE evaluation)
mocap_room(contour DEPENDS tracking numerics region LIBRARIES opencv_core opencv_imgproc TBB::tbb
  TESTS_USE capture)
# Square roots and divisions in vectors; no value changes.
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/contour/fit/ray_match.cpp PROPERTIES
  COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math")
mocap_room(hsiao DEPENDS tracking optimisation LIBRARIES TBB::tbb)
mocap_room(fleischmann DEPENDS tracking optimisation LIBRARIES opencv_core opencv_imgproc TBB::tbb
  TESTS_USE evaluation)
mocap_room(checks DEPENDS camera numerics products LIBRARIES opencv_calib3d opencv_core opencv_imgproc opencv_video
  TESTS_USE capture)
mocap_room(pipeline DEPENDS silhouette hull skeleton segmentation contour hsiao fleischmann
  TESTS_USE evaluation)

mocap_room(motion DEPENDS files numerics text LIBRARIES Eigen3::Eigen yaml-cpp)
mocap_room(character DEPENDS motion numerics options
  LIBRARIES opencv_core opencv_imgcodecs TBB::tbb assimp::assimp nlohmann_json::nlohmann_json)
mocap_room(capture DEPENDS character body camera numerics options
  LIBRARIES opencv_core opencv_imgproc TBB::tbb)
mocap_room(evaluation DEPENDS body camera numerics LIBRARIES opencv_core opencv_imgproc)
mocap_room(exports DEPENDS body character evaluation files motion numerics text
  LIBRARIES nlohmann_json::nlohmann_json TESTS_USE capture)

# templates/ and Debian's three.js are built in, so that a page needs nothing else.
set(MOCAP_RESOURCE_SOURCES "")
find_path(THREE_JS three.min.js PATHS /usr/share/javascript/three REQUIRED)
foreach(resource "pageHtml templates/page.html" "pageStyle templates/page.css"
    "pagePartsJs templates/parts.js" "pagePlayerJs templates/player.js"
    "threeJs ${THREE_JS}/three.min.js"
    "orbitControlsJs ${THREE_JS}/examples/js/controls/OrbitControls.js")
  separate_arguments(resource)
  mocap_resource(${resource} pages/page_resources.h)
endforeach()
mocap_room(pages DEPENDS products LIBRARIES nlohmann_json::nlohmann_json opencv_core opencv_imgcodecs
  SOURCES ${MOCAP_RESOURCE_SOURCES})

# Pictures to joints, over all rooms.
if(MARKERLESS_MOCAP_TESTS)
  mocap_room_tests(accuracy mocap_pipeline mocap_capture mocap_evaluation mocap_calibration)
endif()

# The ROS-free rooms. DEPENDS are the arrows of docs/architecture.md; scripts/check_arrows holds the
# includes to them.
mocap_room(options LIBRARIES Eigen3::Eigen yaml-cpp)
mocap_room(camera LIBRARIES Eigen3::Eigen yaml-cpp)
mocap_room(silhouette DEPENDS options LIBRARIES opencv_core opencv_video)
mocap_room(hull DEPENDS camera options LIBRARIES opencv_core TBB::tbb)
mocap_room(skeleton DEPENDS hull options LIBRARIES TBB::tbb)
mocap_room(segmentation DEPENDS hull options LIBRARIES TBB::tbb)
mocap_room(body LIBRARIES Eigen3::Eigen urdfdom_model)
mocap_room(optimisation DEPENDS options LIBRARIES Eigen3::Eigen TBB::tbb)
mocap_room(appearance DEPENDS body camera options LIBRARIES opencv_core opencv_imgproc TBB::tbb)
mocap_room(contour DEPENDS body camera options LIBRARIES opencv_core opencv_imgproc TBB::tbb)
# Square roots and divisions in vectors; no value changes.
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/contour/ray_match.cpp PROPERTIES
  COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math")
mocap_room(fitting DEPENDS optimisation appearance contour body hull skeleton segmentation options
  LIBRARIES TBB::tbb)
mocap_room(motion LIBRARIES Eigen3::Eigen yaml-cpp)
mocap_room(character DEPENDS motion options LIBRARIES opencv_core opencv_imgcodecs TBB::tbb assimp::assimp)
mocap_room(capture DEPENDS character body camera options LIBRARIES opencv_core opencv_imgproc TBB::tbb)
mocap_room(evaluation DEPENDS body camera LIBRARIES opencv_core opencv_imgproc)
mocap_room(pipeline DEPENDS silhouette hull skeleton segmentation fitting)

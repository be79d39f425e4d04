#include <nodelet/loader.h>
#include <ros/ros.h>

// Runs all stages named on the command line in one process, so that messages are passed without
// copies. A nodelet manager is no alternative: the processes that loaded its nodelets unload them,
// and a manager that is stopped together with those processes can crash.
int main(int argc, char** argv) {
  ros::init(argc, argv, "mocap");
  if (argc < 2) {
    ROS_FATAL("mocap: no stage is given, allowed are names such as silhouette visual_hull");
    return 1;
  }
  nodelet::Loader loader(false);
  for (int i = 1; i < argc; ++i) {
    const std::string stage = argv[i];
    if (!loader.load(ros::names::resolve(stage), "markerless_mocap/" + stage,
                     ros::names::getRemappings(), {}))
      return 1;
  }
  ros::spin();
  return 0;
}

#include <nodelet/loader.h>
#include <ros/ros.h>

// A process of its own for one nodelet: the node has the stage's name and returns 1 if the nodelet
// refuses its parameters.
int main(int argc, char** argv) {
  ros::init(argc, argv, MOCAP_NODE);
  nodelet::Loader loader;
  const nodelet::V_string arguments(argv + 1, argv + argc);
  if (!loader.load(ros::this_node::getName(), MOCAP_NODELET, ros::names::getRemappings(),
                   arguments))
    return 1;
  ros::spin();
  return 0;
}

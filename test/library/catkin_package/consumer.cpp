// The library and the messages in one source: prints the angles of a message that names all joints.
#include <iostream>

#include "markerless_mocap/pipeline/make_body_tracker.h"
#include "markerless_mocap/ros/messages.h"

int main() {
  using namespace markerless_mocap;
  const auto body = initialBody(PersonResources::standard(), 1.75);
  BodyPoseMsg message;
  message.status = BodyPoseMsg::LOST;
  std::cout << body->model->angleCount() << " angles, status " << int(message.status) << '\n';
}

#include "motion/bvh.h"

#include <cctype>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "files/text_file.h"
#include "motion/bvh/bvh_text.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMaxJoints = 2000;
constexpr double kRadiansPerDegree = 0.017453292519943295;

BvhChannel channelOf(const BvhText& text, const std::string& word) {
  std::string lower;
  for (unsigned char c : word) lower += char(tolower(c));
  const bool rotates = lower.size() > 1 && lower.substr(1) == "rotation";
  const bool moves = lower.size() > 1 && lower.substr(1) == "position";
  if ((!rotates && !moves) || lower[0] < 'x' || lower[0] > 'z')
    text.fail("unknown channel \"" + word +
              "\", allowed are Xposition, Yposition, Zposition, Xrotation, Yrotation, Zrotation");
  return {lower[0] - 'x', rotates};
}

void readChannels(BvhText& text, BvhJoint& joint) {
  const int count = text.takeCount("the number of channels of " + joint.name);
  if (count > 6)
    text.fail(joint.name + " has " + std::to_string(count) + " channels, allowed are 0 to 6");
  for (int i = 0; i < count; ++i)
    joint.channels.push_back(channelOf(text, text.take("a channel of " + joint.name)));
}

void readOffset(BvhText& text, BvhJoint& joint) {
  for (int axis = 0; axis < 3; ++axis)
    joint.offset[axis] = text.takeNumber("the offset of " + joint.name);
}

/// Reads from the joint's opening brace to its closing one, with its children.
void readBlock(BvhText& text, std::vector<BvhJoint>& joints, size_t self);

void readChild(BvhText& text, std::vector<BvhJoint>& joints, size_t parent, bool is_end) {
  if (joints.size() >= kMaxJoints)
    text.fail("the file has more than the " + std::to_string(kMaxJoints) + " joints allowed");
  BvhJoint child;
  if (is_end) {
    // Some programs give the site a name, some omit "Site".
    if (text.peek() != "{") text.takeName("End Site");
    child.name = joints[parent].name + " end";
  } else {
    child.name = text.takeName("JOINT");
  }
  child.is_end = is_end;
  child.parent = int(parent);
  joints.push_back(child);
  readBlock(text, joints, joints.size() - 1);
}

void readBlock(BvhText& text, std::vector<BvhJoint>& joints, size_t self) {
  text.require("{", "after " + joints[self].name);
  while (!text.skipIf("}")) {
    const bool is_end = joints[self].is_end;
    const std::string word = text.take("the \"}\" of " + joints[self].name);
    const auto is = [&](const char* other) { return strcasecmp(word.c_str(), other) == 0; };
    if (is("OFFSET")) {
      readOffset(text, joints[self]);
    } else if (is("CHANNELS") && !is_end) {
      readChannels(text, joints[self]);
    } else if (is("JOINT") && !is_end) {
      readChild(text, joints, self, false);
    } else if (is("End") && !is_end) {
      readChild(text, joints, self, true);
    } else {
      text.fail("\"" + word + "\" stands in " + joints[self].name +
                ", allowed are OFFSET, CHANNELS, JOINT, End Site and \"}\"");
    }
  }
}

void readHierarchy(BvhText& text, BvhMotion& motion) {
  if (!text.skipIf("HIERARCHY"))
    text.failAt(1, "this is not a BVH file, which begins with HIERARCHY");
  if (!text.skipIf("ROOT"))
    text.fail("no ROOT after HIERARCHY, a BVH file's skeleton begins with one");
  BvhJoint root;
  root.name = text.takeName("ROOT");
  motion.joints.push_back(root);
  readBlock(text, motion.joints, 0);
  if (text.nextIs("ROOT")) {
    text.take("ROOT");
    text.fail("a second ROOT, allowed is one skeleton per file");
  }
}

size_t channelCount(const std::vector<BvhJoint>& joints) {
  size_t count = 0;
  for (const BvhJoint& joint : joints) count += joint.channels.size();
  return count;
}

void skipKey(BvhText& text, const std::string& key) {
  text.require(key, "in MOTION");
  text.require(":", "after " + key);
}

void readMotion(BvhText& text, BvhMotion& motion) {
  text.require("MOTION", "after the hierarchy");
  skipKey(text, "Frames");
  const int frames = text.takeCount("the number of frames");
  if (frames == 0) text.fail("the file has no frames, at least one is needed");
  text.require("Frame", "Time: after Frames:");
  skipKey(text, "Time");
  motion.frame_time = text.takeNumber("the frame time");
  if (motion.frame_time <= 0.0)
    text.fail("the frame time is " + std::to_string(motion.frame_time) +
              " s, allowed is more than 0");
  const size_t channels = channelCount(motion.joints);
  if (channels == 0) text.fail("no joint has channels, so nothing can move");
  const size_t lines = text.linesLeft();
  if (lines != size_t(frames))
    text.fail("Frames: tells " + std::to_string(frames) + ", the file has " +
              std::to_string(lines) + " lines of them");
  motion.frames.reserve(lines);
  for (size_t f = 0; f < lines; ++f) motion.frames.push_back(text.takeFrame(f, channels));
}

/// Some programs store displacements in joints below the root, see BvhJoint::positions_displace.
void findDisplacements(BvhMotion& motion) {
  size_t column = 0;
  for (BvhJoint& joint : motion.joints) {
    const double about_zero = 0.01 * joint.offset.norm();
    bool places = false, all_zero = true;
    for (const BvhChannel& channel : joint.channels) {
      if (!channel.rotates) {
        places = true;
        for (const std::vector<double>& frame : motion.frames)
          all_zero = all_zero && std::abs(frame[column]) <= about_zero;
      }
      ++column;
    }
    joint.positions_displace = places && all_zero && joint.parent >= 0;
  }
}

BvhPose poseOf(const std::vector<BvhJoint>& joints, const std::vector<double>* values) {
  BvhPose pose;
  size_t column = 0;
  for (const BvhJoint& joint : joints) {
    Eigen::Vector3d place = joint.offset;
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    for (const BvhChannel& channel : joint.channels) {
      if (!values) break;
      const double value = (*values)[column++];
      if (channel.rotates)
        turn = turn *
               Eigen::AngleAxisd(value * kRadiansPerDegree, Eigen::Vector3d::Unit(channel.axis));
      else
        place[channel.axis] = value + (joint.positions_displace ? joint.offset[channel.axis] : 0.0);
    }
    if (joint.parent < 0) {
      pose.R_world_joint.push_back(turn);
      pose.positions.push_back(place);
      continue;
    }
    const Eigen::Quaterniond parent = pose.R_world_joint[size_t(joint.parent)];
    const Eigen::Vector3d origin = pose.positions[size_t(joint.parent)];
    pose.R_world_joint.push_back((parent * turn).normalized());
    pose.positions.push_back(origin + parent * place);
  }
  return pose;
}

}  // namespace

BvhPose BvhMotion::pose(size_t frame) const {
  return poseOf(joints, &frames.at(frame));
}

BvhPose BvhMotion::rest() const {
  return poseOf(joints, nullptr);
}

BvhMotion readBvh(std::istream& stream, const std::string& name) {
  BvhText text(stream, name);
  BvhMotion motion;
  readHierarchy(text, motion);
  readMotion(text, motion);
  findDisplacements(motion);
  return motion;
}

BvhMotion readBvh(const std::string& path) {
  constexpr uintmax_t kMaxBytes = 1u << 30;  // hours of motion
  try {
    checkRegularFile(path, "the BVH file " + path, kMaxBytes);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
  std::ifstream file(path);
  if (!file) throw std::invalid_argument("cannot read the BVH file " + path);
  return readBvh(file, path);
}

}  // namespace markerless_mocap

#pragma once

#include <unistd.h>
#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "capture/studio_fixture.h"
#include "capture/virtual_studio.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// Angles of a posture, degrees. Trunk: the pelvis leans forward, then turns about the spine. Limbs
/// of each side (left, right): forward from hanging, relative to the world for thighs and shanks,
/// relative to the trunk for arms.
struct StudioPosture {
  const char* name;
  double lean, turn;
  double thigh[2], shank[2];  ///< of the upright trunk's frame before `lean` and `turn`
  double arm[2], elbow[2], outward;
  bool limbs_lie_with_trunk;  ///< legs turn with the pelvis
};

/// The person of the virtual studio in one posture: a skinned mesh, no body of the tracker's.
class PosedPerson {
 public:
  static constexpr double kStature = 1.72;  ///< metres

  /// \param heading degrees to the left of +x
  PosedPerson(const StudioPosture& posture, double heading, const char* rig)
      : skeleton_(HumanSkeleton::adult(kStature, 0.8)),
        studio_(options(posture, heading, rig), packageFiles(), "person1"),
        filmed_(studio_.render(1)) {}

  /// Goes on to a later instant: the person breathes and sways a little.
  void go(int frame) { filmed_ = studio_.render(frame); }

  const CameraRig& rig() const { return studio_.rig(); }
  const std::vector<cv::Mat>& masks() const { return filmed_.masks; }
  const std::vector<cv::Mat>& images() const { return filmed_.images; }
  /// The fifteen of markerNames(), world, metres.
  Eigen::Matrix3Xd joints() const {
    Eigen::Matrix3Xd joints(3, 15);
    for (Eigen::Index i = 0; i < 15; ++i) joints.col(i) = filmed_.points[size_t(i)];
    return joints;
  }

 private:
  static constexpr int kFrames = 40;    // one sway
  static constexpr double kSway = 1.5;  // degrees
  using Turns = PerBone<Eigen::Quaterniond>;

  static Eigen::Quaterniond about(int axis, double degrees) {
    return Eigen::Quaterniond(
        Eigen::AngleAxisd(degrees * M_PI / 180.0, Eigen::Vector3d::Unit(axis)));
  }

  /// Rotation of each bone in the world.
  /// \param sway of trunk and arms, degrees
  static Turns turnsOf(const StudioPosture& p, double heading, double sway) {
    const Eigen::Quaterniond level = about(2, heading);
    const Eigen::Quaterniond trunk = level * about(1, p.lean + sway) * about(2, p.turn);
    const Eigen::Quaterniond legs = p.limbs_lie_with_trunk ? trunk : level;
    Turns turns;
    turns.fill(trunk);
    for (int side = 0; side < 2; ++side) {
      const int first = side ? int(Bone::kRightClavicle) : int(Bone::kLeftClavicle);
      const int sign = side ? 1 : -1;
      const Eigen::Quaterniond out = about(0, -sign * p.outward), down = about(0, sign * 90.0);
      turns[size_t(first + 1)] = trunk * about(1, -p.arm[side]) * out * down;
      turns[size_t(first + 2)] = turns[size_t(first + 3)] =
          trunk * about(1, -p.arm[side] - p.elbow[side]) * out * down;
      turns[size_t(first + 4)] = legs * about(1, -p.thigh[side]) * about(0, -sign * 6.0);
      for (int i : {5, 6, 7})
        turns[size_t(first + i)] = legs * about(1, -p.shank[side]) * about(0, -sign * 3.0);
    }
    return turns;
  }

  static const char* jointName(Bone bone) {
    static const char* const kNames[kBoneCount] = {
        "Hips",        "Spine",       "Chest",       "Neck",         "Head",      "LeftCollar",
        "LeftArm",     "LeftForeArm", "LeftHand",    "LeftUpLeg",    "LeftLeg",   "LeftFoot",
        "LeftToeBase", "RightCollar", "RightArm",    "RightForeArm", "RightHand", "RightUpLeg",
        "RightLeg",    "RightFoot",   "RightToeBase"};
    return kNames[int(bone)];
  }

  static void writeJoint(const HumanSkeleton& skeleton, Bone bone, std::ostream& out,
                         std::vector<Bone>& order) {
    order.push_back(bone);
    const bool root = bone == Bone::kHips;
    const Eigen::Vector3d at =
        skeleton.headOf(bone) - (root ? Eigen::Vector3d(0, 0, 0) : skeleton.headOf(parentOf(bone)));
    out << (root ? "ROOT " : "JOINT ") << jointName(bone) << "\n{\nOFFSET " << at.transpose()
        << "\nCHANNELS " << (root ? "6 Xposition Yposition Zposition " : "3 ")
        << "Zrotation Yrotation Xrotation\n";
    bool leaf = true;
    for (int i = 1; i < kBoneCount; ++i)
      if (parentOf(Bone(i)) == bone) {
        writeJoint(skeleton, Bone(i), out, order);
        leaf = false;
      }
    if (leaf)
      out << "End Site\n{\nOFFSET " << (skeleton.tailOf(bone) - skeleton.headOf(bone)).transpose()
          << "\n}\n";
    out << "}\n";
  }

  /// Writes the posture as a BVH file and returns its path. The file is that of a person of the
  /// same skeleton, so that nothing changes when it is put on.
  static std::string written(const StudioPosture& posture, double heading) {
    const auto path =
        std::filesystem::temp_directory_path() / ("posture_" + std::to_string(getpid()) + ".bvh");
    std::ofstream out(path);
    const HumanSkeleton skeleton = HumanSkeleton::adult(kStature, 0.8);
    std::vector<Bone> order;
    out << "HIERARCHY\n";
    writeJoint(skeleton, Bone::kHips, out, order);
    out << "MOTION\nFrames: " << kFrames << "\nFrame Time: 0.05\n";
    for (int frame = 0; frame < kFrames; ++frame) {
      const Turns turns = turnsOf(posture, heading, kSway * std::sin(2.0 * M_PI * frame / kFrames));
      out << skeleton.headOf(Bone::kHips).transpose();
      for (const Bone bone : order) {
        const Eigen::Quaterniond local =
            bone == Bone::kHips ? turns[0]
                                : turns[size_t(parentOf(bone))].conjugate() * turns[size_t(bone)];
        const Eigen::Vector3d angles = local.toRotationMatrix().eulerAngles(2, 1, 0) * 180.0 / M_PI;
        out << ' ' << angles.transpose();
      }
      out << '\n';
    }
    return path.string();
  }

  static StudioOptions options(const StudioPosture& posture, double heading, const char* rig) {
    StudioOptions options;
    options.motion = written(posture, heading);
    options.rig = rig;
    options.width = 320;
    options.height = 240;
    options.fps = 20;
    options.background_frames = 0;
    options.character.stature = kStature;
    options.character.male = 0.8;
    return options;
  }

  HumanSkeleton skeleton_;
  VirtualStudio studio_;
  StudioFrameSet filmed_;
};

/// A box in the world: the middle of its base, metres, and its size along its own axes.
struct StudioBox {
  Eigen::Vector3d base, size;
};

/// Adds a box to the masks, turned by `heading` radians about the world's z axis at the origin.
inline void paintBox(const StudioBox& box, double heading, const CameraRig& rig,
                     std::vector<cv::Mat>& masks) {
  const Eigen::AngleAxisd turn(heading, Eigen::Vector3d::UnitZ());
  for (size_t v = 0; v < rig.size(); ++v) {
    std::vector<cv::Point2f> corners;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d at = box.base + Eigen::Vector3d((i & 1 ? 0.5 : -0.5) * box.size.x(),
                                                            (i & 2 ? 0.5 : -0.5) * box.size.y(),
                                                            i & 4 ? box.size.z() : 0.0);
      if (const auto pixel = rig[v].project(turn * at))
        corners.emplace_back(float(pixel->x()), float(pixel->y()));
    }
    if (corners.size() < 8) continue;
    std::vector<cv::Point2f> around;
    cv::convexHull(corners, around);
    std::vector<cv::Point> pixels;
    for (const cv::Point2f& p : around) pixels.emplace_back(cvRound(p.x), cvRound(p.y));
    cv::fillConvexPoly(masks[v], pixels, cv::Scalar(255));
  }
}

/// A chair whose seat's middle is above `at`, with its back away from the heading, radians.
inline std::vector<StudioBox> chairAt(const Eigen::Vector3d& at) {
  constexpr double kSeat = 0.42, kHalf = 0.2, kLeg = 0.035;
  std::vector<StudioBox> chair{{at + Eigen::Vector3d(0, 0, kSeat - 0.04), {0.42, 0.42, 0.04}},
                               {at + Eigen::Vector3d(-0.21, 0, kSeat), {0.03, 0.42, 0.42}}};
  for (const double x : {-kHalf, kHalf})
    for (const double y : {-kHalf, kHalf})
      chair.push_back({at + Eigen::Vector3d(x, y, 0), {kLeg, kLeg, kSeat}});
  return chair;
}

}  // namespace markerless_mocap

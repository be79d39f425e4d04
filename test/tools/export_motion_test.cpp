#include "tools/export_motion/export_motion.h"

#include <cstdlib>
#include <map>
#include <sstream>

#include "motion/bvh.h"
#include "tools/evaluation_fixture.h"

namespace markerless_mocap {
namespace {

class ExportMotion : public EvaluationTest {
 protected:
  ExportMotion() {
    what_.input = request_.results;
    what_.output = path("out.csv");
  }
  std::string notes() {
    std::ostringstream out;
    exportMotion(what_, out);
    return out.str();
  }
  std::string refusal() {
    return errorTextOf<std::exception>([&] { notes(); });
  }
  MotionExportOptions what_;
};

TEST_F(ExportMotion, EveryFormatIsWrittenWithoutARemarkIfAllIsSeen) {
  writeResults(nothing);
  for (const char* name : {"a.bvh", "a.glb", "a.trc", "a.c3d", "a.mot", "a.csv"}) {
    what_.output = path(name);
    writeText(std::string(name) + ".gaps.csv", "of an earlier file");
    EXPECT_EQ(notes(), "") << name;
    EXPECT_GT(bytesOf(name).size(), 1000u) << name;
    EXPECT_FALSE(std::filesystem::exists(path(std::string(name) + ".gaps.csv")));
  }
  EXPECT_EQ(readBvh(path("a.bvh")).frames.size(), size_t(kFrames));
  EXPECT_FALSE(hasUnfinished());
}

TEST_F(ExportMotion, GapsAreToldInTheFileOrBesideIt) {
  writeResults([](int frame, BodyPose* pose) {
    if (frame < 2 || frame == kFrames - 1) pose->status = PoseStatus::kLost;
    if (frame >= 10 && frame < 13) pose->part_seen[size_t(PartLabel::kArm1)] = false;
  });
  what_.output = path("a.bvh");
  EXPECT_EQ(notes(),
            "the file begins at the first pose, 0.080 s after the first frame of the results\n"
            "joints are not seen in 4 stretches; there they keep their last rotation: see "
            "--fill\n");
  EXPECT_EQ(readBvh(what_.output).frames.size(), size_t(kFrames) - 3);
  EXPECT_NE(bytesOf("a.bvh.gaps.csv").find("LeftForeArm,0.320000,0.400000,not seen\n"),
            std::string::npos);
  what_.fill_ms = 200;
  notes();
  EXPECT_NE(bytesOf("a.bvh.gaps.csv").find("LeftForeArm,0.320000,0.400000,filled\n"),
            std::string::npos);
  std::filesystem::create_directories(path("folder.bvh"));
  what_.output = path("folder.bvh");
  EXPECT_EQ(refusal(),
            "cannot write " + what_.output + ": it is a folder, pipe or device, allowed are files");
  EXPECT_FALSE(std::filesystem::exists(path("folder.bvh.gaps.csv")));
}

TEST_F(ExportMotion, BadCallsAreRefusedAndLeaveNothing) {
  writeResults(nothing);
  const auto refused = [&](auto change) {
    const MotionExportOptions before = what_;
    change(what_);
    const std::string text = refusal();
    what_ = before;
    return text;
  };
  using Options = MotionExportOptions;
  EXPECT_EQ(refused([](Options& w) { w.output = "walk.fbx"; }),
            "output is walk.fbx, allowed are names that end in .bvh, .glb, .trc, .c3d, .mot, .csv");
  EXPECT_EQ(refused([](Options& w) { w.names = "kinect"; }),
            "there are no names kinect, allowed are package, motionbuilder, opensim, h36m, smpl, "
            "coco");
  EXPECT_EQ(refused([](Options& w) {
              w.joints = {"l_elbo"};
            }).find("there is no joint l_elbo, allowed are pelvis, waist, "),
            0u);
  EXPECT_EQ(
      refused([&](Options& w) { w.output = path("no/such/a.csv"); }),
      "cannot write " + path("no/such/a.csv") + ": its folder is missing or may not be written");
  EXPECT_EQ(refused([&](Options& w) { w.output = path("a.mot"), w.names = "coco"; }),
            "--names does not apply to .mot files");
  EXPECT_EQ(refused([&](Options& w) { w.output = path("a.bvh"), w.angles = true; }),
            "--angles does not apply to .bvh files");
  EXPECT_EQ(refused([](Options& w) { w.input = "none.bag"; }), "there is no bag none.bag");
  EXPECT_EQ(refused([](Options& w) { w.body_id = "person7"; }),
            what_.input + " has no body person7, it has person1");
  std::filesystem::create_directory(path("folder.csv"));
  EXPECT_EQ(
      refused([&](Options& w) { w.output = path("folder.csv"); }),
      "cannot write " + path("folder.csv") + ": it is a folder, pipe or device, allowed are files");
  EXPECT_FALSE(std::filesystem::exists(path("out.csv")));
  EXPECT_FALSE(hasUnfinished());
}

TEST_F(ExportMotion, ResultsWithoutPosesAreTold) {
  writeResults([](int, BodyPose* pose) { pose->status = PoseStatus::kLost; });
  EXPECT_EQ(refusal(), what_.input + ": no frame has a pose");
  BagWriter(what_.input).commit();
  EXPECT_EQ(refusal(), what_.input + " has no results: neither a frame body_<id> in tf nor /pose");
}

TEST_F(ExportMotion, SecondPersonIsAskedFor) {
  BagWriter bag(what_.input);
  for (const char* id : {"anna", "ben"}) {
    const BodyModel model = BodyModel::fromUrdf(
        fillUrdfTemplate(humanTemplate(), id, BodyProportions::fromStature(1.75)), id);
    ResultWriter writer(&bag, model, "world");
    PipelineResult result;
    result.pose = poseOf(0);
    writer.write(stampOf(0), result);
  }
  bag.commit();
  EXPECT_EQ(refusal(), what_.input + " has several bodies, anna, ben: choose one by --id");
  what_.body_id = "ben";
  EXPECT_EQ(refusal(), what_.input +
                           " has no URDF of the body ben: give it by --urdf (rosparam get "
                           "/human_description_ben prints it while the nodes run)");
  what_.urdf = path("ben.urdf");
  writeText("ben.urdf", "no XML");
  EXPECT_EQ(refusal().find("--urdf: URDF of the body: "), 0u) << refusal();
  writeText("ben.urdf",
            fillUrdfTemplate(humanTemplate(), "ben", BodyProportions::fromStature(1.75)));
  EXPECT_EQ(notes(), "");
}

/// Bones by frame and name, in Blender's axes: z up, a person who faces the world's x faces -y. The
/// rotation is the one from rest.
using Bones = std::map<std::pair<int, std::string>, Eigen::Isometry3d>;

Bones blenderBones(const std::string& table) {
  Bones out;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::vector<std::string> row;
    for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
    const auto number = [&](size_t i) { return std::stod(row.at(i)); };
    Eigen::Isometry3d bone(
        Eigen::Quaterniond(number(5), number(6), number(7), number(8)).normalized());
    bone.pretranslate(Eigen::Vector3d(number(2), number(3), number(4)));
    out[{std::stoi(row.at(0)), row.at(1)}] = bone;
  }
  return out;
}

constexpr std::pair<const char*, const char*> kBones[] = {
    {"Hips", "body"},           {"Spine", "r_waist"},
    {"Spine1", "torso"},        {"Neck", "p_head"},
    {"Head", "head"},           {"LeftShoulder", "l_r_clavicle"},
    {"LeftArm", "l_shoulder"},  {"LeftForeArm", "l_elbow"},
    {"LeftHand", "l_wrist"},    {"RightShoulder", "r_r_clavicle"},
    {"RightArm", "r_shoulder"}, {"RightForeArm", "r_elbow"},
    {"RightHand", "r_wrist"},   {"LeftUpLeg", "l_hip"},
    {"LeftLeg", "l_knee"},      {"LeftFoot", "l_ankle"},
    {"RightUpLeg", "r_hip"},    {"RightLeg", "r_knee"},
    {"RightFoot", "r_ankle"}};

class Blender : public ExportMotion, public ::testing::WithParamInterface<const char*> {
 protected:
  Bones imported(const std::string& file) {
    const std::string command =
        "blender -b --factory-startup --python-exit-code 1 -P " MOCAP_SOURCE_DIR
        "/test/tools/blender_joints.py -- " +
        file + " " + path("bones.csv") + " 0.04 " + std::to_string(kFrames) + " >" +
        path("blender.log") + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << bytesOf("blender.log");
    return blenderBones(bytesOf("bones.csv"));
  }
  /// Links at rest: the zero pose with the arms out to the sides.
  LinkPoses rest() const {
    BodyPose pose = poseOf(0);
    pose.T_world_body.setIdentity();
    pose.angles.setZero();
    for (const char* joint : {"l_p_shoulder", "r_p_shoulder"})
      pose.angles[model_.angleIndex(joint)] = M_PI_2;
    return linksOf(pose);
  }
};

TEST_P(Blender, ImportsEveryJointAtEveryFrame) {
  if (std::system("command -v blender >/dev/null") != 0)
    GTEST_SKIP() << "Blender is not installed: apt-get install blender";
  writeResults(nothing);
  what_.output = path(GetParam());
  notes();
  const Bones bones = imported(what_.output);
  ASSERT_EQ(bones.size(), size_t(kFrames) * std::size(kBones));
  const double unit = what_.output.back() == 'h' ? 0.01 : 1.0;  // centimetres, metres
  const Eigen::Matrix3d axes = (Eigen::Matrix3d() << 0, 1, 0, -1, 0, 0, 0, 0, 1).finished();
  const LinkPoses at_rest = rest();
  for (int f = 0; f < kFrames; ++f) {
    const LinkPoses T_world_link = linksOf(poseOf(f));
    for (const auto& [name, link] : kBones) {
      const size_t index = size_t(model_.linkIndex(link));
      const Eigen::Isometry3d& bone = bones.at({f, name});
      const Eigen::Vector3d place = axes * T_world_link[index].translation();
      EXPECT_LT((unit * bone.translation() - place).norm(), 1e-4) << name << " in frame " << f;
      const Eigen::Matrix3d turn = axes * T_world_link[index].linear() *
                                   at_rest[index].linear().transpose() * axes.transpose();
      EXPECT_LT(Eigen::AngleAxisd(turn.transpose() * bone.linear()).angle(), 0.1 * M_PI / 180)
          << name << " in frame " << f;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Blender, ::testing::Values("a.bvh", "a.glb"));

}  // namespace
}  // namespace markerless_mocap

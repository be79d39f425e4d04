#include <map>

#include "exports/export_fixture.h"

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A motion file read by its own header, in radians.
struct Mot {
  explicit Mot(const std::string& text) {
    const auto lines = linesOf(text);
    size_t line = 0;
    while (lines.at(line) != "endheader") header.push_back(lines[line++]);
    const auto labels = fieldsOf(lines.at(line + 1), '\t');
    for (line += 2; line < lines.size(); ++line) {
      const auto fields = fieldsOf(lines[line], '\t');
      EXPECT_EQ(fields.size(), labels.size());
      rows.emplace_back();
      for (size_t i = 0; i < labels.size(); ++i) rows.back()[labels[i]] = std::stod(fields[i]);
    }
  }
  double radians(size_t row, const std::string& name) const {
    return rows.at(row).at(name) * M_PI / 180.0;
  }
  std::vector<std::string> header;
  std::vector<std::map<std::string, double>> rows;
};

/// The model's axes: x forward, y up, z right.
Matrix3d modelAxes(const Matrix3d& R) {
  const Matrix3d C = (Matrix3d() << 1, 0, 0, 0, 0, 1, 0, -1, 0).finished();
  return C * R * C.transpose();
}

class MotFile : public MovingPerson {
 protected:
  /// As the model of Rajagopal et al. defines a joint of three coordinates.
  static Matrix3d joint(const Mot& mot, size_t row, const std::string& first,
                        const std::string& second, const std::string& third, double side) {
    return (AngleAxisd(mot.radians(row, first), Vector3d::UnitZ()) *
            AngleAxisd(mot.radians(row, second), side * Vector3d::UnitX()) *
            AngleAxisd(mot.radians(row, third), side * Vector3d::UnitY()))
        .toRotationMatrix();
  }
  Matrix3d turn(const PersonFrame& frame, const std::string& name) const {
    return modelAxes(link(frame, name).linear());
  }
};

TEST_F(MotFile, CoordinatesRebuildTheLinks) {
  const PersonMotion recorded = motion(120);
  const Mot mot(motOf(recorded, "walk"));
  ASSERT_EQ(mot.rows.size(), 120u);
  for (size_t f = 0; f < 120; ++f) {
    const PersonFrame& frame = recorded.frames[f];
    const Matrix3d pelvis = joint(mot, f, "pelvis_tilt", "pelvis_list", "pelvis_rotation", 1);
    EXPECT_LT(degreesBetween(pelvis, turn(frame, "body")), 1e-3);
    const Matrix3d torso =
        pelvis * joint(mot, f, "lumbar_extension", "lumbar_bending", "lumbar_rotation", 1);
    EXPECT_LT(degreesBetween(torso, turn(frame, "torso")), 1e-3);
    for (const std::string side : {"r", "l"}) {
      const double sign = side == "r" ? 1.0 : -1.0;
      const Matrix3d thigh = pelvis * joint(mot, f, "hip_flexion_" + side, "hip_adduction_" + side,
                                            "hip_rotation_" + side, sign);
      EXPECT_LT(degreesBetween(thigh, turn(frame, side + "_hip")), 1e-3);
      const Matrix3d shank =
          thigh * AngleAxisd(mot.radians(f, "knee_angle_" + side), -Vector3d::UnitZ());
      EXPECT_LT(degreesBetween(shank, turn(frame, side + "_knee")), 1e-3);
      const Matrix3d foot =
          shank * AngleAxisd(mot.radians(f, "ankle_angle_" + side), Vector3d::UnitZ());
      EXPECT_LT(degreesBetween(foot, turn(frame, side + "_ankle")), 1e-3);
      const Matrix3d arm =
          torso * joint(mot, f, "arm_flex_" + side, "arm_add_" + side, "arm_rot_" + side, sign);
      EXPECT_LT(degreesBetween(arm, turn(frame, side + "_shoulder")), 1e-3);
      const Matrix3d forearm =
          arm * AngleAxisd(mot.radians(f, "elbow_flex_" + side), Vector3d::UnitZ());
      EXPECT_LT(degreesBetween(forearm, turn(frame, side + "_elbow")), 1e-3);
    }
  }
}

TEST_F(MotFile, SignsAreTheModels) {
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(body_->angleCount());
  const auto set = [&](const char* name, double value) { angles[body_->angleIndex(name)] = value; };
  set("l_r_hip", 0.5);   // forward
  set("r_p_hip", 0.25);  // away from the body
  set("l_knee", -0.7);   // bent
  set("r_elbow", 0.9);   // bent
  set("l_ankle", 0.2);   // toes up
  set("waist", 0.3);     // forward
  PersonFrame frame = frameAt(0);
  Eigen::Isometry3d T_world_root = Eigen::Isometry3d::Identity();
  T_world_root.translation() << 1, 2, 3;
  body_->forwardKinematics(T_world_root, angles, frame.T_world_link);
  const Mot mot(motOf(personMotion(body_, {frame}), "signs"));
  EXPECT_NEAR(mot.radians(0, "hip_flexion_l"), 0.5, 1e-6);
  EXPECT_NEAR(mot.radians(0, "hip_adduction_r"), -0.25, 1e-6);
  EXPECT_NEAR(mot.radians(0, "knee_angle_l"), 0.7, 1e-6);
  EXPECT_NEAR(mot.radians(0, "elbow_flex_r"), 0.9, 1e-6);
  EXPECT_NEAR(mot.radians(0, "ankle_angle_l"), 0.2, 1e-6);
  EXPECT_NEAR(mot.radians(0, "lumbar_extension"), -0.3, 1e-6);
  EXPECT_NEAR(mot.rows[0].at("pelvis_tx"), 1.0, 1e-6);
  EXPECT_NEAR(mot.rows[0].at("pelvis_ty"), 3.0, 1e-6);
  EXPECT_NEAR(mot.rows[0].at("pelvis_tz"), -2.0, 1e-6);
}

TEST_F(MotFile, GapsAreNanUnlessFilledAndTheHeaderSaysSo) {
  std::vector<PersonFrame> all = frames(5);
  hideLeftArm(&all[2]);
  PersonMotion recorded = personMotion(body_, all);
  const Mot open(motOf(recorded, "gap"));
  EXPECT_TRUE(std::isnan(open.rows[2].at("elbow_flex_l")));
  EXPECT_FALSE(std::isnan(open.rows[2].at("elbow_flex_r")));
  fillGaps(0.1, &recorded);
  const Mot filled(motOf(recorded, "gap"));
  EXPECT_FALSE(std::isnan(filled.rows[2].at("elbow_flex_l")));
  EXPECT_EQ(filled.header[6], "Gaps of up to 100 ms were filled by cubic splines.");
}

}  // namespace
}  // namespace markerless_mocap

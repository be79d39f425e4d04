#include <cstring>

#include "error_text_of.h"
#include "exports/export_fixture.h"

namespace markerless_mocap {
namespace {

/// A reader of C3D files, written from https://www.c3d.org/docs/C3D_User_Guide.pdf. It knows floats
/// of Intel processors.
class C3d {
 public:
  explicit C3d(std::string bytes) : bytes_(std::move(bytes)) {
    EXPECT_EQ(bytes_.size() % 512, 0u);
    EXPECT_EQ(bytes_.at(1), 0x50);
    readParameters(size_t(512) * (size_t(uint8_t(bytes_[0])) - 1));
  }

  int16_t word(size_t number) const { return at<int16_t>(2 * (number - 1)); }
  float headerFloat(size_t number) const { return at<float>(2 * (number - 1)); }
  float number(const std::string& name) const { return value<float>(name, 0); }
  int integer(const std::string& name, size_t index = 0) const {
    return value<uint16_t>(name, index);
  }
  std::vector<std::string> texts(const std::string& name) const {
    const std::string& data = parameters_.at(name).data;
    const size_t length = parameters_.at(name).sizes.at(0);
    std::vector<std::string> out;
    for (size_t i = 0; i + length <= data.size(); i += length) {
      std::string text = data.substr(i, length);
      text.erase(text.find_last_not_of(' ') + 1);
      out.push_back(text);
    }
    return out;
  }
  /// x, y, z, residual; the residual is in the low byte of the fourth number.
  Eigen::Vector4d point(size_t frame, size_t index) const {
    const size_t begin = 512 * (size_t(integer("POINT:DATA_START")) - 1);
    const size_t place = begin + 16 * (frame * size_t(word(2)) + index);
    Eigen::Vector4d out;
    for (size_t i = 0; i < 4; ++i) out[Eigen::Index(i)] = at<float>(place + 4 * i);
    if (out[3] >= 0) out[3] = double(int(out[3]) & 255) * std::abs(number("POINT:SCALE"));
    return out;
  }

 private:
  struct Parameter {
    std::vector<size_t> sizes;
    std::string data;
  };

  template <class Value>
  Value at(size_t place) const {
    Value value;
    std::memcpy(&value, &bytes_.at(place), sizeof value);
    return value;
  }
  template <class Value>
  Value value(const std::string& name, size_t index) const {
    Value value;
    std::memcpy(&value, &parameters_.at(name).data.at(index * sizeof value), sizeof value);
    return value;
  }

  void readParameters(size_t begin) {
    EXPECT_EQ(bytes_.at(begin + 3), 84) << "Intel";
    std::map<int, std::string> groups;
    size_t place = begin + 4;
    while (bytes_.at(place) != 0) {
      const size_t length = size_t(std::abs(at<int8_t>(place)));
      const int group = at<int8_t>(place + 1);
      const std::string name = bytes_.substr(place + 2, length);
      const size_t offset = place + 2 + length;
      if (group < 0)
        groups[-group] = name;
      else
        parameters_[groups.at(group) + ":" + name] = parameterAt(offset + 2);
      place = offset + size_t(at<int16_t>(offset));
    }
    EXPECT_LE(place, begin + 512 * size_t(uint8_t(bytes_.at(begin + 2))));
  }
  Parameter parameterAt(size_t place) const {
    Parameter out;
    size_t bytes = size_t(std::abs(at<int8_t>(place)));
    for (int d = 0; d < at<uint8_t>(place + 1); ++d) {
      out.sizes.push_back(at<uint8_t>(place + 2 + size_t(d)));
      bytes *= out.sizes.back();
    }
    out.data = bytes_.substr(place + 2 + out.sizes.size(), bytes);
    return out;
  }

  std::string bytes_;
  std::map<std::string, Parameter> parameters_;
};

using MarkerFiles = MovingPerson;

TEST_F(MarkerFiles, C3dSaysWhatItHolds) {
  const C3d file(c3dOf(motion(70), pointNames("package")));
  EXPECT_EQ(file.word(2), 28);
  EXPECT_EQ(file.word(4), 1);
  EXPECT_EQ(file.word(5), 70);
  EXPECT_FLOAT_EQ(file.headerFloat(11), 25.0f);
  EXPECT_EQ(file.word(9), file.integer("POINT:DATA_START"));
  EXPECT_EQ(file.integer("POINT:USED"), 28);
  EXPECT_EQ(file.integer("POINT:FRAMES"), 70);
  EXPECT_EQ(file.integer("TRIAL:ACTUAL_END_FIELD"), 70);
  EXPECT_FLOAT_EQ(file.number("POINT:RATE"), 25.0f);
  EXPECT_LT(file.number("POINT:SCALE"), 0.0f) << "numbers are floats";
  EXPECT_EQ(file.integer("ANALOG:USED"), 0);
  EXPECT_EQ(file.texts("POINT:UNITS"), std::vector<std::string>{"mm"});
  EXPECT_EQ(file.texts("POINT:X_SCREEN"), std::vector<std::string>{"+X"});
  EXPECT_EQ(file.texts("POINT:Y_SCREEN"), std::vector<std::string>{"+Z"});
  EXPECT_EQ(file.texts("POINT:LABELS").at(7), "l_shoulder");
}

TEST_F(MarkerFiles, C3dPlacesAreThoseOfTheLinksInMillimetres) {
  const PersonMotion recorded = motion(70);
  const auto points = choosePoints("package", {"pelvis", "l_elbow", "r_ankle"});
  const C3d file(c3dOf(recorded, points));
  const char* links[] = {"body", "l_elbow", "r_ankle"};
  for (size_t f = 0; f < 70; ++f)
    for (size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d place = 1e-3 * file.point(f, i).head<3>();
      EXPECT_LT((place - link(recorded.frames[f], links[i]).translation()).norm(), 1e-6);
    }
}

TEST_F(MarkerFiles, C3dResidualsTellExpectedErrorsAndGaps) {
  std::vector<PersonFrame> all = frames(9);
  hideLeftArm(&all[3]);
  for (const size_t f : {6, 7}) hideLeftArm(&all[f]);
  PersonMotion recorded = personMotion(body_, all);
  fillGaps(0.081, &recorded);
  const auto points = choosePoints("package", {"pelvis", "l_elbow", "r_ankle"});
  const C3d file(c3dOf(recorded, points));
  EXPECT_EQ(file.point(0, 0)[3], 2.0);  // mm
  EXPECT_EQ(file.point(0, 1)[3], 4.0);
  EXPECT_EQ(file.point(0, 2)[3], 1.0) << "0.4 mm, but 0 would mean filled";
  EXPECT_EQ(file.point(3, 1)[3], 0.0) << "filled";
  EXPECT_EQ(file.point(6, 1)[3], -1.0) << "a gap";
  EXPECT_EQ(file.point(6, 0)[3], 2.0);
}

TEST_F(MarkerFiles, C3dCountsLongFilmsWithTwoWords) {
  PersonMotion recorded = motion(2);
  while (recorded.frames.size() < 70000) {
    recorded.frames.push_back(recorded.frames.back());
    recorded.frames.back().stamp_ns += kStep;
  }
  const C3d file(c3dOf(recorded, choosePoints("package", {"pelvis"})));
  EXPECT_EQ(file.integer("POINT:FRAMES"), 65535);
  EXPECT_EQ(file.number("POINT:LONG_FRAMES"), 70000.0f);
  EXPECT_EQ(
      file.integer("TRIAL:ACTUAL_END_FIELD", 0) + 65536 * file.integer("TRIAL:ACTUAL_END_FIELD", 1),
      70000);
}

TEST_F(MarkerFiles, TrcIsInOpenSimsAxesAndMillimetres) {
  std::vector<PersonFrame> all = frames(5);
  hideLeftArm(&all[2]);
  const PersonMotion recorded = personMotion(body_, all);
  const auto lines =
      linesOf(trcOf(recorded, choosePoints("opensim", {"hip_r", "elbow_l"}), "a.trc"));
  ASSERT_EQ(lines.size(), 6u + 5u);
  EXPECT_EQ(lines[0], "PathFileType\t4\t(X/Y/Z)\ta.trc");
  EXPECT_EQ(lines[2], "25.0000\t25.0000\t5\t2\tmm\t25.0000\t1\t5");
  EXPECT_EQ(lines[3], "Frame#\tTime\thip_r\t\t\telbow_l\t\t");
  EXPECT_EQ(lines[4], "\t\tX1\tY1\tZ1\tX2\tY2\tZ2");
  EXPECT_EQ(lines[5], "");
  const auto row = fieldsOf(lines[6 + 4], '\t');
  ASSERT_EQ(row.size(), 8u);
  EXPECT_EQ(row[0], "5");
  EXPECT_EQ(row[1], "0.160000");
  const Eigen::Vector3d elbow = 1e3 * link(all[4], "l_elbow").translation();
  EXPECT_NEAR(std::stod(row[5]), elbow.x(), 1e-3);
  EXPECT_NEAR(std::stod(row[6]), elbow.z(), 1e-3) << "y is up";
  EXPECT_NEAR(std::stod(row[7]), -elbow.y(), 1e-3) << "z is to the right";
  EXPECT_EQ(fieldsOf(lines[6 + 2], '\t')[5], "") << "not seen";
}

TEST_F(MarkerFiles, CsvHasARowForEachFrameAndJoint) {
  std::vector<PersonFrame> all = frames(4);
  hideLeftArm(&all[1]);
  const PersonMotion recorded = personMotion(body_, all);
  const auto lines = linesOf(pointsCsvOf(recorded, choosePoints("coco", {"nose", "left_wrist"})));
  ASSERT_EQ(lines.size(), 1u + 8u);
  EXPECT_EQ(lines[0], "stamp_s,time_s,frame,joint,x_m,y_m,z_m,qx,qy,qz,qw,expected_error_m,state");
  EXPECT_EQ(lines[1], "1000.000000000,0.000000,1,nose,,,,,,,,,not seen") << "the body has no face";
  EXPECT_EQ(lines[4], "1000.040000000,0.040000,2,left_wrist,,,,,,,,,not seen");
  const auto row = fieldsOf(lines[8], ',');
  const Eigen::Isometry3d& wrist = link(all[3], "l_wrist");
  const Eigen::Vector3d place(std::stod(row[4]), std::stod(row[5]), std::stod(row[6]));
  const Eigen::Quaterniond turn(std::stod(row[10]), std::stod(row[7]), std::stod(row[8]),
                                std::stod(row[9]));
  EXPECT_LT((place - wrist.translation()).norm(), 2e-6);
  EXPECT_LT(degreesBetween(turn.toRotationMatrix(), wrist.linear()), 1e-3);
  EXPECT_EQ(row[11], "0.004000");
  EXPECT_EQ(row[12], "seen");
}

TEST_F(MarkerFiles, NamesThatDoNotExistAreTold) {
  EXPECT_EQ(errorTextOf<std::exception>([] { pointNames("kinect"); }),
            "there are no names kinect, allowed are package, motionbuilder, opensim, h36m, smpl, "
            "coco");
  EXPECT_EQ(errorTextOf<std::exception>([] {
              choosePoints("h36m", {"Hip", "LElbo"});
            }).find("there is no joint LElbo, allowed are Hip, RHip, RKnee, RFoot, LHip"),
            0u);
}

TEST_F(MarkerFiles, SetsHaveTheirUsualSizesAndOrder) {
  EXPECT_EQ(pointNames("h36m").size(), 17u);
  EXPECT_EQ(pointNames("h36m")[14].name, "RShoulder");
  EXPECT_EQ(pointNames("smpl").size(), 24u);
  EXPECT_EQ(pointNames("smpl")[15].name, "head");
  EXPECT_EQ(pointNames("coco").size(), 17u);
  EXPECT_EQ(pointNames("coco")[16].name, "right_ankle");
  const Eigen::Matrix3Xd spine =
      placesOf(choosePoints("smpl", {"spine1", "spine2", "neck"}), *body_, frameAt(0));
  EXPECT_LT((spine.col(1) - spine.col(0)).norm(), (spine.col(2) - spine.col(0)).norm());
}

}  // namespace
}  // namespace markerless_mocap

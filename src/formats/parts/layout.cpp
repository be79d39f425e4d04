#include "formats/parts/layout.h"

namespace markerless_mocap {

const std::vector<CalibrationLayout>& calibrationLayouts() {
  using F = CalibrationFormat;
  static const std::vector<CalibrationLayout> kLayouts = {
      {F::kRig, "rig", "rig file of this package", isRigText, readRigFiles, writeRigFiles},
      {F::kRos, "ros", "ROS camera_info and static transforms", isRosText, readRosFiles,
       writeRosFiles, readRosLenses},
      {F::kKalibr, "kalibr", "Kalibr camchain", isKalibrText, readKalibrFiles, writeKalibrFiles},
      {F::kQualisys, "qualisys", "Qualisys .qca.txt", isQualisysText, readQualisysFiles,
       writeQualisysFiles},
      {F::kEasyMocap, "easymocap", "EasyMocap intri.yml and extri.yml", isEasyMocapText,
       readEasyMocapFiles, writeEasyMocapFiles},
      {F::kOpenCv, "opencv", "OpenCV XML or YAML", isOpenCvText, readOpenCvFiles, writeOpenCvFiles,
       readOpenCvLenses},
      {F::kAnipose, "anipose", "anipose TOML", isTomlText, readTomlFiles, writeAniposeFiles},
      {F::kCaliscope, "caliscope", "caliscope TOML", isTomlText, readTomlFiles,
       writeCaliscopeFiles},
      {F::kFreeMoCap, "freemocap", "FreeMoCap TOML", isTomlText, readTomlFiles,
       writeFreeMoCapFiles},
      {F::kPose2Sim, "pose2sim", "Pose2Sim TOML", isTomlText, readTomlFiles, writePose2SimFiles},
      {F::kColmap, "colmap", "COLMAP text model", isColmapText, readColmapFiles, writeColmapFiles},
      {F::kMatrices, "matrices", "3x4 projection matrices", isMatrixText, readMatrixFiles,
       writeMatrixFiles}};
  return kLayouts;
}

}  // namespace markerless_mocap

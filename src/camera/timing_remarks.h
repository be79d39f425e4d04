#pragma once

#include <string>

#include "markerless_mocap/camera/frame_set_assembler.h"

namespace markerless_mocap {

/// In rigs with time offsets the clocks differ, so drift up to this is followed, s.
constexpr double kFollowedDrift = 0.1;

/// A sentence about a camera whose stamps come near to what is allowed; empty if they do not.
/// \param timing of cameras that are in step
std::string lagRemark(const std::string& camera, const StreamTiming& timing,
                      const AssemblerOptions& options);

/// That cameras are out of step and joined all the same; empty if they are in step.
/// \param tolerance of FrameSetAssembler::tolerance(), s
/// \param in_step as AssemblerOptions::tolerance, s
std::string stepRemark(double tolerance, double in_step);

/// Why a camera was missing in the last frame set that lacked it, such as "cam3 is left out, its
/// nearest stamp is 41.0 ms later".
std::string missRemark(const std::string& camera, const StreamTiming& timing);

}  // namespace markerless_mocap

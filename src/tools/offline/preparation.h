#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "markerless_mocap/tracking/shape_parameters.h"
#include "tools/offline/offline_run.h"

namespace markerless_mocap {

/// What is learned of a recording before the person is followed in it. All parts of a recording
/// that is cut must be followed with the same preparation.
struct Preparation {
  /// One per camera, or none; nullptr: the first images give the background.
  std::vector<SharedBackground> backgrounds;
  std::optional<ShapeParameters> shape;  ///< of the person; empty: not measured
  /// One per background: how many of the first images of the recording it was learned from, which
  /// get no silhouette; 0: it was learned from the whole recording.
  std::vector<int> first_images;
};

/// Learns the backgrounds if somebody is in the first images, and measures the person if the
/// options ask for it. Decides how the silhouettes of `pipeline` learn and that the person is not
/// measured again. Throws as runOffline().
/// \param notes stream for progress and results; nullptr: none
/// \param terminal true if `notes` is a terminal
Preparation prepare(const OfflineOptions& options, const PersonResources& resources,
                    PipelineOptions* pipeline, std::ostream* notes, bool terminal);

/// Prepares a recording and writes all of it to a folder, with the backgrounds that the first
/// images give. Throws as runOffline(), and std::invalid_argument if the model of the silhouettes
/// cannot be saved.
void writePreparation(const OfflineOptions& options, const std::string& folder, std::ostream* notes,
                      bool terminal);

/// What writePreparation() wrote, for a part of the recording: one that begins with the recording
/// learns from the first images itself, as a run over the whole recording does. Sets `pipeline` as
/// prepare(). Throws std::invalid_argument if the folder lacks a file or is of other cameras.
/// \param cameras of the recording
Preparation readPreparation(const OfflineOptions& options, const std::string& folder,
                            size_t cameras, PipelineOptions* pipeline);

/// Lets the backgrounds of a part follow the light in the images before it, as they would have done
/// from the beginning of the recording on. They begin in the cycle of images
/// (silhouette/image_cycle.h) where a run over the whole recording is, with so many images that
/// what they had been before counts less than a pixel's rounding: the silhouettes are then those of
/// the whole. Throws as runOffline().
void settleBackgrounds(const OfflineOptions& options, const Preparation& prepared,
                       Pipeline* pipeline);

}  // namespace markerless_mocap

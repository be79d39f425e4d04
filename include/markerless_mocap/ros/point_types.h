#pragma once

// Points of hull/points and segmentation/points for the Point Cloud Library: with this header and
// pcl_ros/point_cloud.h a node subscribes to pcl::PointCloud<markerless_mocap::HullPoint>. Before
// you use a filter of PCL with these types, define PCL_NO_PRECOMPILE or include its impl/*.hpp.
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <cstdint>

namespace markerless_mocap {

/// A voxel of the visual hull: its centre in the world, metres, and its colour.
struct EIGEN_ALIGN16 HullPoint {
  PCL_ADD_POINT4D;
  PCL_ADD_RGB;
  uint8_t views = 0;  ///< cameras that see the voxel
  /// Cameras that voted for the same colour as the neighbour at +x, +y, +z, and that could vote.
  uint8_t votes_x = 0, votes_y = 0, votes_z = 0;
  uint8_t possible_x = 0, possible_y = 0, possible_z = 0;

  HullPoint() : data{0, 0, 0, 1} { rgba = 0; }
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

/// The same voxel with its part of the body.
struct EIGEN_ALIGN16 SegmentationPoint {
  PCL_ADD_POINT4D;
  PCL_ADD_RGB;        ///< of the part; darker if the label is carried over from earlier frames
  uint8_t label = 0;  ///< PartLabel

  SegmentationPoint() : data{0, 0, 0, 1} { rgba = 0; }
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace markerless_mocap

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT(
    markerless_mocap::HullPoint,
    (float, x, x)(float, y, y)(float, z, z)(float, rgb, rgb)(std::uint8_t, views, views)
    (std::uint8_t, votes_x, votes_x)(std::uint8_t, votes_y, votes_y)(std::uint8_t, votes_z, votes_z)
    (std::uint8_t, possible_x, possible_x)(std::uint8_t, possible_y, possible_y)
    (std::uint8_t, possible_z, possible_z))
POINT_CLOUD_REGISTER_POINT_STRUCT(
    markerless_mocap::SegmentationPoint,
    (float, x, x)(float, y, y)(float, z, z)(float, rgb, rgb)(std::uint8_t, label, label))
// clang-format on

#pragma once

#include "studies/reproduce/hsiao/hsiao_film.h"

namespace markerless_mocap {

/// Figures 3-11, 3-12 and 3-14: the segmentation of an image by the original Laplacian, by the
/// modified one, and by the modified one with colours. {name: JPEG in base64, "head": by name,
/// whether the head's top has a branch of its own}
Json planeFigures();

/// Figures 3-6 to 3-10, 3-15 and 3-16 from one frame each, and how much larger the hull of four
/// cameras is, over all frames. {name: JPEG in base64, "litres_8", "litres_4", "site_values":
/// curves of torso and first arm}
Json hullFigures(const Capture& capture);
/// Figure 3-6: images, hull. {"images", "litres"}
Json laboratoryFigure(const Capture& capture);
/// Mean volume of the hulls of a capture, litres.
Json hullVolume(const Capture& capture);

}  // namespace markerless_mocap

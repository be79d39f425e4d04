#pragma once

#include <string>

namespace markerless_mocap {

// Texts of templates/ and of Debian's three.js, built into the tools (cmake/resources.cmake).
std::string pageHtml();         ///< templates/page.html
std::string pageStyle();        ///< templates/page.css
std::string pagePartsJs();      ///< templates/parts.js: texts, tables, plots
std::string pagePlayerJs();     ///< templates/player.js: what moves
std::string threeJs();          ///< three.min.js (libjs-three, MIT)
std::string orbitControlsJs();  ///< OrbitControls.js of it

}  // namespace markerless_mocap

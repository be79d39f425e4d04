#include <cmath>
#include <stdexcept>

#include "files/text_file.h"
#include "files/yaml_text.h"
#include "motion/motion_script.h"
#include "motion/script/script_node.h"

namespace markerless_mocap {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kMaxSeconds = 600.0;  // seconds
constexpr double kMaxDistance = 10.0;  // metres

Stance readStance(const ScriptNode& node, Stance otherwise) {
  return {node.number("width", otherwise.width, 0.02, 0.4),
          node.number("stagger", otherwise.stagger, -0.4, 0.4)};
}

void readStart(const ScriptNode& node, MotionScript& script) {
  node.allowKeys({"x", "y", "heading", "width", "stagger"});
  script.start_x = node.number("x", 0.0, -kMaxDistance, kMaxDistance);
  script.start_y = node.number("y", 0.0, -kMaxDistance, kMaxDistance);
  script.start_heading = kDegree * node.number("heading", 0.0, -360.0, 360.0);
  script.start_stance = readStance(node, Stance());
}

double readSeconds(const ScriptNode& node) {
  return node.number(0.01, kMaxSeconds);
}

/// The first key of a move and the other keys that it allows.
struct MoveRow {
  std::string key;
  Move::Kind kind;
  std::vector<std::string> others;
};

const std::vector<MoveRow>& moveRows() {
  static const std::vector<std::string> stepping{"seconds", "turn",  "steps",  "first",
                                                 "run",     "width", "stagger"};
  static const std::vector<MoveRow> rows{
      {"stand", Move::Kind::kStand, {}},
      {"go", Move::Kind::kGo, stepping},
      {"shift", Move::Kind::kShift, stepping},
      {"jump", Move::Kind::kJump, {"seconds", "turn", "tuck", "width", "stagger"}}};
  return rows;
}

const MoveRow& moveRow(const ScriptNode& node) {
  for (const MoveRow& row : moveRows())
    if (node.has(row.key)) return row;
  throw std::invalid_argument(node.address() +
                              " names no move, allowed is one of stand, go, shift, jump");
}

void readWay(const ScriptNode& node, Move& move) {
  if (move.kind == Move::Kind::kStand) {
    move.seconds = readSeconds(node);
  } else if (move.kind == Move::Kind::kGo) {
    move.forward = node.number(-kMaxDistance, kMaxDistance);
  } else {
    const std::vector<double> offset = node.numbers(2, "metres forward and to the left");
    move.forward = offset[0];
    move.left = offset[1];
  }
}

/// \param before the stance before the move
Move readMove(const ScriptNode& node, const Stance& before) {
  const MoveRow& row = moveRow(node);
  std::vector<std::string> allowed{row.key};
  allowed.insert(allowed.end(), row.others.begin(), row.others.end());
  node.allowKeys(allowed);
  Move move;
  move.kind = row.kind;
  readWay(node.need(row.key), move);
  if (move.kind != Move::Kind::kStand) move.seconds = readSeconds(node.need("seconds"));
  move.turn = kDegree * node.number("turn", 0.0, -3600.0, 3600.0);
  move.steps = node.whole("steps", 0, 1, 200);
  if (node.has("first"))
    move.first = node.need("first").word({"left", "right"}) == "left" ? Move::First::kLeft
                                                                      : Move::First::kRight;
  move.run = node.flag("run", false);
  move.tuck = node.number("tuck", 0.0, 0.0, 0.3);
  move.stance = readStance(node, before);
  return move;
}

void readPath(const ScriptNode& node, MotionScript& script) {
  Stance stance = script.start_stance;
  double seconds = 0.0;
  for (const ScriptNode& item : node.items()) {
    script.path.push_back(readMove(item, stance));
    stance = script.path.back().stance;
    seconds += script.path.back().seconds;
  }
  if (seconds > script.seconds + 1e-9)
    throw std::invalid_argument(node.address() + " takes " + formatNumber(seconds) +
                                " s, allowed is up to the motion's " +
                                formatNumber(script.seconds) + " s");
}

/// Reads keys [seconds, value, ...] with values within bounds.
ScriptCurve readCurve(const ScriptNode& node, const CurveValues& minimum,
                      const CurveValues& maximum, double max_seconds, const std::string& meaning) {
  std::vector<CurveKey> keys;
  for (const ScriptNode& item : node.items()) {
    const std::vector<double> numbers = item.numbers(size_t(minimum.size()) + 1, meaning);
    if (numbers[0] < 0.0 || numbers[0] > max_seconds)
      item.fail("a time from 0 to the motion's " + formatNumber(max_seconds) + " s");
    if (!keys.empty() && numbers[0] <= keys.back().seconds)
      item.fail("a time after the key before, " + formatNumber(keys.back().seconds) + " s");
    CurveKey key{numbers[0], CurveValues::Zero(minimum.size())};
    for (Eigen::Index i = 0; i < minimum.size(); ++i) {
      key.values[i] = numbers[size_t(i) + 1];
      if (key.values[i] < minimum[i] || key.values[i] > maximum[i])
        item.fail("as number " + std::to_string(i + 2) + " one from " + formatNumber(minimum[i]) +
                  " to " + formatNumber(maximum[i]));
    }
    keys.push_back(key);
  }
  if (keys.empty()) node.fail("at least one key of " + meaning);
  return ScriptCurve(keys);
}

void readTracks(const ScriptNode& node, MotionScript& script) {
  node.allowKeys(trackNames());
  for (int t = 0; t < kTrackCount; ++t) {
    const TrackRow& row = trackRow(Track(t));
    if (!node.has(row.name)) continue;
    script.tracks[size_t(t)] =
        readCurve(node.need(row.name), row.minimum, row.maximum, script.seconds,
                  "seconds and the " + std::to_string(row.neutral.size()) + " of " + row.name);
  }
}

FootGesture readGesture(const ScriptNode& node, double max_seconds) {
  node.allowKeys({"foot", "keys"});
  FootGesture gesture;
  gesture.left = node.need("foot").word({"left", "right"}) == "left";
  const ScriptNode keys = node.need("keys");
  CurveValues bounds(4);
  bounds << 0.6, 0.4, 0.7, 80.0;
  gesture.keys = readCurve(keys, -bounds, bounds, max_seconds,
                           "seconds, forward, outward, up, degrees of toes up");
  if (!gesture.keys.keys().front().values.isZero() || !gesture.keys.keys().back().values.isZero())
    keys.fail("a first and a last key with zeros: the foot comes back to where it stood");
  return gesture;
}

MotionScript readRoot(const ScriptNode& root) {
  root.allowKeys({"seconds", "start", "path", "feet", "tracks"});
  MotionScript script;
  script.name = root.address();
  script.seconds = readSeconds(root.need("seconds"));
  for (int t = 0; t < kTrackCount; ++t)
    script.tracks[size_t(t)] = ScriptCurve(trackRow(Track(t)).neutral);
  readStart(root.need("start"), script);
  readPath(root.need("path"), script);
  readTracks(root.need("tracks"), script);
  if (root.has("feet"))
    for (const ScriptNode& item : root.need("feet").items())
      script.gestures.push_back(readGesture(item, script.seconds));
  return script;
}

}  // namespace

MotionScript parseMotionScript(const std::string& text, const std::string& name) {
  return readRoot(ScriptNode(yamlFrom(text, name), name));
}

MotionScript readMotionScript(const std::string& file) {
  std::string text;
  try {
    text = readTextFile(file, "the motion " + file);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
  return parseMotionScript(text, file);
}

}  // namespace markerless_mocap

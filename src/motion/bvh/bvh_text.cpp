#include "motion/bvh/bvh_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <istream>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr int kMaxFrames = 100000000;

bool sameWord(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return tolower(x) == tolower(y); });
}

// Keeps the error message on one line.
std::string quoted(const std::string& text) {
  constexpr size_t kMaxQuoted = 30;
  std::string shown = text.substr(0, kMaxQuoted);
  for (char& c : shown)
    if (!isprint(static_cast<unsigned char>(c))) c = '?';
  return '"' + shown + (text.size() > kMaxQuoted ? "..." : "") + '"';
}

}  // namespace

BvhText::BvhText(std::istream& stream, std::string name) : name_(std::move(name)) {
  std::string line;
  for (size_t number = 1; std::getline(stream, line); ++number) {
    last_line_ = number;
    if (number == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0)
      line.erase(0, 3);  // UTF-8 byte order mark
    // "Frames:12" and "Frames : 12" are the same; elsewhere a colon is a part of a joint's name.
    const size_t start = line.find_first_not_of(" \t");
    const bool colon_is_word =
        start != std::string::npos && sameWord(line.substr(start, 5), "frame");
    std::string word;
    const auto finish = [&] {
      if (!word.empty()) words_.push_back({word, number});
      word.clear();
    };
    for (char c : line) {
      if (isspace(static_cast<unsigned char>(c))) {
        finish();
      } else if (c == '{' || c == '}' || (c == ':' && colon_is_word)) {
        finish();
        words_.push_back({std::string(1, c), number});
      } else {
        word += c;
      }
    }
    finish();
  }
}

const std::string& BvhText::peek() const {
  static const std::string nothing;
  return atEnd() ? nothing : words_[next_].text;
}

const std::string& BvhText::take(const std::string& expected) {
  if (atEnd()) failAt(last_line_, "the file ends where " + expected + " is expected");
  return words_[next_++].text;
}

bool BvhText::nextIs(const std::string& word) const {
  return !atEnd() && sameWord(words_[next_].text, word);
}

bool BvhText::skipIf(const std::string& word) {
  if (!nextIs(word)) return false;
  ++next_;
  return true;
}

void BvhText::require(const std::string& word, const std::string& where) {
  const std::string found = take(word + " " + where);
  if (!sameWord(found, word))
    fail(quoted(found) + " stands where " + word + " " + where + " is expected");
}

std::string BvhText::takeName(const std::string& of) {
  const size_t line = nextLine();
  std::string name = take("the name of a " + of);
  if (name == "{" || name == "}") fail("a " + of + " has no name");
  while (!atEnd() && nextLine() == line && peek() != "{" && peek() != "}")
    name += ' ' + words_[next_++].text;
  return name;
}

double BvhText::number(const Word& word, const std::function<std::string()>& what) const {
  char* end = nullptr;
  const double value = std::strtod(word.text.c_str(), &end);
  if (*end != '\0' || end == word.text.c_str())
    failAt(word.line, what() + " is " + quoted(word.text) + ", allowed is a number");
  if (!std::isfinite(value))
    failAt(word.line, what() + " is " + quoted(word.text) + ", allowed is a finite number");
  return value;
}

double BvhText::takeNumber(const std::string& what) {
  take(what);
  return number(words_[next_ - 1], [&] { return what; });
}

int BvhText::takeCount(const std::string& what) {
  const double value = takeNumber(what);
  if (value != std::floor(value) || value < 0 || value > kMaxFrames)
    fail(what + " is " + words_[next_ - 1].text + ", allowed is a whole number from 0 on");
  return int(value);
}

std::vector<double> BvhText::takeFrame(size_t frame, size_t channels) {
  const size_t line = nextLine();
  std::vector<double> values;
  values.reserve(channels);
  const std::string which = "frame " + std::to_string(frame + 1);
  for (; !atEnd() && nextLine() == line; ++next_)
    values.push_back(number(words_[next_], [&] {
      return "value " + std::to_string(values.size() + 1) + " of " + which;
    }));
  if (values.size() != channels)
    failAt(line, which + " has " + std::to_string(values.size()) + " values, the hierarchy has " +
                     std::to_string(channels) + " channels");
  return values;
}

size_t BvhText::linesLeft() const {
  size_t lines = 0, last = 0;
  for (size_t i = next_; i < words_.size(); ++i) {
    lines += words_[i].line != last;
    last = words_[i].line;
  }
  return lines;
}

void BvhText::fail(const std::string& error) const {
  failAt(next_ > 0 ? words_[next_ - 1].line : last_line_, error);
}

void BvhText::failAt(size_t line, const std::string& error) const {
  throw std::invalid_argument(name_ + ", line " + std::to_string(line) + ": " + error);
}

}  // namespace markerless_mocap

#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace markerless_mocap {

/// The words of a BVH file with their line numbers; throws errors that name file and line.
class BvhText {
 public:
  BvhText(std::istream& stream, std::string name);

  bool atEnd() const { return next_ == words_.size(); }
  /// The next word, without consuming it; empty at the end.
  const std::string& peek() const;
  /// \param expected what is expected here, for the error message if the file ends
  const std::string& take(const std::string& expected);
  /// Case-insensitive comparison.
  bool nextIs(const std::string& word) const;
  bool skipIf(const std::string& word);
  void require(const std::string& word, const std::string& where);
  /// Words up to a brace or the end of the line, joined by blanks.
  std::string takeName(const std::string& of);
  double takeNumber(const std::string& what);
  int takeCount(const std::string& what);
  /// The numbers of a line; there must be `channels` of them.
  std::vector<double> takeFrame(size_t frame, size_t channels);
  /// Number of lines with words from here on.
  size_t linesLeft() const;

  /// Throws std::invalid_argument with the file and the line of the last word taken.
  [[noreturn]] void fail(const std::string& error) const;
  [[noreturn]] void failAt(size_t line, const std::string& error) const;

 private:
  struct Word {
    std::string text;
    size_t line;
  };

  size_t nextLine() const { return atEnd() ? last_line_ : words_[next_].line; }
  double number(const Word& word, const std::function<std::string()>& what) const;

  std::string name_;
  std::vector<Word> words_;
  size_t next_ = 0;
  size_t last_line_ = 1;
};

}  // namespace markerless_mocap

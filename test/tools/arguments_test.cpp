#include "tools/common/arguments.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

namespace markerless_mocap {
namespace {

struct Refusal {
  std::optional<int> code;
  std::string text;
};

/// A program with each kind of number, as an option and in a command of its own.
Refusal refusal(std::vector<std::string> words) {
  CLI::App app("A test.", "tool");
  double length = 0.0, part = 0.0;
  int steps = 0;
  size_t threads = 0;
  std::string name;
  app.add_option("--length", length)->check(CLI::PositiveNumber);
  app.add_option("--steps", steps);
  app.add_option("--threads", threads);
  app.add_option("--name", name);
  app.add_subcommand("cut")->add_option("--part", part);
  words.insert(words.begin(), "tool");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  testing::internal::CaptureStderr();
  const auto code = parseArguments(app, int(argv.size()), argv.data());
  std::string text = testing::internal::GetCapturedStderr();
  return {code, text.substr(0, text.find('\n'))};
}

TEST(Arguments, ThatCanBeUsedAreTaken) {
  const Refusal taken = refusal({"--length", "1e-3", "--steps=-2", "--threads", "3", "--name",
                                 "nan", "cut", "--part", "-.5"});
  EXPECT_EQ(taken.code, std::nullopt);
  EXPECT_EQ(taken.text, "");
}

TEST(Arguments, NumbersThatAreNoneAreToldWithWhatIsAllowed) {
  const Refusal word = refusal({"--length", "long"});
  EXPECT_EQ(word.text, "tool: --length is 'long', allowed are finite numbers (POSITIVE)");
  EXPECT_NE(word.code.value_or(0), 0);
  EXPECT_EQ(refusal({"--steps", "1.5"}).text,
            "tool: --steps is '1.5', allowed are whole numbers of up to nine digits");
  EXPECT_EQ(refusal({"--threads=-1"}).text,
            "tool: --threads is '-1', allowed are whole numbers from 0");
}

TEST(Arguments, NumbersThatAreNotFiniteAreRefused) {
  for (const std::string text : {"nan", "inf", "-inf", "1e999"}) {
    EXPECT_EQ(refusal({"--length=" + text}).text,
              "tool: --length is '" + text + "', allowed are finite numbers (POSITIVE)");
    EXPECT_NE(refusal({"cut", "--part=" + text}).code.value_or(0), 0) << text;
  }
}

TEST(Arguments, OtherFaultsBeginWithTheNameOfTheProgram) {
  const Refusal unknown = refusal({"--nosuch"});
  EXPECT_EQ(unknown.text.rfind("tool: ", 0), 0u);
  EXPECT_NE(unknown.text.find("--nosuch"), std::string::npos);
  EXPECT_NE(unknown.code.value_or(0), 0);
}

}  // namespace
}  // namespace markerless_mocap

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
  double length = 0.0, part = 0.0, at = 0.0;
  int steps = 0, share = 5;
  size_t threads = 0;
  std::string name, file;
  std::vector<std::string> settings;
  bool quiet = false, images = true;
  app.add_option("file", file);
  app.add_option("--length", length)->check(CLI::PositiveNumber);
  app.add_option("--steps", steps);
  app.add_option("--share", share)->check(CLI::Range(5, 100));
  app.add_option("--at", at)->check(CLI::NonNegativeNumber);
  app.add_option("--threads", threads);
  app.add_option("--name", name);
  app.add_option("--set", settings);
  app.add_flag("--quiet", quiet);
  app.add_flag("!--no-images", images);
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
  EXPECT_EQ(word.text, "tool: --length is 'long', allowed are finite numbers above 0");
  EXPECT_NE(word.code.value_or(0), 0);
  EXPECT_EQ(refusal({"--steps", "1.5"}).text,
            "tool: --steps is '1.5', allowed are whole numbers of up to nine digits");
  EXPECT_EQ(refusal({"--threads=-1"}).text,
            "tool: --threads is '-1', allowed are whole numbers from 0");
}

TEST(Arguments, NumbersThatAreNotFiniteAreRefused) {
  for (const std::string text : {"nan", "inf", "-inf", "1e999"}) {
    EXPECT_EQ(refusal({"--length=" + text}).text,
              "tool: --length is '" + text + "', allowed are finite numbers above 0");
    EXPECT_NE(refusal({"cut", "--part=" + text}).code.value_or(0), 0) << text;
  }
}

TEST(Arguments, NumbersOutsideTheirRangeAreToldWithIt) {
  EXPECT_EQ(refusal({"--length", "0"}).text,
            "tool: --length is '0', allowed are finite numbers above 0");
  EXPECT_EQ(refusal({"--at=-1"}).text, "tool: --at is '-1', allowed are finite numbers from 0");
  for (const std::string text : {"4", "101", "5.5"})
    EXPECT_EQ(refusal({"--share", text}).text,
              "tool: --share is '" + text + "', allowed are whole numbers, 5 to 100");
  EXPECT_EQ(refusal({"--share", "100", "--at", "0"}).text, "");
}

TEST(Arguments, ThatAreGivenTooOftenOrWithoutTheirValueAreTold) {
  EXPECT_EQ(refusal({"--name", "a", "--name", "b", "--quiet", "--no-images"}).text,
            "tool: --name is given 2 times, allowed is once");
  EXPECT_EQ(refusal({"--quiet", "--name"}).text,
            "tool: --name is given without its value, allowed is one");
  EXPECT_EQ(refusal({"--quiet=abc"}).text,
            "tool: --quiet is given the value 'abc', allowed is none");
  EXPECT_EQ(refusal({"--set", "a=1", "b=2", "--set", "c=3", "--quiet", "--no-images"}).text, "");
}

TEST(Arguments, OptionsAreNotTakenForValues) {
  for (const std::string next : {"--quiet", "--nosuch", "-h"}) {
    const Refusal refused = refusal({"--name", next});
    EXPECT_EQ(refused.text,
              "tool: --name is given without its value, allowed is one, before " + next);
    EXPECT_NE(refused.code.value_or(0), 0);
  }
  EXPECT_EQ(refusal({"--length", "--quiet"}).text,
            "tool: --length is given without its value, allowed is one, before --quiet");
  EXPECT_EQ(refusal({"--name", "file", "--set", "-", "--quiet", "--", "--odd"}).text, "");
}

TEST(Arguments, OtherFaultsBeginWithTheNameOfTheProgram) {
  const Refusal unknown = refusal({"--nosuch"});
  EXPECT_EQ(unknown.text.rfind("tool: ", 0), 0u);
  EXPECT_NE(unknown.text.find("--nosuch"), std::string::npos);
  EXPECT_NE(unknown.code.value_or(0), 0);
}

}  // namespace
}  // namespace markerless_mocap

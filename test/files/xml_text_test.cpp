#include "files/xml_text.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

std::string refusal(const std::string& text) {
  return errorTextOf([&] {
    tinyxml2::XMLDocument document;
    readXml(text, "a.xml", &document);
  });
}

TEST(XmlText, IsRead) {
  tinyxml2::XMLDocument document;
  readXml("<!-- b --><a/>", "a.xml", &document);
  EXPECT_STREQ(document.RootElement()->Name(), "a");
}

TEST(XmlText, WithoutTagsIsTold) {
  EXPECT_EQ(refusal(""), "a.xml: the text is empty or has no tags");
  EXPECT_EQ(refusal("<!-- <a/> -->"), "a.xml: the text is empty or has no tags");
}

TEST(XmlText, FaultsAreToldInPlainWordsWithTheirLine) {
  const std::string second = "a.xml: the text is no XML from line 2 on: ";
  EXPECT_EQ(refusal("<a>\n<b></a>"), second + "a tag has no end, or that of another");
  EXPECT_EQ(refusal("<a>\n<b c=d/></a>"),
            second + "an attribute is not NAME=\"VALUE\", or stands twice");
  EXPECT_EQ(refusal("<a>\n<!-- b</a>"), second + "a comment has no end -->");
}

}  // namespace
}  // namespace markerless_mocap

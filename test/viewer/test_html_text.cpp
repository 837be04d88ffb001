// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tools/html_text.hpp"

namespace multimesh::tools {
namespace {

TEST(HtmlText, MarkupBecomesText) {
  EXPECT_EQ(html_escaped("a.obj"), "a.obj");
  EXPECT_EQ(html_escaped("<b>\"Tom\" & 'Jerry'</b>"),
            "&lt;b&gt;&quot;Tom&quot; &amp; &#39;Jerry&#39;&lt;/b&gt;");
  EXPECT_EQ(html_escaped("&lt;"), "&amp;lt;");
}

TEST(HtmlText, WhatIsNotUtf8IsReplaced) {
  EXPECT_EQ(html_escaped("Sp\xc3\xb6t"), "Sp\xc3\xb6t");
  EXPECT_EQ(html_escaped("Sp\xf6t"), "Sp\xef\xbf\xbdt");
  EXPECT_EQ(Json::parse(json_for_html({{"name", "Sp\xf6t"}}))["name"], "Sp\xef\xbf\xbdt");
}

TEST(HtmlText, JsonCannotEndItsScript) {
  for (const char* hostile : {"</script><b>", "<!--", "<script>", "]]>", "\\</script>"}) {
    const Json j = {{hostile, hostile}, {"list", {hostile}}};
    const std::string text = json_for_html(j);
    EXPECT_EQ(text.find('<'), std::string::npos) << text;
    EXPECT_EQ(Json::parse(text), j);
  }
}

}  // namespace
}  // namespace multimesh::tools

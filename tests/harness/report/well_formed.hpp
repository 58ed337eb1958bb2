// SPDX-License-Identifier: GPL-3.0-or-later
// A strict reader of the XML that reports are made of: it accepts less than XML 1.0 allows, and
// nothing else.
#pragma once

#include <cctype>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::harness::testing {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<Element> children;
  std::string text;  ///< its own, children apart

  /// All elements of that name below this one, in order.
  [[nodiscard]] std::vector<const Element*> all(const std::string& wanted) const {
    std::vector<const Element*> result;
    for (const Element& child : children) {
      if (child.name == wanted) result.push_back(&child);
      for (const Element* below : child.all(wanted)) result.push_back(below);
    }
    return result;
  }
  [[nodiscard]] const std::string& operator[](const std::string& attribute) const { return attributes.at(attribute); }
};

/// Throws std::runtime_error on anything that is not well-formed.
class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : text_(text) {}

  Element document() {
    for (const std::string_view prolog : {"<?xml version=\"1.0\" encoding=\"UTF-8\"?>", "<!DOCTYPE html>"})
      if (text_.starts_with(prolog)) text_.remove_prefix(prolog.size());
    skip_blanks();
    expect("<");
    Element root = element();
    skip_blanks();
    require(text_.empty(), "something after the root");
    return root;
  }

 private:
  static void require(bool holds, const std::string& what) {
    if (!holds) throw std::runtime_error("not well-formed: " + what);
  }
  void expect(std::string_view token) {
    require(text_.starts_with(token), "expected " + std::string(token) + " at " + std::string(text_.substr(0, 40)));
    text_.remove_prefix(token.size());
  }
  bool accept(std::string_view token) {
    if (!text_.starts_with(token)) return false;
    text_.remove_prefix(token.size());
    return true;
  }
  void skip_blanks() {
    while (!text_.empty() && (text_[0] == ' ' || text_[0] == '\n')) text_.remove_prefix(1);
  }
  std::string name() {
    std::string result;
    for (; !text_.empty() && (std::isalnum(static_cast<unsigned char>(text_[0])) || text_[0] == '-');
         text_.remove_prefix(1))
      result += text_[0];
    require(!result.empty(), "expected a name");
    return result;
  }

  /// One character of text, decoded.
  std::string character() {
    const auto byte = static_cast<unsigned char>(text_[0]);
    if (byte == '&') return reference();
    require(byte != '<' && byte != 0x7f && (byte >= 0x20 || byte == '\n'), "a character that text may not hold");
    const std::size_t length = byte < 0x80 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
    require((byte < 0x80 || byte >= 0xc2) && byte <= 0xf4 && text_.size() >= length, "no UTF-8");
    const std::string result(text_.substr(0, length));
    for (std::size_t i = 1; i < length; ++i)
      require((static_cast<unsigned char>(result[i]) & 0xc0U) == 0x80, "no UTF-8");
    for (const std::string_view bad : {"\xef\xbf\xbe", "\xef\xbf\xbf"}) require(result != bad, "U+FFFE, U+FFFF");
    if (length > 1) {
      const auto second = static_cast<unsigned char>(result[1]);
      require(!(byte == 0xe0 && second < 0xa0) && !(byte == 0xed && second >= 0xa0),
              "no UTF-8: overlong, or a surrogate");
      require(!(byte == 0xf0 && second < 0x90) && !(byte == 0xf4 && second >= 0x90),
              "no UTF-8: overlong, or beyond U+10FFFF");
    }
    text_.remove_prefix(length);
    return result;
  }
  std::string reference() {
    static const std::map<std::string_view, std::string> known{{"&amp;", "&"},   {"&lt;", "<"},  {"&gt;", ">"},
                                                               {"&quot;", "\""}, {"&#39;", "'"}, {"&#9;", "\t"},
                                                               {"&#10;", "\n"},  {"&#13;", "\r"}};
    for (const auto& [written, meant] : known)
      if (accept(written)) return meant;
    require(false, "an unknown reference");
    return "";
  }

  /// What follows a "<".
  Element element() {
    Element result;
    result.name = name();
    while (accept(" ")) {
      const std::string attribute = name();
      expect("=\"");
      std::string value;
      while (!text_.starts_with('"')) {
        require(!text_.empty(), "an attribute without an end");
        value += character();
      }
      text_.remove_prefix(1);
      require(result.attributes.emplace(attribute, value).second, "an attribute twice");
    }
    if (accept("/>")) return result;
    expect(">");
    while (!accept("</")) {
      require(!text_.empty(), "an element without an end");
      if (accept("<")) result.children.push_back(element());
      else result.text += character();
    }
    expect(result.name + ">");
    return result;
  }

  std::string_view text_;
};

inline Element read_xml(std::string_view text) { return XmlReader(text).document(); }

}  // namespace fathom::harness::testing

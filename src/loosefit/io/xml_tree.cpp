#include "loosefit/io/xml_tree.h"

#include <expat.h>
#include <fmt/format.h>

#include <memory>
#include <string_view>
#include <type_traits>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"
#include "loosefit/io/text_encoding.h"

namespace loosefit::io {
namespace {

constexpr std::size_t kDeepest = 200, kMostElements = 500'000;

struct Builder {
  XML_Parser parser = nullptr;
  XmlElement root;                ///< whose first child is the document's
  std::vector<XmlElement*> open;  ///< from the root on
  std::size_t elements = 0;
  std::string fault;  ///< that ended the reading

  void stop(const std::string& why) {
    if (fault.empty()) fault = why;
    XML_StopParser(parser, XML_FALSE);
  }
};

std::string local_name(const char* name) {
  const std::string text = name;
  return text.starts_with("svg:") ? text.substr(4) : text;
}

void on_start(void* user, const char* name, const char** attributes) {
  Builder& b = *static_cast<Builder*>(user);
  if (b.open.size() > kDeepest) return b.stop(fmt::format("{} elements in each other", kDeepest));
  if (++b.elements > kMostElements) return b.stop(fmt::format("{} elements", kMostElements));
  XmlElement element;
  element.name = local_name(name);
  element.line = static_cast<int>(XML_GetCurrentLineNumber(b.parser));
  for (; attributes[0]; attributes += 2) element.attributes[attributes[0]] = attributes[1];
  // Elder siblings may move in memory, open elements never do: only the last of a list is open.
  std::vector<XmlElement>& list = b.open.back()->children;
  list.push_back(std::move(element));
  b.open.push_back(&list.back());
}

void on_end(void* user, const char*) { static_cast<Builder*>(user)->open.pop_back(); }

void on_text(void* user, const char* text, int length) {
  static_cast<Builder*>(user)->open.back()->text.append(text, static_cast<std::size_t>(length));
}

}  // namespace

const std::string& XmlElement::attribute(const std::string& key) const {
  static const std::string none;
  const auto found = attributes.find(key);
  return found == attributes.end() ? none : found->second;
}

XmlElement parse_xml(const std::string& written, const std::string& file) {
  // An editor that saves UTF-16 leaves the encoding that the head names: the bytes are believed.
  const bool wide = std::string_view(written).substr(0, 4).find('\0') != std::string_view::npos;
  const std::string converted = wide ? plain_text(written) : std::string();
  const std::string& text = wide ? converted : written;
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(wide ? "UTF-8" : nullptr), &XML_ParserFree);
  if (!parser) throw InvalidInput({file, 0, {}}, "no memory for the XML reader", "some");
  Builder builder;
  builder.parser = parser.get();
  builder.open = {&builder.root};
  XML_SetUserData(parser.get(), &builder);
  XML_SetElementHandler(parser.get(), on_start, on_end);
  XML_SetCharacterDataHandler(parser.get(), on_text);
  // In pieces, since expat counts bytes in int.
  constexpr std::size_t kPiece = 1 << 20;
  for (std::size_t at = 0;; at += kPiece) {
    const std::size_t size = std::min(kPiece, text.size() - std::min(at, text.size()));
    const bool last = at + size >= text.size();
    if (XML_Parse(parser.get(), text.data() + std::min(at, text.size()), static_cast<int>(size),
                  last) == XML_STATUS_ERROR) {
      const int line = static_cast<int>(XML_GetCurrentLineNumber(parser.get()));
      const std::string why = builder.fault.empty()
                                  ? std::string(XML_ErrorString(XML_GetErrorCode(parser.get())))
                                  : "more than " + builder.fault;
      throw InvalidInput({file, line, "XML"}, why, "well-formed XML of usual size");
    }
    if (last) break;
  }
  return std::move(builder.root.children.front());
}

}  // namespace loosefit::io

// formats/svg_import/element_tree.cpp: the elements of an SVG document, as Expat finds them.
#include "formats/svg_import/element_tree.h"

#include <expat.h>

#include <algorithm>
#include <climits>
#include <exception>
#include <memory>

#include "pliant/boundary/fault.h"

namespace pliant::svg {
namespace {

constexpr std::string_view svg_space = "http://www.w3.org/2000/svg";
constexpr std::string_view xlink_space = "http://www.w3.org/1999/xlink";
constexpr std::string_view inkscape_space = "http://www.inkscape.org/namespaces/inkscape";
constexpr char between = '\n';           // separates namespace and local name, and occurs in neither
constexpr int most_entity_bytes = 1024;  // longest entity: programs abbreviate namespaces by entities, nothing longer

std::string place(long line, long column) {
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// The functions that Expat calls. An exception must not pass through C code: the first one is kept, and the parser
/// is stopped.
class Builder {
 public:
  explicit Builder(std::vector<Element>& elements)
      : elements_(elements), parser_(XML_ParserCreateNS(nullptr, between)) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(),
        [](void* self, const char* name, const char** attributes) {
          static_cast<Builder*>(self)->guard([&](Builder& b) { b.start(name, attributes); });
        },
        [](void* self, const char*) { static_cast<Builder*>(self)->guard([](Builder& b) { b.open_.pop_back(); }); });
    XML_SetCharacterDataHandler(parser_.get(), [](void* self, const char* text, int length) {
      static_cast<Builder*>(self)->guard([&](Builder& b) { b.add_text({text, static_cast<std::size_t>(length)}); });
    });
    XML_SetProcessingInstructionHandler(parser_.get(), [](void* self, const char* target, const char*) {
      if (std::string_view(target) == "xml-stylesheet") static_cast<Builder*>(self)->names_sheets_ = true;
    });
    XML_SetEntityDeclHandler(parser_.get(), [](void* self, const char* name, int is_parameter, const char* value,
                                               int length, const char*, const char*, const char*, const char*) {
      static_cast<Builder*>(self)->guard([&](Builder& b) {
        b.check_entity(
            name, is_parameter != 0,
            value == nullptr ? nullptr : std::make_unique<std::string>(value, static_cast<std::size_t>(length)));
      });
    });
  }

  bool names_sheets() const { return names_sheets_; }

  void parse(std::string_view bytes) {
    if (bytes.size() > INT_MAX) throw InputError("", "the file has more than 2 GB");
    // The document is parsed in one call: fed in pieces, Expat 2.5 starts a long attribute anew at every piece.
    const XML_Status status = XML_Parse(parser_.get(), bytes.data(), static_cast<int>(bytes.size()), 1);
    if (failure_) std::rethrow_exception(failure_);
    if (status == XML_STATUS_OK) return;
    throw InputError(here(), std::string("no well-formed XML: ") + XML_ErrorString(XML_GetErrorCode(parser_.get())));
  }

 private:
  template <class Work>
  void guard(const Work& work) {
    if (failure_) return;
    try {
      work(*this);
    } catch (...) {
      failure_ = std::current_exception();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }

  long line() const { return static_cast<long>(XML_GetCurrentLineNumber(parser_.get())); }
  long column() const { return static_cast<long>(XML_GetCurrentColumnNumber(parser_.get())) + 1; }
  std::string here() const { return place(line(), column()); }

  void start(std::string_view name, const char** attributes) {
    if (open_.size() >= max_depth)
      throw InputError(here(), "elements are nested deeper than " + std::to_string(max_depth));
    if (elements_.size() >= max_elements)
      throw InputError(here(), "more than " + std::to_string(max_elements) + " elements");
    Element element;
    const std::size_t cut = name.find(between);
    if (cut != std::string_view::npos) {
      if (name.substr(0, cut) == svg_space) element.name = name.substr(cut + 1);
    } else if (elements_.empty() ? name == "svg" : has_no_space_) {
      has_no_space_ = true;
      element.name = name;
    }
    if (elements_.empty() && element.name != "svg")
      throw InputError(here(), "expected the root element svg of an SVG document, found '" +
                                   std::string(name.substr(cut == std::string_view::npos ? 0 : cut + 1)) + "'");
    if (!element.name.empty())
      for (const char** a = attributes; *a != nullptr; a += 2) add_attribute(element, a[0], a[1]);
    element.line = line();
    element.column = column();
    const int index = static_cast<int>(elements_.size());
    if (!open_.empty()) {
      element.parent = open_.back();
      elements_[static_cast<std::size_t>(open_.back())].children.push_back(index);
    }
    elements_.push_back(std::move(element));
    open_.push_back(index);
  }

  static void add_attribute(Element& element, std::string_view name, const char* value) {
    const std::size_t cut = name.find(between);
    if (cut == std::string_view::npos)
      element.attributes.emplace_back(name, value);
    else if (name.substr(0, cut) == xlink_space && name.substr(cut + 1) == "href")
      element.attributes.emplace_back("xlink:href", value);
    else if (name.substr(0, cut) == inkscape_space && name.substr(cut + 1) == "label")
      element.attributes.emplace_back("inkscape:label", value);
  }

  void add_text(std::string_view text) {
    if (open_.empty()) return;
    Element& element = elements_[static_cast<std::size_t>(open_.back())];
    if (element.name == "style" || element.name == "title") element.text += text;
  }

  /// Refuses entities that refer to others. The rest cannot grow faster than the file, and Expat limits the factor.
  void check_entity(const char* name, bool is_parameter, const std::unique_ptr<std::string>& value) {
    std::string why;
    if (is_parameter)
      why = "is a parameter entity";
    else if (!value)
      why = "is external";
    else if (value->find('&') != std::string::npos)
      why = "refers to others";
    else if (value->size() > most_entity_bytes)
      why = "is longer than " + std::to_string(most_entity_bytes) + " bytes";
    if (!why.empty())
      throw InputError(here(), "the entity '" + std::string(name) + "' " + why + "; such entities are not read");
  }

  struct Freer {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
  };

  std::vector<Element>& elements_;
  std::vector<int> open_;
  bool has_no_space_ = false, names_sheets_ = false;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, Freer> parser_;
  std::exception_ptr failure_;
};

}  // namespace

const std::string* Element::find(std::string_view attribute) const {
  for (const auto& [name_of, value] : attributes)
    if (name_of == attribute) return &value;
  return nullptr;
}

ElementTree::ElementTree(std::string_view bytes) {
  if (std::all_of(bytes.begin(), bytes.end(), [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }))
    throw InputError("", "the input is empty; expected an SVG document");
  Builder builder(elements_);
  builder.parse(bytes);
  names_sheets_ = builder.names_sheets();
  for (int i = 0; i < size(); ++i)
    if (const std::string* id = (*this)[i].find("id")) ids_.emplace(*id, i);
}

int ElementTree::find(const std::string& id) const {
  const auto found = ids_.find(id);
  return found == ids_.end() ? no_element : found->second;
}

std::string place_of(const Element& element) { return place(element.line, element.column); }

}  // namespace pliant::svg

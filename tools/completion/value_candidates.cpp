// tools/completion/value_candidates.cpp: the names that a value may have, from the input on the command line.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <map>

#include "completion/completion.h"
#include "completion/document_names.h"
#include "completion/value_type.h"
#include "pliant/flow/velocity_field.h"
#include "pliant/quality/metrics.h"

namespace pliant {
namespace {

/// A command line that is still being written.
struct TypedLine {
  std::vector<std::string> positionals;
  std::map<std::string, std::string> values;  ///< of options, by the name that was typed

  std::string value(const std::string& option) const {
    const auto found = values.find(option);
    return found == values.end() ? "" : found->second;
  }
};

TypedLine read_line(const CLI::App& app, const std::vector<std::string>& words) {
  TypedLine line;
  bool has_ended = false;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    const std::size_t equals = word.find('=');
    if (has_ended || word == "-" || !word.starts_with('-')) {
      line.positionals.push_back(word);
    } else if (word == "--") {
      has_ended = true;
    } else if (word.starts_with("--") && equals != std::string::npos) {
      line.values[word.substr(0, equals)] = word.substr(equals + 1);
    } else if (!word.starts_with("--") && word.size() > 2) {
      line.values[word.substr(0, 2)] = word.substr(2);
    } else {
      const CLI::Option* const option = app.get_option_no_throw(word);
      if (option != nullptr && takes_value(*option) && k + 1 < words.size()) line.values[word] = words[++k];
    }
  }
  return line;
}

/// The positional arguments in their order, without those for which an option stands (STEP, if --step is given).
std::vector<const CLI::Option*> positionals_of(const CLI::App& app, const TypedLine& line) {
  std::vector<const CLI::Option*> wanted;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) continue;
    std::string stand_in = "--" + option->get_name();
    std::ranges::transform(stand_in, stand_in.begin(), [](unsigned char c) { return std::tolower(c); });
    if (!line.values.contains(stand_in)) wanted.push_back(option);
  }
  return wanted;
}

class Candidates {
 public:
  Candidates(const CLI::App& app, const TypedLine& line, std::string option, std::string typed)
      : app_(app), line_(line), option_(std::move(option)), typed_(std::move(typed)) {}

  void add(const ValueType& type) {
    if (type.word == "FLOW") return add_flows();
    if (type.word.empty()) {
      if (!type.literal.empty()) found_.push_back(type.literal);
      return;
    }
    if (!is_name_word(type.word)) return;
    std::string end = type.follows.empty() || type.follows.starts_with("[.") ? "" : type.follows.substr(0, 1);
    const bool by_face = type.follows.starts_with("[@FACE]");
    if (by_face) end = "=";
    if (type.follows.starts_with(":") && typed_.find(':') != std::string::npos) return;  // behind the name
    for (const std::string& name : names(type.word)) {
      found_.push_back(type.literal + name + end);
      if (by_face)
        for (const std::string& face : names("FACE")) found_.push_back(name + "@" + face + end);
    }
    if (type.follows.starts_with(":")) found_.push_back("*:");  // of the mesh as a whole
  }

  const std::vector<std::string>& found() const { return found_; }

 private:
  std::vector<std::string> names(const std::string& word) {
    if (word == "METRIC") {
      std::vector<std::string> list;
      for (const Metric& metric : all_metrics()) list.emplace_back(metric.name);
      return list;
    }
    if (word == "FACE") return document().faces;
    if (word == "CURVE") return document().curves;
    if (word == "PARAMETER") return parameters();
    std::vector<std::string> list;
    for (const DocumentNames::Field& field : document().fields) list.push_back(field.name);
    return list;
  }

  std::vector<std::string> parameters() {
    const std::string problem = line_.value("--problem");
    return problem.empty() ? document().parameters : names_in_file(problem).parameters;
  }

  /// The document whose names are wanted: INPUT, but the field of a flow is in the flow's own file.
  const DocumentNames& document() {
    if (is_read_) return document_;
    is_read_ = true;
    if (option_ == "--flow-field") return document_ = names_in_file(line_.value("--flow"));
    const std::vector<const CLI::Option*> wanted = positionals_of(app_, line_);
    for (std::size_t k = 0; k < wanted.size() && k < line_.positionals.size(); ++k)
      if (wanted[k]->get_name() == "INPUT") document_ = names_in_file(line_.positionals[k]);
    return document_;
  }

  void add_flows() {
    const std::size_t colon = typed_.find(':');
    for (const NamedFlow& flow : named_flows()) {
      if (colon == std::string::npos) found_.push_back(flow.name);
      if (colon == std::string::npos || typed_.substr(0, colon) != flow.name) continue;
      const std::string before = typed_.substr(0, typed_.find_last_of(":,") + 1);
      for (const NamedFlow::Parameter& parameter : flow.parameters)
        if (before.find(":" + parameter.name + "=") == std::string::npos &&
            before.find("," + parameter.name + "=") == std::string::npos)
          found_.push_back(before + parameter.name + "=");
    }
    if (colon == std::string::npos) found_.push_back("help");
  }

  const CLI::App& app_;
  const TypedLine& line_;
  std::string option_, typed_;
  DocumentNames document_;
  bool is_read_ = false;
  std::vector<std::string> found_;
};

std::string print(const ValueForm& form, const std::vector<std::string>& found) {
  std::string text;
  if (form.is_file) {
    text = "files";
    for (const std::string& extension : form.extensions) text += " " + extension;
  }
  text += '\0';
  for (const std::string& each : found) (text += each) += '\0';
  return text;
}

}  // namespace

std::string value_candidates(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.size() < 2) return {};
  const TypedLine line = read_line(app, {words.begin() + 2, words.end()});
  const std::string& name = words[0];
  if (name.empty()) {
    const std::vector<const CLI::Option*> wanted = positionals_of(app, line);
    const std::size_t place = std::min(line.positionals.size(), wanted.size());
    return print(place < wanted.size() ? form_of(app, *wanted[place]) : ValueForm{}, {});
  }
  const CLI::Option* const option = app.get_option_no_throw(name);
  if (option == nullptr) return print({}, {});
  Candidates candidates(app, line, name, words[1]);
  for (const ValueType& type : value_types(option->get_type_name())) candidates.add(type);
  return print(form_of(app, *option), candidates.found());
}

}  // namespace pliant

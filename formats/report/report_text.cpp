// formats/report/report_text.cpp: tables with fixed columns.
#include "formats/report/report_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "pliant/geometry/describe.h"

namespace pliant {
namespace {

constexpr std::size_t columns = 80;
constexpr double text_resolution = 1e-4;  // of the mesh's size: places

[[gnu::format(printf, 2, 3)]] void print(std::string& out, const char* format, ...) {
  std::array<char, 512> text;
  va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(text.data(), text.size(), format, arguments);
  va_end(arguments);
  out.append(text.data(), std::min(static_cast<std::size_t>(std::max(length, 0)), text.size() - 1));
}

/// Blanks in place of control characters, by which a document could move the terminal's cursor.
std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7F; }, ' ');
  return text;
}

/// Bytes of whole UTF-8 characters that fit the columns, dots where some had to go.
std::string shortened(const std::string& text, std::size_t width) {
  std::size_t characters = 0, keep = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if ((static_cast<unsigned char>(text[k]) & 0xC0) == 0x80) continue;
    if (characters == width - 2) keep = k;
    ++characters;
  }
  const std::string result = printable(characters <= width ? text : text.substr(0, keep) + "..");
  return result + std::string(width - std::min(characters, width), ' ');
}

/// Breaks at blanks; `indent` blanks before every line but the first.
void print_wrapped(std::string& out, const std::string& text, std::size_t first_column, std::size_t indent) {
  std::size_t column = first_column, start = 0;
  while (start < text.size()) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    if (column + 1 + (end - start) > columns && column > indent) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (start > 0) {
      out += ' ';
      ++column;
    }
    out.append(text, start, end - start);
    column += end - start;
    start = end + 1;
  }
  out += '\n';
}

/// A character a bin, eight heights: empty bins stay blank, the smallest count shows. More than `most_cells` bins are
/// drawn together.
std::string bars(const std::vector<std::int64_t>& histogram, std::size_t most_cells) {
  constexpr std::array<const char*, 9> heights{" ",      "\u2581", "\u2582", "\u2583", "\u2584",
                                               "\u2585", "\u2586", "\u2587", "\u2588"};
  std::vector<std::int64_t> cells(std::min(histogram.size(), most_cells), 0);
  for (std::size_t k = 0; k < histogram.size(); ++k) cells[k * cells.size() / histogram.size()] += histogram[k];
  const std::int64_t most = std::max<std::int64_t>(1, *std::ranges::max_element(cells));
  std::string result;
  for (const std::int64_t count : cells) {
    const double part = static_cast<double>(count) / static_cast<double>(most);
    result += heights[static_cast<std::size_t>(std::ceil(8 * part))];
  }
  return result;
}

std::string number(double value) {
  if (std::isnan(value)) return "-";
  std::string text;
  print(text, "%.4g", value);
  return text;
}
std::string number(std::int64_t value) { return std::to_string(value); }

/// With the digits of a sum of round steps, as far as the column takes them.
std::string time_text(double time) {
  std::string text;
  print(text, "%.11g", time);
  if (text.size() <= 11) return text;
  text.clear();
  print(text, "%.5g", time);
  return text;
}

void print_counts(std::string& out, const QualityReport& report) {
  const auto row = [&out](const char* first, const std::string& a, const char* second, const std::string& b,
                          const char* third, const std::string& c) {
    print(out, "%-10s %11s   %-14s %11s   %-12s %11s\n", first, a.c_str(), second, b.c_str(), third, c.c_str());
  };
  row("triangles", number(report.triangles), "degree", std::to_string(report.degree), "invalid",
      number(report.invalid));
  row("vertices", number(report.vertices), "control points", number(report.control_points), "degenerate",
      number(report.degenerate));
  row("area", number(report.area), "time", time_text(report.time), "overlaps", number(report.overlaps));
  row("faces", std::to_string(report.faces.size()), "tangent jump",
      report.tangent_jump ? number(*report.tangent_jump) : "-", "faults", std::to_string(report.faults.size()));
}

void print_elements(std::string& out, const std::string& what, std::int64_t count, const std::vector<BadElement>& shown,
                    double resolution) {
  if (shown.empty()) return;
  std::string list = what + ", with the places of their centres:";
  for (const BadElement& element : shown)
    list += " " + std::to_string(element.triangle) + "(" + describe_number(element.centroid.x, resolution) + "," +
            describe_number(element.centroid.y, resolution) + ")";
  if (count > static_cast<std::int64_t>(shown.size())) list += " ...";
  print_wrapped(out, list, 0, 2);
}

void print_overlaps(std::string& out, const QualityReport& report) {
  for (const OverlapPlace& overlap : report.overlap_places) {
    std::string text = "overlap at " + describe_point(overlap.place, text_resolution * report.size) + ": ";
    if (overlap.first == none || overlap.second == none)
      text += overlap.first == none ? "curves cross"
                                    : "triangle " + std::to_string(overlap.first) + " lies on another part of the mesh";
    else
      text +=
          "edges of triangles " + std::to_string(overlap.first) + " and " + std::to_string(overlap.second) + " meet";
    print_wrapped(out, text, 0, 2);
  }
  if (report.duplicate_points > 0)
    print_wrapped(out, std::to_string(report.duplicate_points) + " vertices are at the place of another one", 0, 2);
  if (report.unused_points > 0)
    print_wrapped(out, std::to_string(report.unused_points) + " points are in no triangle", 0, 2);
}

void print_faces(std::string& out, const std::vector<FaceFigures>& faces) {
  if (faces.empty()) return;
  print(out, "\n%-34s %12s %15s %15s\n", "face", "triangles", "area", "perimeter");
  for (const FaceFigures& face : faces)
    print(out, "%s %12s %15s %15s\n", shortened(face.name, 34).c_str(), number(face.triangles).c_str(),
          number(face.area).c_str(), number(face.perimeter).c_str());
}

void print_fields(std::string& out, const std::vector<FieldFigures>& fields) {
  if (fields.empty()) return;
  print(out, "\n%-31s %15s %15s %15s\n", "field", "min", "max", "integral");
  for (const FieldFigures& field : fields) {
    for (std::size_t c = 0; c < field.min.size(); ++c) {
      const std::string name = field.min.size() == 1 ? field.name : field.name + "." + std::to_string(c);
      print(out, "%s %15s %15s %15s\n", shortened(name, 31).c_str(), number(field.min[c]).c_str(),
            number(field.max[c]).c_str(), number(field.integral[c]).c_str());
    }
  }
}

void print_metrics(std::string& out, const std::vector<MetricSummary>& metrics) {
  print(out, "\n%-16s %15s %15s %15s %10s\n", "metric", "min", "mean", "max", "missing");
  for (const MetricSummary& metric : metrics)
    print(out, "%-16s %15s %15s %15s %10s\n", metric.name.c_str(), number(metric.min).c_str(),
          number(metric.mean).c_str(), number(metric.max).c_str(),
          metric.missing > 0 ? number(metric.missing).c_str() : "-");
}

void print_histograms(std::string& out, const std::vector<MetricSummary>& metrics) {
  const char* title = "\ndistribution           from\n";
  for (const MetricSummary& metric : metrics) {
    if (metric.histogram.empty() || metric.count == 0) continue;
    out += title;
    title = "";
    print(out, "%-16s %10s |%s| %s\n", metric.name.c_str(), number(metric.histogram_low).c_str(),
          bars(metric.histogram, 38).c_str(), number(metric.histogram_high).c_str());
  }
}

void print_worst(std::string& out, const std::vector<MetricSummary>& metrics) {
  const char* title = "\nworst            triangle:value\n";
  for (const MetricSummary& metric : metrics) {
    if (metric.worst.empty()) continue;
    out += title;
    title = "";
    std::string list;
    for (const WorstElement& worst : metric.worst)
      list += (list.empty() ? "" : " ") + std::to_string(worst.triangle) + ":" + number(worst.value);
    print(out, "%-16s ", metric.name.c_str());
    print_wrapped(out, list, 17, 17);
  }
}

void print_history(std::string& out, const std::vector<HistoryEntry>& history) {
  const char* title = "\nmade by\n";
  for (const HistoryEntry& entry : history) {
    out += title;
    title = "";
    std::string words = entry.tool + " " + entry.version;
    for (const std::string& option : entry.options) words += " " + option;
    print_wrapped(out, printable(words), 0, 2);
  }
}

}  // namespace

void write_report_text(const QualityReport& report, const std::vector<HistoryEntry>& history, const std::string& title,
                       std::string& out) {
  print_wrapped(out, title, 0, 2);
  const double resolution = text_resolution * report.size;
  print_counts(out, report);
  print_elements(out, "invalid", report.invalid, report.invalid_elements, resolution);
  print_elements(out, "degenerate", report.degenerate, report.degenerate_elements, resolution);
  for (const Fault& fault : report.faults)
    print_wrapped(out, fault.invariant + " " + fault.place + ": " + fault.text, 0, 2);
  print_overlaps(out, report);
  print_faces(out, report.faces);
  print_fields(out, report.fields);
  print_metrics(out, report.metrics);
  print_histograms(out, report.metrics);
  print_worst(out, report.metrics);
  print_history(out, history);
}

}  // namespace pliant

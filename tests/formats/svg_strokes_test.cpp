// tests/formats/svg_strokes_test.cpp: strokes as curves and as areas, clip paths, lengths on the page.
#include <numbers>
#include <random>

#include "drawn_boundary.h"

using namespace pliant;
using namespace pliant::samples;

namespace {

constexpr double pi = std::numbers::pi;

double painted(const std::string& content, double tolerance = 1e-6, int degree = 2) {
  SvgReadOptions options;
  options.strokes = Strokes::area;
  options.tolerance = tolerance;
  options.degree = degree;
  return area(samples::svg("<g fill='none' stroke='black'>" + content + "</g>"), options);
}

/// Is p within reach of the polyline of a path, as a stroke with round joins and caps paints it?
double distance_to(const std::vector<Point>& polyline, const Point& p) {
  double least = HUGE_VAL;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Vector along = polyline[i] - polyline[i - 1];
    if (along == Vector{}) continue;
    const double s = std::clamp(dot(p - polyline[i - 1], along) / squared_length(along), 0.0, 1.0);
    least = std::min(least, distance(p, polyline[i - 1] + s * along));
  }
  return least;
}

}  // namespace

TEST_CASE("the area of a stroke is that of closed forms: lines, caps, joins, rings, dots", "[svg][strokes]") {
  CHECK(painted("<line x2='10' stroke-width='2'/>") == Approx(20).epsilon(1e-9));
  CHECK(painted("<line x2='10' stroke-width='2' stroke-linecap='square'/>") == Approx(24).epsilon(1e-9));
  CHECK(painted("<line x2='10' stroke-width='2' stroke-linecap='round'/>") == Approx(20 + pi).epsilon(1e-5));
  // A right angle of legs 10: butt ends, width 2. Two rectangles share half a square; the wedges fill the corner.
  const std::string corner = "<path d='M0 0h10v10' stroke-width='2' ";
  CHECK(painted(corner + "stroke-linejoin='bevel'/>") == Approx(39.5).epsilon(1e-9));
  CHECK(painted(corner + "stroke-linejoin='miter'/>") == Approx(40).epsilon(1e-9));
  CHECK(painted(corner + "stroke-linejoin='miter' stroke-miterlimit='1.4'/>") == Approx(39.5).epsilon(1e-9));
  CHECK(painted(corner + "stroke-linejoin='miter' stroke-miterlimit='1.42'/>") == Approx(40).epsilon(1e-9));
  CHECK(painted(corner + "stroke-linejoin='round'/>") == Approx(39 + pi / 4).epsilon(1e-5));
  CHECK(painted("<path d='M0 0h10v10h-10z' stroke-width='2'/>") == Approx(80).epsilon(1e-9));
  for (const int degree : {2, 3}) {
    CHECK(painted("<circle r='10' stroke-width='2'/>", 1e-7, degree) == Approx(40 * pi).epsilon(1e-5));
    // The hole closes where the radius is half the width or less.
    CHECK(painted("<circle r='1' stroke-width='4'/>", 1e-7, degree) == Approx(9 * pi).epsilon(1e-5));
    CHECK(painted("<circle r='1' stroke-width='2'/>", 1e-7, degree) == Approx(4 * pi).epsilon(1e-5));
  }
  CHECK(painted("<path d='M5 5z' stroke-width='2' stroke-linecap='round'/>") == Approx(pi).epsilon(1e-5));
  CHECK(painted("<path d='M5 5h0' stroke-width='2' stroke-linecap='square'/>") == Approx(4).epsilon(1e-9));
  CHECK_THROWS_WITH(painted("<path d='M5 5h0' stroke-width='2'/>"), Catch::Contains("nothing is filled"));
  CHECK_THROWS_WITH(painted("<path d='M5 5' stroke-width='2' stroke-linecap='round'/>"), Catch::Contains("nothing"));
  // Transforms: the pen is transformed with the outline.
  CHECK(painted("<line x2='10' stroke-width='2' transform='scale(3 5)'/>") == Approx(300).epsilon(1e-9));
  CHECK(painted("<circle r='10' stroke-width='2' transform='matrix(3 1 0 .5 7 9)'/>", 1e-7) ==
        Approx(60 * pi).epsilon(1e-5));
  // A part of a size that the drawing does not have is taken for 1.
  CHECK(painted("<line x2='10' style='stroke-width: 50%'/>") == Approx(10).epsilon(1e-9));
}

TEST_CASE("dashes paint their lengths, from the offset on, and through the start of closed paths", "[svg][strokes]") {
  CHECK(painted("<line x2='10' stroke-width='2' stroke-dasharray='2'/>") == Approx(12).epsilon(1e-9));
  CHECK(painted("<line x2='10' stroke-width='2' stroke-dasharray='2 1 3'/>") == Approx(2 * (2 + 3 + 1)).epsilon(1e-9));
  CHECK(painted("<line x2='10' stroke-width='2' stroke-dasharray='2' stroke-dashoffset='1'/>") ==
        Approx(10).epsilon(1e-9));
  CHECK(painted("<line x2='10' stroke-width='2' stroke-dasharray='4 6' stroke-dashoffset='-3'/>") ==
        Approx(8).epsilon(1e-9));
  CHECK(painted("<path d='M0 0h10v10h-10z' stroke-width='2' stroke-dasharray='15 5' stroke-dashoffset='5'/>") ==
        Approx(2 * 30 + 0.0).epsilon(1e-9));
  CHECK(painted("<circle r='10' stroke-width='2' stroke-dasharray='5 5'/>", 1e-7) > 0.45 * 40 * pi);
  CHECK(painted("<line x2='10' stroke-width='1' stroke-linecap='square' stroke-dasharray='0 2'/>") ==
        Approx(5).epsilon(1e-9));
  CHECK(painted("<path d='M0 0h10v10h-10z' stroke-width='1' stroke-linecap='square' stroke-dasharray='0 2'/>") ==
        Approx(20).epsilon(1e-9));
  CHECK(painted("<line x2='10' stroke-width='2' stroke-dasharray='0 0'/>") == Approx(20).epsilon(1e-9));
  CHECK(painted("<line x2='8' stroke-width='1' stroke-linecap='round' stroke-dasharray='0 2' "
                "stroke-dashoffset='-1'/>") == Approx(pi).epsilon(1e-5));
  CHECK_THROWS_WITH(painted("<line x2='1e9' stroke-dasharray='1e-3'/>"), Catch::Contains("dashes"));
  // The dashes of all subpaths count: 90,000 are read, twice as many are not.
  CHECK_THROWS_WITH(painted("<path d='M0 0h9000M0 9h9000' stroke-dasharray='.1'/>"), Catch::Contains("100000 dashes"));
  // A list of dashes is kept for each stroke that inherits it.
  std::string list, lines;
  for (int i = 0; i < 2000; ++i) list += "1 ";
  for (int i = 0; i < 1001; ++i) lines += "<path d='M0 0h1'/>";
  CHECK_THROWS_WITH(painted("<g stroke-dasharray='" + list + "'>" + lines + "</g>"),
                    Catch::Contains("more than 2000000 lengths"));
}

TEST_CASE("a stroke with round joins and caps paints what is within half its width of the path", "[svg][strokes]") {
  for (const char* d : {"M0 0C30 40 -10 40 20 0", "M0 0C60 30 -40 30 20 0", "M0 0C20 30 20 30 0 0", "M0 0Q10 30 12 0",
                        "M0 0a6 3 20 1 1 9 4", "M0 0C10 10 10 0 0 10S-20 0 5 3z", "M0 0L20 1L0 2L20 30z",
                        "M0 0h20h-10v10", "M0 0C1 8 2 8 3 0"})
    for (const double half : {0.7, 4.5}) {
      CAPTURE(d, half);
      std::vector<Point> line;
      for (const Curve& curve :
           [&] {
             SvgReadOptions lines;
             lines.strokes = Strokes::curves;
             lines.tolerance = 1e-4;
             return read(samples::svg("<rect x='-99' y='-99' width='200' height='200'/><path d='" + std::string(d) +
                                      "' fill='none' stroke='red'/>"),
                         lines);
           }()
               .boundary.curves)
        if (curve.left == curve.right)
          for (std::size_t s = 0; s + 1 < curve.spline.breaks().size(); ++s)
            for (int i = 0; i <= 12; ++i)
              line.push_back(curve.spline.evaluate(curve.spline.breaks()[s] * (12 - i) / 12 +
                                                   curve.spline.breaks()[s + 1] * i / 12));
      SvgReadOptions options;
      options.strokes = Strokes::area;
      options.tolerance = 1e-5;
      const SvgImport import = read(samples::svg("<path d='" + std::string(d) +
                                                 "' fill='none' stroke='red' stroke-linejoin='round' "
                                                 "stroke-linecap='round' stroke-width='" +
                                                 std::to_string(2 * half) + "'/>"),
                                    options);
      // The area by a raster of distances.
      Box box;
      for (const Point& p : line) box.extend(p);
      box.low -= Vector{half, half};
      box.high += Vector{half, half};
      const double h = std::max(box.high.x - box.low.x, box.high.y - box.low.y) / 160;
      double raster = 0;
      for (double x = box.low.x + h / 2; x < box.high.x + h; x += h)
        for (double y = box.low.y + h / 2; y < box.high.y + h; y += h)
          raster += h * h * std::clamp(0.5 - (distance_to(line, {x, y}) - half) / h, 0.0, 1.0);
      CHECK(face_area(import.boundary, 0) == Approx(raster).epsilon(3e-3));
    }
}

TEST_CASE("offset curves are within the tolerance of the true ones", "[svg][strokes]") {
  SvgReadOptions options;
  options.strokes = Strokes::area;
  options.tolerance = 1e-4;
  const SvgImport import = read(samples::svg("<circle r='10' fill='none' stroke='red' stroke-width='2'/>"), options);
  CHECK(worst(import.boundary, [](const Point& p) { return std::abs(std::hypot(p.x, p.y) - 10) - 1; }) <
        1e-4 * import.size);
  long spans = 0;
  for (const auto& span : spans_of(import.boundary)) spans += span.size() > 2 ? 1 : 1000;
  CHECK(spans < 100);  // curves, not polylines
}

TEST_CASE("strokes have the names of their shapes, and a default that leaves them out", "[svg][strokes]") {
  const std::string drawing = samples::svg(
      "<rect id='a' width='9' height='9' stroke='red'/>"
      "<line id='b' x1='20' x2='29' stroke='red'/>");
  SvgReadOptions options;
  options.planar = true;
  CHECK(read(drawing, options).boundary.faces.size() == 1);
  options.strokes = Strokes::area;
  const SvgImport import = read(drawing, options);
  REQUIRE(import.boundary.faces.size() == 3);
  CHECK(import.boundary.faces[1].name == "a stroke");
  CHECK(import.boundary.faces[2].name == "b");
  CHECK(face_area(import.boundary, "a") == Approx(64));
  CHECK(face_area(import.boundary, "a stroke") == Approx(36));
  // The fill hides half of a stroke that is painted before it.
  for (const auto& [order, fill] : std::vector<std::pair<std::string, double>>{
           {"normal", 64}, {"fill", 64}, {"markers", 64}, {"stroke", 81}, {"markers stroke", 81}}) {
    const std::string text = "<rect id='a' width='9' height='9' stroke='red' paint-order='" + order + "'/>";
    CHECK(face_area(read(samples::svg(text), options).boundary, "a") == Approx(fill));
  }
  for (const char* d : {"stroke-width='0'", "stroke-opacity='0'", "visibility='hidden'", "opacity='0'"})
    CHECK_THROWS(read_svg(samples::svg("<line x2='9' stroke='red' " + std::string(d) + "/>"), options));
  CHECK_THROWS_WITH(read_svg(samples::svg("<line x2='9' stroke='red'/>")), Catch::Contains("--strokes area"));
  options.strokes = Strokes::curves;
  CHECK_THROWS_WITH(read_svg(samples::svg("<line x2='9' stroke='red'/>"), options), Catch::Contains("only cut faces"));
}

TEST_CASE("clip paths cut: both units, rules, transforms, groups, nested ones, unions", "[svg][clips]") {
  const auto clipped = [](const std::string& clip, const std::string& shape, const std::string& attributes = "") {
    SvgReadOptions options;
    options.planar = true;
    return area(samples::svg("<clipPath id='c' " + attributes + ">" + clip +
                             "</clipPath><rect width='1' height='1' x='99'/>" + shape),
                options) -
           1;
  };
  const std::string square = "<rect width='10' height='10' clip-path='url(#c)'/>";
  CHECK(clipped("<rect width='5' height='20'/>", square) == Approx(50));
  CHECK(clipped("<rect width='5' height='20'/>", "<rect width='10' height='10' style=\"clip-path:url('#c')\"/>") ==
        Approx(50));
  CHECK(clipped("<rect width='5' height='20'/><rect y='5' width='20' height='9'/>", square) == Approx(75));
  CHECK(clipped("<rect width='.5' height='.5'/>", square, "clipPathUnits='objectBoundingBox'") == Approx(25));
  CHECK(clipped("<path d='M0 0H8V8H0zM2 2H6V6H2z'/>", square) == Approx(64));
  CHECK(clipped("<path clip-rule='evenodd' d='M0 0H8V8H0zM2 2H6V6H2z'/>", square) == Approx(48));
  CHECK(clipped("<path d='M0 0H8V8H0zM2 2H6V6H2z'/>", square, "clip-rule='evenodd'") == Approx(48));
  CHECK(clipped("<rect width='5' height='5' transform='translate(2 2)'/>", square, "transform='scale(2)'") ==
        Approx(36));
  CHECK(clipped("<rect width='5' height='5'/>", "<g transform='scale(2)'>" + square + "</g>") == Approx(100));
  CHECK(clipped("<rect width='5' height='5'/>",
                "<g clip-path='url(#c)' transform='translate(1)'><rect width='3' "
                "height='9'/><rect x='3' width='3' height='9'/></g>") == Approx(25));
  CHECK(clipped("<rect width='5' height='5'/>",
                "<g clip-path='url(#c)'><g clip-path='url(#d)'><rect width='9' "
                "height='9'/></g></g><clipPath id='d'><rect width='2' "
                "height='9'/></clipPath>") == Approx(10));
  CHECK(clipped("<rect width='5' height='5'/>", square + "<clipPath id='d'><rect width='2' height='9'/></clipPath>",
                "clip-path='url(#d)'") == Approx(10));
  CHECK(clipped("<rect width='5' height='5' clip-path='url(#d)'/><rect x='8' width='2' height='1'/>",
                square + "<clipPath id='d'><rect width='2' height='9'/></clipPath>") == Approx(12));
  CHECK(clipped("<use href='#r' x='2'/>", square + "<defs><rect id='r' width='5' height='5'/></defs>") == Approx(25));
  CHECK(clipped("<circle r='5' cx='5' cy='5'/>", square) == Approx(25 * pi).epsilon(1e-5));
  CHECK(clipped("", square) == Approx(0).margin(1e-12));
  CHECK(clipped("<rect width='5' height='5' display='none'/>", square) == Approx(0).margin(1e-12));
  // A reference to nothing clips nothing.
  CHECK(clipped("", "<rect width='10' height='10' clip-path='url(#none)'/>") == Approx(100));
  SvgReadOptions options;
  options.planar = true;
  CHECK_THROWS_WITH(
      read_svg(samples::svg("<clipPath id='c' clip-path='url(#d)'><rect width='1' height='1'/></clipPath><clipPath "
                            "id='d'><rect width='2' height='2' clip-path='url(#c)'/></clipPath>" +
                            square),
               options),
      Catch::Contains("clips itself"));
  CHECK_THROWS_WITH(read_svg(samples::svg("<clipPath id='c'/>" + square), options), Catch::Contains("nothing is seen"));
  // Without --planar they are named.
  const SvgImport plain = read_svg(samples::svg("<clipPath id='c'><rect width='1' height='1'/></clipPath>" + square));
  REQUIRE(plain.warnings.size() == 1);
  CHECK_THAT(plain.warnings[0], Catch::Contains("--planar"));
}

TEST_CASE(
    "a piece that is fitted to a cubic or a circle turns by at most 60 degrees, so that no mesh cuts it whatever the "
    "tolerance",
    "[svg]") {
  for (const int degree : {2, 3})
    for (const double tolerance : {1e-6, 1e-2, 1.0}) {
      SvgReadOptions options;
      options.degree = degree;
      options.tolerance = tolerance;
      const SvgImport import = read_svg(
          "<svg><circle r='5'/><rect x='10' width='30' height='8' rx='3'/><path d='M0 20a9 9 0 0 1 9 9z'/></svg>",
          options);
      for (const Curve& curve : import.boundary.curves) {
        const std::vector<double> breaks = curve.spline.breaks();
        std::vector<Point> span(static_cast<std::size_t>(curve.spline.degree()) + 1);
        for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
          curve.spline.extract(breaks[s], span);
          const Vector first = span[1] - span[0], last = span.back() - span[span.size() - 2];
          CHECK(dot(first, last) >= (0.5 - 1e-6) * length(first) * length(last));
        }
      }
    }
}

TEST_CASE("a unit gives lengths on the page, from width, height and viewBox", "[svg]") {
  const auto box_in = [](LengthUnit unit, const std::string& attributes, const std::string& content) {
    SvgReadOptions options;
    options.unit = unit;
    const Box found = bounding_box(read_svg("<svg " + attributes + ">" + content + "</svg>", options).boundary);
    std::string out;
    for (const double value : {found.low.x, -found.high.y, found.high.x, -found.low.y}) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.6g", std::abs(value) < 1e-12 ? 0 : value);
      out += (out.empty() ? "" : " ") + std::string(digits);
    }
    return out;
  };
  const std::string square = "<rect x='20' y='10' width='40' height='40'/>";
  CHECK(box_in(LengthUnit::mm, "width='100mm' viewBox='0 0 200 100'", square) == "10 5 30 25");
  CHECK(box_in(LengthUnit::cm, "width='100mm' viewBox='0 0 200 100'", square) == "1 0.5 3 2.5");
  CHECK(box_in(LengthUnit::mm, "height='50mm' viewBox='0 0 200 100'", square) == "10 5 30 25");
  CHECK(box_in(LengthUnit::in, "width='2in' height='1in' viewBox='0 0 200 100'", square) == "0.2 0.1 0.6 0.5");
  CHECK(box_in(LengthUnit::px, "width='2in' height='1in' viewBox='0 0 192 96'", square) == "20 10 60 50");
  // The page's upper left corner is the origin.
  CHECK(box_in(LengthUnit::mm, "width='100mm' height='50mm' viewBox='20 10 200 100'", square) == "0 0 20 20");
  // A page that is wider than the viewBox has it in its middle, or stretches it.
  CHECK(box_in(LengthUnit::mm, "width='200mm' height='50mm' viewBox='0 0 200 100'", square) == "60 5 80 25");
  CHECK(box_in(LengthUnit::mm, "width='200mm' height='50mm' viewBox='0 0 200 100' preserveAspectRatio='xMinYMin'",
               square) == "10 5 30 25");
  CHECK(box_in(LengthUnit::mm, "width='200mm' height='50mm' viewBox='0 0 200 100' preserveAspectRatio='none'",
               square) == "20 5 60 25");
  // Without a size, or with a part of the window, a user unit is a px: 96 to the inch.
  CHECK(box_in(LengthUnit::in, "", "<rect width='96' height='48'/>") == "0 0 1 0.5");
  CHECK(box_in(LengthUnit::in, "width='100%' viewBox='0 0 9 9'", "<rect width='96' height='48'/>") == "0 0 1 0.5");
  CHECK(box_in(LengthUnit::mm, "width='50mm' height='9mm'", "<rect width='1in' height='20mm'/>") == "0 0 25.4 20");
  CHECK(box_in(LengthUnit::mm, "",
               "<svg width='20mm' height='20mm' viewBox='0 0 2 2'><rect width='1' height='1'/></svg>") == "0 0 10 10");
  for (const char* page :
       {"width='0' viewBox='0 0 1 1'", "width='-1mm' viewBox='0 0 1 1'", "height='50vh'",
        "width='10mm' viewBox='0 0 0 5'", "width='1e60in' height='1e60in' viewBox='0 0 1e-300 1e-300'"})
    CHECK_THROWS_WITH(box_in(LengthUnit::mm, page, square), Catch::StartsWith("svg: "));
}

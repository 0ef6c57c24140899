// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/readers/sniff.hpp"

#include <algorithm>
#include <array>

#include "core/io/readers/binary.hpp"
#include "core/io/readers/text.hpp"

namespace arcbid::readers {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kLegal =
    "legal are PCD, PLY, OBJ, STL, LAS and text with x y z in each line";

/// What is recognised only to be refused. In `advice` {} is the file, {stem} its name without
/// ending.
struct Refused {
  std::string_view start, what, advice;
};
constexpr Refused kRefused[] = {
    {"ASTM-E57", "an E57 scan", "convert it: pdal translate {} {stem}.las"},
    {"\x1f\x8b"sv, "gzip-compressed", "unpack it first: gunzip {}"},
    {"PK\x03\x04", "a ZIP archive", "unpack it first: unzip {}"},
    {"BZh", "bzip2-compressed", "unpack it first: bunzip2 {}"},
    {"\xfd"
     "7zXZ",
     "xz-compressed", "unpack it first: unxz {}"},
    {"7z\xbc\xaf", "a 7-Zip archive", "unpack it first: 7z x {}"},
    {"(\xb5/\xfd", "zstd-compressed", "unpack it first: unzstd {}"},
    {"AutoCAD Binary DXF", "a DXF drawing", "save it as OBJ or STL in a CAD program"},
    {"AC10", "a DWG drawing", "save it as OBJ or STL in a CAD program"},
    {"ISO-10303-21", "an IFC or STEP model", "convert it: IfcConvert {} {stem}.obj"},
    {"glTF", "a glTF model", "convert it: assimp export {} {stem}.obj"},
    {"Kaydara FBX Binary", "an FBX model", "convert it: assimp export {} {stem}.obj"},
    {"; FBX", "an FBX model", "convert it: assimp export {} {stem}.obj"},
    {"BLENDER", "a Blender scene", "export it as PLY or OBJ in Blender"},
    {"OFF\n", "an OFF mesh", "convert it: assimp export {} {stem}.obj"},
    {"OFF\r\n", "an OFF mesh", "convert it: assimp export {} {stem}.obj"},
    {"# vtk DataFile", "a VTK file", "save it as PLY in ParaView"},
    {"AC3D", "an AC3D model", "convert it: assimp export {} {stem}.obj"},
    {"%PDF", "a PDF document", kLegal},
    {"\x89PNG", "a PNG picture", kLegal},
    {"\xff\xd8\xff", "a JPEG picture", kLegal},
    {"\x89HDF", "an HDF5 file", kLegal},
    {"\x89MCAP", "an MCAP recording", "write its PointCloud2 messages to PCD first"},
    {"#ROSBAG", "a ROS bag", "write its PointCloud2 messages to PCD first"},
    {"SQLite format 3", "an SQLite database", kLegal},
    {"\xff\xfe", "UTF-16 text or binary data", kLegal},
    {"{", "JSON", "if it is glTF convert it: assimp export {} {stem}.obj"},
    {"<", "XML or HTML", "if it is COLLADA or X3D convert it: assimp export {} {stem}.obj"}};

std::string ending(const Source& source) {
  return lower_case(std::filesystem::path(source.name).extension().string());
}

/// A file name as a shell takes it.
std::string shell_word(const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return std::string_view(" '\"\\$&|;<>()*?[]`!#~").find(c) == std::string_view::npos;
  });
  return plain ? name : fmt::format("\"{}\"", name);
}

[[noreturn]] void refuse(const Source& source, std::string_view what, std::string_view advice) {
  const std::filesystem::path path(source.name);
  std::string text(advice);
  const auto replace = [&](std::string_view mark, const std::string& by) {
    if (const auto at = text.find(mark); at != text.npos) text.replace(at, mark.size(), by);
  };
  std::filesystem::path stem = path;
  stem.replace_extension();
  replace("{stem}.las", shell_word(stem.string() + ".las"));
  replace("{stem}.obj", shell_word(stem.string() + ".obj"));
  replace("{}", shell_word(source.name));
  fail(source, "is {}, which is not read: {}", what, text);
}

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kStlHeaderBytes + kStlFacetBytes) return false;
  const std::uint64_t count = load_le<std::uint32_t>(bytes, kStlHeaderBytes - 4);
  return bytes.size() == kStlHeaderBytes + count * kStlFacetBytes;
}

bool is_dxf(std::string_view bytes) {
  Lines lines(bytes.substr(0, 256));
  const auto code = lines.next(), section = lines.next();
  return code && section && words(*code) == std::vector<std::string_view>{"0"} &&
         words(*section) == std::vector<std::string_view>{"SECTION"};
}

bool is_text(std::string_view bytes) {
  return bytes.substr(0, 4096).find('\0') == bytes.npos;
}

/// The format of a text by its first telling line: a keyword of OBJ or PCD, or three numbers.
std::optional<Format> sniff_text(std::string_view bytes) {
  static constexpr std::array<std::string_view, 11> kObjKeys{
      "v", "vn", "vt", "vp", "f", "o", "g", "s", "mtllib", "usemtl", "l"};
  static constexpr std::array<std::string_view, 3> kPcdKeys{"VERSION", "FIELDS", "COLUMNS"};
  constexpr std::size_t kLinesTried = 30;
  Lines lines(bytes);
  for (std::size_t tried = 0; tried < kLinesTried;) {
    const auto line = lines.next();
    if (!line) break;
    if (line->starts_with("# .PCD")) return Format::pcd;
    const auto row = words(line->substr(0, 1000), ",;");
    if (row.empty() || row[0].starts_with('#')) continue;
    ++tried;
    const auto is_key = [&](const auto& keys) {
      return row.size() > 1 && std::find(keys.begin(), keys.end(), row[0]) != keys.end();
    };
    if (is_key(kPcdKeys)) return Format::pcd;
    if (is_key(kObjKeys)) return Format::obj;
    const auto numbers = std::count_if(row.begin(), row.end(),
                                       [](auto word) { return to_number(word).has_value(); });
    if (numbers >= 3) return Format::xyz;
  }
  return std::nullopt;
}

std::optional<Format> by_content(const Source& source) {
  const std::string_view bytes = source.bytes;
  if (bytes.starts_with("LASF")) return Format::las;
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r\n")) return Format::ply;
  if (is_binary_stl(bytes)) return Format::stl;
  if (is_text_stl(bytes)) return Format::stl;
  const std::string_view trimmed =
      bytes.substr(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  for (const Refused& entry : kRefused) {
    if (trimmed.starts_with(entry.start)) refuse(source, entry.what, entry.advice);
  }
  if (is_dxf(bytes)) refuse(source, "a DXF drawing", "save it as OBJ or STL in a CAD program");
  // A binary PCD has a text header, and its payload may begin within the part that is looked at.
  if (bytes.starts_with("# .PCD") || bytes.starts_with("VERSION ")) return Format::pcd;
  return is_text(bytes) ? sniff_text(bytes) : std::nullopt;
}

std::optional<Format> by_ending(const Source& source) {
  static constexpr struct {
    std::string_view ending;
    Format format;
  } kEndings[] = {{".pcd", Format::pcd}, {".ply", Format::ply}, {".obj", Format::obj},
                  {".stl", Format::stl}, {".las", Format::las}, {".laz", Format::las},
                  {".xyz", Format::xyz}, {".pts", Format::xyz}, {".csv", Format::xyz}};
  for (const auto& entry : kEndings) {
    if (ending(source) == entry.ending) return entry.format;
  }
  return std::nullopt;
}

}  // namespace

std::string_view name(Format format) {
  static constexpr std::array<std::string_view, 6> kNames{"PCD", "PLY", "OBJ",
                                                          "STL", "LAS", "XYZ text"};
  return kNames[static_cast<std::size_t>(format)];
}

Format sniff(const Source& source, std::vector<std::string>& warnings) {
  const auto content = by_content(source), named = by_ending(source);
  if (!content) {
    // A binary STL has no magic number: only its name can tell a truncated one from noise.
    if (named == Format::stl) return Format::stl;
    if (named) {
      fail(source, "is not a {} file, it starts with {}: {}", name(*named),
           in_quotes(source.bytes.substr(0, 16)), kLegal);
    }
    fail(source, "the format is not known, it starts with {}: {}",
         in_quotes(source.bytes.substr(0, 16)), kLegal);
  }
  if (named && *named != *content) {
    warnings.push_back(fmt::format("the content is {}, not {} as the name says: read as {}",
                                   name(*content), name(*named), name(*content)));
  }
  return *content;
}

bool is_text_stl(std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == bytes.npos || lower_case(bytes.substr(begin, 5)) != "solid") return false;
  if (is_binary_stl(bytes)) return false;
  const std::string head = lower_case(bytes.substr(begin, 1024));
  if (head.find('\0') != head.npos) return false;  // a truncated binary one
  return head.find("facet") != head.npos || head.find("endsolid") != head.npos;
}

void refuse_laz(const Source& source) {
  const std::filesystem::path path(source.name);
  std::filesystem::path las = path;
  las.replace_extension(".las");
  if (las == path) las.replace_extension(".plain.las");
  const std::string from = shell_word(source.name), to = shell_word(las.string());
  fail(source,
       "is compressed LAS (LAZ), which is not read: laszip -i {} -o {} (or: pdal translate {} {})",
       from, to, from, to);
}

}  // namespace arcbid::readers

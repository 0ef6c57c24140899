// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/structure_reader.hpp"

#include "core/io/readers/clean.hpp"
#include "core/io/readers/decoders.hpp"
#include "core/io/readers/diagnose.hpp"
#include "core/io/readers/sniff.hpp"
#include "core/io/readers/source.hpp"

namespace arcbid {
namespace {

using namespace readers;

RawGeometry decode(Format format, const Source& source) {
  switch (format) {
    case Format::pcd:
      return decode_pcd(source);
    case Format::ply:
      return decode_ply(source);
    case Format::obj:
      return decode_obj(source);
    case Format::stl:
      return decode_stl(source);
    case Format::las:
      return decode_las(source);
    case Format::xyz:
      return decode_xyz(source);
  }
  return {};
}

}  // namespace

StructureInput read_structure(const std::filesystem::path& file, const ReadOptions& options) {
  metres_per_unit(options);  // a wrong option is reported before a large file is read
  const std::string bytes = load(file);
  Source source{display_name(file), bytes};
  if (source.bytes.starts_with("\xef\xbb\xbf"))
    source.bytes.remove_prefix(3);  // UTF-8 byte order mark

  std::vector<std::string> warnings;
  RawGeometry raw = decode(sniff(source, warnings), source);
  clean(source, raw);
  refuse_degrees(source, raw);
  to_local_frame(raw, options);
  judge_extents(source, raw, options);

  warnings.insert(warnings.end(), raw.warnings.begin(), raw.warnings.end());
  for (std::string& warning : warnings) warning.insert(0, source.name + ": ");
  return {{std::move(raw.points), std::move(raw.triangles)}, std::move(warnings)};
}

}  // namespace arcbid

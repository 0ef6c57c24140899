// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/record/records.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/NotEnoughMemoryException.h>

#include <algorithm>

#include "core/io/record/cdr.hpp"
#include "core/io/record/json.hpp"
#include "core/io/record/named_reader.hpp"
#include "core/io/record/schema.hpp"

namespace arcbid {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

/// Zeros to begin with: Fast CDR skips what it pads, and equal records must have equal bytes.
template <class Record>
std::string encoded(const Record& record) {
  thread_local std::string room(4096, '\0');
  while (true) {
    FastBuffer buffer(room.data(), room.size());
    Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
    try {
      cdr.serialize_encapsulation();
      CdrWriter writer(cdr);
      fields(writer, record);
      const std::size_t used = cdr.getSerializedDataLength();
      std::string bytes(room.data(), used);
      std::fill_n(room.begin(), used, '\0');
      return bytes;
    } catch (const eprosima::fastcdr::exception::NotEnoughMemoryException&) {
      room.assign(2 * room.size(), '\0');
    }
  }
}

template <class Record>
void read_into(Record& record, std::string_view bytes, const StoredSchema* stored) {
  // Fast CDR reads from where it could also write.
  FastBuffer buffer(const_cast<char*>(bytes.data()), bytes.size());
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  try {
    cdr.read_encapsulation();
    if (stored) {
      record = {};
      NamedReader(cdr).read(stored->record(), record);
      return;
    }
    CdrReader reader(cdr, bytes.size());
    fields(reader, record);
  } catch (const eprosima::fastcdr::exception::Exception& error) {
    throw InputError(fmt::format("not a whole {}: {}", record_name<Record>, error.what()));
  }
}

template <class Record>
Record decoded(std::string_view bytes, const StoredSchema* stored) {
  Record record;
  read_into(record, bytes, stored);
  return record;
}

}  // namespace

void decode_into(Step& record, std::string_view bytes, const StoredSchema* stored) {
  read_into(record, bytes, stored);
}

#define ARCBID_ENCODED(Type)                \
  std::string encode(const Type& record) {  \
    return encoded(record);                 \
  }                                         \
  template <>                               \
  std::string schema_of<Type>() {           \
    return SchemaWriter::of<Type>();        \
  }                                         \
  template <>                               \
  std::string_view name_of_record<Type>() { \
    return record_name<Type>;               \
  }
#define ARCBID_DECODED(Type)                                        \
  template <>                                                       \
  Type decode(std::string_view bytes, const StoredSchema* stored) { \
    return decoded<Type>(bytes, stored);                            \
  }
#define ARCBID_SHOWN(Type)                     \
  nlohmann::json to_json(const Type& record) { \
    return JsonWriter::of(record);             \
  }

ARCBID_ENCODED(Step)
ARCBID_ENCODED(Update)
ARCBID_ENCODED(Birth)
ARCBID_ENCODED(PlannedRoute)
ARCBID_ENCODED(Mission)
ARCBID_ENCODED(BidMessage)
ARCBID_ENCODED(RelayMessage)
ARCBID_ENCODED(StatusMessage)
ARCBID_ENCODED(DecisionMade)
ARCBID_ENCODED(Agreement)

ARCBID_DECODED(Step)
ARCBID_DECODED(Birth)
ARCBID_DECODED(PlannedRoute)
ARCBID_DECODED(Mission)
ARCBID_DECODED(StatusMessage)
ARCBID_DECODED(BidMessage)

ARCBID_SHOWN(Step)
ARCBID_SHOWN(Update)
ARCBID_SHOWN(Mission)
ARCBID_SHOWN(BidMessage)
ARCBID_SHOWN(RelayMessage)
ARCBID_SHOWN(StatusMessage)

}  // namespace arcbid

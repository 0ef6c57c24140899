// SPDX-License-Identifier: GPL-3.0-or-later
// SQLite's handles, closed by themselves.
#pragma once

#include <sqlite3.h>

#include <memory>

namespace arcbid {

struct CloseDatabase {
  void operator()(sqlite3* db) const { sqlite3_close_v2(db); }
};
struct FinalizeStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;
using SqlStatement = std::unique_ptr<sqlite3_stmt, FinalizeStatement>;

}  // namespace arcbid

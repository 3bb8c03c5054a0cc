// A store as a file: what makes a database one, and which may be opened. Throws SqliteFailure.
#pragma once

#include <filesystem>
#include <memory>

#include "compiler/store/sqlite_database.h"
#include "compiler/store/store.h"

namespace aspect {

// A sound store for this key, created where there is no file or an empty one; without a key, a
// sound store that is there already. Anything else is refused and left as it is.
std::unique_ptr<SqliteDatabase> open_store_file(const std::filesystem::path& path,
                                                const StoreKey* key);

StoreContents contents_of(const SqliteDatabase& database);

}  // namespace aspect

// tools/measure/table_file.h: a CSV file to which one record after the other is appended, also by one process after the
// other.
#pragma once
#include <string>
#include <string_view>

namespace pliant {

/// A table whose rows begin with a time. The file keeps nothing open between records, and a record says all that is to
/// be known: so a loop of processes that append one each writes the same bytes as one process.
class TableFile {
 public:
  /// `option` is what messages call it.
  TableFile(std::string option, std::string path);
  ~TableFile();
  TableFile(const TableFile&) = delete;
  TableFile& operator=(const TableFile&) = delete;

  const std::string& path() const { return path_; }
  /// Appends `rows`, all of this time, whole or not at all; a file that is new or empty gets the header first.
  ///
  /// Times do not fall in a file: if its last row is of a later time, all rows from this time on go, since they are
  /// those of a run that is now taken up again or made anew. Half a row at the end, of a process that was ended while
  /// it wrote, goes, too. Rows that are the file's last ones already, to the byte, are not appended.
  ///
  /// A device or a FIFO gets the header once, then the rows.
  ///
  /// Requires    header and rows end with a newline each
  /// Throws      UsageError where the file begins with another header (it is left as it is); std::system_error
  void append(std::string_view header, double time, std::string_view rows) const;

 private:
  void append_to_stream(std::string_view header, std::string_view rows) const;

  std::string option_, path_;
  mutable int stream_ = -1;  ///< a device or a FIFO, which stays open
};

}  // namespace pliant

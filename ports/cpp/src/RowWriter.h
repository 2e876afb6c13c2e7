#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace badlog {

/**
 * Writes the lines of a bag into its buffer, cell by cell. Texts are in UTF-8 with quotes according to RFC 4180, and each
 * row ends in one newline. Once the buffer has grown to the longest row, nothing is allocated.
 */
class RowWriter {
public:
    /** The bytes written since the last Clear. */
    std::string_view Bytes() const { return {m_bytes.get(), m_size}; }
    size_t Size() const { return m_size; }

    /** Makes room for this many more bytes. Returns false if memory is lacking. */
    bool Reserve(size_t more);

    void Number(double value);
    void Microseconds(double value);
    void Integer(int64_t value);
    void Truth(bool value) { Text(value ? "true" : "false"); }
    void Text(std::string_view text);
    /** Writes an empty cell: a gap. */
    void Empty() { BeginCell(); }

    /** Ends the row. If there was not enough memory for it, drops it and returns false. */
    bool EndRow();
    /** Discards the cells written since the last row ended. */
    void DropRow();
    /** Discards everything written. */
    void Clear();

private:
    void BeginCell();
    void Encode(std::string_view text, bool doublesQuotes);
    void Put(char byte) { m_bytes[m_size++] = byte; }

    std::unique_ptr<char[]> m_bytes;
    size_t m_capacity = 0;
    size_t m_size = 0;
    size_t m_rowStart = 0;
    size_t m_cells = 0;
    bool m_isTooLong = false;
};

}  // namespace badlog

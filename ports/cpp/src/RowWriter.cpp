#include "RowWriter.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "NumberFormat.h"
#include "Utf8.h"

namespace badlog {
namespace {

// A comma and two quotes for a cell; two quotes for a row of one empty cell, and the newline.
constexpr size_t PUNCTUATION = 8;

bool NeedsQuotes(std::string_view text) {
    return text.find_first_of(",\"\n\r") != std::string_view::npos || HasOuterWhitespace(text);
}

}  // namespace

bool RowWriter::Reserve(size_t more) {
    more += PUNCTUATION;
    if (m_capacity - m_size >= more) return true;
    const auto capacity = std::max(m_capacity * 2, m_size + more);
    std::unique_ptr<char[]> larger{new (std::nothrow) char[capacity]};
    if (!larger) return false;
    if (m_size > 0) std::memcpy(larger.get(), m_bytes.get(), m_size);
    m_bytes = std::move(larger);
    m_capacity = capacity;
    return true;
}

void RowWriter::Number(double value) {
    BeginCell();
    if (m_isTooLong) return;
    m_size = static_cast<size_t>(WriteFiveDigits(value, m_bytes.get() + m_size) - m_bytes.get());
}

void RowWriter::Microseconds(double value) {
    BeginCell();
    if (m_isTooLong) return;
    m_size = static_cast<size_t>(WriteMicroseconds(value, m_bytes.get() + m_size) - m_bytes.get());
}

void RowWriter::Integer(int64_t value) {
    BeginCell();
    if (m_isTooLong) return;
    m_size = static_cast<size_t>(WriteInteger(value, m_bytes.get() + m_size) - m_bytes.get());
}

void RowWriter::Text(std::string_view text) {
    BeginCell();
    // A byte that is not UTF-8 becomes three.
    if (m_isTooLong || !Reserve(text.size() * REPLACEMENT.size())) {
        m_isTooLong = true;
        return;
    }
    const bool isQuoted = NeedsQuotes(text);
    if (isQuoted) Put('"');
    Encode(text, isQuoted);
    if (isQuoted) Put('"');
}

bool RowWriter::EndRow() {
    if (m_isTooLong || !Reserve(0)) {
        DropRow();
        return false;
    }
    // A row of one empty cell would be a blank line, which readers skip.
    if (m_cells == 1 && m_size == m_rowStart) {
        Put('"');
        Put('"');
    }
    Put('\n');
    m_cells = 0;
    m_rowStart = m_size;
    return true;
}

void RowWriter::DropRow() {
    m_size = m_rowStart;
    m_cells = 0;
    m_isTooLong = false;
}

void RowWriter::Clear() {
    m_rowStart = 0;
    DropRow();
}

void RowWriter::BeginCell() {
    if (m_isTooLong || !Reserve(MAX_NUMBER_LENGTH)) {
        m_isTooLong = true;
        return;
    }
    if (m_cells++ > 0) Put(',');
}

void RowWriter::Encode(std::string_view text, bool doublesQuotes) {
    for (size_t i = 0; i < text.size();) {
        const auto character = CharacterAt(text, i);
        if (character.isValid && character.code != 0) {
            if (doublesQuotes && character.code == '"') Put('"');
            for (size_t byte = 0; byte < character.length; byte++) Put(text[i + byte]);
        } else {
            for (const char byte : REPLACEMENT) Put(byte);
        }
        i += character.length;
    }
}

}  // namespace badlog

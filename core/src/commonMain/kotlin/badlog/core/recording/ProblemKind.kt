package badlog.core.recording

/**
 * The kinds of problems of a recording. `docs/bag-format.md` and `docs/wpilog.md` have the rule behind each kind.
 *
 * @property severity the importance of such a problem.
 */
public enum class ProblemKind(public val severity: Severity) {
    /** The bytes are neither a bag, nor a CSV file, nor any other log this library reads. There is nothing to show. */
    NOT_A_RECORDING(Severity.ERROR),

    /** The file has no bytes, or no bytes but NULs. */
    EMPTY_FILE(Severity.ERROR),

    /** The compressed stream ends early; everything that could be inflated was read. */
    GZIP_CUT(Severity.ERROR),

    /** The JSON of line 1 is cut or broken, so units, attributes and values are lost. */
    HEADER_UNREADABLE(Severity.ERROR),

    /** The line of titles does not have a title for each column; the names of the line of JSON were used. */
    TITLES_DAMAGED(Severity.ERROR),

    /** The header is damaged, and a column's name may belong to another column. */
    NAME_IN_DOUBT(Severity.WARNING),

    /** There is a header, but there are no samples. */
    NO_ROWS(Severity.WARNING),

    /** A row was cut off, by a loss of power or by damage, and dropped. */
    ROW_CUT(Severity.ERROR),

    /** The last row lacks its newline, so its last cell may be cut; that cell was read as a gap. */
    LAST_CELL_CUT(Severity.ERROR),

    /** A run of NUL bytes, as file systems leave them after a loss of power. */
    NUL_HOLE(Severity.ERROR),

    /** A text cell that was split by a raw newline was put together again. */
    LINES_JOINED(Severity.WARNING),

    /** Quotes inside a cell were not escaped. The row was read in the way that gives the right number of cells. */
    QUOTES_REPAIRED(Severity.WARNING),

    /** The file has more rows than the maximum; the rest was not read. */
    TOO_MANY_ROWS(Severity.ERROR),

    /** A row has too few cells; the missing ones are gaps. */
    ROW_SHORT(Severity.WARNING),

    /** A row has too many cells; the extra ones were dropped. */
    ROW_LONG(Severity.ERROR),

    /** A blank line was skipped. */
    BLANK_LINE(Severity.NOTE),

    /** The file begins with a byte order mark. */
    BYTE_ORDER_MARK(Severity.NOTE),

    /** Lines end in CRLF or CR. */
    CARRIAGE_RETURNS(Severity.NOTE),

    /** Text is not UTF-8 and was read as Windows-1252. */
    NOT_UTF8(Severity.WARNING),

    /** A CSV file has unusual separators, numbers or column descriptions, and was read accordingly. */
    CSV_DIALECT(Severity.NOTE),

    /** Numbers with a decimal comma were read as if it were a point. */
    DECIMAL_COMMA(Severity.WARNING),

    /** A numeric topic that is not sparse has cells without a value, which are gaps. */
    EMPTY_CELLS(Severity.NOTE),

    /** A numeric topic has cells with text, which are gaps. */
    TEXT_IN_NUMBERS(Severity.WARNING),

    /** `true` and `false` were read as 1 and 0. */
    TRUTH_VALUES(Severity.NOTE),

    /** A sample is `NaN` or an infinity; it was kept as such, and is drawn as a gap. */
    NOT_FINITE(Severity.NOTE),

    /** The header names a topic that has no column. */
    TOPIC_WITHOUT_COLUMN(Severity.WARNING),

    /** A column is not named in the header, so its unit and attributes are unknown. */
    COLUMN_WITHOUT_TOPIC(Severity.WARNING),

    /** Two topics have one name; the second is shown as `name (2)`. */
    DUPLICATE_TOPIC(Severity.WARNING),

    /** A name has a character other than letters, digits, space, `_` and `/`. */
    UNUSUAL_NAME(Severity.NOTE),

    /** An attribute is not registered; it was kept in the data, but has no effect. */
    UNKNOWN_ATTRIBUTE(Severity.NOTE),

    /** A topic has the same attribute twice. */
    DUPLICATE_ATTRIBUTE(Severity.NOTE),

    /** An attribute cannot be applied to this topic, or not together with another one. */
    UNFIT_ATTRIBUTE(Severity.WARNING),

    /** More than one topic has the `xaxis` attribute; the first one wins. */
    SECOND_X_AXIS(Severity.WARNING),

    /** The x axis goes backwards; derivatives and integrals leave a gap there. */
    X_BACKWARDS(Severity.WARNING),

    /** The x axis repeats a value; derivatives have a gap there. */
    X_REPEATS(Severity.NOTE),

    /** The x axis has no value in some rows, which can therefore not be drawn. */
    X_GAPS(Severity.WARNING),

    /** A few values of the x axis are far away from all others; their samples are not drawn. */
    X_WILD(Severity.WARNING),

    /** A joined graph mixes units, repeats a line's name, or is the graph of an existing topic. */
    UNUSUAL_JOIN(Severity.NOTE),

    /** An integral spans gaps; the area under them is not known and not added. */
    INTEGRAL_OVER_GAPS(Severity.NOTE),

    /** A WPILOG ends inside a record, which was dropped. */
    RECORD_CUT(Severity.ERROR),

    /** Bytes inside a WPILOG are not records; reading continued at the next record. */
    RECORDS_SKIPPED(Severity.ERROR),

    /** From some byte on, a WPILOG has no records; nothing after it can be read. */
    RECORDS_LOST(Severity.ERROR),

    /** A record of a WPILOG does not have the size that its type requires; it was dropped. */
    BAD_RECORD(Severity.ERROR),

    /** A record of a WPILOG belongs to no entry that was started; it was dropped. */
    UNKNOWN_ENTRY(Severity.ERROR),

    /** Records of a WPILOG are from before the robot's clock began; they were moved to the start of the log. */
    EARLY_TIMES(Severity.WARNING),

    /** Records of a WPILOG have impossible times, or times days away from all others; they were dropped. */
    WILD_TIMES(Severity.ERROR),

    /** A WPILOG has more topics, or an array more elements, than can be shown; the others were dropped. */
    TOO_MANY_TOPICS(Severity.ERROR),

    /** A path of a WPILOG has more poses than are shown. */
    LONG_PATH(Severity.NOTE),

    /** Samples of a topic are not in order of time in the file; they were sorted. */
    TIMES_SORTED(Severity.NOTE),

    /** A topic's bytes are of a type that is not decoded; the size of each record is shown. */
    NOT_DECODED(Severity.NOTE),

    /** Whole numbers beyond 2^53 lost their last digits. */
    NUMBERS_ROUNDED(Severity.NOTE),

    /** A log of a match is missing, cannot be read, or has no certain place in the match. It was left out. */
    LOG_LEFT_OUT(Severity.ERROR),
}

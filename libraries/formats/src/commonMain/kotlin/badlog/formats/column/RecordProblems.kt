package badlog.formats.column

import badlog.core.recording.Loss
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList

/** Reports that the bytes from [from] until [until], which may have held [records] records, were skipped. */
internal fun ProblemList.addSkipped(from: Long, until: Long, records: Int = 0) = add(
    ProblemKind.RECORDS_SKIPPED,
    "Bytes $from to ${until - 1} are not records and were skipped; the rest was read.",
    loss = Loss(cells = records, bytes = until - from),
)

/** Reports that nothing could be read from byte [from] to the end, [total]. */
internal fun ProblemList.addLost(from: Long, total: Long) = add(
    ProblemKind.RECORDS_LOST,
    "The last bytes of the file, $from to ${total - 1}, are not records and cannot be read.",
    loss = Loss(bytes = total - from),
)

/** Reports that the file ends inside a record, after [bytes] of its bytes. */
internal fun ProblemList.addCut(bytes: Int) = add(
    ProblemKind.RECORD_CUT,
    "The file ends inside a record, which was dropped.",
    loss = Loss(cells = 1, bytes = bytes.toLong()),
)

/** Reports that there are more records than [max]. */
internal fun ProblemList.addTooMany(max: Int) = add(
    ProblemKind.TOO_MANY_ROWS,
    "The log has more than $max records; the rest was not read.",
)

package badlog.formats.wpilog

import badlog.core.recording.Loss
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.timesText

/** Reports what was odd about the records of one entry: once, after all of them were read. */
internal fun reportEntry(entry: Entry, problems: ProblemList) {
    val decoder = entry.decoder
    val name = entry.name
    if (decoder.badCount > 0) {
        problems.add(
            ProblemKind.BAD_RECORD,
            "Records of “$name” are not of its type, ${entry.type}, and were dropped${timesText(decoder.badCount)}.",
            topic = name,
            count = decoder.badCount,
            loss = Loss(cells = decoder.badCount),
        )
    }
    if (decoder.droppedValues > 0) {
        problems.add(
            ProblemKind.TOO_MANY_TOPICS,
            "Values of “$name” were dropped${timesText(decoder.droppedValues)}: there are more than can be shown.",
            topic = name,
            count = decoder.droppedValues,
            loss = Loss(cells = decoder.droppedValues),
        )
    }
    if (decoder.isUndecoded && decoder.timestamps.size > 0 && entry.type != Entry.MESSAGE_SCHEMA) {
        problems.add(
            ProblemKind.NOT_DECODED,
            "“$name” has the type ${entry.type}, which badlog cannot decode; the size of each record is shown instead, in bytes.",
            topic = name,
        )
    }
}

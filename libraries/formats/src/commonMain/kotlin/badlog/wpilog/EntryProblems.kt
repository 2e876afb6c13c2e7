package badlog.wpilog

import badlog.recording.Loss
import badlog.recording.ProblemKind
import badlog.recording.ProblemList

/** Reports what was odd about the records of one entry, once, when all of them were read. */
internal fun reportEntry(entry: Entry, problems: ProblemList) {
    val decoder = entry.decoder
    val name = entry.name
    if (decoder.badCount > 0) {
        problems.add(
            ProblemKind.BAD_RECORD,
            "${decoder.badCount} records of “$name” do not have the bytes of a ${entry.type}; they were dropped.",
            topic = name,
            count = decoder.badCount,
            loss = Loss(cells = decoder.badCount),
        )
    }
    if (decoder.droppedValues > 0) {
        problems.add(
            ProblemKind.TOO_MANY_TOPICS,
            "${decoder.droppedValues} values of “$name” were dropped: there are more than can be shown.",
            topic = name,
            count = decoder.droppedValues,
            loss = Loss(cells = decoder.droppedValues),
        )
    }
    if (decoder.isUndecoded && decoder.timestamps.size > 0 && entry.type != Entry.MESSAGE_SCHEMA) {
        problems.add(
            ProblemKind.NOT_DECODED,
            "“$name” is of type ${entry.type}, which is not decoded; shown is how many bytes each of its " +
                "${decoder.timestamps.size} records has.",
            topic = name,
        )
    }
}

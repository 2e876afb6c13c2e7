package badlog.formats.wpilog

import badlog.core.recording.Loss
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.timesText
import badlog.formats.column.ElementBlocks

/** Reports the oddities in the records of one entry: once, after all of them were read. */
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
    if (decoder.longestPath > 0) {
        problems.add(
            ProblemKind.LONG_PATH,
            "“$name” is a path of up to ${decoder.longestPath} poses; only the first ${ElementBlocks.MAX_ELEMENTS} are shown.",
            topic = name,
        )
    }
    if (decoder.skippedCount > 0) {
        problems.add(
            ProblemKind.NOT_DECODED,
            "The first records of “$name” come long before the description of their type, ${entry.type}, and are not shown" +
                "${timesText(decoder.skippedCount)}.",
            topic = name,
            count = decoder.skippedCount,
        )
    }
}

/** Reports the [entries] that are not decoded; many of one type as one problem. */
internal fun reportUndecoded(entries: Collection<Entry>, problems: ProblemList) {
    val undecoded = entries.filter { it.decoder.isUndecoded && it.decoder.timestamps.size > 0 && it.type != Entry.MESSAGE_SCHEMA }
    for ((type, ofType) in undecoded.groupBy { it.type }) {
        val name = ofType[0].name
        if (ofType.size > SINGLE) {
            problems.add(
                ProblemKind.NOT_DECODED,
                "${ofType.size} topics, such as “$name”, have the type $type, which badlog cannot decode; the size of each record is " +
                    "shown instead, in bytes.",
                count = ofType.size,
            )
            continue
        }
        for (entry in ofType) {
            problems.add(
                ProblemKind.NOT_DECODED,
                "“${entry.name}” has the type $type, which badlog cannot decode; the size of each record is shown instead, in bytes.",
                topic = entry.name,
            )
        }
    }
}

/** Up to this many topics of one type are reported one by one. */
private const val SINGLE = 3

package badlog.cli.output

import badlog.core.analysis.Units
import badlog.core.bag.RecordingWriter
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.formats.wpilog.Omission

/** Writes the header of [recording] and the rows [runs], as a bag or CSV; returns the content that the format cannot express. */
internal fun writeRows(
    recording: Recording,
    format: RecordingFormat,
    runs: List<IntRange>,
    progress: (done: Long, total: Long) -> Unit,
    sink: (ByteArray, Int) -> Unit,
): Omissions {
    val writer = RecordingWriter(recording, format)
    val total = runs.sumOf { it.count() }.toLong()
    var headerSize = 0
    writer.write(0, 0) { bytes, size ->
        headerSize += size
        sink(bytes, size)
    }
    var done = 0L
    for (run in runs) {
        // Each time, the writer begins with the header, which is needed only once.
        var skipped = 0
        val base = done
        writer.write(run.first, run.last + 1, { rows, _ -> progress(base + rows, total) }) { bytes, size ->
            val skip = minOf(headerSize - skipped, size)
            skipped += skip
            if (skip < size) sink(if (skip == 0) bytes else bytes.copyOfRange(skip, size), size - skip)
        }
        done += run.count()
    }
    return omissionsOfNaN(recording) + if (format == RecordingFormat.CSV) omissionsOfCsv(recording) else Omissions()
}

private fun omissionsOfNaN(recording: Recording): Omissions {
    val emptied = recording.topics.associate { it.name to RecordingWriter.emptiedNaNs(it) }.filterValues { it > 0 }
    return Omissions(omissions = emptied.map { (name, count) -> Omission(name, "NaN is written as an empty cell.", count) })
}

private fun omissionsOfCsv(recording: Recording): Omissions {
    val topics = recording.topics
    return Omissions(
        listOfNotNull(
            Omissions.thing(topics.count { !Units.isNone(it.unit) }, "unit"),
            Omissions.thing(topics.sumOf { it.attributes.size }, "attribute"),
            Omissions.thing(recording.values.size, "value"),
        ),
    )
}

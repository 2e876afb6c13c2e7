package badlog.cli.merge

import badlog.cli.output.Omissions
import badlog.cli.output.newLog
import badlog.cli.output.recordsOf
import badlog.cli.output.topicOf
import badlog.files.ReadOptions
import badlog.files.readRecording
import badlog.files.terminal.Progress
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.record.MergedEntry
import badlog.formats.wpilog.record.RecordEntry
import badlog.formats.wpilog.record.RecordLog
import badlog.formats.wpilog.record.RecordMerge
import badlog.formats.wpilog.record.RecordPiece
import badlog.rules.PART_VALUE
import java.nio.file.Path

/**
 * Makes one WPILOG of the unchanged records of several logs.
 *
 * @param parts the logs, without rows.
 */
internal class MergedRecords(parts: List<LogPart>, mode: MergeMode) {
    private class Source(val part: LogPart, val records: RecordLog)

    /** An entry that several logs of a group may have: [entry] in [first], with the records of all of them. */
    private class SharedEntry(val name: String, val first: Source, val entry: RecordEntry) {
        val pieces = ArrayList<RecordPiece>()

        fun add(source: Source, entry: RecordEntry) {
            pieces += RecordPiece(entry, source.part.offset * MICROS)
        }
    }

    private val names = MergedNames()
    private val valueNames = MergedNames()
    private val schemas = HashMap<Pair<String, String>, SharedEntry>()
    private val groups: List<List<LogPart>> = mode.groupsOf(parts).map { group -> group.sortedBy { it.firstX } }

    /** The content of logs with rows that records cannot express. */
    var leftOut = Omissions()
        private set

    /** Writes everything to [target], and returns the result. Call it once. */
    fun write(target: Path, progress: Progress): Merged {
        val sources = groups.map { group -> group.map(::sourceOf) }
        val shared = sharedValues(sources.flatten()) + sources.flatMap(::sharedOf)
        val merge = RecordMerge(
            shared.map { one ->
                val isRenamed = one.name != one.entry.name
                MergedEntry(one.name, one.pieces, if (isRenamed) one.first.part.recording.topicOf(one.entry) else null)
            },
        )
        newLog(target) { stream -> merge.write(progress::advanced) { bytes, size -> stream.write(bytes, 0, size) } }
        val written = readRecording(target, LOG_FORMATS, ReadOptions(keepSamples = false))
        // Only consecutive logs can repeat records.
        val repeated = groups.map { group -> shared.indices.filter { shared[it].first.part in group }.sumOf { merge.repeated[it] } }
        return Merged(written, groups.zip(repeated) { group, count -> Merged.Group(group, count) }, names.renamed + valueNames.renamed)
    }

    private fun sourceOf(part: LogPart): Source {
        if (part.isOfFile) return Source(part, recordsOf(part.file))
        val (records, omissions) = recordsOf(part.recording)
        leftOut += omissions
        return Source(part, records)
    }

    /** Returns the entries of values; equal ones are included once. */
    private fun sharedValues(sources: List<Source>): List<SharedEntry> {
        val known = HashSet<Pair<String, List<Byte>>>()
        return sources.flatMap { source ->
            // Merged parts may be a whole log again.
            val values = source.records.entries.filter { it.isValue && it.size > 0 && it.name != PART_VALUE }
            values.filter { known.add(it.name to it.payload(it.size - 1).asList()) }
                .map { entry -> SharedEntry(valueNames.take(entry.name, source.part), source, entry).apply { add(source, entry) } }
        }
    }

    /** Returns the entries of a [group]: entries with the same name become one, if they have the same type. */
    private fun sharedOf(group: List<Source>): List<SharedEntry> {
        val made = ArrayList<SharedEntry>()
        val known = HashMap<Pair<String, String>, SharedEntry>()
        for (source in group) {
            for (entry in source.records.entries) {
                if (entry.isValue) continue
                // Type descriptions apply to all logs, and are found by name.
                val alike = if (SCHEMA_FOLDER in entry.name) schemas else known
                alike.getOrPut(entry.name to entry.type) {
                    val other = made.find { it.name == entry.name && it.entry.type != entry.type }
                    val reason = other?.let { "its type is ${entry.type}, and ${it.entry.type} in ${it.first.part.file}" }.orEmpty()
                    SharedEntry(names.take(entry.name, source.part, reason), source, entry).also(made::add)
                }.add(source, entry)
            }
        }
        return made
    }
}

private const val MICROS = 1e6
private const val SCHEMA_FOLDER = "/.schema/"

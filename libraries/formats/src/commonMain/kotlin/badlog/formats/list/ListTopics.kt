package badlog.formats.list

import badlog.core.recording.CellCounts
import badlog.core.recording.Loss
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.timesText
import badlog.core.text.UniqueNames
import badlog.core.text.originOf
import badlog.formats.column.ColumnSource
import badlog.formats.column.ElementBlocks
import badlog.formats.column.GrowingDoubles
import badlog.formats.column.MICROS
import badlog.formats.column.SampleBlock
import badlog.formats.column.Timestamps
import badlog.formats.column.reportTopic
import badlog.formats.wpilog.attributesIn
import kotlin.math.round

/** The topics of a list. The first value of each that is not empty shows whether it has numbers, texts or arrays of numbers. */
internal class ListTopics(private val source: ColumnSource, private val problems: ProblemList) {
    private enum class Kind { NUMBERS, TEXTS, ARRAYS }

    private inner class ListedTopic {
        /** The kind of its values; null while all of them are empty. */
        var kind: Kind? = null
        val elements = ElementBlocks(source.keepsSamples) { index, timestamps -> newBlock(kind, index, timestamps) }

        /** The times of the empty values before the kind is known, if samples are kept. */
        val emptyTimes = GrowingDoubles()
        var emptyCount = 0
        var firstEmpty: ListRow? = null
        var textCount = 0
        var firstText = ""
        var firstLine = 0
    }

    private val byName = LinkedHashMap<String, ListedTopic?>()
    private var droppedCount = 0
    private var earlyCount = 0
    private var firstEarly = ""

    private var earliest = Double.POSITIVE_INFINITY

    /** Time 0 of the samples so far, in µs; 0 unless they have times since 1970. */
    val origin: Double get() = originOf(round(earliest * MICROS))

    /** The number of samples so far. */
    var sampleCount = 0
        private set

    /** Adds the sample of [row]. Returns false if it is not one. */
    fun add(row: ListRow): Boolean {
        val time = row.time ?: return false
        val name = row.name ?: return false
        val listed = byName.getOrPut(name) { if (source.hasRoomFor(1)) ListedTopic() else null }
        sampleCount++
        if (time < 0 && earlyCount++ == 0) firstEarly = name
        if (time >= 0 && time < earliest) earliest = time
        when {
            listed == null -> droppedCount++

            listed.isOpenAfter(row) -> listed.hold(row, time)

            else -> {
                decide(listed, row)
                add(listed, row, time)
            }
        }
        return true
    }

    // AdvantageScope writes an empty array as `[]`, DataLogTool as nothing; only a topic of texts has both.
    private fun ListedTopic.isOpenAfter(row: ListRow) = kind == null && isEmpty(row) && firstEmpty?.value?.contentEquals(row.value) != false

    private fun ListedTopic.hold(row: ListRow, time: Double) {
        if (emptyCount++ == 0) firstEmpty = row
        if (source.keepsSamples) emptyTimes.add(time)
    }

    private fun decide(listed: ListedTopic, row: ListRow) {
        if (listed.kind != null) return
        val empty = listed.firstEmpty
        listed.kind = if (empty != null && row !== empty && isEmpty(row)) Kind.TEXTS else kindOf(row)
        if (empty == null) return
        val times = listed.emptyTimes.take()
        for (i in 0 until listed.emptyCount) add(listed, empty, times.getOrElse(i) { 0.0 })
        listed.firstEmpty = null
    }

    private fun kindOf(row: ListRow): Kind = when {
        row.isText -> Kind.TEXTS
        row.value.isEmpty() || row.number != null || truthIn(row) != null -> Kind.NUMBERS
        elementsOf(row) != null -> Kind.ARRAYS
        else -> Kind.TEXTS
    }

    private fun newBlock(kind: Kind?, index: Int, timestamps: Timestamps): SampleBlock? {
        if (index >= ElementBlocks.MAX_ELEMENTS || !source.hasRoomFor(1)) return null
        return SampleBlock(source.columns(listOf(if (kind == Kind.ARRAYS) "[$index]" else "")), timestamps)
    }

    private fun add(listed: ListedTopic, row: ListRow, time: Double) {
        val elements = listed.elements
        if (listed.kind == Kind.ARRAYS) {
            val numbers = elementsOf(row).orEmpty()
            if (numbers.isEmpty() && row.value.isNotEmpty() && !isEmptyArray(row)) noteText(listed, row)
            numbers.forEachIndexed { index, number -> elements.next(index, time)?.columns?.get(0)?.addNumber(number) }
            elements.end(numbers.size, time)
            return
        }
        val column = elements.next(0, time)?.columns?.get(0)
        if (column == null) {
            droppedCount++
            return
        }
        val number = if (listed.kind == Kind.TEXTS || row.isText) null else row.number
        val truth = if (number == null) truthIn(row) else null
        when {
            listed.kind == Kind.TEXTS -> column.addText(row.value, 0, row.value.size)

            number != null -> column.addNumber(number)

            truth != null && !row.isText -> column.addTruth(truth)

            else -> {
                if (row.value.isNotEmpty()) noteText(listed, row)
                column.addGap()
            }
        }
        elements.end(1, time)
    }

    private fun noteText(listed: ListedTopic, row: ListRow) {
        if (listed.textCount++ > 0) return
        listed.firstText = row.textOf(2).take(QUOTED)
        listed.firstLine = row.line
    }

    private fun truthIn(row: ListRow): Boolean? = if (row.value.size in
        TRUTH_SIZES
    ) {
        row.textOf(2).lowercase().toBooleanStrictOrNull()
    } else {
        null
    }

    private fun isEmpty(row: ListRow) = !row.isText && (row.value.isEmpty() || isEmptyArray(row))

    private fun isEmptyArray(row: ListRow) = row.textOf(2).let { it == "[]" || it == "[ ]" }

    /** Returns the numbers of an array: `1;2;3` in a list of DataLogTool, `[1; 2; 3]` in one of AdvantageScope. */
    private fun elementsOf(row: ListRow): List<Double>? {
        val text = row.textOf(2)
        val isBracketed = text.startsWith('[') && text.endsWith(']')
        if (!isBracketed && ';' !in text) return null
        val parts = text.removeSurrounding("[", "]").split(';').map { it.trim() }
        return parts.map { part -> row.numberIn(part) ?: part.toBooleanStrictOrNull()?.let { if (it) 1.0 else 0.0 } ?: return null }
    }

    /** Returns the topics, and reports their oddities. Call it once, last. */
    fun build(): List<Topic> {
        val names = UniqueNames()
        val topics = ArrayList<Topic>()
        for ((name, listed) in byName) if (listed != null) build(name, listed, names, topics)
        if (droppedCount > 0) {
            problems.add(
                ProblemKind.TOO_MANY_TOPICS,
                "There are more topics than can be shown; samples of the others were dropped${timesText(droppedCount)}.",
                count = droppedCount,
                loss = Loss(cells = droppedCount),
            )
        }
        if (earlyCount > 0) {
            problems.add(
                ProblemKind.EARLY_TIMES,
                "Samples from before 0 s, such as one of “$firstEarly”, were moved to 0${timesText(earlyCount)}.",
                count = earlyCount,
            )
        }
        return topics
    }

    private fun build(name: String, listed: ListedTopic, names: UniqueNames, topics: MutableList<Topic>) {
        listed.firstEmpty?.let { decide(listed, it) }
        val span = (if (origin > 0) earliest else 0.0)..Double.MAX_VALUE
        listed.elements.timestamps.finish(span)
        for (block in listed.elements.blocks) {
            block.timestamps.finish(span)
            for (column in block.columns) {
                val like =
                    Topic(name, Topic.UNITLESS, attributesIn("", name), DoubleArray(0), TextColumn.EMPTY, CellCounts(0, 0, 0, 0, 0, 0))
                val topic = column.build(names.give(name + column.path), like, block.timestamps)
                topics += if (topic.counts.texts == 0) topic.copy(attributes = topic.attributes - "log") else topic
                reportTopic(topic, column, block.timestamps, problems)
            }
        }
        if (listed.textCount == 0) return
        problems.add(
            ProblemKind.TEXT_IN_NUMBERS,
            "“$name” has text, such as “${listed.firstText}”, in ${listed.textCount} of its samples; these are gaps.",
            listed.firstLine,
            name,
            listed.textCount,
        )
    }

    private companion object {
        val TRUTH_SIZES = 4..5
        const val QUOTED = 60
    }
}

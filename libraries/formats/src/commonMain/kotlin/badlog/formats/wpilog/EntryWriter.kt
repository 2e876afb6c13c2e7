package badlog.formats.wpilog

import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import kotlin.math.abs
import kotlin.math.floor

/** Writes the samples of [topic], one after another, as records of the entry [id]. */
internal class EntryWriter(
    private val id: Int,
    private val topic: Topic,
    private val times: RecordTimes,
    private val changesOnly: Boolean,
) {
    private enum class Payload(val type: String) {
        BOOLEAN("boolean"),
        INT64("int64"),
        FLOAT("float"),
        DOUBLE("double"),
        STRING("string"),
    }

    private val payload = payloadOf(topic)
    private val positions = times.positionsOf(topic)
    private val dictionary by lazy { topic.texts.dictionary.map { it.encodeToByteArray() } }
    private val isFloating = payload == Payload.FLOAT || payload == Payload.DOUBLE
    private val isNaNValue = isFloating && topic.counts.empty == 0
    private val isNaNGap = isFloating && !isNaNValue && !topic.isSparse

    // An event that occurs twice must be written twice.
    private val happens = topic.kind == TopicKind.EVENT || "log" in topic.attributes
    private var next = 0
    private var nextText = 0
    private var last = Double.NaN
    private var hasLast = false
    private var lastText = -1
    private var gaps = 0
    private var empty = 0
    private var misfits = 0
    private var nowhere = 0

    /** The number of samples skipped because they equal the previous ones. */
    var repeats = 0
        private set

    /** Whether there are samples left. */
    val hasNext: Boolean get() = next < topic.size

    /** The x of the next sample. */
    val nextX: Double get() = positions[next]

    fun start(out: RecordBuffer) {
        val isText = topic.type == "json" || topic.type == "structschema"
        val type = if (isText) topic.type else payload.type
        out.start(id, topic.name, type, metadataOf(topic, type))
    }

    /** Writes the next sample, if it can be written. */
    fun writeNext(out: RecordBuffer) {
        val index = next++
        val texts = topic.texts
        val isText = nextText < texts.size && texts.rows[nextText] == index
        val text = if (isText) texts.ids[nextText++] else -1
        val micros = times.micros(positions[index])
        when {
            micros.isNaN() -> nowhere++
            isText != (payload == Payload.STRING) -> if (isText || hasNumber(index)) misfits++ else empty++
            isText -> writeText(out, micros, text)
            else -> writeNumber(out, micros, topic.samples.getOrElse(index) { Double.NaN })
        }
    }

    private fun hasNumber(index: Int) = topic.samples.isNotEmpty() && !topic.samples[index].isNaN()

    private fun writeText(out: RecordBuffer, micros: Double, text: Int) {
        if (changesOnly && text == lastText && !happens) {
            repeats++
            return
        }
        lastText = text
        out.string(id, micros, dictionary[text])
    }

    private fun writeNumber(out: RecordBuffer, micros: Double, number: Double) {
        if (number.isNaN() && !isNaNValue) {
            // A single NaN ends the previous value, which would otherwise hold.
            val beginsGap = isNaNGap && hasLast && !last.isNaN()
            if (beginsGap) gaps++ else empty++
            if (!beginsGap) return
        }
        if (changesOnly && hasLast && number.toBits() == last.toBits()) {
            repeats++
            return
        }
        last = number
        hasLast = true
        when (payload) {
            Payload.BOOLEAN -> out.boolean(id, micros, number != 0.0)
            Payload.INT64 -> out.int64(id, micros, number.toLong())
            Payload.FLOAT -> out.float(id, micros, number.toFloat())
            else -> out.double(id, micros, number)
        }
    }

    /** Returns the topic's content that the file cannot express. */
    fun omissions(): List<Omission> = buildList {
        if (gaps > 0) add(Omission(topic.name, "Each gap starts with NaN.", gaps))
        if (empty > 0) add(Omission(topic.name, "Empty cells have no record.", empty))
        if (misfits > 0) {
            val what = if (payload == Payload.STRING) "Numbers among texts" else "Texts among numbers"
            add(Omission(topic.name, "$what have no record.", misfits))
        }
        if (payload == Payload.DOUBLE && wholeType(topic) == "int64" && topic.samples.isNotEmpty()) {
            add(Omission(topic.name, "All numbers are of type double, so whole numbers beyond 2^53 are rounded.", topic.counts.numbers))
        }
        if (nowhere > 0) add(Omission(topic.name, "Samples without an x value have no record.", nowhere))
    }

    private companion object {
        const val MAX_EXACT = 9007199254740992.0

        fun payloadOf(topic: Topic): Payload = when {
            topic.kind == TopicKind.STATE || topic.kind == TopicKind.EVENT -> Payload.STRING
            topic.kind == TopicKind.EMPTY -> Payload.entries.firstOrNull { it.type == topic.type } ?: Payload.DOUBLE
            topic.kind == TopicKind.BOOLEAN && topic.samples.all { it == 0.0 || it == 1.0 || it.isNaN() } -> Payload.BOOLEAN
            wholeType(topic) == "int64" && topic.samples.all(::isWhole) -> Payload.INT64
            wholeType(topic) == "float" && topic.samples.all { it.isNaN() || it.toFloat().toDouble() == it } -> Payload.FLOAT
            else -> Payload.DOUBLE
        }

        /** Returns the type of a topic, or of the array that it was an element of. */
        private fun wholeType(topic: Topic) = topic.type.removeSuffix("[]").let { if (it == "int") "int64" else it }

        private fun isWhole(number: Double) = number.isNaN() || (abs(number) <= MAX_EXACT && number == floor(number))
    }
}

/** Entries in the order of their next samples. It is a heap, in which the earlier of two entries with equal times comes first. */
internal class EntryQueue(entries: List<EntryWriter>) {
    private val heap = entries.indices.filter { entries[it].hasNext }.toIntArray()
    private val all = entries
    private var size = heap.size

    init {
        for (i in size / 2 - 1 downTo 0) sink(i)
    }

    /** The entry with the earliest next sample; null if none has one left. */
    val first: EntryWriter? get() = if (size == 0) null else all[heap[0]]

    /** Moves [first] to its new place after its sample was written. */
    fun moveFirst() {
        if (!all[heap[0]].hasNext) heap[0] = heap[--size]
        if (size > 1) sink(0)
    }

    private fun sink(from: Int) {
        var at = from
        while (true) {
            var least = at
            for (child in 2 * at + 1..minOf(2 * at + 2, size - 1)) if (isBefore(heap[child], heap[least])) least = child
            if (least == at) return
            val entry = heap[at]
            heap[at] = heap[least]
            heap[least] = entry
            at = least
        }
    }

    // A sample without a place is handled at once.
    private fun isBefore(one: Int, other: Int): Boolean {
        val x = all[one].nextX
        val y = all[other].nextX
        return if (x == y || (x.isNaN() && y.isNaN())) one < other else x < y || x.isNaN()
    }
}

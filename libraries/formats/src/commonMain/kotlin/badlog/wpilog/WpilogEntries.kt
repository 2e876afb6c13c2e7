package badlog.wpilog

import badlog.recording.ProblemList
import badlog.text.TextDecoder

/** The entries of a file: which were begun, and what their records were turned into. */
internal class WpilogEntries(private val source: ColumnSource, private val problems: ProblemList) : RecordSink {
    private val decoder = TextDecoder()
    private val schemas = StructSchemas()
    private val byName = LinkedHashMap<Triple<String, String, Boolean>, Entry>()
    private val byLargeId = HashMap<Int, Entry>()
    private var byId = arrayOfNulls<Entry>(64)

    /** Where most of the records are. */
    val histogram = TimeHistogram()

    /** What some of them tell about the whole run. */
    val match = MatchMetadata()

    /** The entries, in the order in which they were first begun. */
    val all: Collection<Entry> get() = byName.values

    /** The text of the file's header. */
    var extraHeader = ""
        private set

    /** Why this is not a WPILOG that can be read; null when it can. */
    var refusal: String? = null
        private set

    /** How many records there were, of whatever kind. */
    var recordCount = 0
        private set

    /** How many had times that cannot be, and of which entry the first was. */
    var wildCount = 0
        private set
    var firstWild: Entry? = null
        private set

    /** How many had times before 0, and of which entry the first was. */
    var earlyCount = 0
        private set
    var firstEarly: Entry? = null
        private set

    /** How many belonged to no entry, and to which number the first. */
    var unknownCount = 0
        private set
    var firstUnknown = 0
        private set

    override fun header(bytes: ByteArray, from: Int, until: Int): Boolean {
        val magic = RecordSplitter.MAGIC
        if (!magic.indices.all { bytes[from + it].toInt() == magic[it].code }) {
            refusal = "This is not a WPILOG file."
            return false
        }
        val major = bytes[from + magic.length + 1].toInt() and 0xFF
        if (major != 1) {
            refusal = "This is a WPILOG of version $major; this version of badlog reads version 1."
            return false
        }
        extraHeader = decoder.decode(bytes, from + RecordSplitter.HEADER, until)
        return true
    }

    override fun record(id: Int, micros: Double, bytes: ByteArray, head: Int, from: Int, until: Int): RecordFate {
        if (id == 0) {
            if (!control(bytes, from, until)) return RecordFate.NONSENSE
            recordCount++
            return RecordFate.READ
        }
        recordCount++
        val entry = entryOf(id)
        if (entry == null) {
            if (unknownCount++ == 0) firstUnknown = id
            return RecordFate.UNKNOWN
        }
        if (micros < 0 && micros > -TimeHistogram.NEVER) {
            if (earlyCount++ == 0) firstEarly = entry
        } else if (micros < 0 || !histogram.add(micros)) {
            if (wildCount++ == 0) firstWild = entry
            return RecordFate.READ
        }
        entry.decoder.accept(micros / MICROS, bytes, from, until)
        entry.listener?.heard(micros, bytes, from, until)
        return RecordFate.READ
    }

    /** The entry that has the number [id] now, or null. */
    fun entryOf(id: Int): Entry? = if (id in byId.indices) byId[id] else byLargeId[id]

    private fun control(bytes: ByteArray, from: Int, until: Int): Boolean {
        if (until - from < CONTROL_HEAD) return false
        val id = intAt(bytes, from + 1)
        when (bytes[from].toInt()) {
            START -> {
                val texts = texts(bytes, from + CONTROL_HEAD, until, 3) ?: return false
                if (id == 0) return false
                start(id, texts[0], texts[1], texts[2])
            }

            FINISH -> if (until - from == CONTROL_HEAD) put(id, null) else return false

            SET_METADATA -> {
                val texts = texts(bytes, from + CONTROL_HEAD, until, 1) ?: return false
                entryOf(id)?.metadata = texts[0]
            }

            else -> return false
        }
        return true
    }

    /** The [count] texts, each with its length before it, that the bytes from [from] until [until] are; null otherwise. */
    private fun texts(bytes: ByteArray, from: Int, until: Int, count: Int): List<String>? {
        val texts = ArrayList<String>(count)
        var at = from
        repeat(count) {
            if (until - at < Int.SIZE_BYTES) return null
            val size = intAt(bytes, at)
            at += Int.SIZE_BYTES
            if (size !in 0..until - at) return null
            texts += decoder.decode(bytes, at, at + size)
            at += size
        }
        return texts.takeIf { at == until }
    }

    private fun start(id: Int, name: String, type: String, metadata: String) {
        // A topic may be called like a value.
        val isValue = metadata == VALUE_METADATA && type == "string"
        val entry = byName.getOrPut(Triple(name, type, isValue)) {
            Entry(name, type, isValue, decoderFor(name, type)).also { entry ->
                match.watch(entry)
                if (type == SCHEMA && STRUCT_SCHEMA in name) entry.listener = schemaListener(name)
            }
        }
        if (metadata.isNotEmpty()) entry.metadata = metadata
        put(id, entry)
    }

    private fun schemaListener(name: String) = EntryListener { _, bytes, from, until ->
        schemas.add(name.substringAfter(STRUCT_SCHEMA), bytes.decodeToString(from, until))
    }

    private fun decoderFor(name: String, type: String): PayloadDecoder {
        if (!source.hasRoomFor(1)) return NoDecoder()
        val isArray = type.endsWith("[]")
        val single = type.removeSuffix("[]")
        val layout = ValueLayout.of(single)
        return when {
            layout != null -> if (isArray) LayoutArrayDecoder(source, layout) else LayoutDecoder(source, layout)
            single.startsWith(STRUCT) -> StructDecoder(source, schemas, single.removePrefix(STRUCT), isArray)
            type == "string[]" -> TextArrayDecoder(source)
            type == "string" || type == "json" || type == SCHEMA -> TextPayloadDecoder(source)
            else -> SizeDecoder(source)
        }
    }

    private fun put(id: Int, entry: Entry?) {
        if (id !in 0..MAX_LISTED_ID) {
            if (entry != null) byLargeId[id] = entry else byLargeId.remove(id)
            return
        }
        if (id >= byId.size) {
            if (entry == null) return
            byId = byId.copyOf(maxOf(id + 1, byId.size * 2))
        }
        byId[id] = entry
    }

    /** Says that the file is over; [unreal] of the records that belong to no entry were none. */
    fun finish(unreal: Int) {
        recordCount -= unreal
        unknownCount -= unreal
        for (entry in all) {
            entry.decoder.finish()
            reportEntry(entry, problems)
        }
    }

    companion object {
        const val MICROS = 1e6
        const val START = 0
        const val FINISH = 1
        const val SET_METADATA = 2
        private const val CONTROL_HEAD = 5

        /** Numbers up to here are found in an array; loggers count from 1. */
        private const val MAX_LISTED_ID = 1 shl 16
        private const val STRUCT = "struct:"
        private const val SCHEMA = "structschema"
        private const val STRUCT_SCHEMA = ".schema/struct:"
    }
}

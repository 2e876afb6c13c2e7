package badlog.formats.wpilog

import badlog.core.recording.ProblemList
import badlog.core.text.TextDecoder
import badlog.formats.column.ColumnSource
import badlog.formats.column.addSkipped
import badlog.formats.protobuf.MessageLayout
import badlog.formats.protobuf.MessageTypes

/**
 * The entries that were started in a file, and the samples of their records.
 *
 * @param isWanted whether the samples of an entry with this name are wanted.
 */
internal class WpilogEntries(
    private val source: ColumnSource,
    private val problems: ProblemList,
    private val isWanted: (String) -> Boolean = { true },
) : RecordSink {
    private val decoder = TextDecoder()
    private val structs = StructSchemas()
    private val messages = MessageTypes()

    // The folders that are each a `Field2d`, a picture of the field.
    private val fields = HashSet<String>()
    private val byName = LinkedHashMap<Triple<String, String, Boolean>, Entry>()
    private val byLargeId = HashMap<Int, Entry>()
    private var byId = arrayOfNulls<Entry>(64)

    /** The times of the records, which show where most of them are. */
    val histogram = TimeHistogram()

    /** The facts about the whole run that some of them report. */
    val match = MatchMetadata()

    /** The entries, in the order in which they were first started. */
    val all: Collection<Entry> get() = byName.values

    /** The text of the file's header. */
    var extraHeader = ""
        private set

    /** The reason why this is not a readable WPILOG; null if it is one. */
    var refusal: String? = null
        private set

    /** The number of records of all kinds. */
    var recordCount = 0
        private set

    /** The number of records with impossible times, and the entry of the first one. */
    var wildCount = 0
        private set
    var firstWild: Entry? = null
        private set

    /** The number of records with times before 0, and the entry of the first one. */
    var earlyCount = 0
        private set
    var firstEarly: Entry? = null
        private set

    /** The number of records that do not belong to a started entry. */
    var unknownCount = 0
        private set

    /** The ids in such records, in order of first appearance; not all, if damage produced thousands. */
    val unknownIds: Collection<Int> get() = unknownCounts.keys
    private val unknownCounts = LinkedHashMap<Int, Int>()

    /** The number of control records that cannot be understood. */
    var badControlCount = 0
        private set

    /** Whether bytes between records were skipped. */
    var hasGaps = false
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

    override fun isStranger(id: Int): Boolean = (unknownCounts[id] ?: 0) > STRANGERS

    override fun entryOf(id: Int): Entry? = if (id in byId.indices) byId[id] else byLargeId[id]

    override fun record(head: RecordHead, position: Long, bytes: ByteArray, from: Int, until: Int) {
        read(head, bytes, until)
    }

    /** Reads the record with [head] that ends at [until]. Returns false if it is dropped. */
    fun read(head: RecordHead, bytes: ByteArray, until: Int): Boolean {
        recordCount++
        return if (head.id == 0) control(bytes, until - head.size, until) else take(head, bytes, until)
    }

    override fun skipped(from: Long, until: Long) {
        hasGaps = true
        problems.addSkipped(from, until)
    }

    private fun take(head: RecordHead, bytes: ByteArray, until: Int): Boolean {
        val micros = head.micros
        val from = until - head.size
        val entry = head.entry
        if (entry == null) {
            unknownCount++
            // A damaged file could contain millions.
            val id = head.id
            if (id in unknownCounts || unknownCounts.size < MAX_UNKNOWN) unknownCounts[id] = (unknownCounts[id] ?: 0) + 1
            return false
        }
        if (micros < 0 && micros > -TimeHistogram.NEVER) {
            if (earlyCount++ == 0) firstEarly = entry
        } else if (micros < 0 || !histogram.add(micros)) {
            if (wildCount++ == 0) firstWild = entry
            return false
        }
        val bad = entry.decoder.badCount
        entry.decoder.accept(micros / MICROS, bytes, from, until)
        entry.listener?.handle(micros, bytes, from, until)
        return entry.decoder.badCount == bad
    }

    private fun control(bytes: ByteArray, from: Int, until: Int): Boolean {
        if (!mayBeControlPayload(bytes, from, until)) {
            badControlCount++
            return false
        }
        val kind = bytes[from].toInt()
        val id = intAt(bytes, from + 1)
        var at = from + CONTROL_HEAD
        val texts = List(ControlKind.textsOf(kind)) {
            val begin = at + Int.SIZE_BYTES
            at = begin + intAt(bytes, at)
            decoder.decode(bytes, begin, at)
        }
        when (kind) {
            ControlKind.START -> start(id, texts[0], texts[1], texts[2])
            ControlKind.FINISH -> put(id, null)
            else -> entryOf(id)?.metadata = texts[0]
        }
        return true
    }

    private fun start(id: Int, name: String, type: String, metadata: String) {
        // A topic may have the same name as a value.
        val isValue = metadata == VALUE_METADATA && type == "string"
        val entry = byName.getOrPut(Triple(name, type, isValue)) {
            Entry(name, type, isValue, decoderFor(name, type)).also { entry ->
                match.watch(entry)
                schemaListener(name, type)?.let { entry.listener = it }
            }
        }
        if (metadata.isNotEmpty()) entry.metadata = metadata
        put(id, entry)
    }

    private fun schemaListener(name: String, type: String) = when {
        type == "string" && name.endsWith(DASHBOARD_TYPE) -> EntryListener { _, bytes, from, until ->
            if (bytes.decodeToString(from, until) == FIELD) fields += name.removeSuffix(DASHBOARD_TYPE)
        }

        type == SCHEMA && STRUCT_SCHEMA in name -> EntryListener { _, bytes, from, until ->
            structs.add(name.substringAfter(STRUCT_SCHEMA), bytes.decodeToString(from, until))
        }

        type == Entry.MESSAGE_SCHEMA -> EntryListener { _, bytes, from, until -> messages.add(bytes.copyOfRange(from, until)) }

        else -> null
    }

    private fun decoderFor(name: String, type: String): PayloadDecoder {
        if (!isWanted(name)) return UnwantedDecoder()
        if (!source.hasRoomFor(1)) return NoDecoder()
        if (type == "double[]" && NETWORK in name) {
            return FieldArrayDecoder(source) {
                name.substringBeforeLast('/').let { it in fields || it.substringAfterLast('/').equals(FIELD_FOLDER, ignoreCase = true) }
            }
        }
        val isArray = type.endsWith("[]")
        val single = type.removeSuffix("[]")
        val layout = ValueLayout.of(single)
        return when {
            layout != null -> if (isArray) LayoutArrayDecoder(source, layout) else LayoutDecoder(source, layout)
            single.startsWith(STRUCT) -> SchemaDecoder(source, structs::version) { structDecoder(single.removePrefix(STRUCT), isArray) }
            type == Entry.MESSAGE_SCHEMA -> SizeDecoder(source)
            type.startsWith(PROTO) -> SchemaDecoder(source, messages::version) { protoDecoder(type.removePrefix(PROTO)) }
            type == "string[]" -> TextArrayDecoder(source)
            type == "string" || type == "json" || type == SCHEMA -> TextPayloadDecoder(source)
            else -> SizeDecoder(source)
        }
    }

    private fun structDecoder(name: String, isArray: Boolean): PayloadDecoder? {
        val layout = structs.layoutOf(name)?.takeIf { source.hasRoomFor(it.leaves.size) } ?: return null
        return if (isArray) LayoutArrayDecoder(source, layout) else LayoutDecoder(source, layout)
    }

    private fun protoDecoder(name: String): PayloadDecoder? =
        MessageLayout.of(messages, name)?.takeIf { source.hasRoomFor(it.values.size) }?.let { ProtoDecoder(source, it) }

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

    /** Marks the end of the file. */
    fun finish() {
        for (entry in all) {
            entry.decoder.finish()
            reportEntry(entry, problems)
        }
        reportUndecoded(all, problems)
    }

    companion object {
        const val MICROS = 1e6

        /** An id with more records than this belongs to an entry with a lost start; fewer may be damage. */
        private const val STRANGERS = 1
        private const val MAX_UNKNOWN = 1000

        /** Ids up to this one are looked up in an array; loggers count from 1. */
        private const val MAX_LISTED_ID = 1 shl 16
        private const val STRUCT = "struct:"

        /** The mark in the names of entries from NetworkTables. */
        private const val NETWORK = "NT:"
        private const val DASHBOARD_TYPE = "/.type"
        private const val FIELD = "Field2d"

        /** The usual name of a `Field2d`, which shows it even if the record with its type was lost. */
        private const val FIELD_FOLDER = "Field"
        private const val SCHEMA = "structschema"
        private const val STRUCT_SCHEMA = ".schema/struct:"
        private const val PROTO = "proto:"
    }
}

package badlog.formats.protobuf

/**
 * One field of a message type.
 *
 * @property type the type of its values; null if they are messages.
 * @property typeName the full name of its message or enumeration.
 * @property hasPresence whether it may be missing; otherwise a missing field has its default: 0, false or an empty
 * text.
 */
internal class MessageField(
    val number: Int,
    val name: String,
    val type: ScalarType?,
    val typeName: String,
    val isList: Boolean,
    val hasPresence: Boolean,
)

/** The message types that a file has described so far; see `google/protobuf/descriptor.proto`. */
internal class MessageTypes {
    private val messages = HashMap<String, List<MessageField>>()
    private val enumerations = HashMap<String, Map<Long, ByteArray>>()

    /** A counter of descriptors. When it grows, a type that was null may be available. */
    var version = 0
        private set

    /**
     * Adds the `FileDescriptorProto` [bytes]. Of two types with the same name, the first counts, since records may already have been read
     * with it.
     */
    fun add(bytes: ByteArray) {
        if (messages.size >= MAX_TYPES) return
        var folder = ""
        forEach(bytes, 0, bytes.size) { if (number == FILE_PACKAGE && wire == WireReader.SIZED) folder = text(bytes) + "." }
        forEach(bytes, 0, bytes.size) {
            if (wire == WireReader.SIZED) {
                when (number) {
                    FILE_MESSAGE -> addMessage(bytes, from, end, folder, 0)
                    FILE_ENUM -> addEnumeration(bytes, from, end, folder)
                }
            }
        }
        version++
    }

    /** Returns the fields of the message with the full name [name], such as `wpi.proto.ProtobufPose2d`; null if no descriptor has it. */
    fun fieldsOf(name: String): List<MessageField>? = messages[name]

    /** Returns the names of the numbers of the enumeration [name]. */
    fun namesOf(name: String): Map<Long, ByteArray> = enumerations[name].orEmpty()

    private fun addMessage(bytes: ByteArray, from: Int, until: Int, folder: String, depth: Int) {
        if (depth == MAX_DEPTH) return
        val name = folder + nameIn(bytes, from, until)
        val fields = ArrayList<MessageField>()
        forEach(bytes, from, until) {
            if (wire == WireReader.SIZED) {
                when (number) {
                    MESSAGE_FIELD -> fields += fieldIn(bytes, this.from, end)
                    MESSAGE_NESTED -> addMessage(bytes, this.from, end, "$name.", depth + 1)
                    MESSAGE_ENUM -> addEnumeration(bytes, this.from, end, "$name.")
                }
            }
        }
        if (name !in messages) messages[name] = fields
    }

    private fun fieldIn(bytes: ByteArray, from: Int, until: Int): MessageField {
        var number = 0
        var name = ""
        var type = 0
        var typeName = ""
        var isList = false
        var hasPresence = false
        forEach(bytes, from, until) {
            when (this.number) {
                FIELD_NAME -> name = text(bytes)
                FIELD_NUMBER -> number = bits.toInt()
                FIELD_LABEL -> isList = bits == LABEL_REPEATED
                FIELD_TYPE -> type = bits.toInt()
                FIELD_TYPE_NAME -> typeName = text(bytes).removePrefix(".")
                FIELD_ONE_OF, FIELD_OPTIONAL -> hasPresence = true
            }
        }
        return MessageField(number, name, ScalarType.of(type), typeName, isList, hasPresence)
    }

    private fun addEnumeration(bytes: ByteArray, from: Int, until: Int, folder: String) {
        val names = HashMap<Long, ByteArray>()
        forEach(bytes, from, until) {
            if (number == ENUM_VALUE && wire == WireReader.SIZED) {
                var value = 0L
                forEach(bytes, this.from, end) { if (number == VALUE_NUMBER) value = bits.toInt().toLong() }
                names.getOrPut(value) { nameIn(bytes, this.from, end).encodeToByteArray() }
            }
        }
        enumerations.getOrPut(folder + nameIn(bytes, from, until)) { names }
    }

    // In messages, enumerations and their values alike, 1 is the name.
    private fun nameIn(bytes: ByteArray, from: Int, until: Int): String {
        var name = ""
        forEach(bytes, from, until) { if (number == FIELD_NAME && wire == WireReader.SIZED) name = text(bytes) }
        return name
    }

    private inline fun forEach(bytes: ByteArray, from: Int, until: Int, read: WireReader.() -> Unit) {
        val reader = WireReader(bytes, from, until)
        while (reader.next()) reader.read()
    }

    private fun WireReader.text(bytes: ByteArray) = if (wire == WireReader.SIZED) bytes.decodeToString(from, end) else ""
}

private const val MAX_TYPES = 10_000
private const val MAX_DEPTH = 32

private const val FILE_PACKAGE = 2
private const val FILE_MESSAGE = 4
private const val FILE_ENUM = 5
private const val MESSAGE_FIELD = 2
private const val MESSAGE_NESTED = 3
private const val MESSAGE_ENUM = 4
private const val FIELD_NAME = 1
private const val FIELD_NUMBER = 3
private const val FIELD_LABEL = 4
private const val FIELD_TYPE = 5
private const val FIELD_TYPE_NAME = 6
private const val FIELD_ONE_OF = 9
private const val FIELD_OPTIONAL = 17
private const val ENUM_VALUE = 2
private const val VALUE_NUMBER = 2
private const val LABEL_REPEATED = 3L

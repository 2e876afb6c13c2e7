package badlog.samples.generated.log

import java.io.ByteArrayOutputStream

/** Writes a Protocol Buffers message or descriptor, field by field. */
internal class MessageBytes {
    private val out = ByteArrayOutputStream()

    val bytes: ByteArray get() = out.toByteArray()

    fun whole(number: Int, value: Long): MessageBytes = apply {
        varint(number.toLong() shl 3)
        varint(value)
    }

    fun text(number: Int, text: String): MessageBytes = sized(number, text.encodeToByteArray())

    fun sized(number: Int, bytes: ByteArray): MessageBytes = apply {
        varint(number.toLong() shl 3 or SIZED)
        varint(bytes.size.toLong())
        out.writeBytes(bytes)
    }

    private fun varint(number: Long) {
        var left = number
        while (left and 0x7FL.inv() != 0L) {
            out.write((left and 0x7F or 0x80).toInt())
            left = left ushr 7
        }
        out.write(left.toInt())
    }
}

// The types of fields in descriptors.
private const val TEXT = 9
private const val UINT32 = 13

/** A message of the Driver Station of 2027, with the numbers, types and names of its fields. */
internal enum class Message(val typeName: String, private vararg val fields: Pair<String, Int>) {
    CONTROL_DATA("ProtobufControlData", "control_word" to UINT32, "match_time" to UINT32),
    MATCH_INFO("ProtobufMatchInfo", "event_name" to TEXT, "match_type" to UINT32, "match_number" to UINT32),
    CONSOLE_LINE("ProtobufConsoleLineTimestamp", "console_line" to TEXT, "sequence_number" to UINT32),
    ;

    private val description: ByteArray
        get() = fields.foldIndexed(MessageBytes().text(NAME, typeName)) { index, message, (name, type) ->
            val field = MessageBytes().text(NAME, name).whole(NUMBER, index + 1L).whole(LABEL, OPTIONAL).whole(TYPE, type.toLong())
            message.sized(FIELD, field.bytes)
        }.bytes

    companion object {
        /** The package of all messages. */
        const val PACKAGE = "mrc.proto"

        // The numbers of fields in descriptors.
        private const val NAME = 1
        private const val FIELD = 2
        private const val NUMBER = 3
        private const val LABEL = 4
        private const val TYPE = 5
        private const val OPTIONAL = 1L
        private const val MESSAGE_IN_FILE = 4

        /** Returns the descriptor of all messages, as in a log's schema. */
        fun descriptions(): ByteArray = entries.fold(MessageBytes().text(1, "mrc.proto").text(2, PACKAGE)) { file, message ->
            file.sized(MESSAGE_IN_FILE, message.description)
        }.bytes
    }
}

private const val SIZED = 2L

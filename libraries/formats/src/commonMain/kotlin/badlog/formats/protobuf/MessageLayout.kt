package badlog.formats.protobuf

/**
 * The values and lists of one message type that are shown. A nested message is replaced by its values.
 *
 * @property values the single values.
 * @property lists the repeated ones.
 * @property partCount the number of messages, including the outermost and the nested ones.
 */
internal class MessageLayout private constructor(
    val values: List<MessageValue>,
    val lists: List<MessageList>,
    val partCount: Int,
    val outermost: MessagePart,
) {
    /** The number of values and messages, with one element for each list. */
    val size: Int = values.size + partCount + lists.sumOf { it.element.size }

    /** Returns whether the bytes from [from] until [until] of [bytes] are such a message; only then may they be read. */
    fun fits(bytes: ByteArray, from: Int, until: Int): Boolean = fits(outermost, bytes, from, until)

    private fun fits(part: MessagePart, bytes: ByteArray, from: Int, until: Int): Boolean {
        val reader = WireReader(bytes, from, until)
        while (reader.next()) {
            val isFitting = when (val member = part.members[reader.number]) {
                null -> true
                is MessageValue -> reader.wire == member.type.wire
                is MessagePart -> reader.wire == WireReader.SIZED && fits(member, bytes, reader.from, reader.end)
                is MessageList -> member.fits(reader, bytes)
            }
            if (!isFitting) return false
        }
        return !reader.isBad
    }

    private class Building(val types: MessageTypes) {
        val values = ArrayList<MessageValue>()
        val lists = ArrayList<MessageList>()
        var partCount = 0

        fun part(name: String, path: String, within: Set<String>): MessagePart? {
            if (within.size > MAX_DEPTH) return null
            val index = partCount++
            val members = HashMap<Int, MessageMember>()
            for (field in types.fieldsOf(name) ?: return null) {
                val inside = "$path/${field.name}"
                // A message that contains itself would never end.
                if (field.type == null && field.typeName in within) continue
                members[field.number] = when {
                    field.isList -> {
                        val element = if (field.type == null) {
                            of(types, field.typeName, within + field.typeName) ?: return null
                        } else {
                            single(types, field)
                        }
                        MessageList(lists.size, inside, element, field.type).also(lists::add)
                    }

                    field.type == null -> part(field.typeName, inside, within + field.typeName) ?: return null

                    else -> value(types, field, values.size, inside, index).also(values::add)
                }
                if (values.size + partCount + lists.sumOf { it.element.size } > MAX_SIZE) return null
            }
            return MessagePart(index, members)
        }
    }

    companion object {
        /** Each value is a topic, and a graph. */
        private const val MAX_SIZE = 1024

        /** The depth that other readers of Protocol Buffers accept. Each level calls the next, and the stack is finite. */
        private const val MAX_DEPTH = 100

        /**
         * Returns the layout of the message with the full name [name]. Null if a descriptor is missing, if there are too many values, or if
         * messages are nested too deeply.
         */
        fun of(types: MessageTypes, name: String): MessageLayout? = of(types, name, setOf(name))

        private fun of(types: MessageTypes, name: String, within: Set<String>): MessageLayout? {
            val building = Building(types)
            val outermost = building.part(name, "", within) ?: return null
            return MessageLayout(building.values, building.lists, building.partCount, outermost)
        }

        /** Returns the layout of an element that is not a message. */
        private fun single(types: MessageTypes, field: MessageField): MessageLayout {
            val only = value(types, field, 0, "", 0)
            return MessageLayout(listOf(only), emptyList(), 1, MessagePart(0, mapOf(field.number to only)))
        }

        private fun value(types: MessageTypes, field: MessageField, index: Int, path: String, part: Int): MessageValue {
            val type = requireNotNull(field.type)
            val names = if (type == ScalarType.ENUM) types.namesOf(field.typeName) else null
            return MessageValue(index, path, type, part, field.hasPresence, names)
        }
    }
}

/** A field of a message that is shown. */
internal sealed interface MessageMember

/**
 * The outermost message, or one nested in it.
 *
 * @property index its index in the layout, from 0.
 * @property members the members by their field numbers.
 */
internal class MessagePart(val index: Int, val members: Map<Int, MessageMember>) : MessageMember

/**
 * A single value.
 *
 * @property index its index in the layout, from 0.
 * @property path the part of the topic's name after the message's.
 * @property part the [MessagePart.index] of the message that it is in.
 * @property hasPresence whether it may be missing although its message is present.
 * @property names for an enumeration, the names of its numbers; otherwise null.
 */
internal class MessageValue(
    val index: Int,
    val path: String,
    val type: ScalarType,
    val part: Int,
    val hasPresence: Boolean,
    val names: Map<Long, ByteArray>?,
) : MessageMember

/**
 * A repeated field: any number of values or messages.
 *
 * @property index its index in the layout, from 0.
 * @property type the type of its elements; null if they are messages.
 */
internal class MessageList(val index: Int, val path: String, val element: MessageLayout, val type: ScalarType?) : MessageMember {
    /** The encoding of an element. */
    val wire: Int get() = type?.wire ?: WireReader.SIZED

    /**
     * Returns whether the field that [reader] has read is packed: its numbers follow each other, without the field's number before each.
     */
    fun isPacked(reader: WireReader): Boolean = reader.wire != wire

    /** Returns whether the field that [reader] has read may belong to this list. */
    fun fits(reader: WireReader, bytes: ByteArray): Boolean = when {
        type == null -> reader.wire == WireReader.SIZED && element.fits(bytes, reader.from, reader.end)

        isPacked(reader) -> reader.wire == WireReader.SIZED && WireReader(bytes, reader.from, reader.end).run {
            while (nextPacked(this@MessageList.wire)) continue
            !isBad
        }

        else -> true
    }
}

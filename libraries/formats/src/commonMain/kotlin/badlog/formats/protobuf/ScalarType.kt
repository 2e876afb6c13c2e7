package badlog.formats.protobuf

/**
 * A type of single values.
 *
 * @property id its number in a descriptor, `FieldDescriptorProto.Type`.
 * @property wire its encoding, see [WireReader.wire].
 */
internal enum class ScalarType(val id: Int, val wire: Int) {
    DOUBLE(1, WireReader.FIXED_64),
    FLOAT(2, WireReader.FIXED_32),
    INT64(3, WireReader.VARINT),
    UINT64(4, WireReader.VARINT),
    INT32(5, WireReader.VARINT),
    FIXED64(6, WireReader.FIXED_64),
    FIXED32(7, WireReader.FIXED_32),
    BOOL(8, WireReader.VARINT),
    STRING(9, WireReader.SIZED),
    BYTES(12, WireReader.SIZED),
    UINT32(13, WireReader.VARINT),
    ENUM(14, WireReader.VARINT),
    SFIXED32(15, WireReader.FIXED_32),
    SFIXED64(16, WireReader.FIXED_64),
    SINT32(17, WireReader.VARINT),
    SINT64(18, WireReader.VARINT),
    ;

    companion object {
        /** Returns the type with the number [id] in descriptors, or null, for example for a message. */
        fun of(id: Int): ScalarType? = entries.find { it.id == id }
    }
}

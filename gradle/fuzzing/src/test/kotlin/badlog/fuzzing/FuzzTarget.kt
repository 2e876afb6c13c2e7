package badlog.fuzzing

/**
 * A reader of untrusted bytes, to be fuzzed.
 *
 * @property extensions the extensions of the conformance corpora's files that it reads.
 * @property read reads the bytes, and throws if the result is wrong. No bytes may cause an exception of the reader itself.
 */
internal enum class FuzzTarget(val extensions: Set<String>, val read: (ByteArray) -> Unit) {
    BAG(setOf("bag"), ::readBag),
    WPILOG(setOf("wpilog"), ::readWpilog),
    PROTOBUF(emptySet(), ::readProtobuf),
    STATION(setOf("dslog", "dsevents"), ::readStationLog),
    REVLOG(emptySet(), ::readRevlog),
    JSON(setOf("json"), ::readJson),
    TOML(emptySet(), ::readToml),
    EXPRESSION(emptySet(), ::readExpression),
    ;

    /** The folder of its findings and its own seeds. */
    val folder: String get() = name.lowercase()
}

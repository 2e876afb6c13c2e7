package badlog.fuzzing

/**
 * What reads bytes that somebody else wrote.
 *
 * @property extensions the names' ends of the files of the conformance corpora that are such bytes.
 * @property read throws if the bytes are not read as they should be; whatever they are, they are never refused with an exception.
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

    /** The folder of what was found, and of seeds of its own. */
    val folder: String get() = name.lowercase()
}

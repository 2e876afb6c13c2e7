package badlog.fuzzing

import badlog.formats.LOG_ENDINGS

/**
 * A reader of untrusted bytes, to be fuzzed.
 *
 * @property extensions the extensions of the conformance corpora's files that it reads.
 * @property read reads the bytes, and throws if the result is wrong. No bytes may cause an exception of the reader itself.
 */
internal enum class FuzzTarget(val extensions: Set<String>, val read: (ByteArray) -> Unit) {
    /** Bags, and every kind of log without a target of its own: the content decides. */
    BAG(LOG_ENDINGS.mapTo(HashSet()) { it.removePrefix(".") } - OWN, ::readBag),
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

/** The endings of logs with targets of their own. */
private val OWN = setOf("wpilog", "dslog", "dsevents")

package badlog.bag

/** What the first bytes of a file say about it; what is no bag is refused by its name. */
internal enum class FileSignature {
    /** A gzip stream, which has to be inflated. */
    GZIP,

    /** A WPILOG of WPILib's DataLog. */
    WPILOG,

    /** Anything else: a bag, a CSV file, or nothing that can be read. */
    OTHER,
    ;

    companion object {
        /** How many bytes [of] wants to see; fewer are a shorter file. */
        const val BYTES: Int = 6

        /** The signature of a file that begins with the first [count] of [bytes]. */
        fun of(bytes: ByteArray, count: Int = bytes.size): FileSignature = when {
            count >= 2 && bytes[0] == 0x1f.toByte() && bytes[1] == 0x8b.toByte() -> GZIP
            count >= 6 && bytes.decodeToString(0, 6) == "WPILOG" -> WPILOG
            else -> OTHER
        }
    }
}

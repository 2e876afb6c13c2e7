package badlog.fuzzing

/** The entry point for Jazzer, see https://github.com/CodeIntelligenceTesting/jazzer. */
internal object Fuzzer {
    private var target = FuzzTarget.BAG

    /** Chooses the target that the first of [arguments] names. */
    @JvmStatic
    fun fuzzerInitialize(arguments: Array<String>) {
        target = FuzzTarget.valueOf(arguments.first().uppercase())
    }

    /** Reads [bytes]; an exception is a finding. */
    @JvmStatic
    fun fuzzerTestOneInput(bytes: ByteArray) = target.read(bytes)
}

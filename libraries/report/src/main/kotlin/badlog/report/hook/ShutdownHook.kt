package badlog.report.hook

/** Does [work]; if the program is asked to end meanwhile, as by Ctrl+C, does [atEnd] on another thread before it does. */
internal fun <T> withShutdownHook(atEnd: () -> Unit, work: () -> T): T {
    val runtime = Runtime.getRuntime()
    val thread = Thread(atEnd, "badlog-end")
    try {
        runtime.addShutdownHook(thread)
    } catch (_: IllegalStateException) {
        // It is ending already: what begins now is not waited for.
        throw InterruptedException("The program ends.")
    }
    try {
        return work()
    } finally {
        try {
            runtime.removeShutdownHook(thread)
        } catch (_: IllegalStateException) {
            // It runs now.
        }
    }
}

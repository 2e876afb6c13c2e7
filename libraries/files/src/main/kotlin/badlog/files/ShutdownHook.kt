package badlog.files

/** Runs [work]. If the program is asked to end meanwhile, for example by Ctrl+C, [atEnd] runs on another thread before the program ends. */
public fun <T> withShutdownHook(atEnd: () -> Unit, work: () -> T): T {
    val runtime = Runtime.getRuntime()
    val thread = Thread(atEnd, "badlog-end")
    try {
        runtime.addShutdownHook(thread)
    } catch (_: IllegalStateException) {
        // The program is already ending, and does not wait for work that begins now.
        throw InterruptedException("The program ends.")
    }
    try {
        return work()
    } finally {
        try {
            runtime.removeShutdownHook(thread)
        } catch (_: IllegalStateException) {
            // It is already running.
        }
    }
}

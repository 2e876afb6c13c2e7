package badlog.lib

/** Closes a log when its program ends in an orderly way, so that rows that wait are written. */
internal class CloseOnExit(private val session: LogSession) : Thread("badlog close") {
    override fun run() = session.close()

    fun register() = unlessExiting { Runtime.getRuntime().addShutdownHook(this) }

    fun unregister() = unlessExiting { Runtime.getRuntime().removeShutdownHook(this) }

    private fun unlessExiting(action: () -> Unit) {
        try {
            action()
        } catch (_: IllegalStateException) {
            // The program is ending already.
        }
    }
}

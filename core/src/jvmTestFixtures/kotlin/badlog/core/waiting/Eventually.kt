package badlog.core.waiting

/**
 * Polls until [isSo]; fails after a minute with a message that names [what].
 *
 * Only for processes, browsers, windows and sockets: the project's own code gets its clock from the test instead. An [isSo] that throws
 * counts as false; the last error is the cause of the failure.
 */
internal fun eventually(what: String, isSo: () -> Boolean) {
    val end = System.nanoTime() + LIMIT_NANOSECONDS
    var pause = FIRST_PAUSE_MILLISECONDS
    while (true) {
        val outcome = runCatching(isSo)
        if (outcome.getOrDefault(false)) return
        if (System.nanoTime() > end) throw AssertionError("Waited a minute in vain for $what.", outcome.exceptionOrNull())
        Thread.sleep(pause)
        // Each look at a page takes time from the page.
        pause = minOf(2 * pause, LAST_PAUSE_MILLISECONDS)
    }
}

private const val LIMIT_NANOSECONDS = 60_000_000_000
private const val FIRST_PAUSE_MILLISECONDS = 10L
private const val LAST_PAUSE_MILLISECONDS = 80L

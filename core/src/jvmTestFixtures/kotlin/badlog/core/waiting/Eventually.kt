package badlog.core.waiting

/**
 * Polls until [isSo]; fails after a minute, saying [what] was awaited in vain.
 *
 * Only for processes, browsers, windows and sockets: whatever is this project's own gets its clock from the test instead. An [isSo] that
 * throws is not so yet; the last error is the cause of the failure.
 */
internal fun eventually(what: String, isSo: () -> Boolean) {
    val end = System.nanoTime() + LIMIT_NANOSECONDS
    while (true) {
        val outcome = runCatching(isSo)
        if (outcome.getOrDefault(false)) return
        if (System.nanoTime() > end) throw AssertionError("Waited a minute in vain for $what.", outcome.exceptionOrNull())
        Thread.sleep(PAUSE_MILLISECONDS)
    }
}

private const val LIMIT_NANOSECONDS = 60_000_000_000
private const val PAUSE_MILLISECONDS = 10L

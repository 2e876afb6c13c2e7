package badlog.html

import badlog.terminal.Progress

/** Carries what an [Progress] threw past all that would take it for a failure of a file. */
private class ProgressFailure(override val cause: Throwable) : RuntimeException(cause)

/** Runs [work], to which it gives [progress]; throws what that throws as it is. */
internal fun <T> passingOn(progress: Progress, work: (Progress) -> T): T = try {
    work { done, total ->
        try {
            progress.advanced(done, total)
        } catch (e: Throwable) {
            throw ProgressFailure(e)
        }
    }
} catch (e: ProgressFailure) {
    throw e.cause
}

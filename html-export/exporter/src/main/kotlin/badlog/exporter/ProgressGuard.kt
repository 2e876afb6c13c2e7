package badlog.exporter

import badlog.files.terminal.Progress

/** Carries an exception of a [Progress] past all code that would report it as the failure of a file. */
private class ProgressFailure(override val cause: Throwable) : RuntimeException(cause)

/** Runs [work] with [progress]; rethrows exceptions of [progress] unchanged. */
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

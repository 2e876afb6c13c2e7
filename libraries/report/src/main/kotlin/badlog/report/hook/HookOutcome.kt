package badlog.report.hook

import badlog.core.analysis.Span
import badlog.core.recording.Recording
import badlog.rules.Finding
import java.io.IOException

/**
 * The outcome of a hook for one recording: a [result] or a [failure].
 *
 * @property hook the name of the hook.
 * @property result its result; null if it failed.
 * @property failure the reason for the failure; null if it did not fail.
 */
class HookOutcome private constructor(val hook: String, val result: HookResult?, val failure: HookException?) {
    /** Returns the program's findings; x has the unit [timeUnit]. */
    fun findings(timeUnit: String): List<Finding> = result?.findings.orEmpty().map { found ->
        val spans = if (found.time.isNaN()) emptyList() else listOf(Span(found.time, if (found.until.isNaN()) found.time else found.until))
        Finding(hook, found.severity, null, found.text, found.time, spans, spans.size, timeUnit, isOfHook = true)
    }

    companion object {
        /**
         * Runs [hook] for [recording], like [HookRunner.run].
         *
         * @throws InterruptedException if the thread was interrupted.
         */
        fun of(hook: HookRunner, recording: Recording): HookOutcome = try {
            HookOutcome(hook.name, hook.run(recording), null)
        } catch (e: HookException) {
            HookOutcome(hook.name, null, e)
        }
    }
}

/**
 * Thrown if a hook has no valid result. The message has the reason, the next step, and the last line of the program's standard error.
 */
class HookException internal constructor(override val message: String, cause: Throwable? = null) : IOException(message, cause)

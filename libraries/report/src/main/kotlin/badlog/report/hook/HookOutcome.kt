package badlog.report.hook

import badlog.core.analysis.Span
import badlog.core.recording.Recording
import badlog.rules.Finding
import java.io.IOException

/**
 * The outcome of a hook for one recording: [result], or [failure] that says why there is none.
 *
 * @property hook the name of the hook.
 * @property result what it returned; null if it failed.
 * @property failure what went wrong; null if nothing did.
 */
class HookOutcome private constructor(val hook: String, val result: HookResult?, val failure: HookException?) {
    /** Returns what the program found; x has the unit [timeUnit]. */
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
 * Thrown if a hook returned nothing usable. The message says what went wrong and what to do, with the end of the program's standard
 * error.
 */
class HookException internal constructor(override val message: String, cause: Throwable? = null) : IOException(message, cause)

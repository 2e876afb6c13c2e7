package badlog.report.hook

import badlog.analysis.Span
import badlog.recording.Recording
import badlog.rules.Finding
import java.io.IOException

/**
 * What came of a hook for one recording: [result], or [failure] that says why there is none.
 *
 * @property hook what the hook is called.
 * @property result what it returned; null when it failed.
 * @property failure what went wrong; null when nothing did.
 */
public class HookOutcome private constructor(public val hook: String, public val result: HookResult?, public val failure: HookException?) {
    /** What the program found, where x has the unit [timeUnit]. */
    public fun findings(timeUnit: String): List<Finding> = result?.findings.orEmpty().map { found ->
        val spans = if (found.time.isNaN()) emptyList() else listOf(Span(found.time, if (found.until.isNaN()) found.time else found.until))
        Finding(hook, found.severity, null, found.text, found.time, spans, spans.size, timeUnit, isOfHook = true)
    }

    public companion object {
        /**
         * Runs [hook] for [recording], as [HookRunner.run] does.
         *
         * @throws InterruptedException when the thread was interrupted.
         */
        public fun of(hook: HookRunner, recording: Recording): HookOutcome = try {
            HookOutcome(hook.name, hook.run(recording), null)
        } catch (e: HookException) {
            HookOutcome(hook.name, null, e)
        }
    }
}

/**
 * A hook gave nothing that can be used. The message says what went wrong and what to do, with the last that the program wrote to its
 * standard error.
 */
public class HookException internal constructor(override val message: String, cause: Throwable? = null) : IOException(message, cause)

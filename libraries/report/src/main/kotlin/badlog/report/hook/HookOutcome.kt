package badlog.report.hook

import badlog.recording.Recording

/**
 * What came of a hook for one recording: [result], or [failure] that says why there is none.
 *
 * @property hook what the hook is called.
 * @property result what it returned; null when it failed.
 * @property failure what went wrong; null when nothing did.
 */
public class HookOutcome private constructor(public val hook: String, public val result: HookResult?, public val failure: HookException?) {
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
